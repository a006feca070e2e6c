#pragma once

#include <QPolygonF>
#include <QRectF>
#include <QString>
#include <utility>
#include <vector>

#include "balance-shaft/model/shaft_map_model.h"

class QPainter;

namespace ravnoves {

class PlaceScale;

/// The numbers at contours and markers of the map, each where there is room: they overlap neither
/// each other nor the places kept free, in order of precedence.
class ShaftMapLabels {
  public:
    /// Begins again in a rectangle of pixels.
    void clear(const QRectF& area);
    /// No number in this square.
    void keepFree(const QPointF& middle, double half);
    /// No number over this circle, except one of a marker, or of no change, without another place.
    void keepFreeCircle(const QPointF& middle, double radius);
    /// The change at each marker of the criterion.
    void addMarkers(const ShaftMapModel& map, const PlaceScale& scale);
    /// Each line's number where the line is nearest to a ray from a centre, so that the numbers are
    /// in a row; the ray turns on where that has no room.
    /// @param lines  the longest of each contour, pixels
    void addContours(const ChangeContours& field, const std::vector<QPolygonF>& lines,
                     const QPointF& centre);
    void paint(QPainter& painter) const;

  private:
    struct Label {
        QRectF box;
        QString text;  ///< empty: kept free
        bool isBold = false;
    };

    /// In the first of the boxes that has room.
    /// @param overCircles  where none has, over circles
    void add(const std::vector<QRectF>& boxes, const QString& text, bool isBold, bool overCircles);

    QRectF area_;
    std::vector<std::pair<QPointF, double>> circles_;  ///< middle and radius
    std::vector<Label> labels_;
};

}  // namespace ravnoves
