#include "pictures/model/shape.h"

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

struct Ink {
    std::array<float, 4> steps;  ///< of blue, green, red and alpha, where it covers all
    float alpha;

    explicit Ink(const QColor& colour)
        : steps{255.0F * colour.blueF(), 255.0F * colour.greenF(), 255.0F * colour.redF(), 255.0F},
          alpha(colour.alphaF()) {}
};

/// Line over ground, each covering part of a pixel; premultiplied.
QRgb over(const Ink& line, double lineCover, const Ink& ground, double groundCover) {
    const float top = line.alpha * static_cast<float>(lineCover);
    const float under = ground.alpha * static_cast<float>(groundCover) * (1.0F - top);
    QRgb pixel = 0;
    for (std::size_t i = 0; i < line.steps.size(); ++i) {
        const float step = line.steps[i] * top + ground.steps[i] * under;
        pixel |= static_cast<QRgb>(step + 0.5F) << (8 * i);
    }
    return pixel;
}

/// A convex polygon grown by a radius, in pixels of the device: of one corner a disc, of two a bar
/// with round ends.
class RoundedPolygon {
  public:
    RoundedPolygon(const QPolygonF& corners, double radius)
        : radius_(radius), box_(corners.boundingRect().adjusted(-radius, -radius, radius, radius)) {
        double area = 0.0;
        for (qsizetype i = 0; i < corners.size(); ++i) {
            const QPointF& from = corners[i];
            const QPointF& to = corners[(i + 1) % corners.size()];
            area += from.x() * to.y() - from.y() * to.x();
            const QPointF way = to - from;
            const double length = std::hypot(way.x(), way.y());
            if (length > 1e-9) {
                sides_.push_back({from, way / length, length});
            }
        }
        if (sides_.empty()) {
            sides_.push_back({corners.front(), {}, 0.0});
        }
        turn_ = area < 0.0 ? -1.0 : 1.0;
    }

    /// How far a place is outside the edge; less than nothing inside.
    double distance(const QPointF& place) const {
        if (isDisc()) {
            const QPointF from = place - sides_.front().from;
            return std::sqrt(QPointF::dotProduct(from, from)) - radius_;
        }
        double outside = -infinite;
        double along = 0.0;
        double length = 0.0;
        for (const Side& side : sides_) {
            const QPointF from = place - side.from;
            const double out = turn_ * (from.x() * side.along.y() - from.y() * side.along.x());
            if (out > outside) {
                outside = out;
                along = QPointF::dotProduct(from, side.along);
                length = side.length;
            }
        }
        // Where several sides are seen, the corner is an end of that which is farthest.
        const double beyond = std::max({0.0, -along, along - length});
        return (outside < 0.0 || radius_ == 0.0 || beyond == 0.0
                    ? outside
                    : std::sqrt(outside * outside + beyond * beyond)) -
               radius_;
    }
    const QRectF& box() const { return box_; }
    /// Where the distance is the row's alone: nearer than `reach` there is an upper or lower edge
    /// only. Of a block; the first is the greater of anything else.
    std::pair<double, double> level(double reach) const {
        const bool isBlock =
            sides_.size() == 4 && sides_[0].along.y() == 0.0 && sides_[1].along.x() == 0.0;
        const double aside = isBlock ? radius_ + reach : infinite;
        return {box_.left() + aside, box_.right() - aside};
    }
    /// Where a row is no farther outside than a distance, and perhaps somewhat more; inside, for a
    /// distance less than nothing, perhaps somewhat less. From, to; the first is the greater where
    /// there is nothing.
    std::pair<double, double> row(double y, double distance) const {
        constexpr double flat = 1e-9;
        const double grown = radius_ + distance;
        if (isDisc()) {
            const QPointF& middle = sides_.front().from;
            const double up = y - middle.y();
            const double wide = std::sqrt(std::max(0.0, grown * grown - up * up));
            return {middle.x() - (grown > 0.0 ? wide : -1.0), middle.x() + wide};
        }
        std::pair range(box_.left() - distance, box_.right() + distance);
        const auto keep = [&](const QPointF& outwards, const QPointF& from, double beyond) {
            const double x = outwards.x();
            const double room = beyond + QPointF::dotProduct(outwards, from) - outwards.y() * y;
            if (x > flat) {
                range.second = std::min(range.second, room / x);
            } else if (x < -flat) {
                range.first = std::max(range.first, room / x);
            } else if (room < 0.0) {
                range.second = -infinite;
            }
        };
        const bool isBar = sides_.size() < 3;
        for (const Side& side : sides_) {
            keep(turn_ * QPointF(side.along.y(), -side.along.x()), side.from,
                 distance < 0.0 && !isBar ? std::min(grown, 0.0) : grown);
            if (distance < 0.0 && isBar) {
                keep(-side.along, side.from, 0.0);  // between its ends
            }
        }
        return range;
    }

