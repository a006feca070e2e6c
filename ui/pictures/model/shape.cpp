#include "pictures/model/shape.h"

#include <QImage>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "numerics/constants.h"
#include "pictures/model/pixel.h"

namespace ravnoves {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

struct Ink {
    double red = 0.0;
    double green = 0.0;
    double blue = 0.0;
    double alpha = 0.0;

    explicit Ink(const QColor& colour)
        : red(colour.redF()),
          green(colour.greenF()),
          blue(colour.blueF()),
          alpha(colour.alphaF()) {}
};

/// Line over ground, each covering part of a pixel; premultiplied.
QRgb over(const Ink& line, double lineCover, const Ink& ground, double groundCover) {
    const double top = line.alpha * lineCover;
    const double under = ground.alpha * groundCover * (1.0 - top);
    const auto part = [&](double a, double b) { return pixelStep(a * top + b * under); };
    return qRgba(part(line.red, ground.red), part(line.green, ground.green),
                 part(line.blue, ground.blue), pixelStep(top + under));
}

/// Where a row of pixels meets a shape; nothing where the first is the greater.
using Stretch = std::pair<double, double>;
constexpr Stretch nothing{infinite, -infinite};

Stretch both(const Stretch& one, const Stretch& other) {
    return {std::min(one.first, other.first), std::max(one.second, other.second)};
}

/// All within a distance of a point.
Stretch nearPoint(const QPointF& point, double y, double distance) {
    const double up = y - point.y();
    if (!(std::abs(up) < distance)) {
        return nothing;
    }
    const double wide = std::sqrt(distance * distance - up * up);
    return {point.x() - wide, point.x() + wide};
}

/// A half-plane: how far a place is outside it.
struct Side {
    QPointF outwards;
    double at = 0.0;

    double distance(double x, double y) const { return outwards.x() * x + outwards.y() * y - at; }
};

/// Where a row is no farther outside than a distance, of each of the sides.
template <typename Sides>
Stretch within(const Sides& sides, double y, double distance) {
    constexpr double flat = 1e-9;
    Stretch stretch(-infinite, infinite);
    for (const Side& side : sides) {
        const double x = side.outwards.x();
        const double left = distance + side.at - side.outwards.y() * y;
        if (x > flat) {
            stretch.second = std::min(stretch.second, left / x);
        } else if (x < -flat) {
            stretch.first = std::max(stretch.first, left / x);
        } else if (left < 0.0) {
            return nothing;
        }
    }
    return stretch;
}

// What a shape knows: how far a place is outside its edge, less than nothing inside; where a row is
// no farther outside than a distance; its box. In pixels of the device.

struct Disc {
    QPointF middle;
    double radius;

    double distance(double x, double y) const {
        const double across = x - middle.x();
        const double up = y - middle.y();
        return std::sqrt(across * across + up * up) - radius;
    }
    Stretch row(double y, double distance) const { return nearPoint(middle, y, radius + distance); }
    QRectF box() const { return {middle - QPointF(radius, radius), 2.0 * QSizeF(radius, radius)}; }
};

struct Polygon {
    std::vector<Side> sides;
    QRectF bounds;

    explicit Polygon(const QPolygonF& corners) : bounds(corners.boundingRect()) {
        double area = 0.0;
        for (qsizetype i = 0; i < corners.size(); ++i) {
            const QPointF& from = corners[i];
            const QPointF& to = corners[i + 1 < corners.size() ? i + 1 : 0];
            area += from.x() * to.y() - from.y() * to.x();
        }
        for (qsizetype i = 0; i < corners.size(); ++i) {
            const QPointF& from = corners[i];
            const QPointF way = corners[i + 1 < corners.size() ? i + 1 : 0] - from;
            const double length = std::hypot(way.x(), way.y());
            if (length > 1e-9) {
                const QPointF outwards =
                    QPointF(way.y(), -way.x()) * ((area < 0.0 ? -1.0 : 1.0) / length);
                sides.push_back({outwards, QPointF::dotProduct(outwards, from)});
            }
        }
    }
    double distance(double x, double y) const {
        double maximum = -infinite;
        for (const Side& side : sides) {
            maximum = std::max(maximum, side.distance(x, y));
        }
        return maximum;
    }
    Stretch row(double y, double distance) const { return within(sides, y, distance); }
    QRectF box() const { return bounds; }
};

struct Bar {
    QPointF from;
    QPointF to;
    double radius;
    double length;
    QPointF along;

