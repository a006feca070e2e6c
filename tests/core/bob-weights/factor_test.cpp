// The factor of theory, and the ellipse that it leaves.

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "bob-weights/factor_theory.h"
#include "numerics/constants.h"

namespace ravnoves::bob_weights {
namespace {

Engine v(double bank_deg, double split_deg = 0.0, int cylinders = 6) {
    return {EngineType::v, cylinders, bank_deg * degree, 2, split_deg * degree};
}

TEST(Factor, OfANinetyDegreeVTakesUpAll) {
    EXPECT_EQ(theory_factor(v(90)), 0.5);
    EXPECT_LT(first_order(v(90), 0.5, 1.0).maximum(), 1e-15);
    // Without counterweights the force is a circle: of constant size, turning with the crank.
    const FirstOrder bare = first_order(v(90), 0.0, 1.0);
    EXPECT_NEAR(bare.upright(), 1.0, 1e-15);
    EXPECT_NEAR(bare.across(), 1.0, 1e-15);
}

TEST(Factor, OfSplitPinsLeavesALine) {
    // The even-fire 90° V-6 of the trade: 36.6 %, (1 − tan 15°)/2.
    EXPECT_NEAR(theory_factor(v(90, 30)), 0.3660254037844386, 1e-15);
    const FirstOrder left = first_order(v(90, 30), theory_factor(v(90, 30)), 1.0);
    EXPECT_NEAR(left.upright(), 0.0, 1e-15);
    EXPECT_NEAR(left.across(), 2.0 * std::sin(15 * degree), 1e-15);
    // Where the part against the crank is larger whatever the factor, that is said.
    EXPECT_EQ(theory_factor(v(30, -40)), 0.0);
    const FirstOrder bare = first_order(v(30, -40), 0.0, 1.0);
    EXPECT_GT(bare.backward, 1.04 * bare.forward);
    const std::string reason = factor_reason(v(30, -40)).english();
    EXPECT_EQ(reason.find("as large"), std::string::npos) << reason;
    EXPECT_NE(reason.find("with the crank only 94 % even at 0 %"), std::string::npos) << reason;
    // Banks at 60° with pins split by 60°: all first-order forces of a throw go at 50 %.
    EXPECT_NEAR(theory_factor(v(60, 60)), 0.5, 1e-15);
    EXPECT_LT(first_order(v(60, 60), 0.5, 1.0).maximum(), 1e-15);
}

TEST(Factor, OfOneCylinderMakesHalfACircle) {
    const Engine single{EngineType::in_line, 1, std::nullopt, 1, 0.0};
    EXPECT_NEAR(first_order(single, 0.0, 1.0).upright(), 1.0, 1e-15);
    EXPECT_NEAR(first_order(single, 0.0, 1.0).across(), 0.0, 1e-15);
    EXPECT_NEAR(first_order(single, 1.0, 1.0).across(), 1.0, 1e-15);
    EXPECT_NEAR(first_order(single, 0.5, 1.0).upright(), 0.5, 1e-15);
    EXPECT_NEAR(first_order(single, 0.5, 1.0).across(), 0.5, 1e-15);
}

TEST(Factor, FiftyPercentMakesTheLargestForceSmallest) {
    for (const Engine& engine : {v(45, 0, 2), v(60), v(72, 0, 10), v(90, 18), v(180, 0, 12)}) {
        const double best = first_order(engine, 0.5, 1.0).maximum();
        for (double factor = 0.0; factor <= 1.0; factor += 0.01) {
            EXPECT_GE(first_order(engine, factor, 1.0).maximum(), best - 1e-15);
        }
    }
}

// What both cylinders of a throw push, each along its axis by the cosine of its crankpin's angle to
// it, less a mass on each crankpin; its size over a turn is a test of the scenes.
TEST(ForcePath, PointsWhereThePistonsPush) {
    using namespace std::complex_literals;
    constexpr double mass = 0.8;
    constexpr double factor = 0.42;
    const Engine engine = v(75, 18);
    const ForcePath path = force_path(first_order(engine, factor, mass));
    const auto last = static_cast<double>(path.across.size() - 1);
    for (std::size_t i = 0; i < path.across.size(); ++i) {
        std::complex<double> sum;
        for (const double side : {1.0, -1.0}) {
            const double axis = 0.5 * side * *engine.bank_angle;
            const double pin =
                two_pi * static_cast<double>(i) / last - 0.5 * side * engine.pin_split;
            sum += std::cos(pin - axis) * std::exp(1i * axis) - factor * std::exp(1i * pin);
        }
        EXPECT_NEAR(path.upright[i], mass * sum.real(), 1e-12);
        EXPECT_NEAR(path.across[i], mass * sum.imag(), 1e-12);
    }
}

TEST(Factor, IsExplainedForEveryEngine) {
    EXPECT_NE(factor_reason(v(90, 30)).english().find("25.9 %"), std::string::npos)
        << factor_reason(v(90, 30)).english();
    EXPECT_NE(factor_reason(v(45)).english().find("70.7 %"), std::string::npos);
    EXPECT_NE(factor_effect(v(90, 30), theory_factor(v(90, 30))).english().find("horizontal"),
              std::string::npos);
    EXPECT_NE(factor_effect(v(90), 0.52).english().find("with the crank, 4 %"), std::string::npos)
        << factor_effect(v(90), 0.52).english();
    for (const EngineType type : {EngineType::in_line, EngineType::boxer, EngineType::v}) {
        const Engine engine{type, 4, 90 * degree, 1, 0.0};
        EXPECT_NE(factor_reason(engine).english().find("50 %"), std::string::npos);
        EXPECT_FALSE(factor_effect(engine, 0.3).empty());
    }
}

}  // namespace
}  // namespace ravnoves::bob_weights
