#include "shell/case_notices.h"

#include <QApplication>
#include <QMessageBox>
#include <QVBoxLayout>

#include "model/case_document.h"
#include "shell/disk_notice.h"
#include "shell/solving_notice.h"

namespace ravnoves {

CaseNotices::CaseNotices(QWidget* parent)
    : QWidget(parent), disk_(new DiskNotice(this)), solving_(new SolvingNotice(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(disk_);
    column->addWidget(solving_);
    connect(disk_, &DiskNotice::reloadAsked, this, &CaseNotices::reload);
    connect(disk_, &DiskNotice::keepAsked, this, &CaseNotices::keep);
    connect(disk_, &DiskNotice::saveAsAsked, this, [this] { document_->saveAs(); });
}

void CaseNotices::showFor(CaseDocument* document, QWidget* page) {
    document_ = document;
    const bool hadFocus = disk_->isAncestorOf(QApplication::focusWidget());
    disk_->showFor(document);
    if (hadFocus && disk_->isHidden()) {
        // Else it goes where it happens to.
        QWidget* last = page->focusWidget();
        (last != nullptr ? last : page)->setFocus(Qt::OtherFocusReason);
    }
    solving_->follow(document->model());
}

void CaseNotices::reload() {
    const QString trouble = document_->disk().state() != FileOnDisk::State::Same
                                ? document_->reload()
                                : document_->readSources();
    if (!trouble.isEmpty()) {
        QMessageBox::warning(window(), tr("Open case"), trouble);
    }
}

void CaseNotices::keep() {
    if (document_->disk().state() != FileOnDisk::State::Same) {
        document_->keepMine();
    } else {
        document_->keepSources();
    }
}

}  // namespace ravnoves
