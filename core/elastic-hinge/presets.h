#pragma once

#include <vector>

#include "case-file/preset.h"
#include "elastic-hinge/input.h"

namespace ravnoves::elastic_hinge {

/// The paper's mechanism: P₁ 5, P₂ 6.5, P₃ 6 N, g 9.82 m/s², r 50 mm, λ 0.3, ω 100 rad/s,
/// c 2·10⁷ N/m, ℓ₀ 200 mm, ρ₀ 90 mm.
Input preset_zotov();

std::vector<Preset<Input>> presets();

}  // namespace ravnoves::elastic_hinge
