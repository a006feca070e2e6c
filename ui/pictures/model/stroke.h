#pragma once

#include <QLineF>
#include <QPen>
#include <QPolygonF>
#include <optional>
#include <utility>
#include <vector>

class QPainter;
class QPainterPath;

namespace ravnoves {

/// Draws a polyline with the painter's pen. Onto a screen by a brush of our own, where the pen is
/// no narrower than a pixel: Qt's stroker takes longer. Anywhere else, and with round ends, it is a
/// polyline of Qt's.
void paintLine(QPainter& painter, const QPolygonF& line);
inline void paintLine(QPainter& painter, const QPointF& from, const QPointF& to) {
    paintLine(painter, QPolygonF{from, to});
}

/// Lines of one pen: where they meet, a translucent pen gets no darker.
struct LinesOfPen {
    QPen pen;
    std::vector<QPolygonF> lines;
};
/// One after the other, onto the pixels of the picture, else into one layer that is laid over it
/// once.
void paintLines(QPainter& painter, const std::vector<LinesOfPen>& all);

/// Lines at 45° that fill an area, those that may meet a rectangle.
/// @param apart  from one to the next, across the page
/// @param fall  1: they fall to the right, −1: to the left
std::vector<QPolygonF> hatchLines(const QPainterPath& area, const QRectF& seen, double apart,
                                  double fall);

/// Leaves out the points of a polyline that would move no pixel: every dropped point is within
/// `tolerance` (pixels) of the remaining line (Ramer, Douglas and Peucker). A chart pays for points
/// drawn, so a 721-point curve is drawn with 100 to 200.
/// @param points  in pixels; may be empty
QPolygonF thinPolyline(const std::vector<QPointF>& points, double tolerance = 0.25);

/// Where a straight line enters and leaves a rectangle, as shares of its length; nothing where it
/// passes by.
std::optional<std::pair<double, double>> crossings(const QLineF& line, const QRectF& box);

}  // namespace ravnoves
