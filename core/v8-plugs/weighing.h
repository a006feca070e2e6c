#pragma once

#include <optional>

#include "v8-plugs/input.h"

namespace ravnoves::v8_plugs {

/// What a scale leaves uncertain of the bob weight of a crankpin.
struct Weighing {
    double bob_weight;  ///< ±, 19 of 20 times within it, kg
    double unbalance;   ///< the same on the crankpin's radius, kg·m
    bool enough;        ///< it is no more than a third of the tolerance
    double coarsest;    ///< the coarsest readability of 1, 2, 5, 10, … that is enough, kg
};

/// How far weights read to the scale's readability d make the bob weight uncertain.
///
/// A reading is rounded: its error is uniform within ±d/2, of the variance d²/12, and independent
/// of the others. Each column of the weigh-in sheet that counts goes into the bob weight as
/// c·(mean of eight), where c is what the method makes of a change of 1 of that part (1 for a
/// piston with its pin and rings, 2 for a shell, 2 + k_ш for a big end …), and the finished bob
/// weight is weighed once more before it is hung on the pin:
///
///     u² = d²/12 (1 + Σ c²/8),  U = 2 u,  U r on the crankpin
///
/// Drawing masses and typed changes are taken as exact. @param resolution d, kg, > 0
/// @return nothing while crank radius or k_ш are missing
std::optional<Weighing> weighing(const Input& input, double resolution);

}  // namespace ravnoves::v8_plugs
