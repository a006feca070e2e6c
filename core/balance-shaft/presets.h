#pragma once

#include <vector>

#include "balance-shaft/input.h"
#include "case-file/preset.h"

namespace ravnoves::balance_shaft {

/// The TMZ-650D diesel of the paper: Tables 1 and 2 at 376.8 rad/s, α = 45°. l = 100.15 mm follows
/// from the printed amplitude; the torque at 555° is +30 N·m as printed.
Input preset_tmz_650d();

std::vector<Preset<Input>> presets();

}  // namespace ravnoves::balance_shaft
