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
           transform.m11() == transform.m22();
}

bool canBrush(const QPen& pen, double scale) {
    return pen.style() == Qt::SolidLine && pen.capStyle() != Qt::RoundCap &&
           pen.widthF() * scale >= 1.0;
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
    paintLines(painter, {{painter.pen(), {line}}});
}

void paintLines(QPainter& painter, const std::vector<LinesOfPen>& all) {
    const QTransform& transform = painter.deviceTransform();
    const double scale = transform.m11();
    const bool canBrushAll =
        canBrush(painter) && std::all_of(all.begin(), all.end(), [&](const LinesOfPen& each) {
            return canBrush(each.pen, scale);
        });
    std::vector<LinesOfPen> onDevice;
    std::optional<Overlay> overlay;
    if (canBrushAll) {
        QRectF seen;
        for (const LinesOfPen& each : all) {
            LinesOfPen& mapped = onDevice.emplace_back(LinesOfPen{each.pen, {}});
            mapped.lines.reserve(each.lines.size());
            for (const QPolygonF& line : each.lines) {
                if (line.size() > 1) {
                    mapped.lines.push_back(transform.map(line));
                }
            }
            seen |= seenPart(painter, mapped.lines, each.pen.widthF() * scale + 1.0);
        }
        overlay = overlayFor(seen);
    }
    if (!overlay) {
        const QPen before = painter.pen();
        for (const LinesOfPen& each : all) {
            painter.setPen(each.pen);
            for (const QPolygonF& line : each.lines) {
                painter.drawPolyline(line);
            }
        }
        painter.setPen(before);
        return;
    }
    LineBrush brush(overlay->picture, overlay->picture.rect());
    for (LinesOfPen& each : onDevice) {
        const double width = each.pen.widthF() * scale;
        const double squareEnd = each.pen.capStyle() == Qt::SquareCap ? 0.5 * width : 0.0;
        for (QPolygonF& line : each.lines) {
            line.translate(-overlay->corner);
            const qsizetype last = line.size() - 1;
            const QPointF atStart = along(line[0], line[1], squareEnd);
            const QPointF atEnd = along(line[last - 1], line[last], squareEnd);
            line.front() -= atStart;
            line.back() += atEnd;
        }
        brush.draw(each.lines, 1.0, each.pen.color(), width);
    }
    lay(painter, *overlay);
}

void paintPolygon(QPainter& painter, const QPolygonF& polygon) {
    const QPen pen = painter.pen();
    const auto corners = static_cast<int>(polygon.size());
    const double scale = painter.deviceTransform().m11();
    if (corners < 3 || pen.widthF() * scale <= 1.0 || !canBrush(painter) || !canBrush(pen, scale)) {
        painter.drawConvexPolygon(polygon.constData(), corners);
        return;
    }
    painter.setPen(Qt::NoPen);
    painter.drawConvexPolygon(polygon.constData(), corners);
    painter.setPen(pen);
    // Past its first corner, so that this has a bend as the others have.
    QPolygonF outline = polygon;
    outline << polygon[0] << polygon[1];
    paintLine(painter, outline);
}

}  // namespace ravnoves
