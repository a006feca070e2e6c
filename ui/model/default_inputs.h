#pragma once

#include <string>
#include <vector>

#include "case-file/json_fwd.h"

namespace ravnoves {

class SceneModel;

/// Writes defaults into the model's input for numbers at these pointers below "input", so that they
/// can be varied. Given values are kept, and numbers without a default are not added.
void giveDefaults(const SceneModel& model, Json& input, const std::vector<std::string>& pointers);

}  // namespace ravnoves
