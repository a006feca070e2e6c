#pragma once

#include <QWidget>

class QPainter;

namespace ravnoves {

/// A surface with a hairline border, the ground of forms, plots and results.
class Panel : public QWidget {
    Q_OBJECT

  public:
    using QWidget::QWidget;

  protected:
    void paintEvent(QPaintEvent* event) override;
};

/// Paints that surface; paintings on it are smooth.
void paintPanel(QPainter& painter, const QRect& panel);
/// The same with a title at the top left, for a picture that paints itself.
/// @return the line that the title is in
QRect paintPanel(QPainter& painter, const QRect& panel, const QString& title);

}  // namespace ravnoves
