#include "pictures/model/stroke.h"

#include <QImage>
#include <QMap>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "pictures/model/line_brush.h"
#include "pictures/model/pixel.h"

namespace ravnoves {

namespace {

/// A picture of part of the screen, which is laid over it.
struct Overlay {
    QImage picture;
    QPoint corner;  ///< on the device
};

bool canBrush(const QPainter& painter) {
    return paintsPixels(painter) && painter.testRenderHint(QPainter::Antialiasing) &&
           painter.opacity() == 1.0;
}

bool canBrush(const QPen& pen, double scale) {
    return pen.style() != Qt::NoPen && pen.style() != Qt::CustomDashLine &&
           pen.brush().style() == Qt::SolidPattern && pen.capStyle() != Qt::RoundCap &&
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
    constexpr double maximum = 4e6;  // pixels
    if (!(box.width() * box.height() < maximum) || !(box.width() < maximum) ||
        !(box.height() < maximum)) {
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
    PaintedPixels pixels;
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
        pixels = pixelsOf(painter, seen);
        if (pixels.picture == nullptr) {
            overlay = overlayFor(seen);
        }
    }
    const bool canDraw = canBrushAll && (overlay || pixels.picture != nullptr);
    if (!canDraw && all.size() > 1) {
        for (const LinesOfPen& each : all) {
            paintLines(painter, {each});
        }
        return;
    }
    if (!canDraw) {
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
    const QPoint corner = overlay ? overlay->corner : QPoint();
    LineBrush brush(overlay ? overlay->picture : *pixels.picture,
                    overlay ? overlay->picture.rect() : pixels.seen);
    for (LinesOfPen& each : onDevice) {
        const double width = each.pen.widthF() * scale;
        const double squareEnd = each.pen.capStyle() == Qt::SquareCap ? 0.5 * width : 0.0;
        for (QPolygonF& line : each.lines) {
            line.translate(-corner);
            const qsizetype last = line.size() - 1;
            const QPointF atStart = along(line[0], line[1], squareEnd);
            const QPointF atEnd = along(line[last - 1], line[last], squareEnd);
            line.front() -= atStart;
            line.back() += atEnd;
        }
        QList<qreal> dashes =
            each.pen.style() == Qt::SolidLine ? QList<qreal>() : each.pen.dashPattern();
        for (qsizetype i = 0; i < dashes.size(); ++i) {
            // Square ends are those of each dash.
            const double more =
                each.pen.capStyle() == Qt::SquareCap ? (i % 2 == 0 ? 1.0 : -1.0) : 0.0;
            dashes[i] = std::max(0.0, dashes[i] + more) * width;
        }
        brush.draw(each.lines, 1.0, each.pen.color(), width, dashes);
    }
    if (overlay) {
        lay(painter, *overlay);
    }
}

void paintGridLines(QPainter& painter, const QList<QLineF>& lines) {
    const QPen pen = painter.pen();
    const QTransform& transform = painter.deviceTransform();
    const double scale = transform.m11();
    if (!canBrush(painter) || !canBrush(pen, scale) || pen.style() != Qt::SolidLine) {
        painter.drawLines(lines);
        return;
    }
    const double half = 0.5 * pen.widthF() * scale;
    const double beyond = pen.capStyle() == Qt::FlatCap ? 0.0 : half;
    const QTransform back = transform.inverted();
    const auto fill = [&](double left, double top, double right, double bottom) {
        const double part = std::min(1.0, right - left) * std::min(1.0, bottom - top);
        QColor colour = pen.color();
        colour.setAlphaF(static_cast<float>(colour.alphaF() * part));
        if (colour.alpha() > 0) {
            painter.fillRect(back.mapRect(QRectF(QPointF(std::floor(left), std::floor(top)),
                                                 QPointF(std::ceil(right), std::ceil(bottom)))),
                             colour);
        }
    };
    // Pixels that are covered in part are apart: before, within and after.
    const auto parts = [](double from, double to) {
        std::vector<std::pair<double, double>> parts;
        const double first = std::min(std::ceil(from), to);
        const double last = std::max(std::floor(to), first);
        for (const auto& part : {std::pair(from, first), {first, last}, {last, to}}) {
            if (part.second > part.first) {
                parts.push_back(part);
            }
        }
        return parts;
    };
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, false);
    for (const QLineF& line : lines) {
        const QLineF at = transform.map(line);
        const bool isUpright = at.x1() == at.x2();
        const double x = isUpright ? half : beyond;
        const double y = isUpright ? beyond : half;
        for (const auto& [left, right] :
             parts(std::min(at.x1(), at.x2()) - x, std::max(at.x1(), at.x2()) + x)) {
            for (const auto& [top, bottom] :
                 parts(std::min(at.y1(), at.y2()) - y, std::max(at.y1(), at.y2()) + y)) {
                fill(left, top, right, bottom);
            }
        }
    }
    painter.restore();
}

QList<QLineF> hatchLines(const QPainterPath& area, double apart, double fall) {
    const QList<QPolygonF> outlines = area.toSubpathPolygons();
    const auto lineOf = [&](const QPointF& at) { return (at.x() - fall * at.y()) / apart; };
    QMap<int, std::vector<double>> heights;  // of the points of each line on outlines
    for (const QPolygonF& outline : outlines) {
        for (qsizetype i = 0; i < outline.size(); ++i) {
            QPointF from = outline[i];
            QPointF to = outline[(i + 1) % outline.size()];
            if (lineOf(to) < lineOf(from)) {
                std::swap(from, to);
            }
            for (int n = static_cast<int>(std::ceil(lineOf(from))); n < lineOf(to); ++n) {
                const double part = (n - lineOf(from)) / (lineOf(to) - lineOf(from));
                heights[n].push_back(std::lerp(from.y(), to.y(), part));
            }
        }
    }
    QList<QLineF> lines;
    for (auto line = heights.begin(); line != heights.end(); ++line) {
        std::vector<double>& y = line.value();
        std::sort(y.begin(), y.end());
        for (std::size_t i = 0; i + 1 < y.size(); i += 2) {
            const double x = line.key() * apart;
            lines.append({x + fall * y[i], y[i], x + fall * y[i + 1], y[i + 1]});
        }
    }
    return lines;
}

}  // namespace ravnoves
