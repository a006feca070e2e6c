#include "pictures/model/clip_shape.h"

#include <QTransform>
#include <algorithm>

namespace ravnoves {

namespace {

constexpr double spare = 0.01;  // pixels

/// What of a polygon lies on one side of an upright or level line.
QPolygonF halved(const QPolygonF& polygon, double limit, double sign, bool isUpright) {
    QPolygonF kept;
    const auto beyond = [&](const QPointF& point) {
        return sign * ((isUpright ? point.x() : point.y()) - limit);
    };
    for (qsizetype i = 0; i < polygon.size(); ++i) {
        const QPointF& from = polygon[i];
        const QPointF& to = polygon[(i + 1) % polygon.size()];
        const double before = beyond(from);
        const double after = beyond(to);
        if (before >= 0.0) {
            kept << from;
        }
        if ((before >= 0.0) != (after >= 0.0)) {
            QPointF on = from + (to - from) * (before / (before - after));
            (isUpright ? on.rx() : on.ry()) = limit;
            kept << on;
        }
    }
    return kept;
}

}  // namespace

QList<QPolygonF> flattened(const QPainterPath& path) {
    constexpr double finer = 8.0;
    QList<QPolygonF> polygons = path.toSubpathPolygons(QTransform::fromScale(finer, finer));
    for (QPolygonF& polygon : polygons) {
        for (QPointF& point : polygon) {
            point /= finer;
        }
    }
    return polygons;
}

bool ClipShape::contains(const QRectF& box) const {
    // A box that is a line or a point is none to QRectF.
    return box.left() >= bounds_.left() - spare && box.right() <= bounds_.right() + spare &&
           box.top() >= bounds_.top() - spare && box.bottom() <= bounds_.bottom() + spare;
}

bool ClipShape::meets(const QRectF& box) const {
    return box.left() < bounds_.right() && box.right() > bounds_.left() &&
           box.top() < bounds_.bottom() && box.bottom() > bounds_.top();
}

/// After Sutherland and Hodgman: edges along the rectangle cancel one another in either fill rule.
QPainterPath ClipShape::cutArea(const QPainterPath& area) const {
    QPainterPath seen;
    seen.setFillRule(area.fillRule());
    for (QPolygonF polygon : flattened(area)) {
        if (polygon.size() > 1 && polygon.isClosed()) {
            polygon.removeLast();
        }
        polygon = halved(polygon, bounds_.left(), 1.0, true);
        polygon = halved(polygon, bounds_.right(), -1.0, true);
        polygon = halved(polygon, bounds_.top(), 1.0, false);
        polygon = halved(polygon, bounds_.bottom(), -1.0, false);
        if (polygon.size() > 2) {
            seen.addPolygon(polygon);
            seen.closeSubpath();
        }
    }
    return seen;
}

std::optional<std::pair<double, double>> crossings(const QLineF& line, const QRectF& box) {
    double from = 0.0;
    double to = 1.0;
    const auto keep = [&](double at, double along, double low, double high) {
        if (along == 0.0) {
            if (at < low || at > high) {
                to = -1.0;
            }
            return;
        }
        const auto [enters, leaves] = std::minmax({(low - at) / along, (high - at) / along});
        from = std::max(from, enters);
        to = std::min(to, leaves);
    };
    keep(line.x1(), line.dx(), box.left(), box.right());
    keep(line.y1(), line.dy(), box.top(), box.bottom());
    return from < to ? std::optional(std::pair(from, to)) : std::nullopt;
}

std::vector<ClipShape::Stretch> ClipShape::cutLine(const QPolygonF& line) const {
    std::vector<Stretch> seen;
    double before = 0.0;
    bool continues = false;
    const QRectF box = bounds_.adjusted(-spare, -spare, spare, spare);
    for (qsizetype i = 0; i + 1 < line.size(); ++i) {
        const QLineF step(line[i], line[i + 1]);
        const auto cuts = crossings(step, box);
        const bool reachesEnd = cuts && cuts->second == 1.0;
        if (cuts) {
            if (!continues || cuts->first > 0.0) {
                seen.push_back({{step.pointAt(cuts->first)}, before + cuts->first * step.length()});
            }
            seen.back().points << (reachesEnd ? step.p2() : step.pointAt(cuts->second));
        }
        continues = reachesEnd;
        before += step.length();
    }
    if (line.isClosed() && continues && seen.size() > 1 &&
        seen.front().points.first() == line.first()) {
        seen.back().points << seen.front().points.mid(1);
        seen.erase(seen.begin());
    }
    return seen;
}

}  // namespace ravnoves
