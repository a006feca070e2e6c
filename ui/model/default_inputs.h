#pragma once

#include <string>
#include <vector>

#include "case-file/json_fwd.h"

namespace ravnoves {

class SceneModel;

/// Writes into the model's input what it leaves to its default, for numbers at these pointers below
/// "input": so that they can be varied. What is there stays, and what has no default is not added.
void giveDefaults(const SceneModel& model, Json& input, const std::vector<std::string>& pointers);

}  // namespace ravnoves
