// The bob weight against the exact first-order force: what two scenes must agree on.

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>

#include "bob-weights/solver.h"
#include "inertia-moments/balancing.h"

namespace ravnoves {
namespace {

using Vector = std::complex<double>;

struct Throw {
    inertia_moments::Engine engine;  // the cylinders that one bob weight stands for
    bob_weights::Input bob;
};

/// A throw of random masses and sizes: crankpins at κ₁ and κ₂, axes at ±γ/2 about a random middle.
Throw random_throw(std::mt19937& random, bob_weights::EngineType type, int rods, double bank,
                   double split) {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    Throw made;
    bob_weights::Input& bob = made.bob;
    bob.engine = {type, 2, bank, rods, split};
    for (const auto& part : bob_weights::part_fields()) {
        bob.parts.*part.member = 0.01 + unit(random);
    }
    bob.parts.oil = 0.0;  // no mass of the other scene
    bob.factor.reciprocating = unit(random);
    bob.factor.overbalance = 0.05 * unit(random);

    inertia_moments::Engine& engine = made.engine;
    engine.crank_radius = 0.03 + 0.03 * unit(random);
    engine.lambda = 0.2 + 0.15 * unit(random);
    engine.angular_speed = 100.0 + 500.0 * unit(random);
    const auto result = bob_weights::solve(bob);
    engine.reciprocating_mass = result.reciprocating.value();
    engine.rotating_mass = result.rotating.value();
    const bool pair = bob_weights::is_pair(bob.engine);
    if (pair) {
        // Cylinder 1 stands at +γ/2 on the crankpin at −δ/2: the next fires γ + δ later.
        engine.cylinders = {{0.0, 0.5 * bank, 0.0, 0.0}, {0.0, -0.5 * bank, 0.0, split}};
    } else {
        engine.cylinders = {{0.0, 0.0, 0.0, 0.0}};
    }
    return made;
}

TEST(BobWeight, TakesUpTheRotatingPartAndTheFactorOfTheRest) {
    std::mt19937 random(16);
    std::uniform_real_distribution<double> angle(0.0, 180.0);
    std::uniform_real_distribution<double> twist(-60.0, 60.0);
    using bob_weights::EngineType;
    for (int i = 0; i < 60; ++i) {
        const bool v = i % 3 == 0;
        const bool split = i % 3 == 1;
        const bool boxer = i % 6 == 2;
        const EngineType type = v || split ? EngineType::v
                                : boxer    ? EngineType::boxer
                                           : EngineType::in_line;
        const double bank = boxer ? pi : angle(random) * degree;
        const Throw made = random_throw(random, type, v || split || boxer ? 2 : 1, bank,
                                        split ? twist(random) * degree : 0.0);
        const auto& engine = made.engine;
        const auto result = bob_weights::solve(made.bob);
        const auto orders = inertia_moments::exact_orders(engine, 1);
        const auto rotating = inertia_moments::rotating_masses(engine);
        const double unit = engine.crank_radius * engine.angular_speed * engine.angular_speed;

        // The counterweights hold the bob weight, a like share of it on each rod's crankpin.
        const double share = *result.bob_weight / made.bob.engine.rods_on_crankpin();
        const Vector direction = inertia_moments::crankpin_direction(engine);
        const Vector held = share * unit * rotating.force_factor * direction;
        const Vector forward = orders.order(1).force.forward + rotating.force() * direction - held;
        const Vector backward = orders.order(1).force.backward;

        const double scale = engine.force_unit();
        EXPECT_NEAR(std::abs(forward), std::abs(result.first_order->forward) * unit, 1e-9 * scale);
        EXPECT_NEAR(std::abs(backward), std::abs(result.first_order->backward) * unit,
                    1e-9 * scale);
        // The whole curve: largest and smallest force in its two directions.
        const auto total = inertia_moments::RotatingPair{forward, backward};
        EXPECT_NEAR(total.max(), result.first_order->maximum() * unit, 1e-9 * scale);
        double upright = 0.0;
        double across = 0.0;
        for (int k = 0; k < 720; ++k) {
            const Vector force = total.at(k * 0.5 * degree + 0.25 * made.bob.engine.pin_split);
            upright = std::max(upright, std::abs(force.imag()));
            across = std::max(across, std::abs(force.real()));
        }
        EXPECT_NEAR(upright, result.first_order->upright() * unit, 2e-5 * scale);
        EXPECT_NEAR(across, result.first_order->across() * unit, 2e-5 * scale);
    }
}

}  // namespace
}  // namespace ravnoves
