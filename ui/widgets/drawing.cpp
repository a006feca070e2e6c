#include "widgets/drawing.h"

#include <algorithm>
#include <cmath>

#include "numerics/constants.h"
#include "pictures/model/shape.h"
#include "pictures/model/stroke.h"
#include "theme/theme.h"

namespace ravnoves::drawing {

void drawArrow(QPainter& painter, const QPointF& from, const QPointF& to, const QColor& colour,
               double width) {
    const QPointF d = to - from;
    const double length = std::hypot(d.x(), d.y());
    if (length < 3.0) {
        return;
    }
    const QPointF along = d / length;
    const QPointF across(-along.y(), along.x());
    const double head = std::min(4.0 + 2.0 * width, 0.6 * length);
    painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::FlatCap));
    // A pale head does not lie over the line.
    paintLine(painter, from, to - along * head * (colour.alpha() < 255 ? 1.0 : 0.8));
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawPolygon(QPolygonF{to, to - along * head + across * head * 0.45,
                                  to - along * head - across * head * 0.45});
}

QLineF pulledInside(const QLineF& arrow, const QRectF& inside) {
    const QPointF d = arrow.p2() - arrow.p1();
    double over = 0.0;  // of the arrow's length
    const auto keep = [&](double beyond, double along) {
        if (beyond > 0.0 && along > 0.0) {
            over = std::max(over, beyond / along);
        }
    };
    keep(arrow.x2() - inside.right(), d.x());
    keep(inside.left() - arrow.x2(), -d.x());
    keep(arrow.y2() - inside.bottom(), d.y());
    keep(inside.top() - arrow.y2(), -d.y());
    return arrow.translated(-over * d);
}

void drawRod(QPainter& painter, const QPointF& from, const QPointF& to, double width,
             const QColor& fill, const QColor& line) {
    constexpr double edge = 1.2;  // pixels, around the width
    painter.setPen(QPen(line, edge));
    painter.setBrush(fill);
    paintBar(painter, from, to, 0.5 * (width + edge));
}

QPainterPath weightPath(const QPointF& axis, double angle, double radius, double hubRadius,
                        double half) {
    const double middle = angle / degree;
    const QRectF outer(axis - QPointF(radius, radius), QSizeF(2 * radius, 2 * radius));
    const QRectF hub(axis - QPointF(hubRadius, hubRadius), QSizeF(2 * hubRadius, 2 * hubRadius));
    QPainterPath path;
    path.arcMoveTo(outer, middle - half);
    path.arcTo(outer, middle - half, 2 * half);
    path.arcTo(hub, middle + half, -2 * half);
    path.closeSubpath();
    return path;
}

void drawWeight(QPainter& painter, const QPointF& axis, double angle, double radius,
                const QColor& fill, const QColor& line) {
    painter.setPen(QPen(line, 1.1));
    painter.setBrush(fill);
    painter.drawPath(weightPath(axis, angle, radius, 0.3 * radius, 48.0));
}

void drawTurning(QPainter& painter, const QPointF& centre, double radius, double start,
                 double sweep, const QColor& colour) {
    painter.setPen(QPen(colour, 1.4));
    painter.setBrush(Qt::NoBrush);
    const QRectF box(centre - QPointF(radius, radius), QSizeF(2 * radius, 2 * radius));
    painter.drawArc(box, static_cast<int>(std::lround(start / degree * 16)),
                    static_cast<int>(std::lround(sweep / degree * 16)));
    const double end = start + sweep;
    const QPointF tip = centre + QPointF(std::cos(end), -std::sin(end)) * radius;
    const double turn = sweep > 0.0 ? 1.0 : -1.0;
    const QPointF along(-std::sin(end) * turn, -std::cos(end) * turn);
    const QPointF across(-along.y(), along.x());
    constexpr double head = 6.0;
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawPolygon(QPolygonF{tip + along * head * 0.7, tip - along * head * 0.4 + across * 3.0,
                                  tip - along * head * 0.4 - across * 3.0});
}

void drawCentred(QPainter& painter, const QPointF& middle, const QString& text) {
    constexpr QPointF reach(200.0, 50.0);
    painter.drawText(QRectF(middle - reach, middle + reach), Qt::AlignCenter, text);
}

void drawWithHalo(QPainter& painter, const QRectF& room, int flags, const QString& text) {
    QColor ground = Theme::instance().panel();
    ground.setAlphaF(0.86F);
    const QRectF letters = painter.boundingRect(room, flags, text);
    painter.fillRect(letters.adjusted(-2, 0, 2, 0).toAlignedRect(), ground);
    painter.drawText(room, flags, text);
}

QColor bankColour(int bank) {
    return Theme::instance().colour(series(bank % 4));
}

QColor metal() {
    return Theme::instance().isDark() ? QColor(0x4a525c) : QColor(0xd9dee4);
}

QColor brightMetal() {
    return Theme::instance().isDark() ? QColor(0x5a636e) : QColor(0xeef1f4);
}

QColor weightFill(Role role) {
    return mixed(Theme::instance().panel(), Theme::instance().colour(role), 0.34);
}

}  // namespace ravnoves::drawing
