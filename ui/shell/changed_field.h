#pragma once

#include <functional>

namespace ravnoves {

class SceneModel;
class ScenePage;

/// Undoes or redoes on a page and shows the place: one of the changed fields is brought into view,
/// with its tab, and is focused if it was hidden or the focus was in a field. A visible one is
/// preferred to others, which may only follow from it.
void showWhatChanges(ScenePage& page, const std::function<void(SceneModel&)>& step);

}  // namespace ravnoves
