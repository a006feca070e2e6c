#include "shell/disk_notice.h"

#include <QApplication>
#include <QFileInfo>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>

#include "model/case_document.h"
#include "theme/theme.h"
#include "widgets/layouts.h"

namespace ravnoves {

DiskNotice::DiskNotice(QWidget* parent) : Panel(parent), text_(new QLabel(this)) {
    setObjectName(QStringLiteral("disk_notice"));
    QHBoxLayout* row = rowIn(this, Theme::space, barMargins);
    text_->setWordWrap(true);
    row->addWidget(text_, 1);
    reload_ = addButton("disk_reload", tr("Reload"),
                        tr("Show the present contents of the file. Undo restores this page."),
                        [this] { reload(); });
    keep_ = addButton("disk_keep", tr("Keep mine"), {}, [this] { document_->keepMine(); });
    saveAs_ = addButton("disk_save_as", tr("Save as…"), tr("Save this page in another file."),
                        [this] { Q_EMIT saveAsWanted(); });
    hide();
}

QPushButton* DiskNotice::addButton(const char* name, const QString& text, const QString& tip,
                                   const std::function<void()>& pressed) {
    auto* button = new QPushButton(text, this);
    button->setObjectName(QLatin1String(name));
    button->setToolTip(tip);
    layout()->addWidget(button);
    connect(button, &QPushButton::clicked, this, pressed);
    return button;
}

void DiskNotice::showFor(CaseDocument* document, QWidget* page) {
    document_ = document;
    const bool hadFocus = isAncestorOf(QApplication::focusWidget());
    const FileOnDisk* file = document->changedFile();
    setVisible(file != nullptr);
    if (file != nullptr) {
        const bool isOwn = document->isOwn(file);
        const bool isMissing = file->state() == FileOnDisk::State::Missing;
        reload_->setVisible(!isMissing);
        saveAs_->setVisible(isOwn);
        keep_->setToolTip(isOwn ? tr("Continue with this page. Saving replaces the file.")
                                : tr("Continue with the numbers read before. The next time, the "
                                     "case opens with the numbers of the file."));
        const QString words =
            isOwn ? (isMissing ? tr("%1 was deleted, moved or renamed.")
                               : tr("%1 was changed by another program."))
                  : (isMissing ? tr("%1, a file of this case, was deleted, moved or renamed.")
                               : tr("%1, a file of this case, was changed by another program."));
        text_->setText(words.arg(QFileInfo(file->path()).fileName()));
        text_->setToolTip(file->path());
    }
    if (hadFocus && isHidden()) {
        // Else it goes where it happens to.
        QWidget* last = page->focusWidget();
        (last != nullptr ? last : page)->setFocus(Qt::OtherFocusReason);
    }
}

void DiskNotice::reload() {
    const QString trouble = document_->reload();
    if (!trouble.isEmpty()) {
        QMessageBox::warning(window(), tr("Open case"), trouble);
    }
}

}  // namespace ravnoves
