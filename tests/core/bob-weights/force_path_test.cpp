// The ellipses of the first-order force, against the pistons' forces summed over a turn.

#include "bob-weights/factor_theory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "numerics/constants.h"

namespace ravnoves::bob_weights {
namespace {

constexpr double mass = 0.8;  // kg, of what reciprocates in a cylinder

Engine v_engine(double bank_deg, double split_deg) {
    return {EngineType::v, 6, bank_deg * degree, 2, split_deg * degree};
}

ForcePath path_of(const Engine& engine, double factor) {
    return force_path(first_order(engine, factor, mass));
}

/// What both cylinders of a throw push, less a mass on each crankpin; upright + i across, kg. Each
/// piston pushes along its axis by the cosine of its crankpin's angle to it.
std::complex<double> summed(const Engine& engine, double factor, double crank_angle) {
    using namespace std::complex_literals;
    std::complex<double> sum;
    for (const double side : {1.0, -1.0}) {
        const double axis = 0.5 * side * *engine.bank_angle;
        const double pin = crank_angle - 0.5 * side * engine.pin_split;
        sum += std::cos(pin - axis) * std::exp(1i * axis) - factor * std::exp(1i * pin);
    }
    return sum * mass;
}

struct HalfAxes {
    double longer = 0.0;
    double shorter = 1e300;
};

HalfAxes half_axes(const ForcePath& path) {
    HalfAxes found;
    for (std::size_t i = 0; i < path.across.size(); ++i) {
        const double radius = std::hypot(path.across[i], path.upright[i]);
        found = {std::max(found.longer, radius), std::min(found.shorter, radius)};
    }
    return found;
}

HalfAxes half_axes_by_sums(const Engine& engine, double factor) {
    HalfAxes found;
    constexpr int steps = 7200;
    for (int i = 0; i < steps; ++i) {
        const double radius = std::abs(summed(engine, factor, two_pi * i / steps));
        found = {std::max(found.longer, radius), std::min(found.shorter, radius)};
    }
    return found;
}

TEST(ForcePaths, HalfAxesAreThoseOfThePistonsForcesOverATurn) {
    for (const Engine& engine : {v_engine(90, 0), v_engine(60, 0), v_engine(90, 30),
                                 v_engine(60, 60), v_engine(72, -12)}) {
        for (const double factor : {0.0, 0.366, 0.5, 0.62}) {
            const HalfAxes found = half_axes(path_of(engine, factor));
            const HalfAxes summed = half_axes_by_sums(engine, factor);
            EXPECT_NEAR(found.longer, summed.longer, 1e-6);
            EXPECT_NEAR(found.shorter, summed.shorter, 1e-6);
            EXPECT_NEAR(first_order(engine, factor, mass).greatest(), summed.longer, 1e-6);
        }
    }
}

TEST(ForcePaths, PointsWhereThePistonsPush) {
    const Engine engine = v_engine(75, 18);
    const ForcePath path = path_of(engine, 0.42);
    const auto last = static_cast<double>(path.across.size() - 1);
    for (std::size_t i = 0; i < path.across.size(); ++i) {
        const auto sum = summed(engine, 0.42, two_pi * static_cast<double>(i) / last);
        EXPECT_NEAR(path.upright[i], sum.real(), 1e-12);
        EXPECT_NEAR(path.across[i], sum.imag(), 1e-12);
    }
}

TEST(ForcePaths, ANinetyDegreeVWithHalfTheMassLeavesNothing) {
    EXPECT_NEAR(half_axes(path_of(v_engine(90, 0), 0.5)).longer, 0.0, 1e-12);
    // Without counterweights it is a circle of the whole mass.
    EXPECT_NEAR(half_axes(path_of(v_engine(90, 0), 0.0)).longer, mass, 1e-12);
    EXPECT_NEAR(half_axes(path_of(v_engine(90, 0), 0.0)).shorter, mass, 1e-12);
}

}  // namespace
}  // namespace ravnoves::bob_weights
