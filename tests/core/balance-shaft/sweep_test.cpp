// Many angles at once, the extrema of splines, and the processor's vector units: other ways to the
// same numbers.

#include <gtest/gtest.h>

#include <random>

#include "balance-shaft/angle_search.h"
#include "examples.h"
#include "numerics/vector_lanes.h"
#include "scenes/scenes.h"
#include "test_cases.h"

namespace ravnoves::balance_shaft {
namespace {

std::vector<Input> engines() {
    std::vector<Input> inputs{preset_tmz_650d(), test::diesel(), test::two_stroke()};
    for (const std::size_t rows : {3, 5, 12, 49, 200, 2600}) {
        inputs.push_back(preset_tmz_650d());
        inputs.back().torque.table = test::random_table(static_cast<unsigned>(rows), rows);
    }
    inputs.push_back(test::diesel());
    inputs.back().cylinder.offset = 8e-3;
    const std::size_t count = inputs.size();
    for (std::size_t i = 0; i < count; ++i) {
        inputs.push_back(inputs[i]);
        inputs.back().interpolation = Interpolation::periodic_cubic;
    }
    return inputs;
}

std::vector<double> some_angles(int count, double from, double to) {
    std::mt19937 generator(7);
    std::uniform_real_distribution<double> angle(from, to);
    std::vector<double> angles;
    for (int i = 0; i < count; ++i) {
        angles.push_back(angle(generator));
    }
    return angles;
}

TEST(BalanceShaftSweep, ManyAnglesAtOnceHaveTheDigitsOfEach) {
    std::vector<double> degrees;
    for (int i = 0; i <= 360; ++i) {
        degrees.push_back(i * degree);
    }
    for (const Input& input : engines()) {
        const Solver solver(input);
        for (const auto& alpha :
             {degrees, some_angles(60, -10.0, 10.0), std::vector<double>{1.0}, {}}) {
            std::vector<double> range(alpha.size());
            std::vector<double> rms(alpha.size());
            const MomentPlane& plane = solver.moments().plane;
            const double amplitude = solver.moments().forces.moment_amplitude;
            sweep(plane, amplitude, alpha, range, rms);
            for (std::size_t i = 0; i < alpha.size(); ++i) {
                const MomentPlane::Moment shaft = shaft_at(amplitude, alpha[i]);
                EXPECT_EQ(range[i], plane.range(shaft)) << alpha[i];
                EXPECT_EQ(rms[i], plane.rms(shaft));
            }
        }
    }
}

TEST(BalanceShaftSweep, ExtremaStandAtTheirAnglesAndNoSampleIsBeyondThem) {
    for (const Input& input : engines()) {
        const Solver solver(input);
        const auto moment = [&](double angle_deg) { return solver.M_up(angle_deg * degree); };
        std::vector<double> angles = input.torque.table.crank_angle_deg;
        for (int i = 0; i < 2 * input.cycle_deg(); ++i) {
            angles.push_back(0.5 * i);
        }
        for (const double amplitude : {0.0, 1.0, 50.0, 430.0, 3000.0}) {
            for (const double alpha : some_angles(10, 0.0, two_pi)) {
                const MomentPlane::Moment shaft = shaft_at(amplitude, alpha);
                const MomentPlane::Extrema found = solver.moments().plane(shaft);
                const double rounding = 4e-14 * (1000.0 + amplitude);
                const auto value = [&](double angle) {
                    return moment(angle) + amplitude * std::sin(angle * degree + alpha);
                };
                for (const MomentPlane::Place& at : {found.max, found.min}) {
                    EXPECT_NEAR(value(at.angle_deg), at.value, 10.0 * rounding);
                    EXPECT_NEAR(std::cos(at.angle_deg * degree), at.cos, 1e-12);
                    EXPECT_NEAR(std::sin(at.angle_deg * degree), at.sin, 1e-12);
                }
                for (const double angle : angles) {
                    EXPECT_LE(value(angle), found.max.value + 10.0 * rounding) << amplitude;
                    EXPECT_GE(value(angle), found.min.value - 10.0 * rounding) << amplitude;
                }
            }
        }
    }
}

/// With vector units and without: on any processor a user sees the same digits.
TEST(VectorUnits, ChangeNoDigitOfAResult) {
    CaseFile file = ravnoves::test::example("tmz-650d");
    for (const char* interpolation : {"linear", "periodic-cubic"}) {
        file.input["interpolation"] = interpolation;
        const std::string with = solve_case(file, {}).dump();
        want_avx2(false);
        EXPECT_FALSE(has_avx2());
        EXPECT_EQ(solve_case(file, {}).dump(), with);
        want_avx2(true);
    }
    EXPECT_EQ(has_avx2(), processor_has_avx2());
}

}  // namespace
}  // namespace ravnoves::balance_shaft
