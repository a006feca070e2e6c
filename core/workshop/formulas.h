#pragma once

#include <span>
#include <vector>

#include "bibliography/formula.h"
#include "workshop/input.h"

namespace ravnoves::workshop {

/// Formulas of the plugs, if any, and of bob weight and correction.
std::vector<Formula> formulas(const Input& input);
/// What the models leave out.
std::span<const Text> left_out();

}  // namespace ravnoves::workshop
