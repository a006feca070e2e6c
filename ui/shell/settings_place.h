#pragma once

#include <QString>

namespace ravnoves {

/// What is in the place of the settings without being a file, a pipe for example: Qt would wait
/// for it before there is a window. Empty where they can be read, or are still to be written. To be
/// asked before the first QSettings.
QString noFileForSettings();

/// That the settings are not read and not kept, in the language of the window.
QString noFileForSettingsText(const QString& path);

}  // namespace ravnoves
