#include "plot/ticks.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ravnoves {

double niceStep(double span, int wanted) {
    if (!(span > 0.0) || !std::isfinite(span)) {
        return 1.0;
    }
    const double rough = span / std::max(1, wanted);
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    for (const double factor : {1.0, 2.0, 2.5, 5.0, 10.0}) {
        if (factor * power >= rough * 0.999) {
            return factor * power;
        }
    }
    return 10.0 * power;
}

double niceAngleStep(double span, int wanted) {
    static constexpr std::array<double, 11> steps{1, 2, 5, 10, 15, 30, 45, 60, 90, 120, 180};
    const double rough = span / std::max(1, wanted);
    if (rough < steps.front()) {
        return niceStep(span, wanted);
    }
    for (const double step : steps) {
        if (step >= rough * 0.999) {
            return step;
        }
    }
    return steps.back();
}

std::pair<double, double> niceInterval(double min, double max, int wanted) {
    if (!(max > min)) {
        const double pad = std::max(1e-12, std::abs(min) * 0.1);
        min -= pad;
        max += pad;
    }
    const double step = niceStep(max - min, wanted);
    return {std::floor(min / step + 1e-9) * step, std::ceil(max / step - 1e-9) * step};
}

int tickDecimals(double step) {
    for (int decimals = 0; decimals < 12; ++decimals) {
        const double scaled = step * std::pow(10.0, decimals);
        if (std::abs(scaled - std::round(scaled)) < 1e-6 * std::max(1.0, scaled)) {
            return decimals;
        }
    }
    return 12;
}

}  // namespace ravnoves
