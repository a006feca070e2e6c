#pragma once

#include <QList>
#include <QPen>
#include <QRectF>

class QChart;
class QGraphicsScene;
class QPainter;
class QValueAxis;

namespace ravnoves {

/// The lines of a plot's axes, by Qt Charts: all plots of the program have the same chart, since
/// they differ in where it is painted alone. Ticks, grid and numbers are painted by hand: the chart
/// makes an item and a rich text for each, again with every change of the scale.
class ChartFrame {
  public:
    /// @param hasRight  whether there is an axis at the right
    static ChartFrame& instance(bool hasRight);

    /// @param size  of the whole plot, pixels
    /// @param area  where curves are
    void paint(QPainter& painter, const QSizeF& size, const QRectF& area);

  private:
    /// What the chart is laid out for.
    struct Layout {
        QSizeF size;
        QRectF area;
        QPen pen;
        bool operator==(const Layout&) const = default;
    };

    explicit ChartFrame(bool hasRight);
    void layOut(const Layout& layout);

    Layout layout_;
    QGraphicsScene* scene_;
    QChart* chart_;            // owned by the scene
    QList<QValueAxis*> axes_;  // owned by the chart
};

}  // namespace ravnoves
