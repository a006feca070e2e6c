#include "balance-shaft/best_moment.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "numerics/cutting_planes.h"

namespace ravnoves::balance_shaft {

BestMoment minimise_range(const MomentPlane& plane, const Eigen::Vector2d& start) {
    // min u + w over a, b, u, w: u above the planes of the maxima, w above those of −M.
    using Planes = CuttingPlanes<double, 4>;
    using Vector = Planes::Vector;
    const MomentPlane::Extrema without = plane(0.0, 0.0);
    // The range is at least 2 |(a, b)| less that without a shaft, so the best is no farther.
    const double reach = without.range() * (1.0 + 1e-9);
    BestMoment best;
    best.moment = start.norm() < reach ? start : Eigen::Vector2d(0.0, 0.0);
    Eigen::Vector2d at = best.moment;
    MomentPlane::Extrema found = plane(at.x(), at.y());
    best.range = found.range();
    best.evaluations = 1;
    const auto upper = [](const MomentPlane::Place& p) -> Vector { return {-p.cos, -p.sin, 1, 0}; };
    const auto lower = [](const MomentPlane::Place& p) -> Vector { return {p.cos, p.sin, 0, 1}; };
    const double x = found.max.cos < found.min.cos ? -1.0 : 1.0;
    const double y = found.max.sin < found.min.sin ? -1.0 : 1.0;
    const double rounding = 8.0 * std::numeric_limits<double>::epsilon() *
                            std::max(std::abs(without.max.value), std::abs(without.min.value));
    Planes planes({0, 0, 1, 1},
                  {{upper(found.max), found.max.moment},
                   {lower(found.min), -found.min.moment},
                   {{x, 0, 0, 0}, -reach},
                   {{0, y, 0, 0}, -reach}},
                  rounding);
    planes.add({-x, 0, 0, 0}, -reach);
    planes.add({0, -y, 0, 0}, -reach);
    constexpr int most_rounds = 400;
    for (int round = 0; round < most_rounds; ++round) {
        const Vector& vertex = planes.solve();
        best.gap = std::max(0.0, best.range - vertex[2] - vertex[3]);
        if (best.gap <= 4.0 * rounding || (round > 0 && at == vertex.head<2>())) {
            break;
        }
        at = vertex.head<2>();
        found = plane(at.x(), at.y());
        ++best.evaluations;
        if (found.range() < best.range) {
            best.range = found.range();
            best.moment = at;
        }
        planes.add(upper(found.max), found.max.moment);
        planes.add(lower(found.min), -found.min.moment);
    }
    best.gap = std::max(best.gap, rounding);
    return best;
}

}  // namespace ravnoves::balance_shaft
