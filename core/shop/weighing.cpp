#include "shop/weighing.h"

#include <cmath>

#include "case-file/decimal.h"
#include "numerics/demand.h"
#include "numerics/units.h"

namespace ravnoves::shop {

double Weighing::coarsest(double radius) const {
    return round_step(resolution * *largest_radius / radius / units::gram) * units::gram;
}

Weighing weighing(double resolution, double squares, const std::optional<double>& limit) {
    RAVNOVES_DEMAND(resolution > 0.0, "a scale has a last digit");
    Weighing found{resolution, 2.0 * resolution * std::sqrt((1.0 + squares) / 12.0), std::nullopt};
    if (limit) {
        constexpr double share = 1.0 / 3.0;  // that the scale may use up
        found.largest_radius = share * *limit / found.bob_weight;
    }
    return found;
}

}  // namespace ravnoves::shop
