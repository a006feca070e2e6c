#pragma once

#include <QPolygonF>
#include <QRectF>
#include <vector>

#include "balance-shaft/model/shaft_map_model.h"

class QPainter;

/// What the map of places draws over its colours and what rests while the shaft moves, from below.
namespace ravnoves {

class PlaceScale;

/// Where the shaft cannot be built: hatched.
/// @param area  the chart's, pixels
void drawBlocked(QPainter& painter, const std::vector<QPolygonF>& blocked, const PlaceScale& scale,
                 const QRectF& area);
/// Of a reference: what cannot be built, no change and the best places by a criterion, pale.
void drawReference(QPainter& painter, const ShaftMapModel& other, PlaceCriterion::Kind criterion,
                   const PlaceScale& scale);
/// @return the longest line of each, in pixels, for its number
std::vector<QPolygonF> drawContours(QPainter& painter,
                                    const std::vector<ShaftMapModel::Contour>& contours,
                                    const PlaceScale& scale);
void drawMarkers(QPainter& painter, const ShaftMapModel& map, const PlaceScale& scale);

}  // namespace ravnoves
