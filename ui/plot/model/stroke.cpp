#include "plot/model/stroke.h"

#include <QImage>
#include <QPaintEngine>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <optional>

#include "plot/model/line_brush.h"

namespace ravnoves {

namespace {

/// A picture of part of the screen, which is laid over it.
struct Overlay {
    QImage picture;
    QPoint corner;  ///< on the device
};

bool canBrush(const QPainter& painter) {
    const QTransform& transform = painter.deviceTransform();
    return painter.paintEngine()->type() == QPaintEngine::Raster &&
           painter.testRenderHint(QPainter::Antialiasing) && painter.opacity() == 1.0 &&
           transform.type() <= QTransform::TxScale && transform.m11() > 0.0 &&
           transform.m11() == transform.m22() && painter.pen().style() == Qt::SolidLine;
}

/// None where it would be too large, as what lies far outside is.
std::optional<Overlay> overlayFor(const QRectF& box) {
    constexpr double most = 4e6;  // pixels
    if (!(box.width() * box.height() < most) || !(box.width() < most) || !(box.height() < most)) {
        return std::nullopt;
    }
    const QRect whole = box.toAlignedRect();
    Overlay overlay{QImage(whole.size(), QImage::Format_ARGB32_Premultiplied), whole.topLeft()};
    overlay.picture.fill(Qt::transparent);
    return overlay;
}

void lay(QPainter& painter, Overlay& overlay) {
    const QTransform& transform = painter.deviceTransform();
    overlay.picture.setDevicePixelRatio(transform.m11());
    painter.drawImage(transform.inverted().map(QPointF(overlay.corner)), overlay.picture);
}

/// A way of this length along a line.
QPointF along(const QPointF& from, const QPointF& to, double length) {
    const QPointF way = to - from;
    const double whole = std::hypot(way.x(), way.y());
    return whole > 0.0 ? way * (length / whole) : QPointF();
}

}  // namespace

void paintLine(QPainter& painter, const QPolygonF& line) {
    const QPen pen = painter.pen();
    const double scale = painter.deviceTransform().m11();
    const double width = pen.widthF() * scale;
    if (line.size() < 2 || width < 1.0 || pen.capStyle() == Qt::RoundCap || !canBrush(painter)) {
        painter.drawPolyline(line);
        return;
    }
    QPolygonF onDevice = painter.deviceTransform().map(line);
    const double room = width + 1.0;
    auto overlay = overlayFor(onDevice.boundingRect().adjusted(-room, -room, room, room));
    if (!overlay) {
        painter.drawPolyline(line);
        return;
    }
    onDevice.translate(-overlay->corner);
    LineBrush brush(overlay->picture, overlay->picture.rect());
    if (pen.capStyle() == Qt::SquareCap) {
        const double half = 0.5 * width;
        const qsizetype last = onDevice.size() - 1;
        const QPointF atStart = along(onDevice[0], onDevice[1], half);
        const QPointF atEnd = along(onDevice[last - 1], onDevice[last], half);
        onDevice.front() -= atStart;
        onDevice.back() += atEnd;
    }
    brush.draw({onDevice}, 1.0, pen.color(), width);
    lay(painter, *overlay);
}

}  // namespace ravnoves
