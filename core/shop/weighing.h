#pragma once

#include <cmath>
#include <optional>

#include "case-file/decimal.h"
#include "numerics/demand.h"
#include "numerics/units.h"

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
    double coarsest(double radius) const {
        return round_step(resolution * *largest_radius / radius / units::gram) * units::gram;
    }
};

/// @param squares  Σ c²/n
/// @param limit    kg·m
inline Weighing weighing(double resolution, double squares, const std::optional<double>& limit) {
    RAVNOVES_DEMAND(resolution > 0.0, "a scale has a last digit");
    Weighing found{resolution, 2.0 * resolution * std::sqrt((1.0 + squares) / 12.0), std::nullopt};
    if (limit) {
        constexpr double share = 1.0 / 3.0;  // that the scale may use up
        found.largest_radius = share * *limit / found.bob_weight;
    }
    return found;
}

}  // namespace ravnoves::shop
