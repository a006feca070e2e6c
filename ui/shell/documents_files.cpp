// Opening, saving and closing of the documents, with the questions to the user.

#include <QMessageBox>
#include <QPushButton>
#include <algorithm>

#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "model/recovery.h"
#include "page/rejected_entries.h"
#include "page/scene_page.h"
#include "pictures/file_dialogs.h"
#include "shell/documents.h"
#include "text/error_text.h"
#include "text/message_text.h"

namespace ravnoves {

// --------------------------------------------------------------------------------- opening

void Documents::put(const CaseFile& file, OpenDocument* there,
                    const std::function<void(CaseDocument&)>& load) {
    const auto scene = indexOf(QString::fromStdString(file.scene));
    if (!scene) {
        throw InputError(
            "/scene", Text::tr("must be a module of the window; the command line solves this case"),
            file.scene);
    }
    OpenDocument* reused = there != nullptr ? there : untouchedOf(*scene);
    OpenDocument& target = reused != nullptr ? *reused : add(*scene);
    try {
        load(*target.document);
    } catch (const InputError&) {
        if (reused == nullptr) {
            remove(target);
        }
        throw;
    }
    if (reused != nullptr) {
        target.page->resetZoom();
    }
    bringToFront(target);
}

QString Documents::open(const QString& path, bool locates) {
    if (OpenDocument* there = withFile(path)) {
        bringToFront(*there);
        return {};
    }
    try {
        QByteArray known;
        CaseFile file = CaseDocument::read(path, &known);
        const Json input = file.input;
        const auto load = [&] {
            put(file, nullptr, [&](CaseDocument& document) {
                document.open(file, path, known);
                // Where a file is now, and what an older version has become, is to be saved.
                if (file.input != input || !file.changes.empty()) {
                    document.model()->history()->resetClean();
                }
            });
            QStringList changes;
            for (const Message& change : file.changes) {
                changes << messageText(change);
            }
            Q_EMIT status(changes.join(QLatin1Char(' ')));
        };
        if (locates) {
            locate(tr("Open case"), path, QFileInfo(path).absolutePath(), file, load);
        } else {
            load();
        }
        return {};
    } catch (const InputError& error) {
        return path + QStringLiteral(": ") + errorText(error);
    }
}

QString Documents::begin(const CaseFile& file, bool isFirst) {
    try {
        put(file, nullptr, [&](CaseDocument& document) { document.begin(file); });
        if (isFirst) {
            current_->beginning = current_->page->model()->inputJson().dump();
            current_->hasTab = false;
            arrangeTabs();
        }
        return {};
    } catch (const InputError& error) {
        return errorText(error);
    }
}

bool Documents::locate(const QString& title, const QString& name, const QString& folder,
                       CaseFile& file, const std::function<void()>& load) {
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
            QMessageBox box(QMessageBox::Warning, title, trouble, QMessageBox::Cancel, this);
            const QPushButton* search = box.addButton(tr("&Locate file…"), QMessageBox::AcceptRole);
            box.exec();
            // What the case names is looked for, whatever was chosen for it.
            const QString found =
                box.clickedButton() == search
                    ? askOpenPath(this, tr("Where is %1?").arg(missing), folder, tablesFilter())
                    : QString();
            if (found.isEmpty()) {
                return false;
            }
            *named = QFileInfo(found).absoluteFilePath().toStdString();
        }
    }
}

bool Documents::restore(const RecoveredCase& recovered) {
    OpenDocument* there = recovered.path.isEmpty() ? nullptr : withFile(recovered.path);
    if (there != nullptr && (there->document->needsSaving() ||
                             scenes_[there->scene].name.toStdString() != recovered.content.scene)) {
        there = nullptr;
    }
    CaseFile file = recovered.content;
    const QString title = tr("Unsaved cases");
    const bool hasPath = !recovered.path.isEmpty();
    const QString name = hasPath ? recovered.path : recovered.file;
    const QString folder = hasPath ? QFileInfo(name).absolutePath() : QString();
    try {
        if (!locate(title, name, folder, file, [&] {
                put(file, there,
                    [&](CaseDocument& document) { document.restore(file, recovered); });
            })) {
            return false;
        }
    } catch (const InputError& error) {
        QMessageBox::warning(window(), title, name + QStringLiteral(": ") + errorText(error));
        return false;
    }
    return recovery_ == nullptr || recovery_->keep(current_->document);  // or the other copy stays
}

