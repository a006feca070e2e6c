#include "pictures/model/shape.h"

#include <QImage>
#include <QPaintEngine>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "numerics/constants.h"
#include "pictures/model/stroke.h"

namespace ravnoves {

namespace {

bool canBrush(const QPainter& painter) {
    const Qt::PenStyle pen = painter.pen().style();
    return paintsPixels(painter) && painter.testRenderHint(QPainter::Antialiasing) &&
           (pen == Qt::SolidLine || pen == Qt::NoPen);
}

/// What lets through is laid over the picture once: Qt hands it to threads and waits for them.
void fill(QPainter& painter, const QPainterPath& shape) {
    QColor colour = painter.brush().color();
    if (painter.brush().style() != Qt::SolidPattern || colour.alpha() == 255) {
        painter.fillPath(shape, painter.brush());
        return;
    }
    const QTransform& transform = painter.deviceTransform();
    const QPaintDevice& device = *painter.paintEngine()->paintDevice();
    const QRect box = transform.mapRect(shape.boundingRect()).toAlignedRect() &
                      QRect(0, 0, device.width(), device.height());
    if (box.isEmpty()) {
        return;
    }
    QImage layer(box.size(), QImage::Format_ARGB32_Premultiplied);
    layer.fill(Qt::transparent);
    const double opacity = painter.opacity();
    painter.setOpacity(opacity * colour.alphaF());
    colour.setAlpha(255);
    QPainter on(&layer);
    on.setRenderHint(QPainter::Antialiasing);
    on.setTransform(transform * QTransform::fromTranslate(-box.x(), -box.y()));
    on.fillPath(shape, colour);
    on.end();
    layer.setDevicePixelRatio(transform.m11());
    painter.drawImage(transform.inverted().map(QPointF(box.topLeft())), layer);
    painter.setOpacity(opacity);
}

void paint(QPainter& painter, const QPainterPath& shape) {
    if (!canBrush(painter)) {
        painter.drawPath(shape);
        return;
    }
    fill(painter, shape);
    if (painter.pen().style() == Qt::NoPen) {
        return;
    }
    const double fine = 4.0 * painter.deviceTransform().m11();  // of a pixel's parts
    QPolygonF outline = shape.toFillPolygon(QTransform::fromScale(fine, fine));
    for (QPointF& each : outline) {
        each /= fine;
    }
    outline << outline.value(1);  // its first corner is as the others
    QPen pen = painter.pen();
    pen.setCapStyle(Qt::FlatCap);
    paintLines(painter, {{pen, {outline}}});
}

QPainterPath rounded(const QRectF& block, double corner) {
    QPainterPath path;
    path.addRoundedRect(block, corner, corner);
    return path;
}

}  // namespace

void paintDisc(QPainter& painter, const QPointF& middle, double radius) {
    QPainterPath disc;
    disc.addEllipse(middle, radius, radius);
    paint(painter, disc);
}

void paintPolygon(QPainter& painter, const QPolygonF& polygon) {
    if (!canBrush(painter)) {
        painter.drawConvexPolygon(polygon);
        return;
    }
    QPainterPath path;
    path.addPolygon(polygon);
    path.closeSubpath();
    paint(painter, path);
}

void paintBlock(QPainter& painter, const QRectF& block, double corner) {
    const QRectF whole = block.normalized();
    paint(painter, rounded(whole, std::min({corner, 0.5 * whole.width(), 0.5 * whole.height()})));
}

void paintBar(QPainter& painter, const QPointF& from, const QPointF& to, double radius) {
    const QPointF way = to - from;
    const double length = std::hypot(way.x(), way.y());
    QTransform place = QTransform::fromTranslate(from.x(), from.y());
    place.rotate(std::atan2(way.y(), way.x()) / degree);
    paint(painter, place.map(rounded(QRectF(-radius, -radius, length + 2.0 * radius, 2.0 * radius),
                                     radius)));
}

}  // namespace ravnoves
