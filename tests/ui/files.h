#pragma once

#include <gtest/gtest.h>

#include <QByteArray>
#include <QFile>

namespace ravnoves::test {

/// What is in a file; where it cannot be read, the test fails.
inline QByteArray contentOf(const QString& path) {
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
    return file.readAll();
}

/// Writes a file over what is there; where it cannot, the test fails.
inline void writeFile(const QString& path, const QByteArray& content) {
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::WriteOnly)) << path.toStdString();
    file.write(content);
}

}  // namespace ravnoves::test
