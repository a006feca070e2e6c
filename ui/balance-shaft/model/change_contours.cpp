#include "balance-shaft/model/change_contours.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "plot/model/contour_lines.h"
#include "plot/model/ticks.h"

namespace ravnoves {

namespace {

/// Equal steps where the shaft helps; where it harms 1, 2, 5, 10 … times as much, for there the
/// field has no end.
std::vector<double> levelsOf(const std::vector<double>& changes) {
    const auto [minimum, maximum] = std::minmax_element(changes.begin(), changes.end());
    std::vector<double> found{0.0};
    constexpr double smallest = 1e-4;  // less is nothing
    double step = 0.0;
    if (*minimum < -smallest) {
        step = niceStep(-*minimum, 5);
        for (int i = 1; - step * i > *minimum; ++i) {
            found.insert(found.begin(), -step * i);
        }
    }
    constexpr int maxSteps = 6;
    std::vector<double> above;
    const double first = std::max(step, 1e-3 * *maximum);
    double power = std::pow(10.0, std::floor(std::log10(std::max(first, smallest))));
    while (power < *maximum) {
        for (const double factor : {1.0, 2.0, 5.0}) {
            if (factor * power >= 0.999 * first && factor * power < *maximum) {
                above.push_back(factor * power);
            }
        }
        power *= 10.0;
    }
    const auto kept = std::min<std::ptrdiff_t>(maxSteps, std::ssize(above));
    found.insert(found.end(), above.end() - kept, above.end());
    return found;
}

}  // namespace

ChangeContours changeContours(std::vector<double> changes, std::size_t columns,
                              const QRectF& where) {
    ChangeContours made{where, columns, std::move(changes), {}, {}};
    made.levels = levelsOf(made.changes);
    const std::size_t rows = made.changes.size() / columns;
    const double stepX = where.width() / static_cast<double>(columns - 1);
    const double stepY = where.height() / static_cast<double>(rows - 1);
    for (const double level : made.levels) {
        ChangeContours::Contour contour{level, contourLines({made.changes, columns, rows}, level)};
        for (QPolygonF& line : contour.lines) {
            for (QPointF& point : line) {
                point = where.topLeft() + QPointF(point.x() * stepX, point.y() * stepY);
            }
        }
        made.contours.push_back(std::move(contour));
    }
    return made;
}

}  // namespace ravnoves
