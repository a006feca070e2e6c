#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

#include "balance-shaft/knot_stretches.h"
#include "numerics/periodic_piecewise.h"

namespace ravnoves::balance_shaft {

/// An extremum over the cycle.
template <typename Scalar>
struct BasicExtremum {
    Scalar value = Scalar(0);      ///< N·m
    Scalar angle_deg = Scalar(0);  ///< crank angle, 0…720 (0…360 where that is the period)
};

template <typename Scalar>
struct BasicExtrema {
    BasicExtremum<Scalar> max;
    BasicExtremum<Scalar> min;
};

using Extremum = BasicExtremum<double>;
using Extrema = BasicExtrema<double>;

/// The exact extrema of M(φ) + A sin(φ + α) over a cycle of 720° (four-stroke) or 360° (two-stroke)
/// for one M and one A ≥ 0 and any number of α, where M is piecewise linear or cubic in φ in
/// degrees with that period.
///
/// The sine has the period 360°, so the two revolutions (the same one twice where the cycle is one)
/// are folded once into an upper and a lower envelope at the union of their knots; per α only that
/// is searched. Between knots the function
/// exceeds its larger end by at most A h²/8 (error of the sine's chord) plus what the cubic rises
/// above its own chord, so only intervals with an end that near to the best are solved for their
/// interior extremum: in closed form for lines (cos(φ + α) = −slope/A); for cubics by Newton's
/// method where the bend keeps its sign, so that there is one at most, elsewhere by monotone
/// brackets.
///
/// For cubics an α costs twice what it does for lines, in ranges() four times where rows are few:
/// as many intervals are near the best, and each takes bounds of its bend and tangents, and now and
/// then three to five steps of Newton's, where a line has a closed form.
template <typename Scalar>
class BasicCycleExtrema {
  public:
    BasicCycleExtrema(const BasicPeriodicPiecewise<Scalar>& moment, const Scalar& amplitude);

    /// @param alpha  rad, any finite angle
    BasicExtrema<Scalar> operator()(const Scalar& alpha) const;
    Scalar range(const Scalar& alpha) const {
        const BasicExtrema<Scalar> found = (*this)(alpha);
        return found.max.value - found.min.value;
    }

    /// range() of many angles, cheaper where neighbours in the list are near each other: then one
    /// look at all knots serves eight of them.
    void ranges(std::span<const Scalar> alpha,
                std::span<Scalar> range) const requires std::is_same_v<Scalar, double>;

    Scalar amplitude() const { return amplitude_; }

  private:
    using Column = Eigen::Array<Scalar, Eigen::Dynamic, 1>;
    using Cubic = PiecewiseCubic<Scalar>;

    /// M between two folded knots in one of the two revolutions.
    struct Branch {
        Cubic cubic;                  ///< about the interval's left knot, per degree
        Scalar steepest = Scalar(0);  ///< lines: φ + α where an interior maximum lies, °; a minimum
                                      ///< lies at −steepest
        Scalar rise = Scalar(0);   ///< lines: A sin(steepest)
        bool has_interior = true;  ///< false where the slope is too steep for an interior extremum
        Scalar last = Scalar(0);   ///< value at the right knot
        Scalar above = Scalar(0);  ///< most that the moments may lie above their larger end
        Scalar below = Scalar(0);  ///< and below their smaller one
    };

    /// The least and the largest value so far and where, and the search of one interval for more.
    struct Search;
    /// The knots that can be an extremum, or stand beside one, at any of some angles.
    struct Near;

    Search search_at(const Scalar& alpha) const;
    void search_block(Eigen::Index k, const Scalar& block_max, const Scalar& block_min,
                      Search& search) const;
    /// What the knots of a stretch reach with a sine, up to rounding.
    KnotStretches::Bounds reach(std::size_t stretch, const Scalar& x,
                                const Scalar& y) const requires std::is_same_v<Scalar, double>;
    void search_many(Search& search) const requires std::is_same_v<Scalar, double>;
    void offer_knot(std::size_t j, const Scalar& top, const Scalar& bottom, Search& search) const;
    void search_interval(Eigen::Index j, Search& search) const;
    bool search_smooth(const Branch& branch, Eigen::Index j, const Scalar& value_left,
                       const Scalar& value_right, const Scalar& origin,
                       Search& search) const requires std::is_same_v<Scalar, double>;
    void find_near(const Scalar& x, const Scalar& y, const Scalar& apart,
                   Near& near) const requires std::is_same_v<Scalar, double>;

    Scalar amplitude_ = Scalar(0);
    Scalar period_ = Scalar(720);  ///< of M, °
    bool linear_ = true;
    std::size_t count_ = 0;         ///< folded knots
    std::vector<Scalar> knot_deg_;  ///< count_ + 1, 0 ≤ knot < 360, then the first + 360
    std::vector<Branch> branches_;  ///< two per interval: first revolution, second
    // Padded to whole blocks with copies of the first knot.
    Column cos_, sin_, upper_, lower_;
    // How far the function may lie above and below the ends within the intervals beside a knot, and
    // the largest of that in each block.
    Column above_, below_, block_above_, block_below_;
    // Of double alone, and where the knots are many.
    KnotStretches stretches_;
    std::vector<double> stretch_upper_, stretch_lower_, stretch_above_, stretch_below_;
    Scalar slack_ = Scalar(0);  ///< rounding of a value
};

using CycleExtrema = BasicCycleExtrema<double>;

}  // namespace ravnoves::balance_shaft
