#include "balance-shaft/flywheel.h"

#include <gtest/gtest.h>

#include <cmath>

#include "balance-shaft/presets.h"
#include "balance-shaft/solver.h"
#include "case-file/json.h"
#include "test_cases.h"

namespace ravnoves::balance_shaft {
namespace {

using test::written;

/// M = mean + a sin φ every 0.5° by the spline.
Input sine(double mean, double amplitude, int strokes) {
    Input input = preset_tmz_650d();
    input.strokes = strokes;
    input.interpolation = Interpolation::periodic_cubic;
    TorqueTable& table = input.torque.table;
    table = {};
    const int rows = 360 * strokes;
    for (int i = 0; i <= rows; ++i) {
        table.crank_angle_deg.push_back(0.5 * i);
        table.torque.push_back(mean + amplitude * std::sin(0.5 * (i % rows) * degree));
    }
    return input;
}

TEST(FlywheelTest, OfASineIsTwiceItsAmplitude) {
    for (const int strokes : {4, 2}) {
        Input input = sine(40.0, 300.0, strokes);
        input.flywheel = FlywheelTarget{0.5, std::nullopt};
        const Result result = solve(input);
        const Flywheel& wheel = result.flywheel;
        EXPECT_NEAR(wheel.excess_work, 600.0, 1e-6);
        EXPECT_NEAR(wheel.max_energy, 600.0, 1e-6);
        EXPECT_NEAR(wheel.min_energy, 0.0, 1e-6);
        EXPECT_NEAR(std::remainder(wheel.max_angle - pi, two_pi), 0.0, 1e-6);
        EXPECT_NEAR(std::remainder(wheel.min_angle, two_pi), 0.0, 1e-6);
        EXPECT_NEAR(*wheel.fluctuation, 600.0 / (0.5 * 376.8 * 376.8), 1e-9);
        for (std::size_t i = 0; i < wheel.energy.size(); i += 17) {
            EXPECT_NEAR(wheel.energy[i],
                        300.0 * (1.0 - std::cos(result.curves.crank_angle_deg[i] * degree)), 1e-6);
        }
    }
}

TEST(FlywheelTest, TheSpeedOfAWheelDrivenByTheTableSwingsByDelta) {
    // J ω dω/dφ = M − mean in small steps against the formula, whose error is of the order δ².
    for (const Interpolation interpolation :
         {Interpolation::linear, Interpolation::periodic_cubic}) {
        Input input = preset_tmz_650d();
        input.interpolation = interpolation;
        input.flywheel = FlywheelTarget{std::nullopt, 0.01};
        const Solver solver(input);
        const Result result = solver.result();
        const double inertia = *result.flywheel.inertia;
        double square = input.angular_speed * input.angular_speed;
        double highest = 0.0;
        double lowest = 1e300;
        constexpr int steps = 200'000;
        const double step = 4.0 * pi / steps;
        for (int i = 0; i < steps; ++i) {
            square += 2.0 * (-solver.M_up((i + 0.5) * step) + result.M_up.mean) * step / inertia;
            highest = std::max(highest, std::sqrt(square));
            lowest = std::min(lowest, std::sqrt(square));
        }
        EXPECT_NEAR(square, input.angular_speed * input.angular_speed, 1e-6 * square);
        EXPECT_NEAR((highest - lowest) / ((highest + lowest) / 2.0), 0.01, 2e-4);
        EXPECT_NEAR((highest * highest - lowest * lowest) * inertia / 2.0,
                    result.flywheel.excess_work, 1e-6 * result.flywheel.excess_work);
        // J and δ are each other's answer.
        input.flywheel = FlywheelTarget{inertia, std::nullopt};
        EXPECT_NEAR(*solve(input).flywheel.fluctuation, 0.01, 1e-15);
    }
}

TEST(FlywheelTest, ASteadyTorqueNeedsNone) {
    Input input = sine(40.0, 0.0, 4);
    input.flywheel = FlywheelTarget{std::nullopt, 0.02};
    const Flywheel wheel = solve(input).flywheel;
    EXPECT_NEAR(wheel.excess_work, 0.0, 1e-9);
    EXPECT_NEAR(*wheel.inertia, 0.0, 1e-9);
    input.flywheel.reset();
    const Json json = written(input).at("flywheel");
    EXPECT_TRUE(json.at("inertia_kg_m2").is_null());
    EXPECT_TRUE(json.at("fluctuation").is_null());
    EXPECT_TRUE(json.at("excess_work_J").is_number());
}

}  // namespace
}  // namespace ravnoves::balance_shaft