    Bar(const QPointF& start, const QPointF& end, double around)
        : from(start),
          to(end),
          radius(around),
          length(std::hypot((end - start).x(), (end - start).y())),
          along(length > 0.0 ? (end - start) / length : QPointF(1.0, 0.0)) {}

    double distance(double x, double y) const {
        const double dx = x - from.x();
        const double dy = y - from.y();
        const double at = std::clamp(dx * along.x() + dy * along.y(), 0.0, length);
        const double across = dx - at * along.x();
        const double up = dy - at * along.y();
        return std::sqrt(across * across + up * up) - radius;
    }
    Stretch row(double y, double distance) const {
        const double reach = radius + distance;
        const QPointF aside(-along.y(), along.x());
        const double middle = QPointF::dotProduct(aside, from);
        const std::array sides{Side{along, QPointF::dotProduct(along, to)},
                               Side{-along, -QPointF::dotProduct(along, from)},
                               Side{aside, middle + reach}, Side{-aside, reach - middle}};
        Stretch straight = reach > 0.0 ? within(sides, y, 0.0) : nothing;
        if (straight.first > straight.second) {
            straight = nothing;
        }
        return both(straight, both(nearPoint(from, y, reach), nearPoint(to, y, reach)));
    }
    QRectF box() const {
        return QRectF(from, to).normalized().adjusted(-radius, -radius, radius, radius);
    }
};

struct Block {
    QRectF core;  ///< the edge is this far from it
    double corner;

    double distance(double x, double y) const {
        const double across = std::max(core.left() - x, x - core.right());
        const double up = std::max(core.top() - y, y - core.bottom());
        return std::hypot(std::max(across, 0.0), std::max(up, 0.0)) +
               std::min(std::max(across, up), 0.0) - corner;
    }
    Stretch row(double y, double distance) const {
        const double reach = corner + distance;
        const double up = std::max(core.top() - y, y - core.bottom());
        if (!(up < reach)) {
            return nothing;
        }
        const double wide = up > 0.0 ? std::sqrt(reach * reach - up * up) : reach;
        return {core.left() - wide, core.right() + wide};
    }
    QRectF box() const { return core.adjusted(-corner, -corner, corner, corner); }
};

bool canMeasure(const QPainter& painter, const QSizeF& size) {
    constexpr double largest = 4000.0;  // pixels
    const QTransform& transform = painter.deviceTransform();
    const Qt::PenStyle pen = painter.pen().style();
    const Qt::BrushStyle brush = painter.brush().style();
    return paintsPixels(painter) && painter.testRenderHint(QPainter::Antialiasing) &&
           (pen == Qt::SolidLine || pen == Qt::NoPen) &&
           (brush == Qt::SolidPattern || brush == Qt::NoBrush) &&
           size.width() * transform.m11() < largest && size.height() * transform.m11() < largest;
}

template <typename Shape>
void paint(QPainter& painter, const Shape& shape) {
    const QTransform& transform = painter.deviceTransform();
    const double scale = transform.m11();
    const bool hasLine = painter.pen().style() != Qt::NoPen;
    const bool isFilled = painter.brush().style() != Qt::NoBrush;
    const Ink line(painter.pen().color());
    const Ink ground(painter.brush().color());
    const double half = hasLine ? 0.5 * std::max(1.0, painter.pen().widthF() * scale) : 0.0;
    const double reach = half + 1.0;
    const QRect box = shape.box().adjusted(-reach, -reach, reach, reach).toAlignedRect();
    const auto [picture, pixels] = pixelsOf(painter, QRectF(box));
    QImage layer;
    const QRect seen = picture != nullptr ? pixels : box;
    if (picture == nullptr) {
        layer = QImage(box.size(), QImage::Format_ARGB32_Premultiplied);
        layer.fill(Qt::transparent);
    }
    const QRgb inside = over(line, 0.0, ground, isFilled ? 1.0 : 0.0);
    const QPoint origin = picture != nullptr ? QPoint() : box.topLeft();  // of the pixels
    for (int row = seen.top(); row <= seen.bottom(); ++row) {
        const double y = row + 0.5;
        const Stretch touched = shape.row(y, reach);
        if (!(touched.first < touched.second)) {
            continue;
        }
        const Stretch clear = shape.row(y, -reach);  // nothing of the edge is nearer
        // The first pixel whose middle is no less.
        const auto column = [&seen](double x) {
            return static_cast<int>(std::ceil(
                std::clamp(x - 0.5, static_cast<double>(seen.left()), seen.right() + 1.0)));
        };
        const int first = column(touched.first);
        const int last = column(touched.second);
        const bool hasClear = clear.first < clear.second;
        const int clearFirst = hasClear ? std::min(column(clear.first), last) : last;
        const int clearLast = hasClear ? std::clamp(column(clear.second), clearFirst, last) : last;
        QImage& onto = picture != nullptr ? *picture : layer;
        auto* pixels = reinterpret_cast<QRgb*>(onto.scanLine(row - origin.y())) - origin.x();
        const auto draw = [&](int begin, int end) {
            for (int i = begin; i < end; ++i) {
                const double away = shape.distance(i + 0.5, y);
                const double onLine =
                    hasLine ? std::clamp(half + 0.5 - std::abs(away), 0.0, 1.0) : 0.0;
                const double onGround = isFilled ? std::clamp(0.5 - away, 0.0, 1.0) : 0.0;
                if (onLine > 0.0 || onGround > 0.0) {
                    pixels[i] = laidOver(over(line, onLine, ground, onGround), pixels[i]);
                }
            }
        };
        draw(first, clearFirst);
        if (qAlpha(inside) == 255) {
            std::fill(pixels + clearFirst, pixels + clearLast, inside);
        } else if (qAlpha(inside) > 0) {
            std::transform(pixels + clearFirst, pixels + clearLast, pixels + clearFirst,
                           [inside](QRgb below) { return laidOver(inside, below); });
        }
        draw(clearLast, last);
    }
    if (picture == nullptr) {
        layer.setDevicePixelRatio(scale);
        painter.drawImage(transform.inverted().map(QPointF(origin)), layer);
    }
}

}  // namespace

