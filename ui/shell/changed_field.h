#pragma once

#include <functional>

namespace ravnoves {

class SceneModel;
class ScenePage;

/// Undoes or redoes on a page and shows where that was: of the fields that are others now one is
/// brought into view, with its tab, and gets the focus where that was hidden or in a field. One
/// that was in view goes before others, which may only follow from it.
void showWhatChanges(ScenePage& page, const std::function<void(SceneModel&)>& step);

}  // namespace ravnoves
