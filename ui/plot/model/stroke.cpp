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

/// What of lines on the device is seen.
QRectF seenPart(const QPainter& painter, const std::vector<QPolygonF>& onDevice, double room) {
    QRectF box;
    for (const QPolygonF& line : onDevice) {
        box |= line.boundingRect().adjusted(-room, -room, room, room);
    }
    return painter.hasClipping()
               ? box & painter.deviceTransform().mapRect(painter.clipBoundingRect())
               : box;
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
    paintLines(painter, {line});
}

void paintLines(QPainter& painter, const std::vector<QPolygonF>& lines) {
    const QPen pen = painter.pen();
    const QTransform& transform = painter.deviceTransform();
    const double width = pen.widthF() * transform.m11();
    std::vector<QPolygonF> onDevice;
    std::optional<Overlay> overlay;
    if (width >= 1.0 && pen.capStyle() != Qt::RoundCap && canBrush(painter)) {
        onDevice.reserve(lines.size());
        for (const QPolygonF& line : lines) {
            if (line.size() > 1) {
                onDevice.push_back(transform.map(line));
            }
        }
        overlay = overlayFor(seenPart(painter, onDevice, width + 1.0));
    }
    if (!overlay) {
        for (const QPolygonF& line : lines) {
            painter.drawPolyline(line);
        }
        return;
    }
    const double squareEnd = pen.capStyle() == Qt::SquareCap ? 0.5 * width : 0.0;
    for (QPolygonF& line : onDevice) {
        line.translate(-overlay->corner);
        const qsizetype last = line.size() - 1;
        const QPointF atStart = along(line[0], line[1], squareEnd);
        const QPointF atEnd = along(line[last - 1], line[last], squareEnd);
        line.front() -= atStart;
        line.back() += atEnd;
    }
    LineBrush(overlay->picture, overlay->picture.rect()).draw(onDevice, 1.0, pen.color(), width);
    lay(painter, *overlay);
}

}  // namespace ravnoves
