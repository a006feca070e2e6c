#pragma once

#include <vector>

#include "case-file/preset.h"
#include "workshop/input.h"

namespace ravnoves::workshop {

/// The engines of the scenes v8-plugs and bob-weights as jobs.
std::vector<Preset<Input>> presets();

}  // namespace ravnoves::workshop
