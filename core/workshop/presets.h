#pragma once

#include <vector>

#include "case-file/preset.h"
#include "workshop/input.h"

namespace ravnoves::workshop {

/// The engines of [nazarov] with their plugs, and others, whose masses are to be weighed.
std::vector<Preset<Input>> presets();

}  // namespace ravnoves::workshop
