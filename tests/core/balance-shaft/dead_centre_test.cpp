#include "balance-shaft/dead_centre.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "synthetic_engine.h"
#include "test_cases.h"

namespace ravnoves::balance_shaft {
namespace {

using test::SyntheticEngine;

/// A trace whose angles count from elsewhere, with noise.
PressureTrace noisy_trace(std::vector<double> pressure, double step_deg, double first_deg,
                          double noise, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> error(0.0, noise);
    for (double& value : pressure) {
        value = std::max(value + error(random), 100.0);
    }
    return test::trace_of(std::move(pressure), step_deg, first_deg);
}

double error_of_centre(const DeadCentre& found, double first_deg, int strokes) {
    const double half = 90.0 * strokes;
    return std::remainder(found.angle / degree - (first_deg + half), 2.0 * half);
}

// The compression ratio is not known; with heat lost to the walls, any start of the angles.
TEST(DeadCentre, IsFoundToHalfADegree) {
    for (const SyntheticEngine& engine : test::synthetic_engines()) {
        // Combustion of a petrol engine leaves less of the line.
        const bool is_petrol = engine.heat > 0.0 && engine.ratio < 12.0;
        for (const double step : {0.1, 1.0}) {
            const auto pressure = engine.pressure(step);
            for (const double first : {-360.0, 180.0, 298.37}) {
                SCOPED_TRACE(std::string(engine.name) + ", " + std::to_string(step) + "°, from " +
                             std::to_string(first));
                const auto seed = static_cast<unsigned>(step * 10.0 + first + 400.0);
                const auto trace = noisy_trace(pressure, step, first, 2e3, seed);
                const auto found = find_dead_centre(engine.crank, trace);
                ASSERT_TRUE(found);
                EXPECT_LT(std::abs(error_of_centre(*found, first, engine.strokes)),
                          std::min(is_petrol ? 1.5 : 0.5, found->uncertainty / degree));
                const double firing = engine.strokes == 4 ? 360.0 : 0.0;
                EXPECT_NEAR(std::remainder((found->angle + found->shift) / degree - firing,
                                           180.0 * engine.strokes),
                            0.0, 1e-9);
            }
        }
    }
}

// The peak of a motored engine comes before its dead centre by the heat that is lost.
TEST(DeadCentre, IsLaterThanThePeakOfAMotoredEngine) {
    SyntheticEngine engine = test::synthetic_engines()[7];
    ASSERT_EQ(std::string(engine.name), "motored diesel, cold");
    const auto trace = test::trace_of(engine.pressure(0.1), 0.1, -360.0);
    const auto highest = std::max_element(trace.pressure.begin(), trace.pressure.end());
    const double peak =
        trace.crank_angle_deg[static_cast<std::size_t>(highest - trace.pressure.begin())];
    EXPECT_LT(peak, -0.5);
    const auto found = find_dead_centre(engine.crank, trace);
    ASSERT_TRUE(found);
    EXPECT_LT(std::abs(error_of_centre(*found, -360.0, 4)), 0.3);
    EXPECT_TRUE(found->is_certain());
}

// Less of the line, more noise: less sure, and it says so.
TEST(DeadCentre, SaysHowSureItIs) {
    SyntheticEngine engine = test::synthetic_engines().back();
    const auto pressure = engine.pressure(0.5);
    const auto sure = find_dead_centre(engine.crank, noisy_trace(pressure, 0.5, 0.0, 1e3, 5));
    const auto noisy = find_dead_centre(engine.crank, noisy_trace(pressure, 0.5, 0.0, 2e4, 5));
    ASSERT_TRUE(sure && noisy);
    EXPECT_GT(noisy->uncertainty, 1.5 * sure->uncertainty);
    for (const auto& found : {sure, noisy}) {
        EXPECT_LT(std::abs(error_of_centre(*found, 0.0, 4)), found->uncertainty / degree);
    }
    EXPECT_NE(noisy->describe().english().find("may be at"), std::string::npos);
}

// A whole turn that the line tells to 0.8° is a whole turn, and 0.2° of as much is none.
TEST(DeadCentre, ProposesWholeTurnsWhereTheRestIsUncertain) {
    const auto proposed = [](double shift, double uncertainty) {
        return DeadCentre{.shift = shift * degree, .uncertainty = uncertainty * degree}
                   .proposed_shift() /
               degree;
    };
    EXPECT_EQ(proposed(-0.2, 0.8), 0.0);
    EXPECT_NEAR(proposed(359.8, 0.8), 360.0, 1e-12);
    EXPECT_NEAR(proposed(-360.3, 0.4), -360.0, 1e-12);
    EXPECT_EQ(proposed(-3.9, 0.9), -3.9 * degree / degree);
    EXPECT_EQ(proposed(358.5, 0.8), 358.5 * degree / degree);
}

TEST(DeadCentre, IsNoneWithoutACompression) {
    PressureTrace flat = test::trace_of(std::vector(720, 1e5), 1.0);
    EXPECT_FALSE(find_dead_centre({0.046, 0.150, 0.0}, flat));
    flat.pressure.assign(721, 0.0);
    EXPECT_FALSE(find_dead_centre({0.046, 0.150, 0.0}, flat));
    const PressureTrace coarse{{0, 180, 360, 540, 720}, {1e5, 1e5, 4e6, 2e5, 1e5}};
    EXPECT_FALSE(find_dead_centre({0.046, 0.150, 0.0}, coarse));
}

TEST(DeadCentre, IsNoneWhereTheLineHasNoRows) {
    const SyntheticEngine engine = test::synthetic_engines()[0];
    constexpr double step = 0.5;
    const auto pressure = engine.pressure(step);
    // Rows about the peak alone.
    PressureTrace gap{{0.0}, {pressure[0]}};
    for (std::size_t i = 640; i < 800; ++i) {
        gap.crank_angle_deg.push_back(step * static_cast<double>(i));
        gap.pressure.push_back(pressure[i]);
    }
    gap.crank_angle_deg.push_back(720.0);
    gap.pressure.push_back(pressure[0]);
    EXPECT_FALSE(find_dead_centre(engine.crank, gap));
    // All but the last within a degree.
    PressureTrace point;
    for (int i = 0; i < 100; ++i) {
        point.crank_angle_deg.push_back(0.009 * i);
        point.pressure.push_back(1e5);
    }
    point.crank_angle_deg.push_back(720.0);
    point.pressure.push_back(1e5);
    EXPECT_FALSE(find_dead_centre(engine.crank, point));
}

}  // namespace
}  // namespace ravnoves::balance_shaft
