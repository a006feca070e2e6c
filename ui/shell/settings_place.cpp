#include "shell/settings_place.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QStandardPaths>

namespace ravnoves {

QString noFileForSettings() {
    const QString folder =
        QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation) + QLatin1Char('/');
    const QString organization = QCoreApplication::organizationName();
    const QString own = organization + QLatin1Char('/') + QCoreApplication::applicationName();
    for (const QString& name : {own, organization}) {
        const QFileInfo place(folder + name + QStringLiteral(".conf"));
        if (place.exists() && !place.isFile()) {
            return place.filePath();
        }
    }
    return {};
}

QString noFileForSettingsText(const QString& path) {
    return QCoreApplication::translate("Settings", "The settings are not kept: %1 is not a file")
        .arg(path);
}

}  // namespace ravnoves
