#include "pictures/model/stroke.h"

#include <QMap>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <utility>

#include "pictures/model/line_brush.h"
#include "pictures/model/pixel.h"

namespace ravnoves {

namespace {

bool canBrush(const QPainter& painter) {
    return paintsPixels(painter) && painter.testRenderHint(QPainter::Antialiasing) &&
           painter.opacity() == 1.0;
}

bool canBrush(const QPen& pen, double scale) {
    return pen.style() != Qt::NoPen && pen.dashOffset() == 0.0 &&
           pen.brush().style() == Qt::SolidPattern && pen.capStyle() != Qt::RoundCap &&
           pen.widthF() * scale >= 1.0;
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
    if (!canBrushAll && all.size() > 1) {
        for (const LinesOfPen& each : all) {
            paintLines(painter, {each});
        }
        return;
    }
    if (!canBrushAll) {
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
    std::vector<LinesOfPen> onDevice;
    QRectF seen;
    for (const LinesOfPen& each : all) {
        LinesOfPen& mapped = onDevice.emplace_back(LinesOfPen{each.pen, {}});
        const double room = each.pen.widthF() * scale + 1.0;
        for (const QPolygonF& line : each.lines) {
            if (line.size() > 1) {
                mapped.lines.push_back(transform.map(line));
                seen |= mapped.lines.back().boundingRect().adjusted(-room, -room, room, room);
            }
        }
    }
    PaintedPixels pixels(painter, seen);
    LineBrush brush(pixels.picture(), pixels.seen().translated(-pixels.corner()));
    for (LinesOfPen& each : onDevice) {
        const double width = each.pen.widthF() * scale;
        const double squareEnd = each.pen.capStyle() == Qt::SquareCap ? 0.5 * width : 0.0;
        for (QPolygonF& line : each.lines) {
            line.translate(-pixels.corner());
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
        brush.draw(each.lines, each.pen.color(), width, dashes);
    }
}

std::vector<QPolygonF> hatchLines(const QPainterPath& area, const QRectF& seen, double apart,
                                  double fall) {
    const auto lineOf = [&](const QPointF& at) { return (at.x() - fall * at.y()) / apart; };
    const auto [first, last] = std::minmax({lineOf(seen.topLeft()), lineOf(seen.topRight()),
                                            lineOf(seen.bottomLeft()), lineOf(seen.bottomRight())});
    QMap<int, std::vector<double>> heights;  // of the points of each line on outlines
    for (const QPolygonF& outline : area.toSubpathPolygons()) {
        for (qsizetype i = 0; i < outline.size(); ++i) {
            QPointF from = outline[i];
            QPointF to = outline[(i + 1) % outline.size()];
            if (lineOf(to) < lineOf(from)) {
                std::swap(from, to);
            }
            const double end = std::min(lineOf(to), last);
            for (double n = std::ceil(std::max(lineOf(from), first)); n < end; ++n) {
                const double part = (n - lineOf(from)) / (lineOf(to) - lineOf(from));
                heights[static_cast<int>(n)].push_back(std::lerp(from.y(), to.y(), part));
            }
        }
    }
    std::vector<QPolygonF> lines;
    for (auto line = heights.begin(); line != heights.end(); ++line) {
        std::vector<double>& y = line.value();
        std::sort(y.begin(), y.end());
        for (std::size_t i = 0; i + 1 < y.size(); i += 2) {
            const double x = line.key() * apart;
            lines.push_back({{x + fall * y[i], y[i]}, {x + fall * y[i + 1], y[i + 1]}});
        }
    }
    return lines;
}

QPolygonF thinPolyline(const std::vector<QPointF>& points, double tolerance) {
    if (points.size() <= 2) {
        return QPolygonF(QList<QPointF>(points.begin(), points.end()));
    }
    std::vector<char> keep(points.size(), 0);
    keep.front() = 1;
    std::size_t kept = 1;
    // In pieces: halving the whole line would look at each point as often as that takes.
    constexpr std::size_t piece = 48;
    std::vector<std::pair<std::size_t, std::size_t>> spans;
    for (std::size_t first = 0; first + 1 < points.size(); first += piece) {
        const std::size_t last = std::min(first + piece, points.size() - 1);
        spans.emplace_back(first, last);
        keep[last] = 1;
        ++kept;
    }
    while (!spans.empty()) {
        const auto [first, last] = spans.back();
        spans.pop_back();
        const QPointF a = points[first];
        const QPointF way = points[last] - a;
        const double reach = QPointF::dotProduct(way, way);
        // A closed span has no direction: any will do.
        const QPointF d = reach > 0.0 ? way : QPointF(1.0, 0.0);
        // Squares of distances, times that of d's length: nothing is divided.
        double farthest = 0.0;
        std::size_t at = first;
        for (std::size_t i = first + 1; i < last; ++i) {
            const QPointF p = points[i] - a;
            // Beside the span the distance to its end counts: a line that comes back on itself
            // keeps its turning points.
            const double along = QPointF::dotProduct(p, d);
            const double across = d.x() * p.y() - d.y() * p.x();
            const double past = along > reach ? along - reach : std::min(along, 0.0);
            const double distance = across * across + past * past;
            if (distance > farthest) {
                farthest = distance;
                at = i;
            }
        }
        if (farthest > tolerance * tolerance * QPointF::dotProduct(d, d)) {
            keep[at] = 1;
            ++kept;
            spans.emplace_back(first, at);
            spans.emplace_back(at, last);
        }
    }
    QPolygonF thinned;
    thinned.reserve(static_cast<qsizetype>(kept));
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (keep[i] != 0) {
            thinned.append(points[i]);
        }
    }
    return thinned;
}

}  // namespace ravnoves
