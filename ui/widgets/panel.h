#pragma once

#include <QWidget>

class QPainter;

namespace ravnoves {

/// A surface with a hairline border, on which forms, plots and results lie.
class Panel : public QWidget {
    Q_OBJECT

  public:
    using QWidget::QWidget;

  protected:
    void paintEvent(QPaintEvent* event) override;
};

/// Paints that surface; what is painted on it is smooth.
void paintPanel(QPainter& painter, const QRect& panel);
/// The same with a title at the top left, for a picture that paints itself.
/// @return the line that the title is in
QRect paintPanel(QPainter& painter, const QRect& panel, const QString& title);

}  // namespace ravnoves
