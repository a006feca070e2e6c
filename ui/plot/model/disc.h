#pragma once

class QPainter;
class QPointF;

namespace ravnoves {

/// Draws a circle with the painter's pen and brush. Onto a screen by the distance of its pixels
/// from the middle: Qt's outlines of arcs take ten times as long. Anywhere else, and dashed, it is
/// an ellipse of Qt's.
void paintDisc(QPainter& painter, const QPointF& middle, double radius);

}  // namespace ravnoves
