#include "shell/missing_file.h"

#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "model/case_document.h"
#include "pictures/file_dialogs.h"

namespace ravnoves {

std::optional<bool> MissingFile::locate(CaseFile& file, const InputError& error,
                                        const QString& trouble) {
    Json* const named = CaseDocument::fileNamedAt(file, error);
    if (named == nullptr) {
        return std::nullopt;
    }
    const bool isSecond = where_ == error.where();
    if (!isSecond) {
        where_ = error.where();
        name_ = QString::fromStdString(named->get<std::string>());
    }
    // What the case names is looked for, whatever was chosen for it.
    const QString found =
        ask(isSecond
                ? tr("The file selected for %1 is not suitable.").arg(QFileInfo(name_).fileName()) +
                      QStringLiteral("\n\n") + trouble
                : trouble);
    if (!found.isEmpty()) {
        *named = QFileInfo(found).absoluteFilePath().toStdString();
    }
    return !found.isEmpty();
}

QString MissingFile::ask(const QString& trouble) const {
    QMessageBox box(QMessageBox::Warning, title_, trouble, QMessageBox::Cancel, over_);
    const QPushButton* locate = box.addButton(tr("&Locate file…"), QMessageBox::AcceptRole);
    box.exec();
    return box.clickedButton() == locate
               ? askOpenPath(over_, tr("Where is %1?").arg(QFileInfo(name_).fileName()), folder_,
                             tablesFilter())
               : QString();
}

}  // namespace ravnoves
