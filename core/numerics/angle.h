#pragma once

#include <cmath>

#include "numerics/constants.h"

namespace ravnoves {

/// x modulo the period, 0 ≤ … < period. Exact but for the one addition that a negative x needs.
template <typename Scalar>
Scalar wrap(Scalar x, const Scalar& period) {
    using std::fmod;
    x = fmod(x, period);
    if (x < 0) {
        x += period;
    }
    return x < period ? x : Scalar(0);
}

/// An angle in rad brought into one turn, 0 ≤ … < 2π.
inline double wrap_turn(double angle) {
    return wrap(angle, two_pi);
}

}  // namespace ravnoves
