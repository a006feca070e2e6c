#pragma once

#include "balance-shaft/change_map_plot.h"
#include "balance-shaft/model/shaft_map_model.h"
#include "theme/theme.h"
#include "widgets/drawing.h"

namespace ravnoves {

/// The front view of the engine over the map of the places of its balance shaft: the criterion as
/// filled contours with their key, infeasible places hatched, the best places, and the shaft's axis
/// as a handle.
///
/// The handle is dragged, Escape brings it back; a double click moves the shaft to the place or the
/// marker under it; all else as in any plot.
class ShaftMapPlot : public ChangeMapPlot {
    Q_OBJECT

  public:
    explicit ShaftMapPlot(BalanceShaftModel* model, QWidget* parent = nullptr);

    /// Both axes have one scale, so a map that is low is small.
    QSize minimumSizeHint() const override {
        return PlotView::minimumSizeHint() + QSize(0, Theme::withText(120));
    }
    /// Where a place (m) is drawn.
    QPointF pixelOf(const ShaftMapModel::Position& position) const;
    ShaftMapModel::Position placeAt(const QPointF& pixel) const;
    /// The field under the picture.
    QString csv(const CsvFormat& format) const override;

  Q_SIGNALS:
    /// The place under the pointer, as text; empty where it left.
    void hovered(const QString& text);

  protected:
    const ChangeContours& field() const override { return map_->field(); }
    void paintOnField(QPainter& painter) override;
    void paintOverCurves(QPainter& painter) override;
    void paintTop(QPainter& painter) override;
    QString tipAt(const QPointF& pixel) const override { return map_->reasonAt(placeAt(pixel)); }
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void stopReading() override;
    void focusOutEvent(QFocusEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    /// Where places (m) are drawn: the axes are in mm and of one scale.
    drawing::Frame frame() const;
    /// Infeasible places: hatched.
    void paintBlocked(QPainter& painter) const;
    /// The limits on its place that the case gives: walls, distances, angles.
    void paintLimits(QPainter& painter) const;
    /// Cylinder, piston, rod and crank at the angle of the crank.
    void paintEngine(QPainter& painter) const;
    /// The shaft with the circle of its l, red where it is infeasible.
    void paintShaft(QPainter& painter) const;
    void endDrag();
    bool isHandle(const QPointF& pixel) const;
    const ShaftMapModel::Marker* markerAt(const QPointF& pixel) const;

    BalanceShaftModel* model_;
    ShaftMapModel* map_;
    bool dragging_ = false;
    bool gripped_ = false;  ///< the button pressed on the handle is still down
    QPointF grip_;          ///< from the pointer to the axis
};

}  // namespace ravnoves