// ---------------------------------------------------------------------------------- saving

bool Documents::save(OpenDocument& document) {
    const QString path = document.document->path();
    if (path.isEmpty()) {
        const auto inPlace = document.page->saveInPlace();
        return inPlace ? *inPlace : saveAs(document);
    }
    if (!saveWithoutRejected(document.page, tr("Save case"))) {
        return false;
    }
    document.document->checkFiles();
    return document.document->disk().state() == FileOnDisk::State::Changed
               ? saveInstead(document, path,
                             tr("%1 was changed by another program since it was opened or saved "
                                "here. Overwrite it?")
                                 .arg(path),
                             true)
               : saveAt(document, path);
}

bool Documents::saveAs(OpenDocument& document) {
    return saveWithoutRejected(document.page, tr("Save case")) && chooseAndSave(document);
}

bool Documents::chooseAndSave(OpenDocument& document) {
    const QString path = askSavePath(window(), tr("Save case"), document.document->proposedPath(),
                                     {{QStringLiteral("case.json"), tr("Ravnoves case")}});
    const OpenDocument* other = path.isEmpty() ? nullptr : withFile(path);
    if (other != nullptr && other != &document) {
        QMessageBox::warning(
            window(), tr("Save case"),
            tr("%1 is open in another tab. Close that tab first, or choose another name.")
                .arg(path));
        return false;
    }
    return !path.isEmpty() && saveAt(document, path);
}

bool Documents::saveAt(OpenDocument& document, const QString& path) {
    const QString trouble = document.document->saveTo(path);
    if (!trouble.isEmpty()) {
        return saveInstead(document, path, trouble, false);
    }
    Q_EMIT saved(document.document->path());
    return true;
}

bool Documents::saveInstead(OpenDocument& document, const QString& path, const QString& trouble,
                            bool overwrites) {
    QMessageBox box(QMessageBox::Warning, tr("Save case"), trouble, QMessageBox::Cancel, window());
    if (overwrites) {
        box.addButton(tr("&Overwrite"), QMessageBox::DestructiveRole);
    }
    box.setDefaultButton(box.addButton(tr("Save as…"), QMessageBox::AcceptRole));
    box.exec();
    const auto pressed = box.buttonRole(box.clickedButton());
    return pressed == QMessageBox::AcceptRole        ? chooseAndSave(document)
           : pressed == QMessageBox::DestructiveRole ? saveAt(document, path)
                                                     : false;
}

// --------------------------------------------------------------------------------- closing

/// Where one stays, the case that was asked about is in front.
bool Documents::canClose() {
    std::vector<OpenDocument*> all;  // which is in front last may change meanwhile
    for (const auto& each : documents_) {
        all.push_back(each.get());
    }
    return std::ranges::all_of(all, [this](OpenDocument* each) { return mayClose(*each); });
}

bool Documents::mayClose(OpenDocument& document) {
    const bool hasFile = !document.document->path().isEmpty();
    document.document->checkFiles();
    if (!document.document->needsSaving()) {
        return continueWithoutRejected(document.page, tr("Close case"), nameOf(document));
    }
    bringToFront(document);
    // A case that came from a file goes back to it.
    if (const auto answer = hasFile ? std::nullopt : document.page->askToSave()) {
        return *answer;
    }
    const QString scene = scenes_[document.scene].title;
    const QString name = nameOf(document);
    QMessageBox box(QMessageBox::Question, tr("Unsaved changes"),
                    tr("Save the changes of “%1”?")
                        .arg(name == scene ? scene : name + QStringLiteral(" – ") + scene),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window());
    box.setDefaultButton(QMessageBox::Save);
    box.button(QMessageBox::Discard)->setText(tr("Do&n’t save"));
    const int answer = box.exec();
    return answer == QMessageBox::Save ? save(document) : answer == QMessageBox::Discard;
}

}  // namespace ravnoves
