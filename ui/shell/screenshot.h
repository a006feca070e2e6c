#pragma once

#include <QString>

namespace ravnoves {

class MainWindow;

/// Applies "key=value" to the page in front (SceneModel::setByKey), or brings a tab
/// to the front ("tab=torque-table").
/// @return an empty string, or what is wrong
QString applySetting(MainWindow& window, const QString& pair);

/// Renders the window at a size ("1280x800") to a PNG file.
/// @return an empty string, or what is wrong
QString writeScreenshot(MainWindow& window, const QString& path, const QString& size);

}  // namespace ravnoves
