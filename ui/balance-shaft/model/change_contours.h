#pragma once

#include <QPolygonF>
#include <vector>

namespace ravnoves {

struct PlaceCriterion;
struct ShaftMap;

/// What a criterion makes of the map's field: the change at each place, and the lines along which
/// it is equal.
struct ChangeContours {
    /// One line of equal change, m.
    struct Contour {
        double level;  ///< change as a fraction: −0.1 is 10 % less than without a shaft
        std::vector<QPolygonF> lines;
    };

    std::vector<double> changes;  ///< of the field's elements, row × columns + column
    std::vector<double> levels;   ///< where the colours change: ascending, with 0 among them
    std::vector<Contour> contours;
};

ChangeContours changeContours(const ShaftMap& map, const PlaceCriterion& criterion);

}  // namespace ravnoves
