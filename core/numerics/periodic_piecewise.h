#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace ravnoves {

/// A pair of Fourier coefficients: the component a cos(ωx) + b sin(ωx).
template <typename Scalar>
struct BasicFourierPair {
    Scalar a = Scalar(0);
    Scalar b = Scalar(0);
};
using FourierPair = BasicFourierPair<double>;

/// One piece about a local origin: value(t) = y + c1 t + c2 t² + c3 t³.
template <typename Scalar>
struct PiecewiseCubic {
    Scalar y = Scalar(0);
    Scalar c1 = Scalar(0);
    Scalar c2 = Scalar(0);
    Scalar c3 = Scalar(0);

    Scalar value(const Scalar& t) const { return y + t * (c1 + t * (c2 + t * c3)); }
    Scalar slope(const Scalar& t) const { return c1 + t * (Scalar(2) * c2 + t * Scalar(3) * c3); }
    /// The same piece about the origin moved by t.
    PiecewiseCubic shifted(const Scalar& t) const {
        return {value(t), slope(t), c2 + Scalar(3) * c3 * t, c3};
    }
};

/// A continuous periodic function of cubic pieces: interpolates a table whose last row repeats the
/// first one period later. Integrals are those of the interpolant itself, not of samples.
///
/// x may be in any unit; y too. Values are found in O(log n). Made for double and for Real50, so
/// that the 50-digit references run the same code.
template <typename Scalar>
class BasicPeriodicPiecewise {
  public:
    using Cubic = PiecewiseCubic<Scalar>;

    /// Where a place lies: the piece and the distance from its left knot.
    struct Place {
        std::size_t piece = 0;
        Scalar t = Scalar(0);
    };

    BasicPeriodicPiecewise() = default;

    /// Straight lines between the rows.
    /// @param x  n + 1 ascending places, n ≥ 1; the period is x[n] − x[0]
    /// @param y  n + 1 values, y[n] = y[0]
    static BasicPeriodicPiecewise linear(std::span<const Scalar> x, std::span<const Scalar> y);
    /// The periodic cubic spline (value, slope and curvature continuous, over the ends too).
    static BasicPeriodicPiecewise cubic(std::span<const Scalar> x, std::span<const Scalar> y);

    /// Cubics through the values of a function at the knots and at the thirds between them: the
    /// error is of the order h⁴ where the function is smooth between the knots.
    /// @param x  n + 1 ascending knots, n ≥ 1; the function has the period x[n] − x[0]
    static BasicPeriodicPiecewise through(const std::function<Scalar(const Scalar&)>& f,
                                          std::vector<Scalar> x);

    /// f + factor × g, of two functions with the same knots; straight lines where both are.
    static BasicPeriodicPiecewise sum(const BasicPeriodicPiecewise& f,
                                      const BasicPeriodicPiecewise& g, const Scalar& factor);
    /// The same function with every piece that is longer than `longest` cut into equal parts.
    BasicPeriodicPiecewise refined(const Scalar& longest) const;

    Scalar period() const { return knots_.back() - knots_.front(); }
    bool is_linear() const { return linear_; }
    std::size_t size() const { return pieces_.size(); }           ///< n
    const std::vector<Scalar>& knots() const { return knots_; }   ///< n + 1 places
    const std::vector<Cubic>& pieces() const { return pieces_; }  ///< n pieces

    /// −f; straight lines stay straight lines.
    BasicPeriodicPiecewise negated() const;

    Place find(Scalar x) const;  ///< any finite x, taken into the period
    Scalar operator()(const Scalar& x) const;

    Scalar mean() const;      ///< integral over a period / period
    Scalar variance() const;  ///< mean square about the mean
    /// Coefficients at the angular frequency ω: a = (2/T) ∫ f cos(ωx) dx, b with the sine, over one
    /// period from x = knots().front(). ω T should be a multiple of 2π. Exact for the interpolant.
    BasicFourierPair<Scalar> fourier(const Scalar& angular_frequency) const;
    /// The coefficients at ω, 2ω, … count·ω, together cheaper than one by one.
    std::vector<BasicFourierPair<Scalar>> fourier_series(const Scalar& angular_frequency,
                                                         std::size_t count) const;

  private:
    std::vector<Scalar> knots_;
    std::vector<Cubic> pieces_;
    bool linear_ = true;
};

using PeriodicPiecewise = BasicPeriodicPiecewise<double>;

}  // namespace ravnoves
