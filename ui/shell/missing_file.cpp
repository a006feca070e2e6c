#include "shell/missing_file.h"

#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "model/case_document.h"
#include "pictures/file_dialogs.h"
#include "text/error_text.h"

namespace ravnoves {

namespace {

/// @return an empty text where the user gives up
QString askWhere(QWidget* over, const QString& title, const QString& trouble, const QString& name,
                 const QString& folder) {
    QMessageBox box(QMessageBox::Warning, title, trouble, QMessageBox::Cancel, over);
    const QPushButton* locate =
        box.addButton(MissingFile::tr("&Locate file…"), QMessageBox::AcceptRole);
    box.exec();
    return box.clickedButton() == locate
               ? askOpenPath(over, MissingFile::tr("Where is %1?").arg(name), folder,
                             tablesFilter())
               : QString();
}

}  // namespace

bool MissingFile::locate(QWidget* over, const QString& title, const QString& name,
                         const QString& folder, CaseFile& file, const std::function<void()>& load) {
    std::string where;  // in the case
    QString missing;    // as the case has it
    while (true) {
        try {
            load();
            return true;
        } catch (const InputError& error) {
            Json* const named = CaseDocument::fileNamedAt(file, error);
            if (named == nullptr) {
                throw;
            }
            QString trouble = name + QStringLiteral(": ") + errorText(error);
            if (where == error.where()) {
                trouble = tr("The file selected for %1 is not suitable.").arg(missing) +
                          QStringLiteral("\n\n") + trouble;
            } else {
                where = error.where();
                missing = QFileInfo(QString::fromStdString(named->get<std::string>())).fileName();
            }
            // What the case names is looked for, whatever was chosen for it.
            const QString found = askWhere(over, title, trouble, missing, folder);
            if (found.isEmpty()) {
                return false;
            }
            *named = QFileInfo(found).absoluteFilePath().toStdString();
        }
    }
}

}  // namespace ravnoves
