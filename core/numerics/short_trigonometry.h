#pragma once

namespace ravnoves {

struct CosSin {
    double cos;
    double sin;
};

/// For |t| ≤ 0.27; the next terms are below 1e-17.
inline CosSin short_cos_sin(double t) {
    const double q = t * t;
    return {1.0 + q * (-1.0 / 2 +
                       q * (1.0 / 24 +
                            q * (-1.0 / 720 + q * (1.0 / 40320 +
                                                   q * (-1.0 / 3628800 + q * (1.0 / 479001600)))))),
            t * (1.0 + q * (-1.0 / 6 +
                            q * (1.0 / 120 +
                                 q * (-1.0 / 5040 + q * (1.0 / 362880 + q * (-1.0 / 39916800))))))};
}
inline constexpr double longest_short_angle = 0.27;

}  // namespace ravnoves
