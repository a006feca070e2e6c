#pragma once

#include <QLineF>
#include <QList>
#include <QPen>
#include <QPolygonF>
#include <vector>

class QPainter;
class QPainterPath;

namespace ravnoves {

/// Draws a polyline with the painter's pen. Onto a screen by LineBrush, where the pen is no
/// narrower than a pixel: Qt's stroker takes longer. Anywhere else, and with round ends, it is a
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
/// One after the other, onto the pixels of a picture, else into one layer that is laid over the
/// screen once.
void paintLines(QPainter& painter, const std::vector<LinesOfPen>& all);

/// Lines at 45° that fill an area.
/// @param apart  from one to the next, across the page
/// @param fall  1: they fall to the right, −1: to the left
QList<QLineF> hatchLines(const QPainterPath& area, double apart, double fall);

}  // namespace ravnoves
