#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace ravnoves {

/// A pair of Fourier coefficients: the component a cos(ωx) + b sin(ωx).
struct FourierPair {
    double a = 0.0;
    double b = 0.0;
};

/// A continuous periodic function of cubic pieces: interpolates a table whose last row repeats the
/// first one period later. Integrals are those of the interpolant itself, not of samples.
///
/// x may be in any unit; y too. Values are found in O(log n).
class PeriodicPiecewise {
  public:
    /// One piece about a local origin: value(t) = y + c1 t + c2 t² + c3 t³.
    struct Cubic {
        double y = 0.0;
        double c1 = 0.0;
        double c2 = 0.0;
        double c3 = 0.0;

        double value(double t) const { return y + t * (c1 + t * (c2 + t * c3)); }
        double slope(double t) const { return c1 + t * (2.0 * c2 + t * 3.0 * c3); }
        /// The same piece about the origin moved by t.
        Cubic shifted(double t) const { return {value(t), slope(t), c2 + 3.0 * c3 * t, c3}; }
    };

    /// Where a place lies: the piece and the distance from its left knot.
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

    double period() const { return knots_.back() - knots_.front(); }
    bool is_linear() const { return linear_; }
    std::size_t size() const { return pieces_.size(); }           ///< n
    const std::vector<double>& knots() const { return knots_; }   ///< n + 1 places
    const std::vector<Cubic>& pieces() const { return pieces_; }  ///< n pieces

    Place find(double x) const;  ///< any finite x, taken into the period
    double operator()(double x) const;

    double mean() const;      ///< integral over a period / period
    double variance() const;  ///< mean square about the mean
    /// Coefficients at the angular frequency ω: a = (2/T) ∫ f cos(ωx) dx, b with the sine, over one
    /// period from x = knots().front(). ω T should be a multiple of 2π. Exact for the interpolant.
    FourierPair fourier(double angular_frequency) const;

  private:
    std::vector<double> knots_;
    std::vector<Cubic> pieces_;
    bool linear_ = true;
};

}  // namespace ravnoves
