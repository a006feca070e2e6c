#pragma once

#include "widgets/panel.h"

class QLabel;
class QPushButton;

namespace ravnoves {

class JobDesk;

/// Above the sheets: news of the journal or the card. Hidden without any.
class JournalBanner : public Panel {
    Q_OBJECT

  public:
    explicit JournalBanner(JobDesk* desk, QWidget* parent = nullptr);

    /// Something else, until it is understood, or with an empty text.
    void say(const QString& text);

  Q_SIGNALS:
    /// The user wants to have the backup's jobs back after the journal was damaged.
    void restoreWanted(const QString& backup);

  private:
    void showText();

    JobDesk* desk_;
    QString said_;
    QLabel* text_;
    QPushButton* restore_;
};

}  // namespace ravnoves
