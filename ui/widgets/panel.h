#pragma once

#include <QWidget>

namespace ravnoves {

/// A surface with a hairline border, on which forms, plots and results lie.
class Panel : public QWidget {
    Q_OBJECT

  public:
    using QWidget::QWidget;

  protected:
    void paintEvent(QPaintEvent* event) override;
};

}  // namespace ravnoves
