// The ellipses of the first-order force, against the pistons' forces summed over a turn.

#include "bob-weights/model/shown_force.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "numerics/constants.h"
#include "numerics/units.h"

namespace ravnoves {
namespace {

using namespace bob_weights;

constexpr double mass = 0.8;  // kg, of what reciprocates in a cylinder

Engine vEngine(double bankDeg, double splitDeg) {
    return {EngineType::v, 6, bankDeg * degree, 2, splitDeg * degree};
}

ShownForce shown(const Engine& engine, double factor) {
    Result result;
    result.first_order = first_order(engine, factor, mass);
    result.first_order_bare = first_order(engine, 0.0, mass);
    return shownForce(result).value();
}

/// What both cylinders of a throw push, less a mass on each crankpin; upright + i across, g. Each
/// piston pushes along its axis by the cosine of its crankpin's angle to it.
std::complex<double> summed(const Engine& engine, double factor, double crankAngle) {
    using namespace std::complex_literals;
    std::complex<double> sum;
    for (const double side : {1.0, -1.0}) {
        const double axis = 0.5 * side * *engine.bank_angle;
        const double pin = crankAngle - 0.5 * side * engine.pin_split;
        sum += std::cos(pin - axis) * std::exp(1i * axis) - factor * std::exp(1i * pin);
    }
    return sum * mass / units::gram.to_si;
}

struct HalfAxes {
    double longer = 0.0;
    double shorter = 1e300;
};

HalfAxes halfAxes(const ForcePath& path) {
    HalfAxes found;
    for (std::size_t i = 0; i < path.across.size(); ++i) {
        const double radius = std::hypot(path.across[i], path.upright[i]);
        found = {std::max(found.longer, radius), std::min(found.shorter, radius)};
    }
    return found;
}

HalfAxes halfAxesBySums(const Engine& engine, double factor) {
    HalfAxes found;
    constexpr int steps = 7200;
    for (int i = 0; i < steps; ++i) {
        const double radius = std::abs(summed(engine, factor, two_pi * i / steps));
        found = {std::max(found.longer, radius), std::min(found.shorter, radius)};
    }
    return found;
}

TEST(ShownForce, HalfAxesAreThoseOfThePistonsForcesOverATurn) {
    for (const Engine& engine :
         {vEngine(90, 0), vEngine(60, 0), vEngine(90, 30), vEngine(60, 60), vEngine(72, -12)}) {
        for (const double factor : {0.0, 0.366, 0.5, 0.62}) {
            const ShownForce force = shown(engine, factor);
            const HalfAxes left = halfAxesBySums(engine, factor);
            const HalfAxes bare = halfAxesBySums(engine, 0.0);
            EXPECT_NEAR(halfAxes(force.left).longer, left.longer, 1e-3);
            EXPECT_NEAR(halfAxes(force.left).shorter, left.shorter, 1e-3);
            EXPECT_NEAR(halfAxes(force.bare).longer, bare.longer, 1e-3);
            EXPECT_NEAR(halfAxes(force.bare).shorter, bare.shorter, 1e-3);
            EXPECT_GT(force.reach, std::max(left.longer, bare.longer));
        }
    }
}

TEST(ShownForce, PointsWhereThePistonsPush) {
    const Engine engine = vEngine(75, 18);
    const ShownForce force = shown(engine, 0.42);
    const auto last = static_cast<double>(force.left.across.size() - 1);
    for (std::size_t i = 0; i < force.left.across.size(); ++i) {
        const auto sum = summed(engine, 0.42, two_pi * static_cast<double>(i) / last);
        EXPECT_NEAR(force.left.upright[i], sum.real(), 1e-9);
        EXPECT_NEAR(force.left.across[i], sum.imag(), 1e-9);
    }
}

TEST(ShownForce, ANinetyDegreeVWithHalfTheMassLeavesNothing) {
    const ShownForce force = shown(vEngine(90, 0), 0.5);
    EXPECT_NEAR(halfAxes(force.left).longer, 0.0, 1e-9);
    // Without counterweights it is a circle of the whole mass.
    EXPECT_NEAR(halfAxes(force.bare).longer, mass / units::gram.to_si, 1e-9);
    EXPECT_NEAR(halfAxes(force.bare).shorter, mass / units::gram.to_si, 1e-9);
}

TEST(ShownForce, TheReachStaysWhileTheMassesChangeALittle) {
    EXPECT_FALSE(shownForce({}));
    const double first = steadyReach(100.0, 0.0);
    EXPECT_GT(first, 100.0);
    EXPECT_EQ(steadyReach(105.0, first), first);
    EXPECT_EQ(steadyReach(80.0, first), first);
    EXPECT_GT(steadyReach(130.0, first), 130.0);
    EXPECT_LT(steadyReach(20.0, first), 30.0);
    EXPECT_EQ(steadyReach(0.0, first), first);  // nothing to show
}

}  // namespace
}  // namespace ravnoves
