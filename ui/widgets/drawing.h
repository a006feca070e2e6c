#pragma once

#include <QColor>
#include <QLineF>
#include <QPainter>
#include <QPainterPath>
#include <QPointF>
#include <complex>

#include "theme/model/role.h"

namespace ravnoves::drawing {

/// A point of the front view (x right, y up) in a widget's pixels.
struct Frame {
    QPointF origin;
    double pixelsPerUnit = 1.0;

    QPointF at(double x, double y) const {
        return origin + QPointF(x * pixelsPerUnit, -y * pixelsPerUnit);
    }
    QPointF at(const std::complex<double>& p) const { return at(p.real(), p.imag()); }
    template <typename Point>
    QPointF at(const Point& p) const {
        return at(p.x, p.y);
    }
    double length(double units) const { return units * pixelsPerUnit; }
};

/// An arrow of the present pen width in one colour; nothing where it would be too short to see.
void drawArrow(QPainter& painter, const QPointF& from, const QPointF& to, const QColor& colour,
               double width = 2.0);

/// An arrow moved back along its line until its tip is inside: a force acts along its line.
QLineF pulledInside(const QLineF& arrow, const QRectF& inside);

/// A straight bar of metal (rod, crank web) about two points, with round ends; its outline is
/// around the width.
void drawRod(QPainter& painter, const QPointF& from, const QPointF& to, double width,
             const QColor& fill, const QColor& line);

/// A counterweight seen along its shaft: the sector of a disc with a hub towards an angle (rad,
/// counter-clockwise from x), `half` degrees to both sides.
QPainterPath weightPath(const QPointF& axis, double angle, double radius, double hubRadius,
                        double half);
/// The usual counterweight, 48° to both sides.
void drawWeight(QPainter& painter, const QPointF& axis, double angle, double radius,
                const QColor& fill, const QColor& line);

/// An arc with an arrowhead round a centre, from `start` through `sweep` (rad, counter-clockwise).
void drawTurning(QPainter& painter, const QPointF& centre, double radius, double start,
                 double sweep, const QColor& colour);

/// A text with its middle at a point.
void drawCentred(QPainter& painter, const QPointF& middle, const QString& text);

/// A text with the ground round its letters, so that lines behind it do not cross them.
void drawWithHalo(QPainter& painter, const QRectF& room, int flags, const QString& text);

/// Colours of bank 1, bank 2, … and of metal parts in the present theme.
QColor bankColour(int bank);
QColor metal();
QColor brightMetal();
/// Of a counterweight: its role's colour, translucent.
QColor weightFill(Role role);

}  // namespace ravnoves::drawing
