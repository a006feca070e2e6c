#include "studies/model/band_slopes.h"

#include <cmath>

namespace ravnoves {

namespace {

/// 95 % point of the normal distribution.
constexpr double point95 = 1.6448536269514722;

/// A result with both sides of a standard deviation, as far as there are.
double moved(double nominal, double plus, double minus, double period) {
    const auto apart = [&](double from, double to) {
        return period > 0.0 ? std::remainder(to - from, period) : to - from;
    };
    if (std::isfinite(plus) && std::isfinite(minus)) {
        return 0.5 * apart(minus, plus);
    }
    return std::isfinite(plus) ? apart(nominal, plus) : apart(minus, nominal);
}

}  // namespace

std::vector<float> BandSlopes::add(const std::optional<std::vector<double>>& up,
                                   const std::optional<std::vector<double>>& down, bool isCentred) {
    std::vector<float> slopes(nominal.size());
    for (std::size_t i = 0; i < nominal.size(); ++i) {
        const double above = up ? (*up)[i] : none;
        const double under = down ? (*down)[i] : none;
        const double by = moved(nominal[i], above, under, periods[i]);
        if (!std::isfinite(by)) {
            continue;
        }
        variance[i] += by * by;
        slopes[i] = static_cast<float>(by);
        if (!isCentred && std::isfinite(above) && std::isfinite(under)) {
            shift[i] += 0.5 * (above + under) - nominal[i];
        }
    }
    return slopes;
}

std::vector<double> BandSlopes::side(double sign) const {
    std::vector<double> found;
    for (std::size_t i = 0; i < nominal.size(); ++i) {
        found.push_back(point95 * std::sqrt(variance[i]) + sign * shift[i]);
    }
    return found;
}

}  // namespace ravnoves
