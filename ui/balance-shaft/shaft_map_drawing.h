#pragma once

#include <QPolygonF>
#include <QRectF>
#include <vector>

#include "balance-shaft/model/shaft_map_model.h"
#include "plot/plot_view.h"
#include "widgets/drawing.h"

class QPainter;

/// What the map of the places of the shaft is drawn with, from below; sizes in pixels.
namespace ravnoves {

/// Where places (m) are drawn in a plot whose axes are in mm and of one scale.
drawing::Frame frameOf(const PlotView& plot);

// Over the colours, what rests while the shaft moves.

/// Infeasible places: hatched.
void drawBlocked(QPainter& painter, const std::vector<QPolygonF>& blocked, const PlotView& plot);
/// The limits on its place that the case gives: walls, distances, angles.
void drawLimits(QPainter& painter, const balance_shaft::PlaceLimits& limits, const PlotView& plot);
/// Of a reference: infeasible places and the line of no change, dimmed.
void drawReference(QPainter& painter, const ShaftMapModel& other, const PlotView& plot);

// The engine from the front.

/// Of the shaft's axis, by which it is dragged; pixels.
inline constexpr double shaftHandleRadius = 6.5;

/// Cylinder, piston, rod and crank at the angle of the crank.
void drawEngine(QPainter& painter, const BalanceShaftModel& model, const PlotView& plot);
/// The shaft with the circle of its l, red where it is infeasible.
/// @param other  its place in the reference; null: none
void drawShaft(QPainter& painter, const BalanceShaftModel& model, const ShaftMapModel& map,
               const ShaftMapModel* other, const PlotView& plot);

}  // namespace ravnoves
