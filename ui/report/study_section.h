#pragma once

namespace ravnoves {

class Patience;
class SceneModel;
struct Report;

/// The tolerances of a case and their effect on the watched results; nothing where it has none. The
/// study is computed now, within a minute.
void addTolerances(Report& report, SceneModel& model, const Patience& patience);

}  // namespace ravnoves
