#pragma once

#include <QPolygonF>
#include <vector>

class QPainter;

namespace ravnoves {

/// Draws a polyline with the painter's pen. Onto a screen by LineBrush, where the pen is solid and
/// wider than a pixel: Qt's stroker takes longer. Anywhere else, and with round ends, it is a
/// polyline of Qt's.
void paintLine(QPainter& painter, const QPolygonF& line);

/// Several lines of one pen: where they meet, a pale pen gets no darker.
void paintLines(QPainter& painter, const std::vector<QPolygonF>& lines);

}  // namespace ravnoves
