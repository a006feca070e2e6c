#include "workshop/journal_banner.h"

#include <QLabel>
#include <QPushButton>

#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/layouts.h"
#include "workshop/model/job_desk.h"
#include "workshop/workshop_sheet.h"

namespace ravnoves {

JournalBanner::JournalBanner(JobDesk* desk, QWidget* parent) : Panel(parent), desk_(desk) {
    QHBoxLayout* row = rowIn(this, -1, barMargins);
    text_ = copyableLabel("banner", Theme::baseSize, this, true);
    row->addWidget(text_, 1);
    restore_ = largeButton("backup_restore", tr("Restore the backup"), this);
    row->addWidget(restore_);
    QPushButton* close = largeButton("banner_close", tr("Understood"), this);
    row->addWidget(close);
    hide();
    connect(restore_, &QPushButton::clicked, this,
            [this] { Q_EMIT restoreWanted(desk_->offeredBackup()); });
    connect(close, &QPushButton::clicked, this, [this] {
        said_.clear();
        hide();
    });
    connect(desk_, &JobDesk::journalTroubleChanged, this, &JournalBanner::showText);
}

void JournalBanner::say(const QString& text) {
    if (text != said_) {
        said_ = text;
        showText();
    }
}

void JournalBanner::showText() {
    const QString trouble = said_.isEmpty() ? desk_->journalTrouble() : said_;
    text_->setText(trouble);
    restore_->setVisible(said_.isEmpty() && !trouble.isEmpty() &&
                         !desk_->offeredBackup().isEmpty());
    setVisible(!trouble.isEmpty());
}

}  // namespace ravnoves
