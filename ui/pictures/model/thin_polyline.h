#pragma once

#include <QPolygonF>
#include <vector>

namespace ravnoves {

/// Leaves out the points of a polyline that would move no pixel: every dropped point is within
/// `tolerance` (pixels) of the remaining line (Ramer, Douglas and Peucker). A chart pays for points
/// drawn, so a 721-point curve is drawn with 100 to 200.
/// @param points  in pixels; may be empty
QPolygonF thinPolyline(const std::vector<QPointF>& points, double tolerance = 0.25);

}  // namespace ravnoves
