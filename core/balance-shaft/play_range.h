#pragma once

#include "balance-shaft/cycle_extrema.h"

namespace ravnoves::balance_shaft {

/// Least and largest range of M_up + M_s over an interval of α.
struct PlayRange {
    double low = 0.0;   ///< N·m
    double high = 0.0;  ///< N·m
};

/// Both to rounding, by branch and bound. The range R(α) is the largest of sinusoids of amplitude
/// at most 2A. From below: every evaluated α gives one that lies under R everywhere (range_cut()),
/// the larger of two bounds R between their angles. From above: each has a second derivative of at
/// least −2A, so R(α) + A α² is convex and R lies at most A (α − a)(b − α) above its chord.
/// @param from  rad
/// @param to    rad, from ≤ to ≤ from + 2π
PlayRange play_range(const CycleExtrema& extrema, double from, double to);

}  // namespace ravnoves::balance_shaft
