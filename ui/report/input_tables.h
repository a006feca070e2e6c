#pragma once

#include <vector>

#include "paper/paper.h"

namespace ravnoves {

class SceneModel;

/// What the case gives, as its file has it: the numbers of each object in one table with their
/// units, each list of objects in one of its own.
std::vector<paper::Table> inputTables(const SceneModel& model);

/// What the case leaves out and what represents it, each with the name that the form has for it;
/// without rows where it leaves out nothing.
paper::Table leftOut(const SceneModel& model);

}  // namespace ravnoves
