#pragma once

#include <optional>
#include <span>

#include "workshop/weigh_in.h"

namespace ravnoves::workshop {

/// A mass that was typed in kilograms, as it seems: the first of these that is less than any such
/// part of a car or truck weighs (a piston of 0.5 g is no piston), or a hundredth of the nominal
/// mass or less, or of which that is a hundredth. Nothing where there is none; 0 is no mass.
std::optional<double> mass_in_kilograms(Part part, const std::optional<double>& nominal,
                                        std::span<const Weighed> masses);

}  // namespace ravnoves::workshop
