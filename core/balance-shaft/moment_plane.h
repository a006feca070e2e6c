#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "numerics/periodic_piecewise.h"

namespace ravnoves::balance_shaft {

/// The exact extrema and the RMS of M(φ) + a cos φ + b sin φ over the cycle for one M, piecewise
/// linear or cubic with a period of 720° or 360°, and any moment (a, b) of the shaft, N·m: one
/// preparation for the whole plane.
///
/// The sine has the period 360°, so the revolutions are folded at the union of their knots. Between
/// two knots the function exceeds its larger end by at most the error of the sine's chord plus what
/// the cubic rises above its own, so only intervals with an end that near to the best are searched
/// within. No interval is longer than 15°: there the sine is a short series, and Newton's method
/// finds the one place where a concave stretch is flat.
class MomentPlane {
  public:
    using Moment = Eigen::Vector2d;  ///< (a, b), N·m

    explicit MomentPlane(const PeriodicPiecewise& moment);

    /// A place φ of the cycle and its values.
    struct Place {
        double value = 0.0;  ///< M(φ) + a cos φ + b sin φ, N·m
        double cos = 1.0;    ///< of φ
        double sin = 0.0;
        double angle_deg = 0.0;  ///< φ, from 0 to the end of the cycle
    };
    struct Extrema {
        Place max;
        Place min;
        double range() const { return max.value - min.value; }
        /// Of the range by (a, b).
        Moment slope() const { return {max.cos - min.cos, max.sin - min.sin}; }
    };
    Extrema operator()(const Moment& shaft) const;
    double range(const Moment& shaft) const { return (*this)(shaft).range(); }
    /// The ranges of neighbouring moments: only knots that can be an extremum of one of them are
    /// looked at. Moments of a grid in its order, of a curve along it.
    void ranges(std::span<const Moment> shafts, std::span<double> ranges) const;

    double mean() const { return mean_; }  ///< of M, N·m
    /// About the mean, (N·m)².
    double variance(const Moment& shaft) const {
        return min_variance_ + (shaft - opposed_).squaredNorm() / 2.0;
    }
    double rms(const Moment& shaft) const { return std::sqrt(variance(shaft)); }  ///< N·m
    /// The shaft with the smallest RMS: it opposes M's first order.
    const Moment& opposed() const { return opposed_; }

  private:
    /// ±M between two folded knots in one revolution: of the angle from the left knot, rad.
    struct Branch {
        PiecewiseCubic cubic;
        double last = 0.0;   ///< value at the right knot
        double above = 0.0;  ///< largest height above its chord
        double from_deg = 0.0;
    };
    /// What the search for the maximum of ±M needs.
    struct Side {
        double sign;
        std::vector<Branch> branches;  ///< of each interval, one for each turn of the cycle
        Eigen::ArrayXd peak;           ///< the higher branch at each knot, padded to whole blocks
        Eigen::ArrayXd above;  ///< largest height of the neighbouring intervals above their chords
        Eigen::ArrayXd block_above;
    };
    /// A moment as a side sees it.
    struct At {
        double a;
        double b;
        double size;
        double slack;  ///< rounding of a value
    };
    struct Search;

    void find_knots(const PeriodicPiecewise& moment);
    void find_branches(const PeriodicPiecewise& moment, Side& side) const;
    At at(const Side& side, const Moment& shaft) const;
    /// @param block_peaks  left there: the largest value at the knots of each block
    Place highest(const Side& side, const At& at, std::vector<double>& block_peaks) const;
    void search_beside(const Side& side, const At& at, std::size_t knot, Search& search) const;
    void search_branch(const Side& side, std::size_t interval, std::size_t turn, const At& at,
                       Place& best) const;
    void add_highest(const Side& side, std::span<const Moment> shafts, std::span<double> to) const;

    double period_;
    std::size_t turns_ = 1;         ///< of the crank in a cycle
    std::size_t count_ = 0;         ///< folded knots
    std::vector<double> knot_deg_;  ///< count_ + 1, the last a turn after the first
    Eigen::ArrayXd cos_, sin_;      ///< of the knots, padded with copies of the first
    std::vector<double> width_;     ///< of the intervals, rad
    std::vector<double> chord_;     ///< h²/8 of each interval: a sine's most above its chord
    Eigen::ArrayXd chord_beside_;   ///< the larger of those beside a knot, padded
    Eigen::ArrayXd block_chord_;
    Side up_{1.0, {}, {}, {}, {}};
    Side down_{-1.0, {}, {}, {}, {}};
    double slack_ = 0.0;  ///< rounding of a value of M, N·m
    double mean_;
    Moment opposed_;
    double min_variance_;
};

}  // namespace ravnoves::balance_shaft
