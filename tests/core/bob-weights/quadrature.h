#pragma once

#include "bob-weights/drilling.h"
#include "numerics/constants.h"

namespace ravnoves::bob_weights::test {

/// ∫ over the volume of the hole by the midpoint rule: along the depth, across cylinder and cone.
inline Removed by_quadrature(const Cut& cut, double diameter, double depth) {
    const double point = cut.cone(diameter);
    Removed sum{0.0, 0.0};
    const auto add = [&](double from, double length, const auto& radius) {
        constexpr int steps = 4000;
        for (int i = 0; i < steps; ++i) {
            const double share = (i + 0.5) / steps;
            const double r = radius(share);
            const double mass = cut.density * pi * r * r * length / steps;
            sum.mass += mass;
            sum.unbalance += mass * (cut.radius - from - share * length);
        }
    };
    add(0.0, depth, [&](double) { return 0.5 * diameter; });
    add(depth, point, [&](double share) { return 0.5 * diameter * (1.0 - share); });
    return sum;
}

}  // namespace ravnoves::bob_weights::test
