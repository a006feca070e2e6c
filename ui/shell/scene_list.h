#pragma once

#include <QString>
#include <vector>

class QWidget;

namespace ravnoves {

class ScenePage;
class SceneModel;

/// A scene and its page.
struct SceneInfo {
    QString name;     ///< its word in case files, the name of its folders and of its help page
    QString title;    ///< in the navigation
    QString summary;  ///< one line: its purpose
    /// Makes the page, over the model that a page before it has left; null: over a new one.
    ScenePage* (*make)(QWidget* parent, SceneModel* kept);
};

/// All scenes in the order of the navigation, as in core's scenes.cpp.
std::vector<SceneInfo> sceneList();

}  // namespace ravnoves
