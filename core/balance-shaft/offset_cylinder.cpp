#include "balance-shaft/offset_cylinder.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "numerics/constants.h"
#include "numerics/harmonics.h"

namespace ravnoves::balance_shaft {

PistonFirstOrder piston_first_order(const SliderCrank<double>& crank) {
    if (crank.offset == 0.0) {
        return {crank.crank_radius, 0.0};  // √(L² − r² sin²θ) has even orders alone
    }
    const std::size_t count = transform_length(crank.harmonic_decay(), 1, 1e-17);
    double a = 0.0;
    double b = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const double theta = two_pi * static_cast<double>(i) / static_cast<double>(count);
        const double value = -crank.at(theta).d2s;
        a += value * std::cos(theta);
        b += value * std::sin(theta);
    }
    return {2.0 / static_cast<double>(count) * std::hypot(a, b), std::atan2(b, a)};
}

PeriodicPiecewise with_offset_term(const PeriodicPiecewise& moment,
                                   const SliderCrank<double>& crank, double factor) {
    if (crank.offset == 0.0) {
        return moment;
    }
    const std::vector<double>& ends = moment.knots();
    constexpr double longest_deg = 0.5;
    std::vector<double> knots;
    for (std::size_t i = 0; i < moment.size(); ++i) {
        const double h = ends[i + 1] - ends[i];
        const int parts = std::max(1, static_cast<int>(std::ceil(h / longest_deg)));
        for (int part = 0; part < parts; ++part) {
            knots.push_back(ends[i] + h * part / parts);
        }
    }
    knots.push_back(ends.back());
    const double top = crank.top_dead_centre();
    return PeriodicPiecewise::through(
        [&](const double& angle) {
            return moment(angle) + factor * offset_lever(crank, angle * degree + top);
        },
        std::move(knots));
}

}  // namespace ravnoves::balance_shaft
