#pragma once

#include <QPolygonF>

#include "balance-shaft/position_study.h"
#include "numerics/units.h"
#include "plot/plot_view.h"

namespace ravnoves {

/// Where places (m) are drawn in a plot whose axes are in mm and of one scale.
class PlaceScale {
  public:
    explicit PlaceScale(const PlotView& plot) : plot_(plot) {}

    QPointF at(double x, double y) const { return plot_.toPixel(x / units::mm, y / units::mm); }
    QPointF at(const balance_shaft::ShaftPosition& position) const {
        return at(position.x, position.y);
    }
    QPolygonF line(const QPolygonF& metres) const {
        QPolygonF drawn;
        drawn.reserve(metres.size());
        for (const QPointF& point : metres) {
            drawn << at(point.x(), point.y());
        }
        return drawn;
    }
    /// Pixels of a metre.
    double perMetre() const {
        return (plot_.toPixel(1.0, 0.0).x() - plot_.toPixel(0.0, 0.0).x()) / units::mm.to_si;
    }

  private:
    const PlotView& plot_;
};

}  // namespace ravnoves
