#include "pictures/model/clip_shape.h"

#include <QLineF>
#include <QTransform>
#include <algorithm>
#include <cmath>

namespace ravnoves {

namespace {

constexpr double spare = 0.01;  // pixels

/// The rectangle that a path is, where it is one.
std::optional<QRectF> rectangle(const QPainterPath& path) {
    const QRectF box = path.boundingRect();
    if (path.elementCount() < 4 || path.elementCount() > 5) {
        return std::nullopt;
    }
    const auto isNear = [](double a, double b) { return std::abs(a - b) < 1e-6; };
    for (int i = 0; i < path.elementCount(); ++i) {
        const QPainterPath::Element at = path.elementAt(i);
        const QPainterPath::Element next = path.elementAt((i + 1) % path.elementCount());
        const bool isCorner = (isNear(at.x, box.left()) || isNear(at.x, box.right())) &&
                              (isNear(at.y, box.top()) || isNear(at.y, box.bottom()));
        if ((i == 0 ? !at.isMoveTo() : !at.isLineTo()) || !isCorner ||
            (!isNear(at.x, next.x) && !isNear(at.y, next.y))) {
            return std::nullopt;
        }
    }
    return box;
}

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

/// After Sutherland and Hodgman: edges along the rectangle cancel one another in either fill rule.
QPainterPath cutToRectangle(const QPainterPath& area, const QRectF& box) {
    QPainterPath seen;
    seen.setFillRule(area.fillRule());
    for (QPolygonF polygon : flattened(area)) {
        if (polygon.size() > 1 && polygon.isClosed()) {
            polygon.removeLast();
        }
        polygon = halved(polygon, box.left(), 1.0, true);
        polygon = halved(polygon, box.right(), -1.0, true);
        polygon = halved(polygon, box.top(), 1.0, false);
        polygon = halved(polygon, box.bottom(), -1.0, false);
        if (polygon.size() > 2) {
            seen.addPolygon(polygon);
            seen.closeSubpath();
        }
    }
    return seen;
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

void ClipShape::clear() {
    isSet_ = false;
    shape_.reset();
    edges_.clear();
}

void ClipShape::set(const QPainterPath& shape) {
    clear();
    isSet_ = true;
    bounds_ = shape.boundingRect();
    if (shape.isEmpty() || rectangle(shape)) {
        return;
    }
    shape_ = QPainterPath();
    shape_->setFillRule(shape.fillRule());
    for (const QPolygonF& polygon : flattened(shape)) {
        shape_->addPolygon(polygon);
        shape_->closeSubpath();
        for (qsizetype i = 0; i < polygon.size(); ++i) {
            edges_.emplace_back(polygon[i], polygon[(i + 1) % polygon.size()]);
        }
    }
}

void ClipShape::intersect(const QPainterPath& shape) {
    set(isSet_ ? cutArea(shape) : shape);
}

bool ClipShape::contains(const QRectF& box) const {
    // A box that is a line or a point is none to QRectF.
    const bool isInside =
        box.left() >= bounds_.left() - spare && box.right() <= bounds_.right() + spare &&
        box.top() >= bounds_.top() - spare && box.bottom() <= bounds_.bottom() + spare;
    return isInside && (!shape_ || shape_->contains(box.adjusted(0, 0, 1e-9, 1e-9)));
}

bool ClipShape::meets(const QRectF& box) const {
    const bool isNear = box.left() < bounds_.right() && box.right() > bounds_.left() &&
                        box.top() < bounds_.bottom() && box.bottom() > bounds_.top();
    return isNear && (!shape_ || shape_->intersects(box));
}

QPainterPath ClipShape::cutArea(const QPainterPath& area) const {
    if (!shape_) {
        return cutToRectangle(area, bounds_);
    }
    if (const auto box = rectangle(area)) {
        return cutToRectangle(*shape_, *box);
    }
    return area.intersected(*shape_);
}

std::vector<double> ClipShape::crossings(const QLineF& line) const {
    if (!shape_) {
        const QRectF box = bounds_.adjusted(-spare, -spare, spare, spare);
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
        return from < to ? std::vector{from, to} : std::vector<double>();
    }
    std::vector<double> cuts{0.0, 1.0};
    for (const QLineF& edge : edges_) {
        const double turn = line.dx() * edge.dy() - line.dy() * edge.dx();
        const QPointF away = edge.p1() - line.p1();
        const double at = (away.x() * edge.dy() - away.y() * edge.dx()) / turn;
        const double on = (away.x() * line.dy() - away.y() * line.dx()) / turn;
        if (turn != 0.0 && on >= 0.0 && on <= 1.0 && at > 0.0 && at < 1.0) {
            cuts.push_back(at);
        }
    }
    std::sort(cuts.begin(), cuts.end());
    std::vector<double> seen;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        if (cuts[i + 1] - cuts[i] > 1e-9 &&
            shape_->contains(line.pointAt(0.5 * (cuts[i] + cuts[i + 1])))) {
            if (!seen.empty() && seen.back() == cuts[i]) {
                seen.back() = cuts[i + 1];
            } else {
                seen.insert(seen.end(), {cuts[i], cuts[i + 1]});
            }
        }
    }
    return seen;
}

std::vector<ClipShape::Stretch> ClipShape::cutLine(const QPolygonF& line) const {
    std::vector<Stretch> seen;
    double before = 0.0;
    bool goesOn = false;
    for (qsizetype i = 0; i + 1 < line.size(); ++i) {
        const QLineF step(line[i], line[i + 1]);
        const std::vector<double> cuts = crossings(step);
        bool reachesEnd = false;
        for (std::size_t k = 0; k + 1 < cuts.size(); k += 2) {
            if (!(goesOn && k == 0 && cuts[k] == 0.0)) {
                seen.push_back({{step.pointAt(cuts[k])}, before + cuts[k] * step.length()});
            }
            reachesEnd = cuts[k + 1] == 1.0;
            seen.back().points << (reachesEnd ? step.p2() : step.pointAt(cuts[k + 1]));
        }
        goesOn = reachesEnd;
        before += step.length();
    }
    if (line.isClosed() && goesOn && seen.size() > 1 &&
        seen.front().points.first() == line.first()) {
        seen.back().points << seen.front().points.mid(1);
        seen.erase(seen.begin());
    }
    return seen;
}

}  // namespace ravnoves
