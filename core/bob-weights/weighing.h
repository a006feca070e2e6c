#pragma once

#include <optional>

#include "bob-weights/input.h"
#include "bob-weights/result.h"

namespace ravnoves::bob_weights {

/// What a scale leaves uncertain of the bob weights.
struct Weighing {
    double bob_weight;  ///< ±, 19 of 20 times within it, kg
    /// Up to this crank radius the unbalance that follows on a crankpin is no more than a third of
    /// the smaller plane's limit, m; nothing where no limit is known.
    std::optional<double> largest_radius;
};

/// How far weights read to the scale's readability d make a bob weight uncertain.
///
/// A reading is rounded: its error is uniform within ±d/2, of the variance d²/12, and independent
/// of the others. Each part that is weighed goes into the bob weight as its factor c times the mean
/// of n readings (of a column of the weigh-in sheet; else n = 1), and the finished bob weight is
/// weighed once more before it is hung on the pin; the oil is not weighed:
///
///     u² = d²/12 (1 + Σ c²/n),  U = 2 u
///
/// @param resolution d, kg, > 0
/// @return nothing while the bob weight is not known
std::optional<Weighing> weighing(const Input& input, const Result& result, double resolution);

}  // namespace ravnoves::bob_weights
