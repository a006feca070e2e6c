#pragma once

#include <QString>
#include <functional>
#include <string>

namespace ravnoves {

/// Writes what `make` makes as write_text_file() does: what was there stays whole when anything
/// fails.
/// @return empty, or the path and what went wrong with making or writing
QString writeFile(const QString& path, const std::function<std::string()>& make);

}  // namespace ravnoves
