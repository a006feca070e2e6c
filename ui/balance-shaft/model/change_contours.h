#pragma once

#include <QPolygonF>
#include <QRectF>
#include <vector>

namespace ravnoves {

/// A field of changes against the engine without a shaft, and the lines along which they are equal.
struct ChangeContours {
    /// One line of equal change, in the units of the axes.
    struct Contour {
        double level;  ///< change as a fraction: −0.1 is 10 % less than without a shaft
        std::vector<QPolygonF> lines;
    };

    QRectF where;  ///< from the first to the last element, in the units of the axes
    std::size_t columns = 0;
    std::vector<double> changes;  ///< element row × columns + column, rows upwards
    std::vector<double> levels;   ///< where the colours change: ascending, with 0 among them
    std::vector<Contour> contours;
};

ChangeContours changeContours(std::vector<double> changes, std::size_t columns,
                              const QRectF& where);

}  // namespace ravnoves
