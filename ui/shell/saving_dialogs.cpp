#include "shell/saving_dialogs.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPushButton>

#include "page/rejected_entries.h"
#include "page/scene_page.h"
#include "pictures/file_dialogs.h"
#include "shell/documents.h"

namespace ravnoves {

namespace {

class SavingDialogs {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::SavingDialogs)

  public:
    using Answer = DocumentDialogs::Answer;
    using Overwrite = DocumentDialogs::Overwrite;

    SavingDialogs(Documents& documents, OpenDocument& document)
        : documents_(&documents), document_(&document) {}

    Answer saveChanges(bool hasFile) const {
        documents_->bringToFront(*document_);
        // A case that came from a file goes back to it.
        if (const auto answer = hasFile ? std::nullopt : document_->page->askToSave()) {
            return *answer ? Answer::Discard : Answer::Stay;
        }
        const QString scene = documents_->scenes()[document_->scene].title;
        const QString name = documents_->nameOf(*document_);
        QMessageBox box(QMessageBox::Question, tr("Unsaved changes"),
                        tr("Save the changes of “%1”?")
                            .arg(name == scene ? scene : name + QStringLiteral(" – ") + scene),
                        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window());
        box.setDefaultButton(QMessageBox::Save);
        box.button(QMessageBox::Discard)->setText(tr("Do&n’t save"));
        const int answer = box.exec();
        return answer == QMessageBox::Save      ? Answer::Save
               : answer == QMessageBox::Discard ? Answer::Discard
                                                : Answer::Stay;
    }

    std::optional<bool> saveInPlace() const { return document_->page->saveInPlace(); }

    QString choosePath(const QString& suggestion) const {
        QString path = askSavePath(window(), tr("Save case"), suggestion,
                                   {{QStringLiteral("case.json"), tr("Ravnoves case")}});
        const OpenDocument* other = path.isEmpty() ? nullptr : documents_->withFile(path);
        if (other != nullptr && other != document_) {
            QMessageBox::warning(
                window(), tr("Save case"),
                tr("%1 is open in another tab. Close that tab first, or choose another name.")
                    .arg(path));
            return {};
        }
        return path;
    }

    bool elsewhere(const QString& trouble) const {
        QMessageBox box(QMessageBox::Warning, tr("Save case"), trouble, QMessageBox::Cancel,
                        window());
        box.setDefaultButton(box.addButton(tr("Save as…"), QMessageBox::AcceptRole));
        box.exec();
        return box.buttonRole(box.clickedButton()) == QMessageBox::AcceptRole;
    }

    Overwrite overwrite(const QString& path) const {
        QMessageBox box(QMessageBox::Warning, tr("Save case"),
                        tr("%1 was changed by another program since it was opened or saved here. "
                           "Overwrite it?")
                            .arg(path),
                        QMessageBox::Cancel, window());
        QPushButton* over = box.addButton(tr("&Overwrite"), QMessageBox::DestructiveRole);
        QPushButton* elsewhere = box.addButton(tr("Save as…"), QMessageBox::AcceptRole);
        box.setDefaultButton(elsewhere);
        box.exec();
        return box.clickedButton() == over        ? Overwrite::Yes
               : box.clickedButton() == elsewhere ? Overwrite::Elsewhere
                                                  : Overwrite::No;
    }

    bool continueWithout() const {
        return continueWithoutRejected(document_->page, tr("Save case"));
    }

    bool leaveRejected() const {
        if (rejectedEntries(document_->page).isEmpty()) {
            return true;
        }
        documents_->bringToFront(*document_);
        return continueWithoutRejected(document_->page, tr("Close case"));
    }

  private:
    QWidget* window() const { return documents_->window(); }

    Documents* documents_;
    OpenDocument* document_;
};

}  // namespace

DocumentDialogs savingDialogs(Documents& documents, OpenDocument& document) {
    const SavingDialogs ask(documents, document);
    DocumentDialogs dialogs;
    dialogs.saveChanges = [ask](bool hasFile) { return ask.saveChanges(hasFile); };
    dialogs.choosePath = [ask](const QString& suggestion) { return ask.choosePath(suggestion); };
    dialogs.saveInPlace = [ask] { return ask.saveInPlace(); };
    dialogs.elsewhere = [ask](const QString& trouble) { return ask.elsewhere(trouble); };
    dialogs.overwrite = [ask](const QString& path) { return ask.overwrite(path); };
    dialogs.continueWithoutRejected = [ask] { return ask.continueWithout(); };
    dialogs.leaveRejected = [ask] { return ask.leaveRejected(); };
    return dialogs;
}

}  // namespace ravnoves
