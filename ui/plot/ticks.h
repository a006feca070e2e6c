#pragma once

#include <utility>

namespace ravnoves {

/// The distance between ticks that a person would choose: 1, 2, 2.5 or 5 times a power of ten, so
/// that about `wanted` fit into the span.
/// @param span  > 0
double niceStep(double span, int wanted);

/// The same for degrees: 1, 2, 5, 10, 15, 30, 45, 60, 90, 120, 180.
double niceAngleStep(double span, int wanted);

/// The smallest interval of whole ticks that holds [min, max]; widened where it is empty.
std::pair<double, double> niceInterval(double min, double max, int wanted);

/// Decimals that a tick label needs to tell neighbouring ticks apart.
int tickDecimals(double step);

}  // namespace ravnoves
