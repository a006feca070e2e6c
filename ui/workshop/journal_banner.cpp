#include "workshop/journal_banner.h"

#include <QLabel>
#include <QPushButton>

#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/layouts.h"
#include "workshop/model/job_desk.h"

namespace ravnoves {

JournalBanner::JournalBanner(JobDesk* desk, QWidget* parent) : Panel(parent), desk_(desk) {
    constexpr int buttonHeight = 34;  // designed pixels
    QHBoxLayout* row = rowIn(this, -1, barMargins);
    text_ = copyableLabel("banner", Theme::baseSize, this, true);
    row->addWidget(text_, 1);
    const auto button = [&](const QString& name, const QString& text) {
        auto* made = new QPushButton(text, this);
        made->setObjectName(name);
        made->setMinimumHeight(Theme::withText(buttonHeight));
        row->addWidget(made);
        return made;
    };
    restore_ = button(QStringLiteral("backup_restore"), tr("Restore the backup"));
    close_ = button(QStringLiteral("banner_close"), tr("Understood"));
    hide();
    connect(restore_, &QPushButton::clicked, this,
            [this] { Q_EMIT restoreWanted(desk_->offeredBackup()); });
    connect(close_, &QPushButton::clicked, this, [this] {
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
