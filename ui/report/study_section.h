#pragma once

namespace ravnoves {

class Patience;
class SceneModel;
struct Report;

/// The tolerances of a case and what they do to the results that it watches; nothing where it has
/// none. The study is computed now, as far as it gets in a minute.
void addTolerances(Report& report, SceneModel& model, const Patience& patience);

}  // namespace ravnoves
