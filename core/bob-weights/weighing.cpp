#include "bob-weights/weighing.h"

#include <algorithm>
#include <cmath>

#include "numerics/demand.h"

namespace ravnoves::bob_weights {

std::optional<Weighing> weighing(const Input& input, const Result& result, double resolution) {
    RAVNOVES_DEMAND(resolution > 0.0, "a scale has a last digit");
    if (!result.bob_weight) {
        return std::nullopt;
    }
    double sum = 1.0;
    for (const Line& line : result.lines) {
        if (line.part == nullptr || line.kind == PartKind::crankpin || line.mass == 0.0) {
            continue;
        }
        const bool is_column = input.weigh_in && line.part->column &&
                               (*input.weigh_in)[*line.part->column].is_weighed();
        sum += line.factor * line.factor / (is_column ? input.engine.cylinders : 1);
    }
    Weighing found{2.0 * resolution * std::sqrt(sum / 12.0), std::nullopt};
    if (result.permissible) {
        constexpr double share = 1.0 / 3.0;  // of the limit that the scale may use up
        const double limit =
            *std::min_element(result.permissible->begin(), result.permissible->end());
        found.largest_radius = share * limit / found.bob_weight;
    }
    return found;
}

}  // namespace ravnoves::bob_weights
