#pragma once

#include "v8-plugs/input.h"
#include "v8-plugs/result.h"

namespace ravnoves::v8_plugs {

/// Computes whatever the input allows.
Result solve(const Input& input);

}  // namespace ravnoves::v8_plugs
