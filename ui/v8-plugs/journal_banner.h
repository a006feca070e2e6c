#pragma once

#include <QList>

#include "v8-plugs/model/journal.h"
#include "widgets/panel.h"

class QLabel;
class QPushButton;

namespace ravnoves {

class V8PlugsModel;

/// Above the sheets: an unfinished job that a crash left, or what happened to the journal. Hidden
/// where there is nothing to say.
class JournalBanner : public Panel {
    Q_OBJECT

  public:
    explicit JournalBanner(V8PlugsModel* model, QWidget* parent = nullptr);

    /// Offers the drafts that a crash left, one after the other.
    void offer(const QList<JournalDraft>& crashed);
    /// Offers no more of them than these.
    void keepOnly(const QList<JournalDraft>& crashed);
    /// To be called once a draft offered was continued: the next, or nothing.
    void next();

  Q_SIGNALS:
    /// The user wants to go on with the draft.
    void continued(const JournalDraft& draft);

  private:
    void showText();

    V8PlugsModel* model_;
    QList<JournalDraft> crashed_;
    QLabel* text_;
    QPushButton* continue_;
    QPushButton* discard_;
    QPushButton* close_;
};

}  // namespace ravnoves
