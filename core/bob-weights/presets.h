#pragma once

#include <vector>

#include "bob-weights/input.h"
#include "case-file/preset.h"

namespace ravnoves::bob_weights {

/// Engines to begin with; their masses are to be weighed.
std::vector<Preset<Input>> presets();

}  // namespace ravnoves::bob_weights
