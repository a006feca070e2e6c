#pragma once

#include <optional>

namespace ravnoves::shop {

/// Uncertainty of the bob weights by the scale.
///
/// A reading is rounded: its error is uniform within ±d/2, of the variance d²/12, and independent
/// of the others. Each weighed part is in the bob weight as its factor c times the mean of n
/// readings, and the finished bob weight is weighed once more before it is hung on the pin; the oil
/// is not weighed:
///
///     u² = d²/12 (1 + Σ c²/n),  U = 2 u
struct Weighing {
    double resolution;  ///< d, kg
    double bob_weight;  ///< U: ±, 19 of 20 times within it, kg
    /// Up to this crank radius the resulting unbalance on a crankpin is within a third of the
    /// limit, m; empty without a limit.
    std::optional<double> largest_radius;

    /// At a crank radius, m.
    bool is_enough(double radius) const { return radius <= *largest_radius * (1.0 + 1e-12); }
    /// The coarsest last digit of a scale that is enough there, kg.
    double coarsest(double radius) const;
};

/// @param squares  Σ c²/n
/// @param limit    kg·m
Weighing weighing(double resolution, double squares, const std::optional<double>& limit);

}  // namespace ravnoves::shop
