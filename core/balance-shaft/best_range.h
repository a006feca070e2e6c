#pragma once

#include "balance-shaft/angle_minimum.h"
#include "balance-shaft/cycle_extrema.h"

namespace ravnoves::balance_shaft {

/// The least range over α and what is known of the others.
template <typename Scalar>
struct BasicBestRange {
    Scalar shaft_angle = Scalar(0);  ///< rad, 0…2π
    Scalar range = Scalar(0);        ///< N·m
    Scalar worst = Scalar(0);        ///< N·m, the largest range met on the way
    Scalar gap = Scalar(0);          ///< N·m: no α has a range below range − gap
    int evaluations = 0;
};

using BestRange = BasicBestRange<double>;

/// The range R(α) = max − min of M(φ) + A sin(φ + α) with its bound: where the extrema at α lie at
/// φ₊ and φ₋, h(α) = M(φ₊) − M(φ₋) + A sin(φ₊ + α) − A sin(φ₋ + α) touches R there and lies below
/// it everywhere (a range is at least the difference of any two of its values).
template <typename Scalar>
Cut<Scalar> range_cut(const BasicCycleExtrema<Scalar>& extrema, const Scalar& alpha);

/// The global minimum of the range over α by minimise_over_angle(). Made for double and for Real50.
/// @param within  the angles to choose from, one stretch at least; default: all
template <typename Scalar>
BasicBestRange<Scalar> minimise_range(const BasicCycleExtrema<Scalar>& extrema,
                                      const std::vector<AngleStretch>& within = whole_turn());

}  // namespace ravnoves::balance_shaft
