#pragma once

#include <QPolygonF>

class QPainter;

namespace ravnoves {

/// Draws a polyline with the painter's pen. Onto a screen by LineBrush, where the pen is solid and
/// wider than a pixel: Qt's stroker takes longer. Anywhere else, and with round ends, it is a
/// polyline of Qt's.
void paintLine(QPainter& painter, const QPolygonF& line);

}  // namespace ravnoves
