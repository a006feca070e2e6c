#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "case-file/message.h"
#include "inertia-moments/input.h"

namespace ravnoves::inertia_moments {

/// A throw of the crank: one crankpin with the rods that run on it.
struct Throw {
    std::vector<std::size_t> cylinders;  ///< indices in the table, from the front to the rear
    double position = 0.0;               ///< mean axial position of its rods, m
    double crankpin_angle = 0.0;         ///< κ, rad
};

/// "1, 4" of indices.
std::string numbers_of(std::span<const std::size_t> cylinders);

/// The throws, from the front to the rear. Rods share a crankpin where it is at the same angle for
/// both, their cylinders are in different directions, and they are less than the crank radius apart
/// along the crank (0 where they are forked, else the width of a big end).
std::vector<Throw> crank_throws(std::span<const Cylinder> cylinders, double crank_radius);

/// The number of rods on every throw; nothing where throws differ in it.
std::optional<std::size_t> rods_per_throw(std::span<const Throw> throws);

/// By each number of rods, from the fewest to the most, the first throw with it.
std::map<std::size_t, const Throw*> kinds_of_throw(std::span<const Throw> throws);

/// What the model leaves out of a radial: three rods or more cannot run on one pin in one plane, so
/// all but one of them hang on the master rod. One sentence for each throw where none of them is
/// given as articulated.
std::vector<Message> articulated_rod_notes(std::span<const Throw> throws,
                                           std::span<const Cylinder> cylinders,
                                           double crank_radius);

}  // namespace ravnoves::inertia_moments
