#include "inertia-moments/orders.h"

#include <gtest/gtest.h>

#include "case-file/input_error.h"
#include "engines.h"

namespace ravnoves::inertia_moments {
namespace {

using test::exact_wrench;
using test::irregular;
using test::sum_of_orders;
using test::vr5;
using test::Wrench;

Input single(double crank_radius, double rod_length, double offset) {
    Input input;
    input.crank_radius = crank_radius;
    input.lambda = crank_radius / rod_length;
    input.angular_speed = 10.0;
    input.reciprocating_mass = 2.0;
    input.cylinders = {{0.0, 0.0, offset, 0.0}};
    return input;
}

TEST(ExactOrders, PublishedHarmonicsOfOneCylinder) {
    const Result centred = solve(single(0.300, 1.000, 0.0));
    const double unit = centred.engine.force_unit();
    EXPECT_NEAR(centred.exact.order(2).force.vertical().cos / unit, 0.307050659, 5e-10);
    EXPECT_NEAR(centred.exact.order(4).force.vertical().cos / unit, -0.007237695, 5e-10);
    EXPECT_NEAR(centred.exact.order(6).force.vertical().cos / unit, 0.000191937, 5e-10);
    const Result offset = solve(single(0.050, 0.150, 0.0125));
    const double scale = offset.engine.force_unit();
    EXPECT_NEAR(offset.exact.order(1).force.vertical().sin / scale, 0.0874317, 5e-8);
    EXPECT_NEAR(offset.exact.order(2).force.vertical().cos / scale, 0.3471724, 5e-8);
    EXPECT_NEAR(offset.exact.order(3).force.vertical().sin / scale, -0.0118560, 5e-8);
    EXPECT_NEAR(offset.exact.order(4).force.vertical().cos / scale, -0.0107052, 5e-8);
    EXPECT_NEAR(offset.two_term.order(1).force.vertical().sin / scale, 0.25 / 3.0, 1e-15);
    EXPECT_NEAR(offset.two_term.order(2).force.vertical().cos / scale, 1.0 / 3.0, 1e-15);
}

// Classical torque of the two-term form: order 2 −½, order 3 −¾λ, order 1 ¼λ, order 4 −¼λ².
TEST(TwoTermOrders, ClassicalTorqueHarmonics) {
    const Input input = single(0.05, 0.2, 0.0);
    const EngineOrders orders = two_term_orders(make_engine(input));
    const double unit = orders.order(1).force_scale * 0.05;
    EXPECT_NEAR(orders.order(1).reaction_torque.sin / unit, -0.25 * 0.25, 1e-15);
    EXPECT_NEAR(orders.order(2).reaction_torque.sin / unit, 0.5, 1e-15);
    EXPECT_NEAR(orders.order(3).reaction_torque.sin / unit, 0.75 * 0.25, 1e-15);
    EXPECT_NEAR(orders.order(4).reaction_torque.sin / unit, 0.25 * 0.0625, 1e-15);
}

/// s′ and s″ of the paper's two-term form: −s″ = R(cos θ + K λ sin θ + λ cos 2θ), and its integral.
PistonMotion<double> two_term_motion(double R, double L, double e, double theta) {
    return {0.0,
            -R * (std::sin(theta) - e / L * std::cos(theta) + R / L / 2.0 * std::sin(2.0 * theta)),
            -R * (std::cos(theta) + e / L * std::sin(theta) + R / L * std::cos(2.0 * theta))};
}

// Also with an offset: the orders must add up to the product of force and speed of the two-term
// motion.
TEST(TwoTermOrders, TorqueIsTheProductOfForceAndSpeed) {
    Input input = single(0.05, 0.15, 0.02);
    input.rod = RigidRod{0.6, 0.05, 0.004};
    const Engine engine = make_engine(input);
    const EngineOrders orders = two_term_orders(engine);
    const double omega_2 = input.angular_speed * input.angular_speed;
    for (int i = 0; i < 40; ++i) {
        const double phi = 0.157 * i;
        const auto m = two_term_motion(0.05, 0.15, 0.02, phi);
        // The rod's angle to the same order is λ(K − sin θ).
        const double dpsi = -engine.lambda * std::cos(phi);
        const double d2psi = engine.lambda * std::sin(phi);
        const double torque = -omega_2 * (engine.reciprocating_mass * m.d2s * m.ds +
                                          engine.rod_couple_inertia * d2psi * dpsi);
        const double roll = omega_2 * (0.02 * engine.reciprocating_mass * m.d2s -
                                       engine.rod_couple_inertia * d2psi);
        const Wrench sum = sum_of_orders(orders, phi);
        EXPECT_NEAR(sum.reaction_torque, -torque, 1e-12);
        EXPECT_NEAR(sum.inertia_roll, roll, 1e-12);
    }
}

TEST(ExactOrders, SumOverOrdersIsTheTimeCurve) {
    Input with_rod = irregular();
    with_rod.rod = RigidRod{0.5, 0.04, 0.003};
    for (const Input& input : {irregular(), vr5(), with_rod, test::irregular_star()}) {
        Input with_step = input;
        with_step.step = 5.0 * degree;
        const Engine engine = make_engine(input);
        const EngineOrders orders = exact_orders(engine, 40);
        const double unit = engine.force_unit();
        double mean_roll = 0.0;  // the orders have none; articulated rods do
        for (int k = 0; k < 64; ++k) {
            mean_roll += exact_wrench(engine, two_pi * k / 64).inertia_roll / 64.0;
        }
        for (int i = 0; i < 60; ++i) {
            const double phi = 0.11 * i;
            Wrench sum = sum_of_orders(orders, phi);
            sum.inertia_roll += mean_roll;
            test::expect_near(exact_wrench(engine, phi), sum, 1e-12 * unit);
        }
        const WrenchCurves curves = solve(with_step).curves;
        ASSERT_EQ(curves.crank_angle.size(), 73U);
        const Wrench at_50 = exact_wrench(engine, 50.0 * degree);
        EXPECT_NEAR(curves.force_x[10], at_50.force.real(), 1e-13 * unit);
        EXPECT_NEAR(curves.moment_y[10], at_50.moment.imag(), 1e-13 * unit);
        EXPECT_NEAR(curves.roll[10], at_50.roll(), 1e-13 * unit);
        EXPECT_EQ(curves.force_x.front(), curves.force_x.back());
        const WrenchCurves summed = with_orders(WrenchCurves(curves.crank_angle), orders);
        EXPECT_NEAR(curves.moment_x[33], summed.moment_x[33], 1e-12 * unit);
    }
}

// Turning the whole engine turns the vectors and nothing else.
TEST(EngineOrdersTest, RotationOfTheEngineRotatesTheVectors) {
    const Input input = irregular();
    Input turned = input;
    const double angle = 0.77;
    for (Cylinder& cylinder : turned.cylinders) {
        cylinder.bank_angle += angle;
    }
    const Result a = solve(input);
    const Result b = solve(turned);
    const Complex rotation = std::polar(1.0, angle);
    const double unit = a.engine.force_unit();
    for (std::size_t k = 0; k < a.exact.orders.size(); ++k) {
        for (const auto& [before, after] :
             {std::pair{a.exact.orders[k], b.exact.orders[k]},
              std::pair{a.remaining.orders[k], b.remaining.orders[k]}}) {
            EXPECT_NEAR(std::abs(before.force.forward * rotation - after.force.forward), 0.0,
                        1e-13 * unit);
            EXPECT_NEAR(std::abs(before.force.backward * rotation - after.force.backward), 0.0,
                        1e-13 * unit);
            EXPECT_NEAR(std::abs(before.moment.forward * rotation - after.moment.forward), 0.0,
                        1e-13 * unit);
            EXPECT_NEAR(std::abs(before.moment.backward * rotation - after.moment.backward), 0.0,
                        1e-13 * unit);
            EXPECT_NEAR(before.roll().cos, after.roll().cos, 1e-13 * unit);
            EXPECT_NEAR(before.roll().sin, after.roll().sin, 1e-13 * unit);
        }
    }
    for (std::size_t k = 0; k < a.two_term.orders.size(); ++k) {
        EXPECT_NEAR(std::abs(a.two_term.orders[k].moment.forward * rotation -
                             b.two_term.orders[k].moment.forward),
                    0.0, 1e-13 * unit);
    }
    EXPECT_EQ(a.rotating.force_factor, b.rotating.force_factor);
}

TEST(EngineOrdersTest, MovingTheReferencePointChangesMomentsByForceTimesDistance) {
    const Input input = irregular();
    Input moved = input;
    const double d = 0.083;
    moved.reference_position += d;
    const Result a = solve(input);
    const Result b = solve(moved);
    const double unit = a.engine.force_unit();
    for (std::size_t k = 0; k < a.exact.orders.size(); ++k) {
        for (const auto& [before, after] :
             {std::pair{a.exact.orders[k], b.exact.orders[k]},
              std::pair{a.remaining.orders[k], b.remaining.orders[k]}}) {
            EXPECT_EQ(before.force.forward, after.force.forward);
            EXPECT_NEAR(
                std::abs(before.moment.forward - d * before.force.forward - after.moment.forward),
                0.0, 1e-13 * unit);
            EXPECT_NEAR(std::abs(before.moment.backward - d * before.force.backward -
                                 after.moment.backward),
                        0.0, 1e-13 * unit);
            EXPECT_EQ(before.roll().cos, after.roll().cos);
        }
    }
}

TEST(ExactOrders, LongRodsAreHarmonic) {
    Input input = single(0.05, 0.05 * 1e9, 0.0);
    const Result result = solve(input);
    const double unit = result.engine.force_unit();
    EXPECT_NEAR(result.exact.order(1).force.vertical().cos, unit, 1e-12 * unit);
    EXPECT_NEAR(result.exact.order(2).force.vertical().cos, 1e-9 * unit, 1e-13 * unit);
}

/// Orders of m R ω² by quadrature in 30 digits: right up to the bound, and rejected beyond it.
TEST(ExactOrders, AreRightUpToLockingOrRejectedWithTheBound) {
    Input input = single(1.0, 1.0, 0.0);
    input.lambda = 1.0 - 1e-8;
    const Result near = solve(input);
    EXPECT_NEAR(near.exact.order(2).force.vertical().cos / near.engine.force_unit(),
                1.697652280676585, 1e-10);
    for (const double lambda : {1.0 - 1e-9, 1.0 - 1e-10}) {
        input.lambda = lambda;
        try {
            static_cast<void>(solve(input));
            ADD_FAILURE() << lambda;
        } catch (const InputError& error) {
            EXPECT_EQ(error.where(), "/input/lambda");
            EXPECT_NE(error.allowed().find("must be at most 0.999999996"), std::string::npos)
                << error.what();
        }
    }
    Input offset = single(0.05, 0.1, 0.04999999999);
    EXPECT_THROW(static_cast<void>(solve(offset)), InputError);
}

}  // namespace
}  // namespace ravnoves::inertia_moments
