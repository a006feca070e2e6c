// One engine in cases of several scenes.

#include "scenes/shared_engine.h"

#include <gtest/gtest.h>

#include <array>
#include <utility>

#include "case-file/json.h"
#include "numerics/units.h"
#include "scenes/scenes.h"

namespace ravnoves {
namespace {

const SharedEngine engine{.bore = 0.088,
                          .crank_radius = 0.0375,
                          .rod_length = 0.132,
                          .offset = 0.002,
                          .speed = 366.5,
                          .reciprocating_mass = 0.52,
                          .rotating_mass = 0.31};

TEST(SharedEngine, IsTheSameInEveryCaseThatHasAPlaceForIt) {
    int taken = 0;
    for (const SceneSolver& solver : scene_solvers()) {
        for (const auto& [title, preset] : solver.presets()) {
            SCOPED_TRACE(std::string(solver.name));
            Json input = preset;
            const SharedEngine before = engine_of(solver.name, input);
            const std::vector<Text> changed = give_engine(engine, solver.name, input).changed;
            if (before == SharedEngine()) {
                EXPECT_TRUE(changed.empty());
                EXPECT_EQ(input, preset);
                continue;
            }
            ++taken;
            EXPECT_FALSE(changed.empty());
            const SharedEngine now = engine_of(solver.name, input);
            for (const auto what :
                 {&SharedEngine::bore, &SharedEngine::crank_radius, &SharedEngine::rod_length,
                  &SharedEngine::offset, &SharedEngine::speed, &SharedEngine::reciprocating_mass,
                  &SharedEngine::rotating_mass}) {
                if (what == &SharedEngine::rotating_mass && solver.name != "inertia-moments") {
                    continue;  // there it follows from the masses
                }
                if (now.*what) {
                    EXPECT_NEAR(*(now.*what), *(engine.*what), 1e-11 * *(engine.*what));
                }
                EXPECT_TRUE(now.*what || !(before.*what));
            }
            EXPECT_TRUE(now.crank_radius && now.rod_length && now.speed);
            EXPECT_NO_THROW(solver.solve(input, {}, {}));
            // Given once more, nothing changes; its own engine gives back nothing else.
            const Json once = input;
            EXPECT_TRUE(give_engine(engine, solver.name, input).changed.empty());
            EXPECT_EQ(input, once);
            Json own = preset;
            EXPECT_TRUE(give_engine(before, solver.name, own).changed.empty());
            EXPECT_EQ(own, preset);
        }
    }
    EXPECT_GE(taken, 3);
}

TEST(SharedEngine, KeepsTheRodWhereAnotherGivesNone) {
    Json input{{"crank_radius_mm", 50.0}, {"lambda", 0.25}, {"angular_speed_rad_s", 100.0}};
    const std::vector<Text> changed =
        give_engine({.crank_radius = 0.04, .rod_length = 0.2}, "elastic-hinge", input).changed;
    EXPECT_EQ(input["crank_radius_mm"], 40.0);
    EXPECT_EQ(input["lambda"], 0.2);
    ASSERT_EQ(changed.size(), 1U) << "the rod is as long as before";
    EXPECT_STREQ(changed[0].english, "crank radius");
    EXPECT_EQ(input["angular_speed_rad_s"], 100.0);
}

/// λ has as many digits as the rod length needs, and gives it back.
TEST(SharedEngine, ARatioHasNoMoreDigitsThanTheRod) {
    for (const auto& [radius, rod, ratio] :
         {std::array{37.5, 132.0, 0.284091}, std::array{50.0, 500.0 / 3.0, 0.3},
          std::array{46.0, 150.0, 0.306667}, std::array{1.0, 1.00001, 0.99999}}) {
        Json hinge{{"crank_radius_mm", 80.0}, {"lambda", 0.5}};
        give_engine({.crank_radius = radius * units::mm, .rod_length = rod * units::mm},
                    "elastic-hinge", hinge);
        EXPECT_EQ(hinge["lambda"], ratio);
        Json shaft{{"crank_radius_mm", 80.0}};
        give_engine(engine_of("elastic-hinge", hinge), "balance-shaft", shaft);
        EXPECT_NEAR(shaft["cylinder"]["rod_length_mm"].get<double>(), rod, 5e-6 * rod);
    }
}

/// A master rod's mass with its knuckles is no mass of one cylinder: both keep theirs and say so.
TEST(SharedEngine, ARadialEngineKeepsTheMassOfItsMasterRod) {
    const Json in_line{{"crank_radius_mm", 37.5}, {"rotating_mass_kg", 0.25}};
    Json radial = in_line;
    radial["rotating_mass_kg"] = 1.6;
    radial["cylinders"] = {{{"articulated", {{"knuckle_mass_kg", 0.8}}}}};
    for (const auto& [from, to] : {std::pair(in_line, radial), std::pair(radial, in_line)}) {
        Json input = to;
        const GivenEngine given =
            give_engine(engine_of("inertia-moments", from), "inertia-moments", input);
        EXPECT_EQ(input, to);
        ASSERT_EQ(given.kept.size(), 1U);
        EXPECT_STREQ(given.kept[0].english, "rotating mass");
    }
}

/// The paper's engine: the rod less its small end rotates, in place of what a new case assumes.
TEST(SharedEngine, TheRotatingPartOfTheRodReplacesAnother) {
    const Json shaft{{"crank_radius_mm", 37.5},
                     {"reciprocating_masses_kg", {{"piston", 0.4}, {"rod_small_end", 0.13}}},
                     {"rod_mass_kg", 0.38}};
    Json input{{"crank_radius_mm", 40.0}, {"rotating_mass_kg", 0.5}, {"speed_rpm", 3000.0}};
    const GivenEngine given =
        give_engine(engine_of("balance-shaft", shaft), "inertia-moments", input);
    EXPECT_EQ(input["rotating_mass_kg"], 0.25);
    ASSERT_EQ(given.kept.size(), 1U);
    EXPECT_STREQ(given.kept[0].english, "speed");
}

}  // namespace
}  // namespace ravnoves
