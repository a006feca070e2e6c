#pragma once

#include <QString>
#include <vector>

namespace ravnoves {

/// A scene as the navigation calls it.
struct SceneName {
    QString name;     ///< its word in case files, the name of its folders and of its help page
    QString title;    ///< in the navigation
    QString summary;  ///< one line: its purpose
};

/// All scenes in the order of the navigation.
std::vector<SceneName> sceneNames();
/// Title of the scene with this word; the word without a scene.
QString sceneTitle(const QString& name);

}  // namespace ravnoves
