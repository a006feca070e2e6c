#include "shell/settings_place.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QStandardPaths>

#include "case-file/input_error.h"
#include "case-file/text_file.h"
#include "text/file_path.h"

namespace ravnoves {

QString noFileForSettings() {
    const QString folder =
        QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation) + QLatin1Char('/');
    const QString organization = QCoreApplication::organizationName();
    const QString own = organization + QLatin1Char('/') + QCoreApplication::applicationName();
    for (const QString& name : {own, organization}) {
        const QString place = folder + name + QStringLiteral(".conf");
        try {
            if (QFileInfo::exists(place)) {
                read_text_file(fsPath(place));
            }
        } catch (const InputError&) {
            return place;
        }
    }
    return {};
}

QString noFileForSettingsText(const QString& path) {
    return QCoreApplication::translate("Settings", "Settings are not saved: %1 is not a file")
        .arg(path);
}

}  // namespace ravnoves
