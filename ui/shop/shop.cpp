#include "shop/shop.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>
#include <new>

#include "case-file/input_error.h"
#include "case-file/text_file.h"
#include "text/file_path.h"
#include "text/write_file.h"

namespace ravnoves {

namespace {

const QString shopName = QStringLiteral("workshop/shop-name");
const QString shopLogo = QStringLiteral("workshop/shop-logo");

QDir shopFolder() {
    return {QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)};
}

}  // namespace

QImage Shop::read(const QString& file) {
    try {
        return file.isEmpty()
                   ? QImage()
                   : QImage::fromData(QByteArray::fromStdString(read_text_file(fsPath(file))));
    } catch (const InputError&) {
        return {};
    } catch (const std::bad_alloc&) {
        return {};
    }
}

Shop Shop::kept() {
    const QSettings settings;
    return {settings.value(shopName).toString(), settings.value(shopLogo).toString()};
}

QString Shop::keep() const {
    QSettings settings;
    settings.setValue(shopName, name);
    const QDir folder = shopFolder();
    const QFileInfo chosen(logo);
    QString own = logo;
    QString trouble;
    if (!logo.isEmpty() && chosen.absolutePath() != folder.absolutePath()) {
        own = folder.filePath(QStringLiteral("shop-logo.") + chosen.suffix().toLower());
        trouble = this->trouble();
        if (trouble.isEmpty() && QDir().mkpath(folder.path())) {
            trouble = writeFile(own, [&] { return read_text_file(fsPath(logo)); });
        }
        own = trouble.isEmpty() ? own : logo;
    }
    settings.setValue(shopLogo, own);
    for (const QFileInfo& each :
         folder.entryInfoList({QStringLiteral("shop-logo.*")}, QDir::Files)) {
        if (each.filePath() != own) {
            QFile::remove(each.filePath());
        }
    }
    return trouble;
}

QString Shop::trouble() const {
    return logo.isEmpty() || !read(logo).isNull()
               ? QString()
               : QCoreApplication::translate(
                     "ravnoves::JobCard",
                     "The card has no logo, because the file cannot be read: %1")
                     .arg(QDir::toNativeSeparators(logo));
}

}  // namespace ravnoves
