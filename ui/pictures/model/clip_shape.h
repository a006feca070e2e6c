#pragma once

#include <QLineF>
#include <QPainterPath>
#include <QPolygonF>
#include <QRectF>
#include <optional>
#include <utility>
#include <vector>

namespace ravnoves {

/// The visible rectangle of a painter, for a device that does not clip: cuts drawings to it. In the
/// device's pixels, the y axis downwards.
class ClipShape {
  public:
    /// A stretch of a polyline that is seen.
    struct Stretch {
        QPolygonF points;
        double before = 0.0;  ///< length of the polyline up to it, pixels
    };

    explicit ClipShape(const QRectF& box) : bounds_(box) {}

    /// With a hundredth of a pixel to spare, so that rounding cuts nothing.
    bool contains(const QRectF& box) const;
    bool meets(const QRectF& box) const;
    const QRectF& bounds() const { return bounds_; }

    /// What of an area is seen; of straight lines.
    QPainterPath cutArea(const QPainterPath& area) const;
    /// What of a line is seen; a closed one is not broken at its first point.
    std::vector<Stretch> cutLine(const QPolygonF& line) const;

  private:
    QRectF bounds_;
};

/// Where a straight line enters and leaves a rectangle, as shares of its length; nothing where it
/// passes by.
std::optional<std::pair<double, double>> crossings(const QLineF& line, const QRectF& box);

/// The subpaths of a path as polygons that are true to an eighth of a pixel.
QList<QPolygonF> flattened(const QPainterPath& path);

}  // namespace ravnoves
