#include "shell/disk_notice.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "model/case_document.h"
#include "theme/theme.h"

namespace ravnoves {

DiskNotice::DiskNotice(QWidget* parent) : Panel(parent) {
    setObjectName(QStringLiteral("disk_notice"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(Theme::margin, Theme::gap, Theme::margin, Theme::gap);
    row->setSpacing(Theme::space);
    text_ = new QLabel(this);
    text_->setWordWrap(true);
    row->addWidget(text_, 1);
    const auto button = [&](const char* name, const QString& text, const QString& tip) {
        auto* made = new QPushButton(text, this);
        made->setObjectName(QLatin1String(name));
        made->setToolTip(tip);
        row->addWidget(made);
        return made;
    };
    reload_ = button("disk_reload", tr("Reload"),
                     tr("Show what the file holds now. Undo brings back what is shown here."));
    connect(reload_, &QPushButton::clicked, this, &DiskNotice::reloadAsked);
    keep_ = button("disk_keep", tr("Keep mine"), {});
    connect(keep_, &QPushButton::clicked, this, &DiskNotice::keepAsked);
    saveAs_ =
        button("disk_save_as", tr("Save as…"), tr("Save what is shown here in another file."));
    connect(saveAs_, &QPushButton::clicked, this, &DiskNotice::saveAsAsked);
    hide();
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
    const QString text =
        source == nullptr
            ? (isGone ? tr("%1 is no longer there: it was deleted, moved or renamed.")
                      : tr("%1 was changed by another program."))
            : (isGone ? tr("%1, which this case reads, is no longer there.")
                      : tr("%1, which this case reads, was changed by another program."));
    text_->setText(text.arg(QFileInfo(file.path()).fileName()));
    text_->setToolTip(file.path());
}

}  // namespace ravnoves
