#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QTemporaryDir>

/// The models know no widgets: an application without them, with settings that vanish afterwards.
int main(int argc, char** argv) {
    const QTemporaryDir home;
    qputenv("XDG_CONFIG_HOME", home.path().toLocal8Bit());
    const QCoreApplication app(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("Ravnoves"));
    QCoreApplication::setOrganizationName(QStringLiteral("Ravnoves"));
    ::testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
