#pragma once

#include <QFile>
#include <QString>
#include <filesystem>

namespace ravnoves {

/// A path of Qt's as core takes it.
inline std::filesystem::path fsPath(const QString& path) {
    return {QFile::encodeName(path).toStdString()};
}

}  // namespace ravnoves
