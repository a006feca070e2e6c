#pragma once

#include <gtest/gtest.h>

#include "case-file/result_json.h"
#include "error_of.h"
#include "inertia-moments/input.h"
#include "inertia-moments/layouts.h"
#include "inertia-moments/result.h"
#include "inertia-moments/results.h"

namespace ravnoves::inertia_moments::test {

/// The paper's engine, with K = 0.278 as printed.
inline Input vr5() {
    Input input;
    input.crank_radius = 0.045;
    input.lambda = 0.265;
    input.angular_speed = 6200.0 * units::rpm;
    input.reciprocating_mass = 0.622;
    input.rotating_mass = 0.8;
    Layout layout;
    layout.name = "vr";
    layout.cylinders = 5;
    layout.bank_angle = 15.0 * degree;
    layout.offset = 0.278 * 0.045;
    layout.spacing = 0.063;
    layout.first_position = 3 * 0.063 + 0.0158;
    layout.firing_order = {1, 2, 4, 5, 3};
    input.layout = layout;
    return input;
}

/// A library layout with m_j R ω² = 1 N, R = 1 m and the spacing 1 m: results come out in the
/// units in which textbooks print them.
inline Input unit_engine(std::string_view name, double lambda = 0.25) {
    Input input;
    input.crank_radius = 1.0;
    input.lambda = lambda;
    input.angular_speed = 1.0;
    input.reciprocating_mass = 1.0;
    Layout layout = usual_layout(*find_layout(name), 1.0);
    *layout.first_position *= 1.0 / layout.spacing;
    layout.spacing = 1.0;
    layout.stagger = 0.0;
    input.layout = layout;
    return input;
}

/// A library layout of an engine as large as a car's.
inline Input engine_of(std::string_view layout) {
    Input input;
    input.crank_radius = 0.045;
    input.lambda = 0.28;
    input.angular_speed = 300.0;
    input.reciprocating_mass = 0.5;
    input.rotating_mass = 0.8;
    input.layout = usual_layout(*find_layout(layout), input.crank_radius);
    return input;
}

/// An irregular engine: no symmetry hides a mistake.
inline Input irregular() {
    Input input;
    input.crank_radius = 0.05;
    input.lambda = 0.31;
    input.angular_speed = 300.0;
    input.reciprocating_mass = 0.7;
    input.rotating_mass = 0.9;
    input.reference_position = 0.031;
    input.cylinders = {{0.20, 0.3, 0.012, 0.0},
                       {0.11, -0.7, -0.02, 2.1},
                       {0.02, 1.9, 0.0, 4.4},
                       {-0.13, 0.1, 0.03, 5.0}};
    return input;
}

/// A table on one crankpin: no symmetry hides a mistake, every value of the rods is given.
inline Input irregular_star() {
    Input input;
    input.crank_radius = 0.08;
    input.lambda = 0.27;
    input.angular_speed = 220.0;
    input.reciprocating_mass = 1.4;
    input.rotating_mass = 1.0;
    input.reference_position = 0.013;
    input.cylinders = {{0.02, 0.4, 0.006, 0.0},     {0.02, 0.4 + 1.3, -0.009, 0.0},
                       {0.01, 0.4 - 1.1, 0.0, 0.0}, {0.03, 0.4 + 2.9, 0.011, 0.0},
                       {-0.2, 0.9, 0.004, 2.2},     {-0.2, -0.3, 0.002, 2.2}};
    input.cylinders[0].articulated = ArticulatedRod{0.055, 1.2, 0.22, 3, 0.3};
    input.cylinders[1].articulated = ArticulatedRod{0.06, {}, {}, 3, 0.0};
    input.cylinders[3].articulated = ArticulatedRod{0.05, 2.2, 0.26, 0, 0.45};
    input.cylinders[5].articulated = ArticulatedRod{0.04, {}, {}, 0, 0.2};
    return input;
}

/// Forces and moments at one instant, N and N·m.
struct Wrench {
    Complex force, moment;
    double inertia_roll = 0.0;
    double reaction_torque = 0.0;
    double roll() const { return inertia_roll + reaction_torque; }
};

inline Wrench first_of(const WrenchCurves& curves) {
    return {{curves.force_x[0], curves.force_y[0]},
            {curves.moment_x[0], curves.moment_y[0]},
            curves.inertia_roll[0],
            curves.reaction_torque[0]};
}

inline Wrench exact_wrench(const Engine& engine, double crank_angle) {
    return first_of(exact_curves(engine, {crank_angle}));
}

inline Wrench sum_of_orders(const EngineOrders& orders, double crank_angle) {
    return first_of(with_orders(WrenchCurves({crank_angle}), orders));
}

/// Forces, moments and the reaction of one are those of the other.
inline void expect_near(const Wrench& found, const Wrench& expected, double tolerance) {
    EXPECT_NEAR(std::abs(found.force - expected.force), 0.0, tolerance);
    EXPECT_NEAR(std::abs(found.moment - expected.moment), 0.0, tolerance);
    EXPECT_NEAR(found.inertia_roll, expected.inertia_roll, tolerance);
    EXPECT_NEAR(found.reaction_torque, expected.reaction_torque, tolerance);
}

/// At its firing angle each piston stands at top dead centre, at even intervals of the cycle: the
/// definition, not the formula.
inline void expect_fires_evenly_at_the_top(const Input& input) {
    const Result result = solve(input);
    const auto count = result.engine.cylinders.size();
    ASSERT_EQ(result.firing.size(), count);
    EXPECT_TRUE(fires_evenly(result.firing));
    const double interval = input.cycle() / static_cast<double>(count);
    const double first = result.engine.mechanism(result.engine.cylinders[0]).top_dead_centre();
    for (std::size_t n = 0; n < count; ++n) {
        EXPECT_NEAR(result.firing[n].interval, interval, 1e-9);
        const auto index = static_cast<std::size_t>(result.firing[n].cylinder) - 1;
        const Cylinder& cylinder = result.engine.cylinders[index];
        const auto motion = result.engine.mechanism(cylinder).at(
            first + interval * static_cast<double>(n) + result.engine.crank_phase(cylinder));
        EXPECT_NEAR(motion.ds, 0.0, 1e-13);
        EXPECT_LT(motion.d2s, 0.0);  // top, not bottom
    }
}

inline std::string rejection_of(const Json& json) {
    return ravnoves::test::error_of([&] { result_json({}, read_input(json)); });
}

}  // namespace ravnoves::inertia_moments::test
