#pragma once

#include <QString>
#include <functional>
#include <vector>

class QWidget;

namespace ravnoves {

class ScenePage;

/// A scene as the navigation shows it.
struct SceneInfo {
    QString name;     ///< its word in case files, the name of its folders and of its help page
    QString title;    ///< in the navigation
    QString summary;  ///< one line: what it is for
    /// Makes the page.
    std::function<ScenePage*(QWidget* parent)> make;
};

/// All scenes in the order of the navigation. To add a scene, add its line here and in core's
/// scenes.cpp.
std::vector<SceneInfo> sceneList();

}  // namespace ravnoves
