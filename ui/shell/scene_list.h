#pragma once

#include <QString>
#include <functional>
#include <vector>

class QWidget;

namespace ravnoves {

class ScenePage;
class SceneModel;

/// A scene as the navigation shows it.
struct SceneInfo {
    QString name;     ///< its word in case files, the name of its folders and of its help page
    QString title;    ///< in the navigation
    QString summary;  ///< one line: what it is for
    std::function<ScenePage*(QWidget* parent, SceneModel* kept)> maker;

    /// Makes the page, over the model that a page before it has left, or over a new one.
    ScenePage* make(QWidget* parent, SceneModel* kept = nullptr) const {
        return maker(parent, kept);
    }
};

/// All scenes in the order of the navigation. To add a scene, add its line here and in core's
/// scenes.cpp.
std::vector<SceneInfo> sceneList();

}  // namespace ravnoves
