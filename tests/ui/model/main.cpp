#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QTemporaryDir>

/// The models know no widgets: an application without them, with settings and with copies kept for
/// a crash that are of this process alone and vanish afterwards.
int main(int argc, char** argv) {
    const QTemporaryDir home;
    qputenv("XDG_DATA_HOME", home.filePath(QStringLiteral("data")).toLocal8Bit());
    qputenv("XDG_CONFIG_HOME", home.filePath(QStringLiteral("config")).toLocal8Bit());
    const QCoreApplication app(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("Ravnoves"));
    QCoreApplication::setOrganizationName(QStringLiteral("Ravnoves"));
    ::testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
