#include "inertia-moments/layouts.h"

#include <gtest/gtest.h>

#include "engines.h"
#include "inertia-moments/presets.h"

namespace ravnoves::inertia_moments {
namespace {

using test::unit_engine;

constexpr double lambda = 0.25;

// Units m R ω² and spacing a; two-term orders, as textbooks print them.
TEST(KnownLayouts, HaveTheOrdersOfTheTextbooks) {
    const auto vertical = [](const RotatingPair& p) { return amplitude(p.vertical()); };
    const auto horizontal = [](const RotatingPair& p) { return amplitude(p.horizontal()); };
    const auto forward = [](const RotatingPair& p) { return std::abs(p.forward); };
    const auto backward = [](const RotatingPair& p) { return std::abs(p.backward); };
    const auto both = [](const RotatingPair& p) { return std::abs(p.forward * p.backward); };
    const auto all = [](const RotatingPair& p) { return p.max(); };
    constexpr auto force = &EngineOrder::force;
    constexpr auto moment = &EngineOrder::moment;
    const struct {
        const char* layout;
        int order;
        RotatingPair EngineOrder::*what;
        double (*part)(const RotatingPair&);
        double expected;
        double tolerance = 1e-13;
    } known[] = {
        {"i3", 1, moment, vertical, std::sqrt(3.0)},
        {"i3", 1, force, all, 0.0, 1e-14},
        {"i3", 2, force, all, 0.0, 1e-14},
        {"i4", 2, force, vertical, 4.0 * lambda},
        {"i4", 1, force, all, 0.0, 1e-14},
        {"i4", 1, moment, all, 0.0, 1e-14},
        {"i4", 2, moment, all, 0.0},
        {"i6", 1, force, all, 0.0},
        {"i6", 1, moment, all, 0.0},
        {"i6", 2, force, all, 0.0},
        {"i6", 2, moment, all, 0.0},
        {"i5", 1, moment, vertical, 0.449, 5e-4},
        {"i5", 2, moment, vertical, 4.980 * lambda, 5e-4},
        {"i5", 1, force, all, 0.0, 1e-14},
        {"v8-cross-plane", 1, moment, forward, std::sqrt(10.0)},
        {"v8-cross-plane", 1, moment, backward, 0.0},
        {"v8-cross-plane", 1, force, all, 0.0},
        {"v8-cross-plane", 2, force, all, 0.0},
        {"v8-cross-plane", 2, moment, all, 0.0},
        {"v8-flat-plane", 2, force, horizontal, 4.0 * std::sqrt(2.0) * lambda},
        {"v8-flat-plane", 2, force, vertical, 0.0},
        {"v8-flat-plane", 1, moment, all, 0.0},
        {"v2-90", 1, force, forward, 1.0, 1e-14},
        {"v2-90", 1, force, backward, 0.0, 1e-14},
        {"v2-90", 2, force, all, std::sqrt(2.0) * lambda, 1e-14},
        {"v6-60", 1, force, all, 0.0},
        {"v6-60", 1, moment, all, 1.5, 1e-12},
        {"v6-60", 1, moment, both, 0.0, 1e-12},
    };
    for (const auto& [layout, order, what, part, expected, tolerance] : known) {
        const Result result = solve(unit_engine(layout, lambda));
        EXPECT_NEAR(part(result.two_term.order(order).*what), expected, tolerance)
            << layout << ", order " << order;
    }
}

TEST(KnownLayouts, CounterweightsAloneCancelTheMomentOfACrossPlaneV8) {
    Input input = unit_engine("v8-cross-plane", lambda);
    input.rotating_mass = 0.8;
    input.end_webs = EndWebs{2.0, -2.0, 0.5, 0.5, 1.0, true};
    const Result result = solve(input);
    EXPECT_NEAR(result.remaining.order(1).force.max(), 0.0, 1e-12);
    EXPECT_NEAR(result.remaining.order(1).moment.max(), 0.0, 1e-12);
    // Exact and two-term agree in order 1 of a centred engine, so the exact design does too.
    EXPECT_NEAR(std::abs(result.counterweights->against_moment) * 4.0,
                std::abs(result.rotating.moment() * 1.0) + std::sqrt(10.0), 1e-9);
}

TEST(KnownLayouts, SplitPinsOfAV6AreApartByTheBankAngleFrom120) {
    // 60° between the two pins of a throw, 30° in the 90° engine.
    for (const auto& [layout, apart] : {std::pair("v6-60", 60.0), std::pair("v6-90", 30.0)}) {
        EXPECT_NEAR(solve(unit_engine(layout)).engine.cylinders[1].crankpin_angle,
                    two_pi - apart * degree, 1e-12);
    }
}

TEST(KnownLayouts, OpposedPistonsCancelAllForces) {
    for (const char* name : {"flat-2", "flat-4", "flat-6"}) {
        Input input = unit_engine(name, lambda);
        input.layout->stagger = 0.5;
        const Result result = solve(input);
        for (const EngineOrder& order : result.exact.orders) {
            EXPECT_NEAR(order.force.max(), 0.0, 1e-13) << name << " order " << order.order;
        }
        // The stagger leaves a couple, but for the boxer six in orders 1 and 2.
        const double moment_1 = result.exact.order(1).moment.max();
        if (std::string(name) == "flat-2") {
            EXPECT_NEAR(moment_1, 0.5, 1e-13);
        } else {
            EXPECT_NEAR(moment_1, 0.0, 1e-13);
        }
    }
}

TEST(LayoutLibrary, EveryLayoutSolvesAndFiresOnceACycle) {
    for (const LayoutSpec& spec : layout_library()) {
        const Result result = solve(test::engine_of(spec.name));
        ASSERT_EQ(result.engine.cylinders.size(), static_cast<std::size_t>(spec.cylinders));
        ASSERT_EQ(result.firing.size(), static_cast<std::size_t>(spec.cylinders)) << spec.name;
        double sum = 0.0;
        for (const FiringEvent& event : result.firing) {
            EXPECT_GT(event.interval, 0.0);
            sum += event.interval;
            if (spec.pins_deg.empty()) {
                EXPECT_NEAR(event.interval, 2.0 * two_pi / spec.cylinders, 1e-12) << spec.name;
            }
        }
        EXPECT_NEAR(sum, 2.0 * two_pi, 1e-11) << spec.name;
        EXPECT_EQ(find_layout(spec.name), &spec);
    }
    EXPECT_EQ(find_layout("i7"), nullptr);
}

// Each throw of the W12 carries a cylinder of either block, its two pins 72° − 60° apart.
TEST(LayoutLibrary, WhatStoodAtItsUsualPlaceFollowsTheSpacing) {
    Input before = unit_engine("i4", lambda);
    before.layout = usual_layout(*find_layout("i4"), before.crank_radius);
    const auto cylinders = [](const Input& input) { return make_cylinders(input); };
    before.end_webs = usual_end_webs(cylinders(before), before.crank_radius);
    before.shafts = usual_shafts(cylinders(before), before.crank_radius);
    Input after = before;
    after.layout->spacing *= 1.25;
    follow_sizes(after, before);
    EXPECT_NEAR(cylinders(after).front().axial_position, 1.5 * after.layout->spacing, 1e-12);
    EXPECT_EQ(*after.end_webs, usual_end_webs(cylinders(after), after.crank_radius));
    EXPECT_EQ(after.shafts, usual_shafts(cylinders(after), after.crank_radius));
    // The second order is a force alone, whatever the spacing.
    EXPECT_NEAR(solve(after).two_term.order(2).moment.max(), 0.0, 1e-12);
    Input wider = after;
    wider.crank_radius *= 1.1;
    follow_sizes(wider, after);
    EXPECT_EQ(wider.end_webs->front_position,
              usual_end_webs(cylinders(wider), wider.crank_radius).front_position);
    // What was put elsewhere stays there.
    before.layout->first_position = cylinders(before).front().axial_position + 0.01;
    before.end_webs->front_position += 0.01;
    before.shafts[0].weight_distance += 0.01;
    after = before;
    after.layout->spacing *= 1.25;
    follow_sizes(after, before);
    EXPECT_EQ(after.layout->first_position, before.layout->first_position);
    EXPECT_EQ(after.end_webs->front_position, before.end_webs->front_position);
    EXPECT_EQ(after.shafts[0].weight_distance, before.shafts[0].weight_distance);
}

TEST(LayoutLibrary, W12HasSixThrowsWithSplitPins) {
    const Result result = solve(unit_engine("w12"));
    const auto& cylinders = result.engine.cylinders;
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(cylinders[i].axial_position, cylinders[i + 6].axial_position);
        EXPECT_NEAR(
            wrap_turn(cylinders[i + 6].crankpin_angle - cylinders[i].crankpin_angle) / degree, 12.0,
            1e-9);
        EXPECT_NEAR(std::abs(cylinders[i].bank_angle - cylinders[i + 6].bank_angle) / degree, 72.0,
                    1e-9);
    }
}

TEST(EvenFiring, PistonsAreAtTopDeadCentreAtEvenIntervals) {
    for (const double gamma : {0.0, 10.6, 15.0, 72.0}) {
        for (const double k : {0.0, 0.278, 0.6}) {
            Input input = test::vr5();
            input.layout->bank_angle = gamma * degree;
            input.layout->offset = k * input.crank_radius;
            input.layout->cylinders = 6;
            input.layout->firing_order = {1, 5, 3, 6, 2, 4};
            test::expect_fires_evenly_at_the_top(input);
        }
    }
}

TEST(EvenFiring, TheOrderMayBeginWithAnyCylinder) {
    Input input = test::vr5();
    const auto pins = make_engine(input).cylinders;
    input.layout->firing_order = {4, 5, 3, 1, 2};
    const auto same = make_engine(input).cylinders;
    for (std::size_t i = 0; i < pins.size(); ++i) {
        EXPECT_NEAR(pins[i].crankpin_angle, same[i].crankpin_angle, 1e-12);
    }
}

TEST(FiringEvents, TwinsOnACommonPinFireUnevenly) {
    const Result result = solve(unit_engine("v2-45"));
    ASSERT_EQ(result.firing.size(), 2U);
    EXPECT_NEAR(result.firing[0].interval / degree, 315.0, 1e-9);
    EXPECT_NEAR(result.firing[1].interval / degree, 405.0, 1e-9);
}

}  // namespace
}  // namespace ravnoves::inertia_moments
