#pragma once

#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/chebyshev.hpp>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace ravnoves {

/// The n Chebyshev points of an interval, ends left out, and the way from values there to the
/// series c₀/2 + c₁ T₁(x) + … + cₙ₋₁ Tₙ₋₁(x) through them, x = −1…1. The series of a function that
/// is analytic about the interval converges geometrically.
class ChebyshevPoints {
  public:
    /// @param n  ≥ 2
    explicit ChebyshevPoints(std::size_t n) : x_(n), polynomials_(n * n) {
        const double step = boost::math::constants::pi<double>() / static_cast<double>(n);
        for (std::size_t j = 0; j < n; ++j) {
            const double angle = step * (static_cast<double>(n - j) - 0.5);
            x_[j] = std::cos(angle);
            for (std::size_t k = 0; k < n; ++k) {
                polynomials_[k * n + j] = std::cos(static_cast<double>(k) * angle);
            }
        }
    }

    std::size_t size() const { return x_.size(); }
    double operator[](std::size_t j) const { return x_[j]; }  ///< ascending

    /// @param values        at the points
    /// @param coefficients  as many, c₀ first
    void transform(std::span<const double> values, std::span<double> coefficients) const {
        const std::size_t n = size();
        for (std::size_t k = 0; k < n; ++k) {
            double sum = 0.0;
            for (std::size_t j = 0; j < n; ++j) {
                sum += values[j] * polynomials_[k * n + j];
            }
            coefficients[k] = 2.0 * sum / static_cast<double>(n);
        }
    }

  private:
    std::vector<double> x_;
    std::vector<double> polynomials_;  ///< T_k at point j
};

/// The series at x = −1…1, by Clenshaw's recurrence.
inline double chebyshev_value(std::span<const double> c, double x) {
    return boost::math::chebyshev_clenshaw_recurrence(c.data(), c.size(), x);
}

/// The series of its integral from −1.
/// @param integral  one coefficient more than c
inline void chebyshev_integral(std::span<const double> c, std::span<double> integral) {
    const std::size_t n = c.size();
    double at_start = 0.0;
    for (std::size_t k = 1; k <= n; ++k) {
        const double next = k + 1 < n ? c[k + 1] : 0.0;
        integral[k] = (c[k - 1] - next) / (2.0 * static_cast<double>(k));
        at_start += k % 2 == 1 ? -integral[k] : integral[k];
    }
    integral[0] = -2.0 * at_start;
}

}  // namespace ravnoves
