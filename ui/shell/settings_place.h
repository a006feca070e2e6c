#pragma once

#include <QString>

namespace ravnoves {

/// A thing in the place of the settings that is no file, a pipe for example: Qt would wait for it
/// before there is a window. Empty where they can be read, or are still to be written. To be called
/// before the first QSettings.
QString noFileForSettings();

/// That the settings are not read and not kept, in the language of the window.
QString noFileForSettingsText(const QString& path);

}  // namespace ravnoves
