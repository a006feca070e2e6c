#pragma once

#include <functional>
#include <vector>

#include "page/scene_names.h"

class QWidget;

namespace ravnoves {

class ScenePage;
class SceneModel;

/// A scene and its page.
struct SceneInfo : SceneName {
    std::function<ScenePage*(QWidget* parent, SceneModel* kept)> maker;

    /// Makes the page, over the model that a page before it has left, or over a new one.
    ScenePage* make(QWidget* parent, SceneModel* kept = nullptr) const;
};

/// All scenes in the order of the navigation, as in core's scenes.cpp.
std::vector<SceneInfo> sceneList();

}  // namespace ravnoves
