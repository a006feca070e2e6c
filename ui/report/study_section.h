#pragma once

namespace ravnoves {

class Patience;
class SceneModel;
struct Paper;

/// The tolerances of a case and their effect on the watched results; nothing where it has none. The
/// study is computed now, within a minute.
void addTolerances(Paper& report, SceneModel& model, const Patience& patience);

}  // namespace ravnoves
