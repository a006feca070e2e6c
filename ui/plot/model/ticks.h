#pragma once

#include <QLocale>
#include <QString>
#include <utility>
#include <vector>

namespace ravnoves {

/// The distance between ticks that a person would choose: 1, 2, 2.5 or 5 times a power of ten, so
/// that about `wanted` fit into the span.
/// @param span  > 0
/// @param degrees  1, 2, 5, 10, 15, 30, 45, 60, 90, 120, 180
double niceStep(double span, int wanted, bool degrees = false);

/// The same, but with two ticks or more from low to high where
/// the first choice would leave one or none: one number says nothing of the scale.
/// @param low, high  low < high
double readableStep(double low, double high, int wanted, bool degrees);

/// The smallest interval of whole ticks around [min, max]; widened where it is empty.
std::pair<double, double> niceInterval(double min, double max, int wanted);

/// Decimals that a tick label needs to tell neighbouring ticks apart.
int tickDecimals(double step);

/// Ticks of a logarithmic axis, about `wanted` at most: at whole decades; with few decades also 2
/// and 5 of each; within one decade as on a linear axis.
/// @param low, high  0 < low < high
std::vector<double> logarithmicTicks(double low, double high, int wanted);

/// A number as science writes it: "10⁻⁹", "2·10⁻⁹", "1.25·10¹²"; plain from 0.001 to 9999 where it
/// is no power of ten.
QString powerText(double value, const QLocale& locale, int significant = 3);

}  // namespace ravnoves