  private:
    struct Side {
        QPointF from;
        QPointF along;
        double length;
    };
    bool isDisc() const { return sides_.front().length == 0.0; }

    static constexpr double infinite = std::numeric_limits<double>::infinity();

    double radius_;
    QRectF box_;
    double turn_ = 1.0;  ///< which side of its sides is outside
    std::vector<Side> sides_;
};

bool canMeasure(const QPainter& painter) {
    const Qt::PenStyle pen = painter.pen().style();
    const Qt::BrushStyle brush = painter.brush().style();
    return paintsPixels(painter) && painter.testRenderHint(QPainter::Antialiasing) &&
           (pen == Qt::SolidLine || pen == Qt::NoPen) &&
           (brush == Qt::SolidPattern || brush == Qt::NoBrush);
}

void paint(QPainter& painter, const QPolygonF& corners, double radius) {
    const QTransform& transform = painter.deviceTransform();
    const double scale = transform.m11();
    const RoundedPolygon shape(transform.map(corners), radius * scale);
    const bool hasLine = painter.pen().style() != Qt::NoPen;
    const bool isFilled = painter.brush().style() != Qt::NoBrush;
    const Ink line(painter.pen().color());
    const Ink ground(painter.brush().color());
    const double half = hasLine ? 0.5 * std::max(1.0, painter.pen().widthF() * scale) : 0.0;
    const double reach = half + 0.5;
    PaintedPixels painted(painter, shape.box().adjusted(-reach, -reach, reach, reach));
    const QRgb inside = over(line, 0.0, ground, isFilled ? 1.0 : 0.0);
    const QPoint corner = painted.corner();
    const QRect& seen = painted.seen();
    // The first pixel whose middle is no less.
    const auto columnAt = [&seen](double x) {
        return static_cast<int>(
            std::ceil(std::clamp(x - 0.5, seen.left() + 0.0, seen.right() + 1.0)));
    };
    for (int row = seen.top(); row <= seen.bottom(); ++row) {
        auto* pixels =
            reinterpret_cast<QRgb*>(painted.picture().scanLine(row - corner.y())) - corner.x();
        const double y = row + 0.5;
        const auto inkAt = [&](int column) {
            const double away = shape.distance({column + 0.5, y});
            const double onLine = hasLine ? std::clamp(half + 0.5 - std::abs(away), 0.0, 1.0) : 0.0;
            const double onGround = isFilled ? std::clamp(0.5 - away, 0.0, 1.0) : 0.0;
            return over(line, onLine, ground, onGround);
        };
        const auto draw = [&](int begin, int end) {
            for (int column = begin; column < end; ++column) {
                pixels[column] = laidOver(inkAt(column), pixels[column]);
            }
        };
        const auto touched = shape.row(y, reach);
        auto even = shape.row(y, -reach);  // nothing of the edge is nearer
        const int last = columnAt(touched.second);
        const bool isEdge = columnAt(even.first) >= columnAt(even.second);
        even = isEdge ? shape.level(reach) : even;
        const int evenFirst = std::min(columnAt(even.first), last);
        const int evenLast = std::clamp(columnAt(even.second), evenFirst, last);
        const QRgb ink = isEdge ? inkAt(evenFirst) : inside;
        draw(columnAt(touched.first), evenFirst);
        if (qAlpha(ink) == 255) {
            std::fill(pixels + evenFirst, pixels + evenLast, ink);
        } else if (qAlpha(ink) > 0) {
            std::transform(pixels + evenFirst, pixels + evenLast, pixels + evenFirst,
                           [ink](QRgb below) { return laidOver(ink, below); });
        }
        draw(evenLast, last);
    }
}

}  // namespace

void paintDisc(QPainter& painter, const QPointF& middle, double radius) {
    if (!canMeasure(painter)) {
        painter.drawEllipse(middle, radius, radius);
        return;
    }
    paint(painter, {middle}, radius);
}

void paintPolygon(QPainter& painter, const QPolygonF& polygon) {
    if (polygon.size() < 3 || !canMeasure(painter)) {
        painter.drawConvexPolygon(polygon);
        return;
    }
    paint(painter, polygon, 0.0);
}

void paintBlock(QPainter& painter, const QRectF& block, double corner) {
    const QRectF whole = block.normalized();
    const double round = std::min({corner, 0.5 * whole.width(), 0.5 * whole.height()});
    if (!canMeasure(painter)) {
        painter.drawRoundedRect(whole, round, round);
        return;
    }
    const QRectF core = whole.adjusted(round, round, -round, -round);
    paint(painter, {core.topLeft(), core.topRight(), core.bottomRight(), core.bottomLeft()}, round);
}

void paintBar(QPainter& painter, const QPointF& from, const QPointF& to, double radius) {
    if (!canMeasure(painter)) {
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
    paint(painter, {from, to}, radius);
}

}  // namespace ravnoves
