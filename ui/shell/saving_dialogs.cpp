#include "shell/saving_dialogs.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPushButton>

#include "page/rejected_entries.h"
#include "page/scene_page.h"
#include "pictures/file_dialogs.h"
#include "shell/documents.h"

namespace ravnoves {

struct SavingDialogs {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::SavingDialogs)
};

DocumentDialogs savingDialogs(Documents& documents, OpenDocument& document) {
    using Answer = DocumentDialogs::Answer;
    using Instead = DocumentDialogs::Instead;
    DocumentDialogs dialogs;
    dialogs.saveChanges = [&](bool hasFile) {
        documents.bringToFront(document);
        // A case that came from a file goes back to it.
        if (const auto answer = hasFile ? std::nullopt : document.page->askToSave()) {
            return *answer ? Answer::Discard : Answer::Stay;
        }
        const QString scene = documents.scenes()[document.scene].title;
        const QString name = documents.nameOf(document);
        QMessageBox box(QMessageBox::Question, SavingDialogs::tr("Unsaved changes"),
                        SavingDialogs::tr("Save the changes of “%1”?")
                            .arg(name == scene ? scene : name + QStringLiteral(" – ") + scene),
                        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel,
                        documents.window());
        box.setDefaultButton(QMessageBox::Save);
        box.button(QMessageBox::Discard)->setText(SavingDialogs::tr("Do&n’t save"));
        const int answer = box.exec();
        return answer == QMessageBox::Save      ? Answer::Save
               : answer == QMessageBox::Discard ? Answer::Discard
                                                : Answer::Stay;
    };
    dialogs.saveInPlace = [&] { return document.page->saveInPlace(); };
    dialogs.choosePath = [&](const QString& suggestion) -> QString {
        QString path =
            askSavePath(documents.window(), SavingDialogs::tr("Save case"), suggestion,
                        {{QStringLiteral("case.json"), SavingDialogs::tr("Ravnoves case")}});
        const OpenDocument* other = path.isEmpty() ? nullptr : documents.withFile(path);
        if (other != nullptr && other != &document) {
            QMessageBox::warning(
                documents.window(), SavingDialogs::tr("Save case"),
                SavingDialogs::tr(
                    "%1 is open in another tab. Close that tab first, or choose another name.")
                    .arg(path));
            return {};
        }
        return path;
    };
    dialogs.instead = [&](const QString& path, const QString& trouble) {
        const bool isChanged = trouble.isEmpty();
        QMessageBox box(QMessageBox::Warning, SavingDialogs::tr("Save case"),
                        isChanged
                            ? SavingDialogs::tr(
                                  "%1 was changed by another program since it was opened or saved "
                                  "here. Overwrite it?")
                                  .arg(path)
                            : trouble,
                        QMessageBox::Cancel, documents.window());
        if (isChanged) {
            box.addButton(SavingDialogs::tr("&Overwrite"), QMessageBox::DestructiveRole);
        }
        box.setDefaultButton(box.addButton(SavingDialogs::tr("Save as…"), QMessageBox::AcceptRole));
        box.exec();
        const auto pressed = box.buttonRole(box.clickedButton());
        return pressed == QMessageBox::AcceptRole        ? Instead::Elsewhere
               : pressed == QMessageBox::DestructiveRole ? Instead::Overwrite
                                                         : Instead::Stay;
    };
    dialogs.continueWithoutRejected = [&](bool closes) {
        if (closes && !rejectedEntries(document.page).isEmpty()) {
            documents.bringToFront(document);
        }
        return continueWithoutRejected(document.page, closes ? SavingDialogs::tr("Close case")
                                                             : SavingDialogs::tr("Save case"));
    };
    return dialogs;
}

}  // namespace ravnoves
