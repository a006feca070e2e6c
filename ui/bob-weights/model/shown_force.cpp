#include "bob-weights/model/shown_force.h"

#include <algorithm>

#include "numerics/units.h"

namespace ravnoves {

using bob_weights::FirstOrder;
using bob_weights::ForcePath;

namespace {

ForcePath pathInGrams(const FirstOrder& force) {
    ForcePath path = bob_weights::force_path(force);
    for (std::vector<double>* masses : {&path.across, &path.upright}) {
        for (double& mass : *masses) {
            mass = mass / units::gram;
        }
    }
    return path;
}

}  // namespace

std::optional<ShownForce> shownForce(const bob_weights::Result& result) {
    if (!result.first_order || !result.first_order_bare) {
        return std::nullopt;
    }
    constexpr double room = 1.15;
    return ShownForce{
        pathInGrams(*result.first_order_bare), pathInGrams(*result.first_order),
        room * std::max(result.first_order_bare->greatest(), result.first_order->greatest()) /
            units::gram};
}

double steadyReach(double reach, double shown) {
    constexpr double tooWide = 0.6;
    return reach > 0.0 && (reach > shown || reach < tooWide * shown) ? 1.1 * reach : shown;
}

}  // namespace ravnoves
