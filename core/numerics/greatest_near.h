#pragma once

#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <utility>

namespace ravnoves {

/// The greatest value of a smooth function near the sample of a grid where it is greatest, and its
/// place: by Brent's method between the neighbouring samples, to rounding in the value.
template <typename Function>
std::pair<double, double> greatest_near(const Function& f, double sample, double step) {
    constexpr int half_the_digits = 26;
    const auto [place, value] = boost::math::tools::brent_find_minima(
        [&](double x) {
            const double y = -f(x);
            return std::isfinite(y) ? y : std::numeric_limits<double>::max();
        },
        sample - step, sample + step, half_the_digits);
    return {place, -value};
}

}  // namespace ravnoves
