#include "balance-shaft/envelope_study.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "numerics/constants.h"

namespace ravnoves::balance_shaft {

EnvelopeStudy envelope_study(const Solver& solver) {
    constexpr std::size_t angles = 720;
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
    // Walk from the smallest box up: an angle is efficient where its range beats all before it, and
    // takes the place of the last one where their boxes are equal.
    std::vector<std::size_t> order(angles);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return study.area[a] < study.area[b]; });
    study.efficient.assign(angles, false);
    std::optional<std::size_t> last;
    for (const std::size_t i : order) {
        if (!study.buildable[i] ||
            (last && !(study.range[i] < study.range[*last] * (1.0 - rounding_share)))) {
            continue;
        }
        if (last && study.area[i] <= study.area[*last] * (1.0 + rounding_share)) {
            study.efficient[*last] = false;
        }
        study.efficient[i] = true;
        last = i;
    }
    return study;
}

}  // namespace ravnoves::balance_shaft
