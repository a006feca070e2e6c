#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "numerics/periodic_piecewise.h"

namespace ravnoves::balance_shaft {

/// An extremum over the cycle.
struct Extremum {
    double value = 0.0;      ///< N·m
    double angle_deg = 0.0;  ///< crank angle, 0…720
};

struct Extrema {
    Extremum max;
    Extremum min;
};

/// The exact extrema of M(φ) + A sin(φ + α) over a cycle of 720° for one M and one A ≥ 0 and any
/// number of α, where M is piecewise linear or cubic in φ in degrees with period 720°.
///
/// The sine has the period 360°, so the two revolutions are folded once into an upper and a lower
/// envelope at the union of their knots; per α only that is searched. Between knots the function
/// exceeds its larger end by at most A h²/8 (error of the sine's chord) plus what the cubic rises
/// above its own chord, so only intervals with an end that near to the best are solved for their
/// interior extremum: in closed form for lines (cos(φ + α) = −slope/A), by monotone brackets for
/// cubics.
class CycleExtrema {
  public:
    CycleExtrema(const PeriodicPiecewise& moment, double amplitude);

    /// @param alpha  rad, any finite angle
    Extrema operator()(double alpha) const;
    double range(double alpha) const {
        const Extrema found = (*this)(alpha);
        return found.max.value - found.min.value;
    }

    double amplitude() const { return amplitude_; }

  private:
    using Cubic = PeriodicPiecewise::Cubic;

    /// M between two folded knots in one of the two revolutions.
    struct Branch {
        Cubic cubic;               ///< about the interval's left knot, per degree
        double steepest = 0.0;     ///< lines: φ + α where an interior maximum lies, °; a minimum
                                   ///< lies at −steepest
        double rise = 0.0;         ///< lines: A sin(steepest)
        bool has_interior = true;  ///< false where the slope is too steep for an interior extremum
        double last = 0.0;         ///< value at the right knot
        double above = 0.0;        ///< most that the moments may lie above their larger end
        double below = 0.0;        ///< and below their smaller one
    };

    /// The least and the largest value so far and where, and the search of one interval for more.
    struct Search;

    void search_interval(Eigen::Index j, Search& search) const;

    double amplitude_ = 0.0;
    bool linear_ = true;
    std::size_t count_ = 0;         ///< folded knots
    std::vector<double> knot_deg_;  ///< count_ + 1, 0 ≤ knot < 360, then the first + 360
    std::vector<Branch> branches_;  ///< two per interval: first revolution, second
    // Padded to whole blocks with copies of the first knot.
    Eigen::ArrayXd cos_, sin_, upper_, lower_;
    // How far the function may lie above and below the ends within the intervals beside a knot, and
    // the largest of that in each block.
    Eigen::ArrayXd above_, below_, block_above_, block_below_;
};

}  // namespace ravnoves::balance_shaft
