#include "balance-shaft/gear_error.h"

#include <algorithm>
#include <cmath>

#include "balance-shaft/angle_search.h"
#include "numerics/constants.h"

namespace ravnoves::balance_shaft {

namespace {

double residual(double force, double phase) {
    return 2.0 * force * std::abs(std::sin(phase / 2));
}

/// Least and largest sin over [middle − half, middle + half].
std::pair<double, double> sine_band(double middle, double half) {
    if (half >= pi) {
        return {-1.0, 1.0};
    }
    const double left = std::sin(middle - half);
    const double right = std::sin(middle + half);
    // A crest lies inside where the middle is within `half` of it.
    const auto within = [&](double crest) {
        return std::abs(std::remainder(middle - crest, two_pi)) <= half;
    };
    return {within(-pi / 2) ? -1.0 : std::min(left, right),
            within(pi / 2) ? 1.0 : std::max(left, right)};
}

}  // namespace

GearError gear_error(const Solver& solver, double shaft_angle) {
    const Input& input = solver.input();
    const double force = solver.moments().forces.counterweight_force;
    const double distance = input.centre_distance;
    GearError result;
    result.phase_error = two_pi * input.gears.shifted_teeth / input.gears.teeth;
    result.residual_force = residual(force, result.phase_error);
    const double angle = shaft_angle + result.phase_error;
    result.range = solver.range(angle);
    result.rms = solver.rms(angle);

    // The pitch radius is l/2, so half the play is the angle (b/2)/(l/2).
    result.play = distance > 0.0 ? std::min(input.gears.backlash / distance, pi) : 0.0;
    result.play_force = std::max(residual(force, result.phase_error - result.play),
                                 residual(force, result.phase_error + result.play));
    result.play_range_low = result.range;
    result.play_range_high = result.range;
    const double turned = angle + solver.moments().phase;
    if (result.play > 0.0) {
        const AngleMinimum minimum = minimise_range(solver.moments().plane, force * distance,
                                                    {{turned - result.play, turned + result.play}});
        result.play_range_low = std::min(result.range, minimum.value);
        // Between these angles the range R lies at most A h²/4 above the larger one beside, since
        // R + A α² is convex: 1e-7 of A where the play is 1°.
        constexpr int steps = 256;
        for (int i = 0; i <= steps; ++i) {
            const double at = angle - result.play + 2.0 * result.play * i / steps;
            result.play_range_high = std::max(result.play_range_high, solver.range(at));
        }
    }

    const int last = static_cast<int>(input.cycle_deg());
    const double amplitude = force * distance;
    for (int i = 0; i <= last; ++i) {
        const double phi = i * degree;
        const double tipping = solver.M_up(phi);
        const auto [low, high] = sine_band(turned + phi, result.play);
        result.crank_angle_deg.push_back(i);
        result.M_ups.push_back(tipping + amplitude * std::sin(turned + phi));
        result.M_ups_low.push_back(tipping + amplitude * low);
        result.M_ups_high.push_back(tipping + amplitude * high);
    }
    return result;
}

}  // namespace ravnoves::balance_shaft