void paintDisc(QPainter& painter, const QPointF& middle, double radius) {
    if (!canMeasure(painter, 2.0 * QSizeF(radius, radius))) {
        painter.drawEllipse(middle, radius, radius);
        return;
    }
    const QTransform& transform = painter.deviceTransform();
    paint(painter, Disc{transform.map(middle), radius * transform.m11()});
}

void paintPolygon(QPainter& painter, const QPolygonF& polygon) {
    if (polygon.size() < 3 || !canMeasure(painter, polygon.boundingRect().size())) {
        painter.drawConvexPolygon(polygon);
        return;
    }
    paint(painter, Polygon(painter.deviceTransform().map(polygon)));
}

void paintBlock(QPainter& painter, const QRectF& block, double corner) {
    const QRectF whole = block.normalized();
    const double round = std::min({corner, 0.5 * whole.width(), 0.5 * whole.height()});
    if (!canMeasure(painter, whole.size())) {
        painter.drawRoundedRect(whole, round, round);
        return;
    }
    const QTransform& transform = painter.deviceTransform();
    paint(painter, Block{transform.mapRect(whole.adjusted(round, round, -round, -round)),
                         round * transform.m11()});
}

void paintBar(QPainter& painter, const QPointF& from, const QPointF& to, double radius) {
    const QRectF box = QRectF(from, to).normalized();
    if (!canMeasure(painter, box.size())) {
        const QPointF way = to - from;
        const double length = std::hypot(way.x(), way.y());
        painter.save();
        painter.translate(from);
        painter.rotate(std::atan2(way.y(), way.x()) / degree);
        painter.drawRoundedRect(QRectF(-radius, -radius, length + 2.0 * radius, 2.0 * radius),
                                radius, radius);
        painter.restore();
        return;
    }
    const QTransform& transform = painter.deviceTransform();
    paint(painter, Bar(transform.map(from), transform.map(to), radius * transform.m11()));
}

}  // namespace ravnoves
