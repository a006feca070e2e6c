#pragma once

#include <vector>

#include "bibliography/formula.h"
#include "v8-plugs/input.h"

namespace ravnoves::v8_plugs {

/// The formulas that the result of this input rests on, in the order of the computation.
std::vector<Formula> formulas(const Input& input);

}  // namespace ravnoves::v8_plugs
