#include "balance-shaft/offset_cylinder.h"

#include <cmath>

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
    constexpr double longest_deg = 0.5;
    const PeriodicPiecewise fine = moment.refined(longest_deg);
    const double top = crank.top_dead_centre();
    const auto term = PeriodicPiecewise::through(
        [&](const double& angle) { return offset_lever(crank, angle * degree + top); },
        fine.knots());
    return PeriodicPiecewise::sum(fine, term, factor);
}

}  // namespace ravnoves::balance_shaft
