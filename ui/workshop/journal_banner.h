#pragma once

#include <QList>

#include "widgets/panel.h"
#include "workshop/model/journal.h"

class QLabel;
class QPushButton;

namespace ravnoves {

class JobDesk;

/// Above the sheets: an unfinished job that a crash left, or what happened to the journal or to the
/// card. Hidden where there is nothing to say.
class JournalBanner : public Panel {
    Q_OBJECT

  public:
    explicit JournalBanner(JobDesk* desk, QWidget* parent = nullptr);

    /// Offers the drafts that a crash left, one after the other.
    void offer(const QList<JournalDraft>& crashed);
    /// Offers no more of them than these.
    void keepOnly(const QList<JournalDraft>& crashed);
    /// To be called once a draft offered was continued: the next, or nothing.
    void next();
    /// Something else, until it is understood, or with an empty text.
    void say(const QString& text);

  Q_SIGNALS:
    /// The user wants to go on with the draft.
    void continued(const JournalDraft& draft);
    /// … to have the backup's jobs back after the journal was damaged.
    void restoreWanted(const QString& backup);

  private:
    void showText();
    bool mayThrowAway(const JournalDraft& draft);

    JobDesk* desk_;
    QList<JournalDraft> crashed_;
    QString said_;
    QLabel* text_;
    QPushButton* continue_;
    QPushButton* discard_;
    QPushButton* restore_;
    QPushButton* close_;
};

}  // namespace ravnoves
