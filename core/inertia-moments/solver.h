#pragma once

#include <optional>
#include <vector>

#include "inertia-moments/input.h"
#include "inertia-moments/result.h"

namespace ravnoves::inertia_moments {

/// Solves the scene. Costs some tens of microseconds, a millisecond where rods are articulated, so
/// that every slider may call it.
/// @param with_curves  else they stay empty: two thirds of the time go there
/// @throws InputError as check_input()
Result solve(const Input& input, bool with_curves = true);

}  // namespace ravnoves::inertia_moments
