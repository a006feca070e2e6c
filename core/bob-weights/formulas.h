#pragma once

#include <vector>

#include "bibliography/formula.h"
#include "bob-weights/input.h"

namespace ravnoves::bob_weights {

/// The formulas that the result of this input rests on, in the order of the computation.
std::vector<Formula> formulas(const Input& input);

}  // namespace ravnoves::bob_weights
