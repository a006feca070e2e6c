#pragma once

#include <QLineF>
#include <QList>
#include <QPen>
#include <QPolygonF>
#include <vector>

class QPainter;

namespace ravnoves {

/// Draws a polyline with the painter's pen. Onto a screen by LineBrush, where the pen is solid and
/// wider than a pixel: Qt's stroker takes longer. Anywhere else, and with round ends, it is a
/// polyline of Qt's.
void paintLine(QPainter& painter, const QPolygonF& line);

/// Lines of one pen: where they meet, a pale pen gets no darker.
struct LinesOfPen {
    QPen pen;
    std::vector<QPolygonF> lines;
};
/// One after the other, into one layer that is laid over the screen once.
void paintLines(QPainter& painter, const std::vector<LinesOfPen>& all);

/// Lines along the axes, with the painter's pen: each pixel darkened by what of it they cover.
void paintGridLines(QPainter& painter, const QList<QLineF>& lines);

/// A convex polygon with the painter's brush and pen, whose line is drawn as paintLine() does where
/// it is wider than a pixel.
void paintPolygon(QPainter& painter, const QPolygonF& polygon);

}  // namespace ravnoves
