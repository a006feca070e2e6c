#include "balance-shaft/model/shaft_map.h"

#include <algorithm>
#include <cmath>

#include "plot/model/contour_lines.h"
#include "plot/model/ticks.h"

namespace ravnoves {

using balance_shaft::Obstacle;
using balance_shaft::PositionStudy;

namespace {

// The field reaches further than the square shown first: the picture may be wider or higher. Its
// steps are equal; of its points every second is looked at for obstacles.
constexpr double reachAcross = 2.6;
constexpr double reachUp = 1.6;
constexpr std::size_t obstacleColumns = 196;
constexpr std::size_t obstacleRows = 121;
constexpr double roomAround = 1.25;

void findObstacles(ShaftMap& map, const std::function<bool(double)>& progress) {
    const balance_shaft::PositionMap& field = map.field;
    std::vector<double> blocked;
    const double stepX = (field.right - field.left) / (obstacleColumns - 1);
    const double stepY = (field.top - field.bottom) / (obstacleRows - 1);
    const auto place = [&](double column, double row) {
        return ShaftMap::Position{field.left + stepX * column, field.bottom + stepY * row};
    };
    for (std::size_t row = 0; row < obstacleRows; ++row) {
        if (!progress(static_cast<double>(row) / obstacleRows)) {
            return;
        }
        for (std::size_t column = 0; column < obstacleColumns; ++column) {
            const auto at = place(static_cast<double>(column), static_cast<double>(row));
            blocked.push_back(map.study.obstacle(at) == Obstacle::none ? 0.0 : 1.0);
        }
    }
    // The boundary between two places by bisection: the lines are as smooth as what they follow.
    const auto crossing = [&](std::size_t from, std::size_t to) {
        const auto at = [&](std::size_t element, double part) {
            const bool upwards = to - from > 1;
            const std::size_t row = element / obstacleColumns;
            return place(static_cast<double>(element % obstacleColumns) + (upwards ? 0.0 : part),
                         static_cast<double>(row) + (upwards ? part : 0.0));
        };
        double low = 0.0;
        double high = 1.0;
        for (int i = 0; i < 6; ++i) {
            const double middle = 0.5 * (low + high);
            const bool isBlocked = map.study.obstacle(at(from, middle)) != Obstacle::none;
            (isBlocked == (blocked[from] > 0.5) ? low : high) = middle;
        }
        return 0.5 * (low + high);
    };
    map.blocked = contourRegion({blocked, obstacleColumns, obstacleRows}, 0.5, crossing);
    for (QPolygonF& line : map.blocked) {
        for (QPointF& point : line) {
            const ShaftMap::Position at = place(point.x(), point.y());
            point = QPointF(at.x, at.y);
        }
    }
}

}  // namespace

double ShaftMap::viewFor(double centreDistance) const {
    double farthest = centreDistance;
    for (const auto* places : {&best, &buildable}) {
        for (const auto& each : {places->range, places->rms}) {
            farthest = std::max(farthest, each ? each->position.centre_distance() : 0.0);
        }
    }
    if (!(farthest > 0.0)) {
        return 0.1;
    }
    const double step = niceStep(roomAround * farthest, 8);
    return step * std::ceil(roomAround * farthest / step - 1e-9);
}

std::shared_ptr<const ShaftMap> makeShaftMap(const balance_shaft::Solver& solver, double present,
                                             const std::function<bool(double)>& progress) {
    auto map = std::make_shared<ShaftMap>(ShaftMap{.study = PositionStudy(solver)});
    map->best = map->study.best();
    map->buildable = map->study.best_buildable();
    map->view = map->viewFor(present);
    const double across = reachAcross * map->view;
    const double up = reachUp * map->view;
    map->field =
        map->study.map(-across, across, -up, up, 2 * obstacleColumns - 1, 2 * obstacleRows - 1);
    findObstacles(*map, progress);
    if (!progress(0.8)) {
        return nullptr;
    }
    // Against a torque without a range no place is better than another.
    if (map->best.reason.empty() && map->buildable.range) {
        map->front = map->study.front(map->buildable);
        map->smallRange = map->study.smallest_buildable(*map->buildable.range, true);
        map->smallRms = map->study.smallest_buildable(*map->buildable.rms, false);
    }
    return map;
}

}  // namespace ravnoves
