#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace ravnoves {

/// A pair of Fourier coefficients: the component a cos(ωx) + b sin(ωx).
struct FourierPair {
    double a = 0.0;
    double b = 0.0;
};

/// One piece about a local origin: value(t) = y + c1 t + c2 t² + c3 t³.
struct PiecewiseCubic {
    double y = 0.0;
    double c1 = 0.0;
    double c2 = 0.0;
    double c3 = 0.0;

    double value(double t) const { return y + t * (c1 + t * (c2 + t * c3)); }
    double slope(double t) const { return c1 + t * (2.0 * c2 + t * 3.0 * c3); }
    /// The same piece about the origin moved by t.
    PiecewiseCubic shifted(double t) const { return {value(t), slope(t), c2 + 3.0 * c3 * t, c3}; }
};

/// A continuous periodic function of cubic pieces: interpolates a table whose last row repeats the
/// first one period later. Integrals are of the interpolant itself, not of samples.
///
/// x may be in any unit; y too. Values are found in O(log n).
class PeriodicPiecewise {
  public:
    using Cubic = PiecewiseCubic;

    /// The place of an x: the piece and the distance from its left knot.
    struct Place {
        std::size_t piece = 0;
        double t = 0.0;
    };

    PeriodicPiecewise() = default;

    /// Straight lines between the rows.
    /// @param x  n + 1 ascending places, n ≥ 1; the period is x[n] − x[0]
    /// @param y  n + 1 values, y[n] = y[0]
    static PeriodicPiecewise linear(std::span<const double> x, std::span<const double> y);
    /// The periodic cubic spline (value, slope and curvature continuous, over the ends too).
    static PeriodicPiecewise cubic(std::span<const double> x, std::span<const double> y);

    /// Cubics through the values of a function at the knots and at the thirds between them: the
    /// error is of the order h⁴ where the function is smooth between the knots.
    /// @param x  n + 1 ascending knots, n ≥ 1; the function has the period x[n] − x[0]
    static PeriodicPiecewise through(const std::function<double(double)>& f, std::vector<double> x);

    /// f + factor × g, of two functions with the same knots.
    static PeriodicPiecewise sum(const PeriodicPiecewise& f, const PeriodicPiecewise& g,
                                 double factor);

    double period() const { return knots_.back() - knots_.front(); }
    std::size_t size() const { return pieces_.size(); }           ///< n
    const std::vector<double>& knots() const { return knots_; }   ///< n + 1 places
    const std::vector<Cubic>& pieces() const { return pieces_; }  ///< n pieces

    /// −f
    PeriodicPiecewise negated() const;

    Place find(double x) const;  ///< any finite x, taken into the period
    double operator()(double x) const;

    double mean() const;      ///< integral over a period / period
    double variance() const;  ///< mean square about the mean
    /// Coefficients at the angular frequency ω: a = (2/T) ∫ f cos(ωx) dx, b with the sine,
    /// over one period from x = knots().front(). ω T should be a multiple of 2π. Exact for the
    /// interpolant.
    FourierPair fourier(double angular_frequency) const;
    /// The coefficients at ω, 2ω, … count·ω, together cheaper than one by one.
    std::vector<FourierPair> fourier_series(double angular_frequency, std::size_t count) const;

  private:
    std::vector<double> knots_;
    std::vector<Cubic> pieces_;
};

}  // namespace ravnoves
