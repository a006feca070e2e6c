#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "numerics/demand.h"

namespace ravnoves {

/// Running integral of a periodic function from its samples: F[i] = ∫ from x₀ to xᵢ, i = 0…n.
///
/// Each interval is integrated through the polynomial of its six nearest samples (the mean of the
/// three-point Gregory rules on either side); the error of one interval is of order h⁷, so the
/// error of the whole is of order h⁶.
/// @param samples  one period at equal steps, n ≥ 6 values, the end left out
/// @param step     h
/// @return n + 1 values, the first 0
inline std::vector<double> cumulative_periodic_integral(std::span<const double> samples,
                                                        double step) {
    const std::size_t n = samples.size();
    RAVNOVES_DEMAND(n >= 6, "a running integral must have at least 6 samples");
    std::vector<double> integral(n + 1, 0.0);
    const auto at = [&](std::size_t i) { return samples[i % n]; };
    for (std::size_t i = 0; i < n; ++i) {
        const double near = at(i) + at(i + 1);
        const double middle = at(i + n - 1) + at(i + 2);
        const double far = at(i + n - 2) + at(i + 3);
        integral[i + 1] = integral[i] + step * (802.0 * near - 93.0 * middle + 11.0 * far) / 1440.0;
    }
    return integral;
}

}  // namespace ravnoves
