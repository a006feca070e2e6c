#include "v8-plugs/weighing.h"

#include <cmath>

#include "case-file/decimal.h"
#include "numerics/demand.h"

namespace ravnoves::v8_plugs {

namespace {

/// Sum of the squares of what the columns count for, by the mean of their eight weights.
double sum_of_squares(const WeighIn& sheet, double rod_coefficient) {
    double sum = 0.0;
    for (const Part part : all_parts) {
        if (sheet[part].is_complete()) {
            const double counts = 2.0 * excess_factor(part, rod_coefficient);  // two on a crankpin
            sum += counts * counts;
        }
    }
    return sum;
}

}  // namespace

std::optional<Weighing> weighing(const Input& input, double resolution) {
    RAVNOVES_DEMAND(resolution > 0.0, "a scale has a last digit");
    if (!input.engine.crank_radius || !input.engine.rod_coefficient) {
        return std::nullopt;
    }
    const double parts = input.changes_from_weigh_in && input.weigh_in
                             ? sum_of_squares(*input.weigh_in, *input.engine.rod_coefficient)
                             : 0.0;
    const double by_resolution = 2.0 * std::sqrt((1.0 + parts / cylinder_count) / 12.0);
    const double radius = *input.engine.crank_radius;
    constexpr double share = 1.0 / 3.0;  // of the tolerance that the scale may use up
    const double largest = share * input.tolerance / (by_resolution * radius);
    const double bob_weight = by_resolution * resolution;
    return Weighing{bob_weight, bob_weight * radius, resolution <= largest * (1.0 + 1e-12),
                    round_step(largest / units::gram) * units::gram};
}

}  // namespace ravnoves::v8_plugs
