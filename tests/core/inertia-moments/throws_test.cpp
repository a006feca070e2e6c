// What a throw carries, radials, and the cycle of two strokes.
#include "inertia-moments/rods.h"

#include <gtest/gtest.h>

#include <map>

#include "case-file/json.h"
#include "case-file/result_json.h"
#include "engines.h"
#include "inertia-moments/input.h"

namespace ravnoves::inertia_moments {
namespace {

using test::engine_of;

constexpr double two_stroke = two_pi;

/// A radial: all cylinders in one plane on one pin.
Input radial(int count) {
    Input input = engine_of("i1");
    input.layout.reset();
    for (int i = 0; i < count; ++i) {
        input.cylinders.push_back({0.0, two_pi * i / count, 0.0, 0.0});
    }
    return input;
}

TEST(Throws, RodsThatShareAPinAreOneThrow) {
    const std::map<std::string_view, std::size_t> rods{
        {"i1", 1},     {"i2-180", 1}, {"i2-360", 1}, {"i4", 1},
        {"i6", 1},     {"v2-45", 2},  {"v2-90", 2},  {"v8-cross-plane", 2},
        {"flat-2", 1}, {"flat-4", 1}, {"v6-60", 1},  {"v8-flat-plane", 2},
        {"vr5", 1},    {"vr6", 1},    {"w12", 1}};
    for (const auto& [name, expected] : rods) {
        const Engine engine = make_engine(engine_of(name));
        EXPECT_EQ(kinds_of_throw(engine.throws).size(), 1U) << name;
        EXPECT_EQ(engine.throws.front().cylinders.size(), expected) << name;
        EXPECT_EQ(engine.throws.size() * expected, engine.cylinders.size()) << name;
    }
    // Side by side on the pin, the throw lies between its rods.
    Input v8 = engine_of("v8-cross-plane");
    v8.layout->stagger = 0.024;
    const Engine engine = make_engine(v8);
    ASSERT_EQ(engine.throws.size(), 4U);
    EXPECT_EQ(engine.throws[1].cylinders, (std::vector<std::size_t>{2, 3}));
    EXPECT_NEAR(engine.throws[1].position,
                0.5 * (engine.cylinders[2].axial_position + engine.cylinders[3].axial_position),
                1e-15);
}

// The counterweights follow from the pins alone: so many kilograms at R on each.
TEST(Throws, AreOfOneKindWhereTheyCarryAsManyRods) {
    const std::vector<Throw> throws{
        {{0, 1}, 0.0, 0.0}, {{2}, 0.1, 1.0}, {{3, 4}, 0.2, 2.0}, {{5}, 0.3, 3.0}};
    const std::map<std::size_t, const Throw*> expected{{1, &throws[1]}, {2, &throws[0]}};
    EXPECT_EQ(kinds_of_throw(throws), expected) << "the first of each, the fewest rods first";
    EXPECT_TRUE(kinds_of_throw({}).empty());
}

TEST(Throws, CounterweightsAreThoseOfTheMassOnEachPin) {
    Input input = engine_of("v8-cross-plane");
    input.rotating_mass = 1.6;
    input.rotating_mass_of_throw = true;
    input.end_webs = EndWebs{0.25, -0.25, 0.05, 0.05, 0.0, true};
    const Result result = solve(input);
    for (const Throw& pin : result.engine.throws) {
        EXPECT_DOUBLE_EQ(result.engine.mass_on(pin), 1.6);
    }
    // Half of it for each of the two cylinders is the same engine.
    Input each = input;
    each.rotating_mass = 0.8;
    each.rotating_mass_of_throw = false;
    EXPECT_DOUBLE_EQ(solve(each).counterweights->front.mass(), result.counterweights->front.mass());
    // Taken for that of one throw, the mass of one cylinder would make them half as heavy.
    each.rotating_mass = 1.6;
    EXPECT_DOUBLE_EQ(solve(each).counterweights->front.mass(),
                     2.0 * result.counterweights->front.mass());
}

TEST(Throws, ARigidRodAddsItsShareForEachRodOnThePin) {
    Input input = engine_of("v8-cross-plane");
    input.rotating_mass = 1.0;
    input.rotating_mass_of_throw = true;
    const double length = input.rod_length();
    input.rod = RigidRod{0.6, 0.25 * length, 0.002};
    const Engine engine = make_engine(input);
    EXPECT_NEAR(engine.mass_on(engine.throws[0]), 1.0 + 2 * 0.6 * 0.75, 1e-15);
}

TEST(Throws, AMassForEachThrowNeedsThrowsThatAreAlike) {
    Input input = engine_of("v2-60");
    input.layout.reset();
    // Two on one pin, a third alone.
    input.cylinders = {{0.05, 0.5, 0.0, 0.0}, {0.03, -0.5, 0.0, 0.0}, {-0.06, 0.5, 0.0, 2.0}};
    Json json = write_input(input);
    const Json solved = result_json({}, read_input(json));
    ASSERT_EQ(solved.at("throws").size(), 2U);
    EXPECT_EQ(solved.at("throws").at(0).at("cylinders"), Json({1, 2}));
    EXPECT_DOUBLE_EQ(solved.at("throws").at(0).at("rotating_mass_kg").get<double>(), 1.6);
    EXPECT_DOUBLE_EQ(solved.at("throws").at(1).at("rotating_mass_kg").get<double>(), 0.8);
    json["rotating_mass_per_throw_kg"] = 1.2;
    EXPECT_EQ(test::rejection_of(json),
              "/input/rotating_mass_per_throw_kg: must be left out if rotating_mass_kg is given");
    json.erase("rotating_mass_kg");
    EXPECT_EQ(
        test::rejection_of(json),
        "/input/rotating_mass_per_throw_kg: must be given for one cylinder (rotating_mass_kg) if "
        "the throws carry different numbers of rods, got throws with 1 and with 2 rods");
    json["cylinders"].erase(2);
    EXPECT_EQ(test::rejection_of(json), "no error");
    // In any order of the keys.
    EXPECT_EQ(nlohmann::json(write_input(read_input(json))), nlohmann::json(json));
}

TEST(Radials, AreSaidToHavePlainRods) {
    EXPECT_TRUE(solve(radial(2)).notes.empty());  // fork and blade
    for (const int count : {3, 5, 9}) {
        const Result result = solve(radial(count));
        ASSERT_EQ(result.notes.size(), 1U) << count;
        EXPECT_NE(result.notes[0].english().find("plain rods"), std::string::npos);
    }
    EXPECT_TRUE(solve(engine_of("v8-cross-plane")).notes.empty());
    // Three rods side by side are plain ones.
    Input arrow = radial(3);
    for (std::size_t i = 0; i < 3; ++i) {
        arrow.cylinders[i].axial_position = -0.025 * static_cast<double>(i);
    }
    EXPECT_TRUE(solve(arrow).notes.empty());
    EXPECT_EQ(solve(arrow).engine.throws.size(), 1U);
    const Json json = result_json({}, read_input(write_input(radial(5))));
    EXPECT_EQ(json.at("notes").size(), 1U);
    EXPECT_EQ(json.at("throws").size(), 1U);
}

TEST(TwoStrokes, PistonsAreAtTopDeadCentreAtEvenIntervalsOfOneTurn) {
    for (const char* name : {"i3", "i4", "i5", "i6", "vr5", "vr6", "v6-60", "flat-6"}) {
        SCOPED_TRACE(name);
        Input input = engine_of(name);
        input.strokes = 2;
        test::expect_fires_evenly_at_the_top(input);
        EXPECT_EQ(result_json({}, read_input(write_input(input))).at("firing_cycle_deg"), 360.0);
    }
}

// A two-stroke in-line four has its pins at 90° and no second order, but a moment of the first.
TEST(TwoStrokes, InlineFourHasNoSecondOrderForce) {
    Input input = test::unit_engine("i4");
    input.strokes = 2;
    const Result result = solve(input);
    EXPECT_NEAR(result.exact.order(1).force.max(), 0.0, 1e-13);
    EXPECT_NEAR(result.exact.order(2).force.max(), 0.0, 1e-13);
    EXPECT_GT(result.exact.order(1).moment.max(), 1.0);
    input.strokes = 4;
    EXPECT_NEAR(solve(input).two_term.order(2).force.max(), 4.0 * 0.25, 1e-13);
}

TEST(TwoStrokes, FireWhenTheyComeToTheTop) {
    Input input = engine_of("flat-2");
    input.strokes = 2;
    Result result = solve(input);
    ASSERT_EQ(result.firing.size(), 2U);
    EXPECT_NEAR(result.firing[0].interval, 0.0, 1e-12);  // both at once
    EXPECT_NEAR(result.firing[1].interval, two_stroke, 1e-12);
    EXPECT_FALSE(fires_evenly(result.firing));
    result = solve([] {
        Input single = engine_of("i1");
        single.strokes = 2;
        return single;
    }());
    ASSERT_EQ(result.firing.size(), 1U);
    EXPECT_NEAR(result.firing[0].interval, two_stroke, 1e-12);
    EXPECT_TRUE(fires_evenly(result.firing));
    // The order of a four-stroke needs two turns; the crank's own is said.
    input = engine_of("v8-cross-plane");
    input.strokes = 2;
    result = solve(input);
    EXPECT_TRUE(result.firing.empty());
    const std::string why = result.firing_trouble.english();
    EXPECT_NE(why.find("one turn"), std::string::npos) << why;
    const std::vector<int> own = dead_centre_order(result.engine);
    input.layout->firing_order = own;
    result = solve(input);
    EXPECT_EQ(result.firing.size(), 8U) << why;
    EXPECT_TRUE(result.firing_trouble.empty());
    // Without an order it is the crank's.
    Input table = input;
    table.cylinders = result.engine.cylinders;
    table.layout.reset();
    ASSERT_EQ(solve(table).firing.size(), 8U);
    EXPECT_EQ(solve(table).firing[3].cylinder, own[3]);
    table.strokes = 4;
    EXPECT_TRUE(solve(table).firing.empty());
}

}  // namespace
}  // namespace ravnoves::inertia_moments
