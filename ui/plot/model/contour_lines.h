#pragma once

#include <QPolygonF>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace ravnoves {

/// A rectangular grid of values: element row × columns + column; both counts at least 2.
struct ValueGrid {
    std::span<const double> values;
    std::size_t columns = 0;
    std::size_t rows = 0;
};

/// Where the value crosses a level between two neighbours of the grid (elements), as a fraction of
/// the way from the first.
using Crossing = std::function<double(std::size_t from, std::size_t to)>;

/// The lines along which a grid has a level, in columns and rows (marching squares); lines that are
/// closed end where they begin. Values that are not finite are below every level. A cell with
/// crosswise corners follows the mean of the four.
/// @param crossing  default: in proportion to the values
std::vector<QPolygonF> contourLines(const ValueGrid& grid, double level,
                                    const Crossing& crossing = {});

/// The outlines of where a grid is at the level or above: closed lines that go along the grid's own
/// edge where it is there, too; filled by the odd-even rule they are the region.
std::vector<QPolygonF> contourRegion(const ValueGrid& grid, double level, const Crossing& crossing);

}  // namespace ravnoves
