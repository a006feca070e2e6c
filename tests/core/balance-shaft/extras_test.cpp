#include <gtest/gtest.h>

#include <cmath>

#include "balance-shaft/crank_balance.h"
#include "balance-shaft/gear_error.h"
#include "balance-shaft/presets.h"
#include "test_cases.h"

namespace ravnoves::balance_shaft {
namespace {

TEST(CrankBalance, TheForceIsTheSumOfInertiaAndCounterweight) {
    Input input = preset_tmz_650d();
    for (const double share : {0.0, 0.25, 0.5, 0.8, 1.0}) {
        input.crank_share = share;
        const CrankBalance balance = crank_balance(Solver(input));
        const double p = balance.first_order;
        EXPECT_NEAR(p, 8594.79473664, 1e-6);
        const ForceLocus locus = force_locus(balance, balance.across, balance.along, 0.0);
        for (std::size_t i = 0; i < locus.x.size(); ++i) {
            const double phi = 2.0 * static_cast<double>(i) * degree;
            EXPECT_NEAR(locus.x[i], -share * p * std::sin(phi), 1e-9 * p);
            EXPECT_NEAR(locus.y[i], p * std::cos(phi) - share * p * std::cos(phi), 1e-9 * p);
        }
        // The shaft makes the first order a point; the second order stays.
        EXPECT_NEAR(balance.with_shaft, 0.0, 1e-6);
    }
}

TEST(GearErrorTest, ResidualForceAgainstTheSumOfTheForces) {
    Input input = preset_tmz_650d();
    input.gears = {40, 1, 0.0};
    const Solver solver(input);
    const GearError error = gear_error(solver, input.shaft_angle);
    EXPECT_NEAR(error.phase_error / degree, 9.0, 1e-12);
    const double p1 = solver.moments().forces.counterweight_force;
    for (int i = 0; i < 360; i += 7) {
        const double phi = i * degree;
        const double delta = error.phase_error;
        // Inertia force, counterweight on the crank, counterweight on the shaft.
        const double x = -p1 * std::sin(phi) + p1 * std::sin(phi + delta);
        const double y = 2 * p1 * std::cos(phi) - p1 * std::cos(phi) - p1 * std::cos(phi + delta);
        EXPECT_NEAR(std::hypot(x, y), error.residual_force, 1e-9 * p1);
        // The shaft's force acts at its axis: moment about the crank axis, clockwise positive.
        const double l = input.centre_distance;
        const double axis_x = l * std::sin(input.shaft_angle);
        const double axis_y = l * std::cos(input.shaft_angle);
        const double moment =
            axis_y * p1 * std::sin(phi + delta) + axis_x * p1 * std::cos(phi + delta);
        EXPECT_NEAR(solver.M_up(phi) + moment, error.M_ups[static_cast<std::size_t>(i)], 1e-9 * p1);
    }
    EXPECT_NEAR(error.range, solver.range(input.shaft_angle + 9.0 * degree), 1e-9);
}

TEST(GearErrorTest, TheBandHoldsEveryPlaceOfTheShaft) {
    Input input = preset_tmz_650d();
    input.gears = {40, 0, 0.3e-3};
    const Solver solver(input);
    const GearError error = gear_error(solver, input.shaft_angle);
    EXPECT_NEAR(error.play, 0.3e-3 / 0.10015, 1e-12);
    for (std::size_t i = 0; i < error.M_ups.size(); i += 5) {
        const double phi = error.crank_angle_deg[i] * degree;
        for (const double place : {-1.0, -0.5, 0.0, 0.7, 1.0}) {
            const double value =
                solver.M_up(phi) + solver.M_s(phi, input.shaft_angle + place * error.play);
            EXPECT_LE(error.M_ups_low[i], value + 1e-9);
            EXPECT_GE(error.M_ups_high[i], value - 1e-9);
        }
    }
    EXPECT_LE(error.play_range_low, error.range);
    EXPECT_GE(error.play_range_high, error.range);
}

TEST(GearErrorTest, ThePlayRangeIsThatOfEveryPlaceNotOfSome) {
    // The smallest range of the paper's engine, 1066.7458 N·m at 50.651°, lies inside this play;
    // the least of 17 places was 1066.94 N·m.
    Input input = preset_tmz_650d();
    input.shaft_angle = 48.0 * degree;
    input.gears = {40, 0, 6e-3};
    const GearError error = gear_error(Solver(input), input.shaft_angle);
    EXPECT_NEAR(error.play_range_low, 1066.7458101914112, 1e-6);
    EXPECT_NEAR(error.play_range_low, solve(input).best_range.value, 1e-10);

    for (const double angle : {0.0, 50.0, 130.0, 237.0, 310.0}) {
        for (const double backlash : {0.1e-3, 2e-3, 10e-3}) {
            input.shaft_angle = angle * degree;
            input.gears = {40, 1, backlash};
            const Solver solver(input);
            const GearError found = gear_error(solver, input.shaft_angle);
            double low = 1e300;
            double high = 0.0;
            constexpr int samples = 20'000;
            for (int i = 0; i <= samples; ++i) {
                const double range = solver.range(input.shaft_angle + found.phase_error +
                                                  found.play * (2.0 * i / samples - 1.0));
                low = std::min(low, range);
                high = std::max(high, range);
            }
            const double missed = 2.0 * solver.result().moment_amplitude * found.play / samples;
            EXPECT_LE(found.play_range_low, low + 1e-9);
            EXPECT_GE(found.play_range_low, low - missed);
            EXPECT_GE(found.play_range_high, high - 1e-9);
            EXPECT_LE(found.play_range_high, high + missed);
        }
    }
}

}  // namespace
}  // namespace ravnoves::balance_shaft
