#include "workshop/journal_banner.h"

#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <algorithm>

#include "text/language.h"
#include "theme/theme.h"
#include "widgets/layouts.h"
#include "workshop/model/job_desk.h"
#include "workshop/sheet_form.h"

namespace ravnoves {

JournalBanner::JournalBanner(JobDesk* desk, QWidget* parent) : Panel(parent), desk_(desk) {
    QHBoxLayout* row = rowIn(this, -1, barMargins);
    text_ = copyableLabel("banner", Theme::baseSize, this, true);
    row->addWidget(text_, 1);
    const auto button = [&](const QString& name, const QString& text) {
        auto* made = new QPushButton(text, this);
        made->setObjectName(name);
        made->setMinimumHeight(Theme::withText(SheetForm::fieldHeight));
        row->addWidget(made);
        return made;
    };
    continue_ = button(QStringLiteral("draft_continue"), tr("Continue it"));
    discard_ = button(QStringLiteral("draft_discard"), tr("Throw it away"));
    restore_ = button(QStringLiteral("backup_restore"), tr("Restore the backup"));
    close_ = button(QStringLiteral("banner_close"), tr("Understood"));
    hide();
    connect(continue_, &QPushButton::clicked, this, [this] {
        if (!crashed_.isEmpty()) {
            Q_EMIT continued(crashed_.constFirst());
        }
    });
    connect(discard_, &QPushButton::clicked, this, [this] {
        if (!crashed_.isEmpty() && mayThrowAway(crashed_.constFirst())) {
            desk_->discardDraft(crashed_.constFirst().session);
            next();
        }
    });
    connect(restore_, &QPushButton::clicked, this,
            [this] { Q_EMIT restoreWanted(desk_->offeredBackup()); });
    connect(close_, &QPushButton::clicked, this, [this] {
        said_.clear();
        hide();
    });
    connect(desk_, &JobDesk::journalTroubleChanged, this, &JournalBanner::showText);
}

void JournalBanner::offer(const QList<JournalDraft>& crashed) {
    crashed_ = crashed;
    showText();
}

bool JournalBanner::mayThrowAway(const JournalDraft& draft) {
    return QMessageBox::question(
               this, tr("Unfinished job"),
               tr("Throw away the unfinished job %1 of %2? It is gone for good then.")
                   .arg(JobDesk::nameOf(draft), timeText(draft.saved)),
               QMessageBox::Yes | QMessageBox::No, QMessageBox::No) == QMessageBox::Yes;
}

void JournalBanner::keepOnly(const QList<JournalDraft>& crashed) {
    const auto removed = crashed_.removeIf([&](const JournalDraft& offered) {
        return std::none_of(crashed.begin(), crashed.end(), [&](const JournalDraft& left) {
            return left.session == offered.session;
        });
    });
    if (removed > 0) {
        showText();
    }
}

void JournalBanner::next() {
    if (!crashed_.isEmpty()) {
        crashed_.removeFirst();
    }
    showText();
}

void JournalBanner::say(const QString& text) {
    if (text != said_) {
        said_ = text;
        showText();
    }
}

void JournalBanner::showText() {
    const bool draft = !crashed_.isEmpty();
    const QString trouble = said_.isEmpty() ? desk_->journalTrouble() : said_;
    if (draft) {
        const JournalDraft& first = crashed_.constFirst();
        QStringList said{tr("The program ended unexpectedly on %1 with an unfinished job: %2.")
                             .arg(timeText(first.saved), JobDesk::nameOf(first))};
        QStringList others;
        for (const JournalDraft& other : crashed_.mid(1)) {
            others << JobDesk::nameOf(other);
        }
        if (!others.isEmpty()) {
            said << tr("Others are offered after it: %1.").arg(others.join(QStringLiteral("; ")));
        }
        text_->setText(said.join(QLatin1Char(' ')));
    } else {
        text_->setText(trouble);
    }
    continue_->setVisible(draft);
    discard_->setVisible(draft);
    restore_->setVisible(!draft && said_.isEmpty() && !trouble.isEmpty() &&
                         !desk_->offeredBackup().isEmpty());
    close_->setVisible(!draft);
    setVisible(draft || !trouble.isEmpty());
}

}  // namespace ravnoves
