#pragma once

#include <QString>

namespace ravnoves {

class MainWindow;

/// Applies "key=value" to the page in front (SceneModel::setByKey), or brings a tab to the front
/// ("tab=torque-table").
/// @return an empty string, or the fault
QString applySetting(MainWindow& window, const QString& pair);

/// @param size  as "1280x800"
/// @return an empty string, or the fault
QString setWindowSize(MainWindow& window, const QString& size);

/// Renders the window to a PNG file.
/// @return an empty string, or the fault
QString writeScreenshot(MainWindow& window, const QString& path);

}  // namespace ravnoves
