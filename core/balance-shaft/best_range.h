#pragma once

#include "balance-shaft/cycle_extrema.h"

namespace ravnoves::balance_shaft {

/// The least range over α and what is known of the others.
struct BestRange {
    double shaft_angle = 0.0;  ///< rad, 0…2π
    double range = 0.0;        ///< N·m
    double worst = 0.0;        ///< N·m, the largest range met on the way
    double gap = 0.0;          ///< N·m: no α has a range below range − gap
    int evaluations = 0;
};

/// The global minimum of the range R(α) = max − min of M(φ) + A sin(φ + α), by cutting planes.
///
/// Where the extrema at some α lie at φ₊ and φ₋, the function
/// h(α) = M(φ₊) − M(φ₋) + A sin(φ₊ + α) − A sin(φ₋ + α) touches R there and lies below it
/// everywhere (a range is at least the difference of any two of its values). Between two
/// evaluated angles the larger of their two sinusoids bounds R from below; the interval is split
/// at that bound's minimum until no bound lies under the best value. Kinks and several minima need
/// no care, since the bounds are global.
BestRange minimise_range(const CycleExtrema& extrema);

}  // namespace ravnoves::balance_shaft
