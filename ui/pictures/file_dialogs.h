#pragma once

#include <QList>
#include <QString>
#include <functional>

class QWidget;

namespace ravnoves {

/// What a file can be written as.
struct FileFormat {
    QString suffix;  ///< without the dot; may have one inside ("case.json")
    QString name;    ///< "PNG picture"
};

/// Prompts for a name: QFileDialog, in whose place a test puts its answers. All return an empty
/// text after Cancel.
struct FileChoosers {
    /// @param filter  of `filters`, separated by ";;", the one that is chosen
    std::function<QString(QWidget* parent, const QString& title, const QString& suggestion,
                          const QString& filters, QString* filter)>
        save;
    std::function<QString(QWidget* parent, const QString& title, const QString& folder,
                          const QString& filters)>
        open;
};
FileChoosers& fileChoosers();

/// A name as it was typed with the format chosen in the dialog: the typed suffix decides, without
/// one the format's is added.
/// @return an empty text for a suffix that no format has
QString completedPath(const QString& typed, const QList<FileFormat>& formats, qsizetype chosen);

/// Asks where to save. The path ends in the suffix of its format; a suffix that no format has is
/// rejected with the reason, and a file that is there already is replaced only where the user says
/// so.
/// @param formats  the first is the usual one
/// @return an empty text where the user gives up
QString askSavePath(QWidget* parent, const QString& title, const QString& suggestion,
                    const QList<FileFormat>& formats);
/// Asks where to save, and writes there.
/// @param write  returns an empty text, or the error to show
/// @return the path of the written file, or an empty text
QString saveFile(QWidget* parent, const QString& title, const QString& suggestion,
                 const QList<FileFormat>& formats,
                 const std::function<QString(const QString& path)>& write);
/// Prompts for a file to read.
QString askOpenPath(QWidget* parent, const QString& title, const QString& folder,
                    const QString& filters);

/// What tables of numbers are read from, as filters of askOpenPath().
QString tablesFilter();

// Formats that more than one page writes.
FileFormat csvFormat();
FileFormat dxfFormat();
FileFormat pdfFormat();
QList<FileFormat> pictureFormats();

}  // namespace ravnoves
