#pragma once

#include <QString>
#include <functional>
#include <string>

namespace ravnoves {

/// Writes the text of `make` as write_text_file() does: the old file remains whole when anything
/// fails.
/// @return empty, or the path and the fault
QString writeFile(const QString& path, const std::function<std::string()>& make);

}  // namespace ravnoves
