#include "balance-shaft/envelope_study.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "numerics/constants.h"

namespace ravnoves::balance_shaft {

EnvelopeStudy envelope_study(const Solver& solver, std::size_t angles) {
    angles = std::max<std::size_t>(angles, 2);
    EnvelopeStudy study;
    for (std::size_t i = 0; i < angles; ++i) {
        const double angle = 360.0 * static_cast<double>(i) / static_cast<double>(angles);
        const Envelope box = envelope(solver.front_view(), angle * degree);
        study.shaft_angle_deg.push_back(angle);
        study.width.push_back(box.width());
        study.height.push_back(box.height());
        study.area.push_back(box.width() * box.height());
        study.range.push_back(solver.range(angle * degree));
        study.buildable.push_back(solver.buildable().contains(angle * degree));
    }
    // Walk from the smallest box up: an angle is efficient where its range beats all before it.
    std::vector<std::size_t> order(angles);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return study.area[a] != study.area[b] ? study.area[a] < study.area[b]
                                              : study.range[a] < study.range[b];
    });
    study.efficient.assign(angles, false);
    double minimum = std::numeric_limits<double>::infinity();
    for (const std::size_t i : order) {
        if (study.buildable[i] && study.range[i] < minimum) {
            minimum = study.range[i];
            study.efficient[i] = true;
        }
    }
    return study;
}

}  // namespace ravnoves::balance_shaft
