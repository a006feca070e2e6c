#pragma once

#include "widgets/panel.h"

class QLabel;
class QPushButton;

namespace ravnoves {

/// A line over the page with what can be done about it; hidden until there is something to say.
class NoticeBar : public Panel {
    Q_OBJECT

  protected:
    NoticeBar(const QString& name, QWidget* parent);

    QLabel* text() const { return text_; }
    /// At the end of the line.
    QPushButton* addButton(const QString& name, const QString& text, const QString& tip);

  private:
    QLabel* text_;
};

}  // namespace ravnoves
