#pragma once

#include <QString>

namespace ravnoves {

class SceneModel;

/// Which files a variant is of that have changed since it was kept, as a sentence; empty where none
/// has.
QString changedFilesText(const SceneModel& model, int variant);

}  // namespace ravnoves
