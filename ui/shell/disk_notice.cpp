#include "shell/disk_notice.h"

#include <QFileInfo>
#include <QLabel>
#include <QPushButton>

#include "model/case_document.h"

namespace ravnoves {

DiskNotice::DiskNotice(QWidget* parent)
    : NoticeBar(QStringLiteral("disk_notice"), parent),
      reload_(addButton(QStringLiteral("disk_reload"), tr("Reload"),
                        tr("Show what the file holds now. Undo brings back what is shown here."))),
      keep_(addButton(QStringLiteral("disk_keep"), tr("Keep mine"), {})),
      saveAs_(addButton(QStringLiteral("disk_save_as"), tr("Save as…"),
                        tr("Save what is shown here in another file."))) {
    connect(reload_, &QPushButton::clicked, this, &DiskNotice::reloadAsked);
    connect(keep_, &QPushButton::clicked, this, &DiskNotice::keepAsked);
    connect(saveAs_, &QPushButton::clicked, this, &DiskNotice::saveAsAsked);
}

void DiskNotice::showFor(CaseDocument* document) {
    const FileOnDisk& own = document->disk();
    const FileOnDisk* source =
        own.state() == FileOnDisk::State::Same ? document->changedSource() : nullptr;
    const FileOnDisk& file = source != nullptr ? *source : own;
    setVisible(file.state() != FileOnDisk::State::Same);
    const bool isGone = file.state() == FileOnDisk::State::Gone;
    reload_->setVisible(!isGone);
    saveAs_->setVisible(source == nullptr);
    keep_->setToolTip(source == nullptr
                          ? tr("Go on with what is shown here. Saving writes it over the file.")
                          : tr("Go on with the numbers that were read before. The case is opened "
                               "with those of the file."));
    const QString words =
        source == nullptr
            ? (isGone ? tr("%1 is no longer there: it was deleted, moved or renamed.")
                      : tr("%1 was changed by another program."))
            : (isGone ? tr("%1, which this case reads, is no longer there.")
                      : tr("%1, which this case reads, was changed by another program."));
    text()->setText(words.arg(QFileInfo(file.path()).fileName()));
    text()->setToolTip(file.path());
}

}  // namespace ravnoves
