#pragma once

#include <QFile>
#include <QRegularExpression>
#include <QString>
#include <filesystem>

namespace ravnoves {

/// A path of Qt's as core takes it.
inline std::filesystem::path fsPath(const QString& path) {
    return {QFile::encodeName(path).toStdString()};
}

/// What a job is called as the name of a file on any system: letters, digits and - stay,
/// "ЗМЗ-53 № 1234/56" is "ЗМЗ-53_1234_56". Empty where nothing stays.
inline QString asFileName(const QString& text) {
    static const QRegularExpression other(QStringLiteral("[^\\p{L}\\p{N}-]+"));
    constexpr qsizetype maximum = 60;  // a system counts bytes, 255 at most
    QString name = text.trimmed().replace(other, QStringLiteral("_")).left(maximum);
    static const QRegularExpression around(QStringLiteral("^[_-]+|[_-]+$"));
    return name.remove(around);
}

}  // namespace ravnoves
