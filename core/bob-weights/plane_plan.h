#pragma once

#include <complex>
#include <optional>

#include "bob-weights/input.h"
#include "bob-weights/result.h"

/// Drilling and slugs that correct one plane.
namespace ravnoves::bob_weights {

/// What the metal of a plane adds to its unbalance.
std::complex<double> effect_of(const Metal& metal);

/// Whether two holes of a plane are one: an angle that was measured is not quite the one planned.
bool are_one_hole(const Hole& a, const Hole& b, double radius);

/// Plans the holes, and slugs where they have no room.
/// @param before  metal drilled there and pressed in after earlier runs
PlaneResult plan_plane(std::complex<double> unbalance, const Plane& plane,
                       const Correction& correction, const std::optional<double>& permissible,
                       const Metal& before);

}  // namespace ravnoves::bob_weights
