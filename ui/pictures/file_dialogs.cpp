#include "pictures/file_dialogs.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QMimeDatabase>
#include <QSettings>
#include <algorithm>

#include "model/case_document.h"
#include "text/plain_title.h"

namespace ravnoves {

/// Its words.
struct FileDialogs {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::FileDialogs)
};

namespace {

const QString folderKey = QStringLiteral("files/folder");

bool endsIn(const QString& path, const QString& suffix) {
    return path.endsWith(QLatin1Char('.') + suffix, Qt::CaseInsensitive);
}

/// A suffix that means something: that of "plot.jpg", not that of "engine 4.25" or "first.try".
bool hasMeaning(const QString& path) {
    const QString suffix = QFileInfo(path).suffix();
    return !suffix.isEmpty() && suffix.front().isLetter() &&
           !QMimeDatabase().mimeTypeForFile(path, QMimeDatabase::MatchExtension).isDefault();
}

}  // namespace

FileChoosers& fileChoosers() {
    static FileChoosers choosers{
        [](QWidget* parent, const QString& title, const QString& suggestion, const QString& filters,
           QString* filter) {
            // The question of overwriting comes when the suffix is known.
            return QFileDialog::getSaveFileName(parent, title, suggestion, filters, filter,
                                                QFileDialog::DontConfirmOverwrite);
        },
        [](QWidget* parent, const QString& title, const QString& folder, const QString& filters) {
            return QFileDialog::getOpenFileName(parent, title, folder, filters);
        }};
    return choosers;
}

QString completedPath(const QString& typed, const QList<FileFormat>& formats, qsizetype chosen) {
    for (const FileFormat& format : formats) {
        // What ends a long suffix is as good: "x.json" for "case.json".
        if (endsIn(typed, format.suffix.section(QLatin1Char('.'), -1))) {
            return typed;
        }
    }
    return hasMeaning(typed) ? QString() : typed + QLatin1Char('.') + formats[chosen].suffix;
}

QString askSavePath(QWidget* parent, const QString& title, const QString& suggestion,
                    const QList<FileFormat>& formats) {
    QStringList filters;
    QStringList suffixes;
    for (const FileFormat& format : formats) {
        filters << QStringLiteral("%1 (*.%2)").arg(format.name, format.suffix);
        suffixes << QLatin1Char('.') + format.suffix;
    }
    QString shown = QFileInfo(suggestion).isAbsolute()
                        ? suggestion
                        : QDir(QSettings().value(folderKey).toString()).filePath(suggestion);
    if (formats.size() > 1 && endsIn(shown, formats.front().suffix)) {
        shown.chop(suffixes.front().size());  // that of the format chosen is added
    }
    QString filter = filters.front();
    while (true) {
        const QString typed =
            fileChoosers().save(parent, title, shown, filters.join(QLatin1String(";;")), &filter);
        if (typed.isEmpty()) {
            return {};
        }
        shown = typed;
        QString path =
            completedPath(typed, formats, std::max<qsizetype>(filters.indexOf(filter), 0));
        if (path.isEmpty()) {
            QMessageBox::warning(parent, title,
                                 FileDialogs::tr("“%1” cannot be written as .%2. Possible: %3.")
                                     .arg(QFileInfo(typed).fileName(), QFileInfo(typed).suffix(),
                                          suffixes.join(QLatin1String(", "))));
            continue;
        }
        // A case that is saved takes the place of a case.
        const bool isCase = formats.front().suffix == QLatin1String("case.json");
        const QString trouble = isCase ? QString() : sourceTrouble(path);
        if (!trouble.isEmpty()) {
            QMessageBox::warning(parent, title, trouble);
            continue;
        }
        const bool replaces = QFileInfo::exists(path);
        if (replaces &&
            QMessageBox::question(
                parent, title,
                FileDialogs::tr("“%1” already exists. Replace it?").arg(QFileInfo(path).fileName()),
                QMessageBox::Yes | QMessageBox::No, QMessageBox::No) != QMessageBox::Yes) {
            continue;
        }
        QSettings().setValue(folderKey, QFileInfo(path).absolutePath());
        return path;
    }
}

QString saveFile(QWidget* parent, const QString& title, const QString& suggestion,
                 const QList<FileFormat>& formats,
                 const std::function<QString(const QString& path)>& write) {
    const QString path = askSavePath(parent, title, suggestion, formats);
    const QString trouble = path.isEmpty() ? QString() : write(path);
    if (!trouble.isEmpty()) {
        QMessageBox::warning(parent, title, trouble);
    }
    return trouble.isEmpty() ? path : QString();
}

QString askOpenPath(QWidget* parent, const QString& title, const QString& folder,
                    const QString& filters) {
    return fileChoosers().open(parent, plainTitle(title),
                               folder.isEmpty() ? QSettings().value(folderKey).toString() : folder,
                               filters);
}

QString tablesFilter() {
    return FileDialogs::tr("Tables (*.csv *.txt *.tsv);;All files (*)");
}

FileFormat csvFormat() {
    return {QStringLiteral("csv"), FileDialogs::tr("Table, CSV")};
}

FileFormat dxfFormat() {
    return {QStringLiteral("dxf"), FileDialogs::tr("Drawing, DXF")};
}

FileFormat pdfFormat() {
    return {QStringLiteral("pdf"), FileDialogs::tr("PDF")};
}

QList<FileFormat> pictureFormats() {
    return {{QStringLiteral("png"), FileDialogs::tr("Picture, PNG")},
            {QStringLiteral("svg"), FileDialogs::tr("Drawing, SVG")},
            pdfFormat()};
}

}  // namespace ravnoves
