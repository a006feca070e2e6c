#pragma once

#include "v8-plugs/input.h"
#include "v8-plugs/result.h"

namespace ravnoves::v8_plugs {

/// Computes whatever the input allows.
/// @param changes_known  false: nothing that rests on the mass changes; a case counts those that it
///                       does not give as 0
Result solve(const Input& input, bool changes_known = true);

}  // namespace ravnoves::v8_plugs
