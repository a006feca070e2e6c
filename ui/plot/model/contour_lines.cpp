#include "plot/model/contour_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "numerics/demand.h"

namespace ravnoves {

namespace {

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

/// Segments of the cells, chained by the grid's edges that they end on: an edge has a number (twice
/// its lower left element, odd for those that run along the rows' direction) and two segments at
/// most.
class Chains {
  public:
    Chains(const ValueGrid& grid, double level, const Crossing& crossing)
        : grid_(grid),
          level_(level),
          crossing_(crossing),
          links_(2 * grid.values.size(), {none, none}) {
        for (std::size_t row = 0; row + 1 < grid.rows; ++row) {
            for (std::size_t column = 0; column + 1 < grid.columns; ++column) {
                addCell(row * grid.columns + column);
            }
        }
    }

    std::vector<QPolygonF> lines() {
        std::vector<QPolygonF> found;
        // Open lines first: what is left then is closed.
        for (const bool open : {true, false}) {
            for (std::size_t edge = 0; edge < links_.size(); ++edge) {
                const bool begins = links_[edge][0] != none && links_[edge][1] == none;
                if (open ? begins : links_[edge][0] != none) {
                    found.push_back(follow(edge));
                }
            }
        }
        return found;
    }

  private:
    bool isAbove(std::size_t element) const { return grid_.values[element] >= level_; }

    void addCell(std::size_t corner) {
        const std::size_t next = corner + grid_.columns;
        const std::array above{isAbove(corner), isAbove(corner + 1), isAbove(next + 1),
                               isAbove(next)};
        // Bottom, right, top, left: each between two corners, in the order of `above`.
        const std::array edges{2 * corner, 2 * (corner + 1) + 1, 2 * next, 2 * corner + 1};
        std::array<std::size_t, 4> crossed{};
        std::size_t count = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            if (above[i] != above[(i + 1) % 4]) {
                crossed[count++] = edges[i];
            }
        }
        if (count == 2) {
            join(crossed[0], crossed[1]);
        } else if (count == 4) {
            const double mean = 0.25 * (grid_.values[corner] + grid_.values[corner + 1] +
                                        grid_.values[next] + grid_.values[next + 1]);
            // The corners that differ from the middle are cut off.
            const bool cutsFirst = (mean >= level_) != above[0];
            join(crossed[0], crossed[cutsFirst ? 3 : 1]);
            join(crossed[2], crossed[cutsFirst ? 1 : 3]);
        }
    }

    void join(std::size_t a, std::size_t b) {
        links_[a][links_[a][0] == none ? 0 : 1] = b;
        links_[b][links_[b][0] == none ? 0 : 1] = a;
    }

    QPointF pointOf(std::size_t edge) const {
        const std::size_t from = edge / 2;
        const bool upwards = edge % 2 != 0;
        const std::size_t to = from + (upwards ? grid_.columns : 1);
        double part = 0.5;
        if (crossing_) {
            part = crossing_(from, to);
        } else if (const double rise = grid_.values[to] - grid_.values[from];
                   std::isfinite(rise) && rise != 0.0) {
            part = (level_ - grid_.values[from]) / rise;
        }
        const std::size_t row = from / grid_.columns;
        const QPointF start(static_cast<double>(from % grid_.columns), static_cast<double>(row));
        return start + (upwards ? QPointF(0.0, part) : QPointF(part, 0.0));
    }

    /// The line from an edge on, which is taken out.
    QPolygonF follow(std::size_t start) {
        QPolygonF line{pointOf(start)};
        std::size_t at = start;
        while (links_[at][0] != none) {
            const std::size_t next = links_[at][0];
            links_[at] = {links_[at][1], none};
            std::array<std::size_t, 2>& back = links_[next];
            back = back[0] == at ? std::array{back[1], none} : std::array{back[0], none};
            at = next;
            line << pointOf(at);
        }
        return line;
    }

    ValueGrid grid_;
    double level_;
    const Crossing& crossing_;
    std::vector<std::array<std::size_t, 2>> links_;
};

}  // namespace

std::vector<QPolygonF> contourLines(const ValueGrid& grid, double level, const Crossing& crossing) {
    RAVNOVES_DEMAND(
        grid.columns >= 2 && grid.rows >= 2 && grid.values.size() == grid.columns * grid.rows,
        "a grid has its values");
    return Chains(grid, level, crossing).lines();
}

std::vector<QPolygonF> contourRegion(const ValueGrid& grid, double level,
                                     const Crossing& crossing) {
    // A frame of what is below the level, which closes every line.
    const std::size_t columns = grid.columns + 2;
    const std::size_t rows = grid.rows + 2;
    std::vector<double> framed(columns * rows, -std::numeric_limits<double>::infinity());
    for (std::size_t row = 0; row < grid.rows; ++row) {
        std::copy_n(grid.values.begin() + static_cast<std::ptrdiff_t>(row * grid.columns),
                    grid.columns,
                    framed.begin() + static_cast<std::ptrdiff_t>((row + 1) * columns + 1));
    }
    const auto isFrame = [&](std::size_t element) {
        const std::size_t column = element % columns;
        const std::size_t row = element / columns;
        return column == 0 || row == 0 || column + 1 == columns || row + 1 == rows;
    };
    const auto inner = [&](std::size_t element) {
        return (element / columns - 1) * grid.columns + element % columns - 1;
    };
    const Crossing onFrame = [&](std::size_t from, std::size_t to) {
        // Along the grid's own edge.
        return isFrame(from) ? 1.0 : isFrame(to) ? 0.0 : crossing(inner(from), inner(to));
    };
    std::vector<QPolygonF> region = contourLines({framed, columns, rows}, level, onFrame);
    for (QPolygonF& line : region) {
        line.translate(-1.0, -1.0);
    }
    return region;
}

}  // namespace ravnoves
