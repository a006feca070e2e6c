#pragma once

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

/// The global minimum of the range R(α) = max − min of M(φ) + A sin(φ + α), by cutting planes.
///
/// Where the extrema at some α lie at φ₊ and φ₋, the function
/// h(α) = M(φ₊) − M(φ₋) + A sin(φ₊ + α) − A sin(φ₋ + α) touches R there and lies below it
/// everywhere (a range is at least the difference of any two of its values). Between two
/// evaluated angles the larger of their two sinusoids bounds R from below; the interval is split
/// at that bound's minimum until no bound lies under the best value. Kinks and several minima need
/// no care, since the bounds are global. Made for double and for Real50.
template <typename Scalar>
BasicBestRange<Scalar> minimise_range(const BasicCycleExtrema<Scalar>& extrema);

}  // namespace ravnoves::balance_shaft
