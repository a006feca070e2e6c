#pragma once

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace ravnoves {

/// One order k of a periodic quantity: cos·cos kφ + sin·sin kφ, in the quantity's unit.
template <typename Scalar>
struct Harmonic {
    Scalar cos = Scalar(0);
    Scalar sin = Scalar(0);
};

/// The number of samples for orders 0…max_order of a function whose coefficients fall as
/// exp(−k·decay), so that the orders above, folded onto them, are under `tolerance` of the
/// function's size.
///
/// Sampling at N points folds order N − k onto order k, so N − max_order orders of decay must
/// suffice. Functions with poles or branch points at the edge of the strip |Im φ| < decay carry a
/// factor that grows as a power of the order and of 1/decay; it is allowed for.
/// @param decay      width of the strip of analyticity, rad, > 0 (SliderCrank::harmonic_decay)
/// @param tolerance  0 < tolerance < 1
/// @return at most 2²⁰, also where the accuracy would need more
inline std::size_t transform_length(double decay, int max_order, double tolerance) {
    constexpr std::size_t longest = std::size_t{1} << 20U;
    const double minimum = 2.0 * max_order + 2.0;  // Nyquist
    if (!(decay > 0.0)) {
        return longest;
    }
    // Terms k^2 exp(−k d) stay under the tolerance from the k that solves
    // k d = ln(1/tolerance) + 2 ln(k); two rounds of the fixed point are enough.
    const double need = -std::log(tolerance);
    double k = need / decay + 1.0;
    for (int round = 0; round < 3; ++round) {
        k = (need + 2.0 * std::log(k)) / decay + 1.0;
    }
    const double samples = std::max(minimum, std::ceil(max_order + k));
    if (!(samples <= static_cast<double>(longest))) {
        return longest;
    }
    // An even number keeps the nodes symmetric about the axis.
    const auto count = static_cast<std::size_t>(samples);
    return count + count % 2;
}

/// Discrete Fourier transform on a uniform grid of one turn, φ_j = 2πj/N, j = 0…N−1. The sines and
/// cosines of the nodes are kept, so several quantities share them.
///
/// A template so that the 50-digit references run the same code.
template <typename Scalar>
class UniformTransform {
  public:
    /// @param samples  N ≥ 1
    explicit UniformTransform(std::size_t samples) : cos_(samples), sin_(samples) {
        using std::cos;
        using std::sin;
        const Scalar step = boost::math::constants::two_pi<Scalar>() / Scalar(samples);
        for (std::size_t j = 0; j <= samples / 2; ++j) {
            const Scalar angle = step * Scalar(j);
            cos_[j] = cos(angle);
            sin_[j] = sin(angle);
        }
        // The second half by symmetry: odd and even parts then separate exactly.
        for (std::size_t j = samples / 2 + 1; j < samples; ++j) {
            cos_[j] = cos_[samples - j];
            sin_[j] = -sin_[samples - j];
        }
    }

    std::size_t size() const { return cos_.size(); }
    std::span<const Scalar> node_cos() const { return cos_; }
    std::span<const Scalar> node_sin() const { return sin_; }

    /// Orders 0…max_order of the sampled function; [0] has the mean in.cos.
    /// @param values  N samples at the nodes
    /// @param max_order  below N/2, else the orders fold onto each other
    std::vector<Harmonic<Scalar>> orders(std::span<const Scalar> values, int max_order) const {
        std::vector<Harmonic<Scalar>> result(static_cast<std::size_t>(max_order) + 1);
        const std::size_t n = size();
        for (std::size_t k = 0; k < result.size(); ++k) {
            Scalar a(0);
            Scalar b(0);
            std::size_t node = 0;  // k·j modulo N
            for (std::size_t j = 0; j < n; ++j) {
                a += values[j] * cos_[node];
                b += values[j] * sin_[node];
                node += k;
                if (node >= n) {
                    node -= n;
                }
            }
            const Scalar weight = Scalar(k == 0 ? 1 : 2) / Scalar(n);
            result[k] = {a * weight, b * weight};
        }
        return result;
    }

  private:
    std::vector<Scalar> cos_;
    std::vector<Scalar> sin_;
};

}  // namespace ravnoves
