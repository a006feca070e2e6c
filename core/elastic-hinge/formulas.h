#pragma once

#include <span>
#include <vector>

#include "bibliography/formula.h"
#include "elastic-hinge/input.h"

namespace ravnoves::elastic_hinge {

/// The formulas that the result of this input rests on, in the order of the computation.
std::vector<Formula> formulas(const Input& input);

/// What the model leaves out, a sentence each.
std::span<const Text> left_out();

}  // namespace ravnoves::elastic_hinge
