#include <gtest/gtest.h>

#include "engines.h"

namespace ravnoves::inertia_moments {
namespace {

using test::irregular;

Shaft shaft(int order, Direction direction, Balances balances) {
    Shaft s;
    s.order = order;
    s.direction = direction;
    s.balances = balances;
    s.weight_distance = 0.35;
    s.weight_radius = 0.03;
    return s;
}

std::vector<Shaft> all_four(int order) {
    return {shaft(order, Direction::forward, Balances::force),
            shaft(order, Direction::backward, Balances::force),
            shaft(order, Direction::forward, Balances::moment),
            shaft(order, Direction::backward, Balances::moment)};
}

TEST(BalanceShafts, LeaveNothingOfTheOrderTheyCancel) {
    for (const int order : {1, 2, 3, 4, 6}) {
        Input input = irregular();
        input.rotating_mass = 0.0;
        input.shafts = all_four(order);
        // Off the reference position: the force shafts then add to the moment.
        input.shafts[0].axial_position = 0.2;
        input.shafts[1].axial_position = -0.1;
        const Result result = solve(input);
        const EngineOrder& before = result.exact.order(order);
        const EngineOrder& after = result.remaining.order(order);
        EXPECT_GT(before.force.max(), 1e-4 * before.force_scale);
        EXPECT_LT(after.force.max(), 1e-10 * before.force.max());
        EXPECT_LT(after.moment.max(), 1e-10 * before.moment.max());
        // The other orders stay as they are.
        const int other = order == 1 ? 2 : 1;
        EXPECT_EQ(result.exact.order(other).moment.forward,
                  result.remaining.order(other).moment.forward);
    }
}

// The weights themselves, as rotating masses at their places: m ρ (kω)² and its moment.
TEST(BalanceShafts, WeightsAreThoseThatTheShaftNeeds) {
    Input input = irregular();
    input.shafts = all_four(2);
    const Result result = solve(input);
    const double speed = 2.0 * input.angular_speed;
    for (const ShaftDesign& design : result.shafts) {
        const double force = *design.mass * *design.shaft.weight_radius * speed * speed;
        const bool moment = design.shaft.balances == Balances::moment;
        EXPECT_NEAR(force * (moment ? design.shaft.weight_distance : 1.0), std::abs(design.target),
                    1e-12 * std::abs(design.target));
        EXPECT_NEAR(std::abs(std::remainder(*design.phase - std::arg(design.target), two_pi)), pi,
                    1e-12);
        // A pair of weights at ±L/2, one opposite the other: no force, moment F L along the front
        // weight (paper's rule).
        if (moment) {
            const Complex weight = std::polar(force, *design.phase);
            const Complex sum = weight * (0.5 * design.shaft.weight_distance) +
                                (-weight) * (-0.5 * design.shaft.weight_distance);
            EXPECT_NEAR(std::abs(sum + design.target), 0.0, 1e-12 * std::abs(design.target));
        }
    }
}

TEST(BalanceShafts, OneShaftLeavesTheOtherPart) {
    Input input = irregular();
    input.rotating_mass = 0.0;
    input.shafts = {shaft(1, Direction::forward, Balances::moment)};
    const Result result = solve(input);
    const RotatingPair& before = result.exact.order(1).moment;
    EXPECT_NEAR(result.remaining.order(1).moment.max(), std::abs(before.backward),
                1e-12 * before.max());
    EXPECT_NEAR(result.shafts[0].remaining, std::abs(before.backward), 1e-12 * before.max());
    EXPECT_NEAR(result.shafts[0].before, before.max(), 1e-12 * before.max());
}

TEST(BalanceShafts, AWrongPhaseLeavesTwiceTheSineOfHalfTheError) {
    for (const double error : {20.0 * degree, pi}) {
        for (const std::size_t wrong : {0, 1}) {
            Input input = irregular();
            input.rotating_mass = 0.0;
            input.shafts = {shaft(2, Direction::forward, Balances::moment),
                            shaft(2, Direction::backward, Balances::moment)};
            input.shafts[wrong].phase_error = error;
            const Result result = solve(input);
            const RotatingPair& before = result.exact.order(2).moment;
            const double part = std::abs(wrong == 0 ? before.forward : before.backward);
            EXPECT_NEAR(result.remaining.order(2).moment.max(), 2.0 * part * std::sin(error / 2.0),
                        1e-12 * before.max());
        }
    }
}

TEST(BalanceShafts, AShaftThatIsOffChangesNothingButSaysWhatItWouldDo) {
    Input input = irregular();
    input.shafts = {shaft(2, Direction::forward, Balances::moment)};
    const Result on = solve(input);
    input.shafts[0].enabled = false;
    const Result off = solve(input);
    EXPECT_EQ(off.remaining.order(2).moment.forward, off.exact.order(2).moment.forward);
    EXPECT_NEAR(off.shafts[0].unbalance, on.shafts[0].unbalance, 1e-15);
}

TEST(BalanceShafts, TwinsShareTheTask) {
    Input input = irregular();
    input.rotating_mass = 0.0;
    input.shafts = {shaft(2, Direction::forward, Balances::moment),
                    shaft(2, Direction::forward, Balances::moment)};
    const Result result = solve(input);
    EXPECT_NEAR(std::abs(result.remaining.order(2).moment.forward), 0.0, 1e-9);
    EXPECT_NEAR(result.shafts[0].unbalance, result.shafts[1].unbalance, 1e-15);
}

TEST(BalanceShafts, TwoTermDesignLeavesWhatTheTwoTermFormLeavesOut) {
    Input input = test::vr5();
    input.rotating_mass = 0.0;
    input.shafts = {shaft(2, Direction::forward, Balances::moment),
                    shaft(2, Direction::backward, Balances::moment)};
    input.shaft_basis = DesignBasis::two_term;
    const Result result = solve(input);
    const RotatingPair left = result.exact.order(2).moment - result.two_term.order(2).moment;
    EXPECT_NEAR(result.remaining.order(2).moment.max(), left.max(), 1e-9);
    EXPECT_GT(left.max(), 1.0);
}

TEST(BalanceShafts, NothingToCancelHasNoPhase) {
    Input input = test::unit_engine("i6");
    input.shafts = {shaft(1, Direction::forward, Balances::moment)};
    const Result result = solve(input);
    EXPECT_FALSE(result.shafts[0].phase.has_value());
    EXPECT_NEAR(result.shafts[0].unbalance, 0.0, 1e-12);
}

TEST(Counterweights, EndWebsCancelTheRotatingMasses) {
    Input input = irregular();
    input.end_webs = EndWebs{0.25, -0.19, 0.05, 0.07, 0.0, true};
    const Result result = solve(input);
    const double unit = result.engine.force_unit();
    EXPECT_NEAR(
        std::abs(result.remaining.order(1).force.forward - result.exact.order(1).force.forward),
        0.0, 1e-12 * unit);
    EXPECT_NEAR(
        std::abs(result.remaining.order(1).moment.forward - result.exact.order(1).moment.forward),
        0.0, 1e-12 * unit);
    // As masses on the crank: with the crankpins' they make no force and no moment.
    const double m = input.rotating_mass * input.crank_radius;
    Complex force;
    Complex moment;
    for (const Cylinder& cylinder : input.cylinders) {
        force += std::polar(m, cylinder.crankpin_angle);
        moment += std::polar(m, cylinder.crankpin_angle) * cylinder.axial_position;
    }
    for (const Counterweight& weight :
         {result.counterweights->front, result.counterweights->rear}) {
        force += weight.unbalance;
        moment += weight.unbalance * weight.position;
        EXPECT_NEAR(weight.mass() * weight.radius, std::abs(weight.unbalance), 1e-15);
    }
    EXPECT_NEAR(std::abs(force), 0.0, 1e-15);
    EXPECT_NEAR(std::abs(moment), 0.0, 1e-15);
}

// The classical half balance of a single: a counterweight for half the reciprocating mass leaves a
// force of constant size, turning backward.
TEST(Counterweights, HalfTheReciprocatingMassOfASingleLeavesABackwardForce) {
    Input input = test::unit_engine("i1");
    input.rotating_mass = 0.5;
    input.end_webs = EndWebs{0.5, -0.5, 1.0, 1.0, 1.0, true};
    const Result result = solve(input);
    EXPECT_NEAR(std::abs(result.remaining.order(1).force.forward), 0.0, 1e-14);
    EXPECT_NEAR(std::abs(result.remaining.order(1).force.backward), 0.5, 1e-14);
    const double masses = result.counterweights->front.mass() + result.counterweights->rear.mass();
    EXPECT_NEAR(masses, 0.5 + 0.5, 1e-13);
}

// Shafts beside such counterweights are made for what these leave.
TEST(Counterweights, ShaftsCancelWhatTheCounterweightsLeave) {
    Input input = irregular();
    input.end_webs = EndWebs{0.25, -0.19, 0.05, 0.07, 0.6, true};
    input.shafts = all_four(1);
    const Result result = solve(input);
    EXPECT_LT(result.remaining.order(1).force.max(), 1e-10 * result.exact.order(1).force.max());
    EXPECT_LT(result.remaining.order(1).moment.max(), 1e-10 * result.exact.order(1).moment.max());
    for (std::size_t i = 0; i < result.curves.crank_angle.size(); i += 17) {
        const test::Wrench sum =
            test::sum_of_orders(result.remaining, result.curves.crank_angle[i]);
        EXPECT_NEAR(result.remaining_curves.force_x[i], sum.force.real(),
                    1e-6 * result.engine.force_unit());
        EXPECT_NEAR(result.remaining_curves.moment_y[i], sum.moment.imag(),
                    1e-6 * result.engine.force_unit());
    }
}

}  // namespace
}  // namespace ravnoves::inertia_moments
