#pragma once

#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>

namespace ravnoves {

/// The maximum of a smooth function of an angle: of samples at equal steps, then by Brent's
/// method between the neighbours of the largest one, to rounding in the value.
struct Maximum {
    double value = 0.0;  ///< at first what no value has to be above to count
    double place = 0.0;
    bool found = false;

    void take(double sample, double at) {
        if (std::isfinite(sample) && sample > value) {
            *this = {sample, at, true};
        }
    }
    template <typename Function>
    void sharpen(const Function& f, double step) {
        if (!found) {
            return;
        }
        constexpr int half_the_digits = 26;
        const auto [at, minimum] = boost::math::tools::brent_find_minima(
            [&](double x) {
                const double y = -f(x);
                return std::isfinite(y) ? y : std::numeric_limits<double>::max();
            },
            place - step, place + step, half_the_digits);
        take(-minimum, at);
    }
};

}  // namespace ravnoves
