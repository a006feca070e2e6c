#pragma once

#include <QPointF>
#include <QPolygonF>
#include <QRectF>

class QPainter;

namespace ravnoves {

// Shapes with the painter's pen and brush. Onto a screen by the distance of its pixels from the
// edge: Qt's outlines need up to ten times as long. Elsewhere, and dashed, they are Qt's own.

/// A circle.
void paintDisc(QPainter& painter, const QPointF& middle, double radius);

/// A polygon, which is convex.
void paintPolygon(QPainter& painter, const QPolygonF& polygon);

/// A block with round corners.
void paintBlock(QPainter& painter, const QRectF& block, double corner);

/// A bar with round ends about two points.
void paintBar(QPainter& painter, const QPointF& from, const QPointF& to, double radius);

}  // namespace ravnoves
