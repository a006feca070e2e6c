#pragma once

#include <QPolygonF>
#include <QRectF>
#include <vector>

#include "balance-shaft/model/shaft_map_model.h"
#include "balance-shaft/position_study.h"
#include "numerics/units.h"
#include "plot/plot_painter.h"
#include "plot/plot_view.h"

class QPainter;

/// What the map of the places of the shaft is drawn with, from below; sizes in pixels.
namespace ravnoves {

/// Where places (m) are drawn in a plot whose axes are in mm and of one scale.
class PlaceScale {
  public:
    explicit PlaceScale(const PlotView& plot) : plot_(plot) {}

    const PlotView& plot() const { return plot_; }
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

// Over the colours, what rests while the shaft moves.

/// Infeasible places: hatched.
void drawBlocked(QPainter& painter, const std::vector<QPolygonF>& blocked, const PlaceScale& scale);
/// The limits on its place that the case gives: walls, distances, angles.
/// @param area  the chart's, pixels
void drawLimits(QPainter& painter, const balance_shaft::PlaceLimits& limits,
                const PlaceScale& scale, const QRectF& area);
/// Of a reference: infeasible places and the line of no change, dimmed.
void drawReference(QPainter& painter, const ShaftMapModel& other, const PlaceScale& scale);

// The engine from the front.

/// Of the shaft's axis, by which it is dragged; pixels.
inline constexpr double shaftHandleRadius = 6.5;

/// Cylinder, piston, rod and crank at the angle of the crank.
void drawEngine(QPainter& painter, const BalanceShaftModel& model, const PlaceScale& scale);
/// The shaft with the circle of its l, red where it is infeasible.
/// @param other  its place in the reference; null: none
void drawShaft(QPainter& painter, const BalanceShaftModel& model, const ShaftMapModel& map,
               const ShaftMapModel* other, const PlaceScale& scale);

}  // namespace ravnoves
