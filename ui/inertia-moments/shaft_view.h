#pragma once

#include <QWidget>

#include "theme/theme.h"

namespace ravnoves {

class InertiaMomentsModel;

/// Arrangement and phases of the balance shafts (the paper's Figs. 7 and 8), each at the present
/// crank angle: its target, its weights opposite, its direction, the cylinder axis and the crankpin
/// where its phase begins.
class ShaftView : public QWidget {
    Q_OBJECT

  public:
    explicit ShaftView(InertiaMomentsModel* model, QWidget* parent = nullptr);

    QSize sizeHint() const override { return {420, 260}; }
    QSize minimumSizeHint() const override { return {Theme::withText(240), Theme::withText(160)}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    int columns() const;
    /// Of a shaft, pixels.
    QRectF cell(int index) const;
    void paintShaft(QPainter& painter, int index, const QRectF& area) const;

    InertiaMomentsModel* model_;
};

}  // namespace ravnoves
