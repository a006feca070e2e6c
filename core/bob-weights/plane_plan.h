#pragma once

#include <complex>
#include <optional>

#include "bob-weights/input.h"
#include "bob-weights/result.h"

/// Drilling and slugs that correct one plane.
namespace ravnoves::bob_weights {

/// What the metal of a plane adds to its unbalance.
std::complex<double> effect_of(const Metal& metal);

/// Whether two holes of a plane are one: an angle that was measured is not quite the one planned,
/// and no drill runs far beside the hole that it deepens.
bool are_one_hole(const Hole& a, const Hole& b, double radius);

/// Why there is no room, as a sentence.
Message describe(NoRoom missing, double maximum_depth);

/// Whether a hole that somebody thinks of has room by the rules of the plan, but for the steps of
/// its depth and the smallest one.
struct TriedRoom {
    NoRoom missing;
    double maximum_depth;  ///< m
    double from_depth;     ///< of the hole there that it deepens, m; 0 for a new one
    double angle;          ///< of the hole there, else its own, rad
};
/// @param before  as below
TriedRoom room_for(const Hole& hole, const Plane& plane, const Correction& correction,
                   const Metal& before);

/// Plans the holes, and slugs where they have no room.
/// @param before  metal drilled there and pressed in after earlier runs
PlaneResult plan_plane(std::complex<double> unbalance, const Plane& plane,
                       const Correction& correction, const std::optional<double>& permissible,
                       const Metal& before);

}  // namespace ravnoves::bob_weights
