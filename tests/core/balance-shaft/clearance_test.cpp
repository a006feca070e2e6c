#include "balance-shaft/clearance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "balance-shaft/position_study.h"
#include "balance-shaft/shaft_places.h"
#include "balance-shaft/speed_study.h"
#include "case-file/json.h"
#include "test_cases.h"

namespace ravnoves::balance_shaft {
namespace {

// As fields say them, and the help from these.
TEST(FrontView, SizesThatAreNotGivenAreThoseThatTheFieldsName) {
    Input input = test::diesel();
    input.cylinder.bore = 0.080;
    FrontView view = front_view(input);
    EXPECT_EQ(view.cylinder_bore, 0.080);
    EXPECT_NEAR(view.cylinder_top, 0.046 + 0.150 + 0.040, 1e-15);
    EXPECT_NEAR(view.cylinder_bottom, 0.150 - 0.046 - 0.3 * 0.080, 1e-15);
    EXPECT_NEAR(view.cylinder_wall, 0.06 * 0.080, 1e-15);
    EXPECT_EQ(view.rod_width, 0.023);
    const double half_disc = std::cbrt(1.5 * 0.658 * 0.046 / (7850.0 * 0.080));
    EXPECT_NEAR(view.shaft_swing_radius, half_disc, 1e-12);
    EXPECT_NEAR(view.crank_swing_radius, 0.046 + 0.0115, 1e-15);
    EXPECT_EQ(view.gear_tip_radius, input.centre_distance / 2.0);
    EXPECT_EQ(view.clearance, 0.002);
    EXPECT_EQ(view.wall, 0.0);
    input.counterweight_mass = 5.0;
    view = front_view(input);
    EXPECT_EQ(view.crank_swing_radius, view.shaft_swing_radius);
    input.cylinder.bore.reset();
    EXPECT_EQ(front_view(input).cylinder_bore, 0.092);
}

using test::diesel;

TEST(Clearance, IsThatOfCrankCylinderAndRod) {
    for (const double offset : {0.0, 0.012, -0.012}) {
        Input input = diesel();
        input.cylinder.offset = offset;
        const FrontView view = front_view(input);
        const double swing = view.shaft_swing_radius;
        const double half = view.cylinder_bore / 2.0 + view.cylinder_wall;
        const Eigen::AlignedBox2d cylinder(Eigen::Vector2d(offset - half, view.cylinder_bottom),
                                           Eigen::Vector2d(offset + half, view.cylinder_top));
        for (const double alpha : {0.1, 0.6, 1.0, 1.3, 2.0, 3.0, 4.4, 5.2, 5.7}) {
            const Eigen::Vector2d place =
                view.centre_distance * Eigen::Vector2d(std::sin(alpha), std::cos(alpha));
            const ShaftClearance found = shaft_clearance(view, alpha);
            EXPECT_NEAR(found.crank, view.centre_distance - view.crank_swing_radius - swing, 1e-15);
            EXPECT_NEAR(found.rod + view.rod_width / 2.0 + swing,
                        RodSweep(view).nearer_than(place, 1e3)->distance, 1e-12);
            if (const double outside = cylinder.exteriorDistance(place); outside > 0.0) {
                EXPECT_NEAR(found.cylinder + swing, outside, 1e-12) << alpha;
            } else {
                EXPECT_LE(found.cylinder, -swing) << alpha;
            }
        }
    }
}

double minimum_clearance(const FrontView& view, double alpha) {
    const ShaftClearance free = shaft_clearance(view, alpha);
    return std::min({free.crank, free.cylinder, free.rod});
}

std::vector<Input> placed_engines() {
    std::vector<Input> inputs{preset_tmz_650d(), diesel(), diesel(), diesel(), diesel()};
    inputs[2].cylinder.offset = 0.01;
    inputs[3].centre_distance = 0.22;  // the shaft may stand beside the cylinder
    inputs[4].centre_distance = 0.3;   // and above it
    return inputs;
}

TEST(BuildableAngles, AreThoseWithEnoughClearance) {
    for (const Input& input : placed_engines()) {
        const FrontView view = front_view(input);
        const BuildableAngles buildable = buildable_angles(view);
        ASSERT_FALSE(buildable.stretches.empty()) << buildable.reason.english();
        EXPECT_TRUE(buildable.reason.empty());
        for (double angle = 0.0; angle < 360.0; angle += 0.5) {
            const double minimum = minimum_clearance(view, angle * degree);
            if (std::abs(minimum - view.clearance) > 1e-9) {
                EXPECT_EQ(buildable.contains(angle * degree), minimum >= view.clearance) << angle;
                EXPECT_EQ(buildable.contains((angle - 360.0) * degree), minimum >= view.clearance);
            }
        }
        for (const AngleStretch& stretch : buildable.stretches) {
            if (stretch == AngleStretch{}) {
                continue;
            }
            for (const double end : {stretch.from, stretch.to}) {
                EXPECT_NEAR(minimum_clearance(view, end), view.clearance, 1e-10);
                EXPECT_TRUE(buildable.contains(end));
            }
        }
    }
    // A long arm carries the shaft round the whole engine.
    Input far = diesel();
    far.centre_distance = 0.5;
    const BuildableAngles all = buildable_angles(front_view(far));
    ASSERT_EQ(all.stretches.size(), 1U);
    EXPECT_EQ(all.stretches[0], AngleStretch{});
}

TEST(BuildableAngles, TheBestOfThemIsThatOfADenseSearch) {
    for (const Input& input : placed_engines()) {
        const Solver solver(input);
        const Result result = solver.result();
        ASSERT_TRUE(result.best_range_buildable.shaft_angle);
        double range = 1e300;
        double rms = 1e300;
        for (const AngleStretch& stretch : result.buildable.stretches) {
            for (int i = 0; i <= 4000; ++i) {
                const double alpha = stretch.from + (stretch.to - stretch.from) * i / 4000;
                range = std::min(range, solver.range(alpha));
                rms = std::min(rms, solver.rms(alpha));
            }
        }
        EXPECT_LE(result.best_range_buildable.value, range + 1e-9);
        EXPECT_NEAR(result.best_range_buildable.value, range, 0.5);
        EXPECT_LE(result.best_rms_buildable.value, rms + 1e-9);
        EXPECT_NEAR(result.best_rms_buildable.value, rms, 0.5);
        EXPECT_NEAR(solver.range(*result.best_range_buildable.shaft_angle),
                    result.best_range_buildable.value, 1e-8);
        EXPECT_NEAR(solver.rms(*result.best_rms_buildable.shaft_angle),
                    result.best_rms_buildable.value, 1e-9);
        EXPECT_TRUE(result.buildable.contains(*result.best_range_buildable.shaft_angle));
        EXPECT_TRUE(result.buildable.contains(*result.best_rms_buildable.shaft_angle));
        EXPECT_GE(result.best_range_buildable.value, result.best_range.value);
        EXPECT_GE(result.best_rms_buildable.value, result.best_rms.value);
    }
}

TEST(BuildableAngles, ThePapersBestAngleIsNotOneOfThem) {
    const Solver solver(preset_tmz_650d());
    const Result result = solver.result();
    EXPECT_NEAR(*result.best_range.shaft_angle / degree, 50.65, 0.01);
    EXPECT_FALSE(result.buildable.contains(*result.best_range.shaft_angle));
    EXPECT_FALSE(result.is_buildable);  // at 45°
    const Json json = test::written(solver.input());
    const Json& built = json.at("optimum_buildable").at("range");
    EXPECT_NEAR(built.at("shaft_angle_deg").get<double>(),
                result.buildable.stretches[0].from / degree, 1e-9);
    EXPECT_GT(built.at("range_Nm").get<double>(), result.best_range.value);
    EXPECT_TRUE(json.at("notes").back().get<std::string>().starts_with(
        "Sizes not given are assumed: swing radius of the shaft 39.3 mm, swing radius of the crank "
        "57.5 mm"));
}

TEST(BuildableAngles, TheVerdictNamesWhatTheShaftMeets) {
    Input input = preset_tmz_650d();
    input.centre_distance = 0.105;
    input.envelope.cylinder_bottom = 0.12;
    input.place_limits.bottom = -0.08;
    const Solver solver(input);
    const PositionStudy study(solver);
    Result result = solver.result();
    std::map<Obstacle, int> met;
    for (int degrees = 0; degrees < 360; ++degrees) {
        const double alpha = degrees * degree;
        solver.move_shaft(alpha, result);
        const Obstacle obstacle = study.obstacle(ShaftPosition::at(input.centre_distance, alpha));
        const char* const named = obstacle == Obstacle::cylinder ? "the shaft meets the cylinder."
                                  : obstacle == Obstacle::rod    ? "the shaft meets the rod."
                                  : obstacle == Obstacle::limits ? "outside the limits."
                                                                 : "Fits";
        EXPECT_EQ(result.obstacle, obstacle) << degrees;
        EXPECT_NE(verdict(result).text.english().find(named), std::string::npos) << degrees;
        ++met[obstacle];
    }
    EXPECT_EQ(met.size(), 4U) << "each of them, and none";
}

TEST(BuildableAngles, NothingIsAnAnswerWithItsReason) {
    using Change = void (*)(Input&);
    const std::pair<const char*, Change> cases[] = {
        {"The shaft's swing circle (radius 39.2", [](Input& i) { i.centre_distance = 0.09; }},
        {"The gears do not mesh: with a tip radius of 60 mm",
         [](Input& i) { i.envelope.gear_tip_radius = 0.06; }},
        {"The gears", [](Input& i) { i.envelope.gear_tip_radius = 0.05; }},
        {"At every angle the shaft's swing circle",
         [](Input& i) {
             i.envelope.crank_swing_radius = 0.05;
             i.envelope.rod_width = 0.1;
         }},
        {"Centre distance 100.2 mm is below the minimum of 120 mm.",
         [](Input& i) { i.place_limits.centre_distance_min = 0.12; }},
        {"Centre distance 100.2 mm is above the maximum of 95 mm.",
         [](Input& i) { i.place_limits.centre_distance_max = 0.095; }},
        {"At the centre distance 100.2 mm no angle clears cylinder and rod within the limits: "
         "Minimum x -20 mm, Maximum x 20 mm, Minimum y 0 mm.",
         [](Input& i) {
             i.place_limits.left = -0.02;
             i.place_limits.right = 0.02;
             i.place_limits.bottom = 0.0;
         }},
        {"At the centre distance 100.2 mm no angle clears cylinder and rod within the limits: "
         "Minimum x 110 mm.",
         [](Input& i) { i.place_limits.left = 0.11; }},
        {"At the centre distance 100.2 mm no angle clears cylinder and rod within the limits: "
         "α from 200°, α to 250°, Minimum x 60 mm.",
         [](Input& i) {
             i.place_limits.shaft_angle_from = 200 * degree;
             i.place_limits.shaft_angle_to = 250 * degree;
             i.place_limits.left = 0.06;
         }},
        {"The limits contradict each other: Minimum x 110 mm, Maximum x 90 mm.", [](Input& i) {
             i.place_limits.left = 0.11;
             i.place_limits.right = 0.09;
         }}};
    for (const auto& [reason, change] : cases) {
        Input input = preset_tmz_650d();
        change(input);
        const Json json = test::written(input);
        EXPECT_TRUE(json.at("optimum_buildable").at("range").is_null());
        EXPECT_TRUE(json.at("optimum_buildable").at("rms").is_null());
        EXPECT_FALSE(json.at("optimum").at("range").at("shaft_angle_deg").is_null());
        EXPECT_TRUE(json.at("envelope_study").at("efficient").empty());
        EXPECT_EQ(json.at("buildable").at("at_shaft_angle"), false);
        const std::string said = json.at("optimum_buildable").at("reason").get<std::string>();
        EXPECT_TRUE(said.starts_with(reason)) << said;
    }
}

TEST(PlaceLimitsTest, LimitsThatContradictEachOtherAreNamed) {
    const std::pair<PlaceLimits, std::string> cases[] = {
        {{}, ""},
        {{.centre_distance_min = 0.1, .centre_distance_max = 0.1}, ""},
        {{.centre_distance_min = 0.15, .centre_distance_max = 0.1, .shaft_angle_to = 10 * degree},
         "Minimum l 150 mm, Maximum l 100 mm"},
        {{.left = 0.03, .right = 0.02}, "Minimum x 30 mm, Maximum x 20 mm"},
        {{.bottom = 0.03, .top = -0.02}, "Minimum y 30 mm, Maximum y -20 mm"}};
    Input input = preset_tmz_650d();
    for (const auto& [limits, names] : cases) {
        const std::string said =
            names.empty() ? names : "The limits contradict each other: " + names + ".";
        EXPECT_EQ(contradiction(limits).english(), said);
        if (!said.empty()) {
            input.place_limits = limits;
            const PositionStudy study{Solver(input)};
            EXPECT_EQ(study.best_buildable().reason.english(), said);
            EXPECT_EQ(study.obstacle_reason({0.01, 0.0}).english(), said);  // at the crank
        }
    }
}

TEST(BuildableAnglesTest, GapsAreAllThatCannotBeBuilt) {
    const auto gaps_of = [](std::vector<AngleStretch> stretches) {
        return BuildableAngles{std::move(stretches), {}}.gaps();
    };
    using Gaps = std::vector<AngleStretch>;
    EXPECT_EQ(gaps_of({}), Gaps({{0.0, two_pi}}));
    EXPECT_EQ(gaps_of(whole_turn()), Gaps());
    EXPECT_EQ(gaps_of({{1.0, 2.0}, {3.0, 4.0}}), Gaps({{0.0, 1.0}, {2.0, 3.0}, {4.0, two_pi}}));
    EXPECT_EQ(gaps_of({{1.0, two_pi}}), Gaps({{0.0, 1.0}}));
    // One that goes on over 0 is built at both ends of the turn.
    const Gaps over_zero = gaps_of({{2.0, 3.0}, {5.0, two_pi + 1.0}});
    ASSERT_EQ(over_zero.size(), 2U);
    EXPECT_NEAR(over_zero[0].from, 1.0, 1e-15);
    EXPECT_EQ(over_zero[0].to, 2.0);
    EXPECT_EQ(over_zero[1], (AngleStretch{3.0, 5.0}));
}

/// Every limit that cuts the circle, with the same test by the place itself.
TEST(BuildableAnglesTest, AreWithinTheLimitsOnTheAxis) {
    Input far = diesel();
    far.centre_distance = 0.5;  // all of the turn clears the engine
    std::vector<Input> inputs;
    for (const Input& base : {preset_tmz_650d(), diesel(), far}) {
        const double l = base.centre_distance;
        const PlaceLimits all[] = {
            {.left = 0.3 * l},
            {.right = 0.3 * l},
            {.bottom = -0.4 * l},
            {.top = -0.1 * l},
            {.top = 2.0 * l},  // cuts nothing
            {.left = -0.8 * l, .right = 0.7 * l, .bottom = -0.9 * l, .top = 0.6 * l},
            {.shaft_angle_from = 100.0 * degree},
            {.shaft_angle_to = 200.0 * degree},
            {.shaft_angle_from = -130.0 * degree, .shaft_angle_to = 110.0 * degree},  // over 0
            {.shaft_angle_from = 230.0 * degree, .shaft_angle_to = 110.0 * degree},   // the same
            {.centre_distance_min = l,
             .centre_distance_max = 1.1 * l,
             .shaft_angle_from = 95.0 * degree,
             .right = 0.9 * l}};
        for (const PlaceLimits& limits : all) {
            inputs.push_back(base);
            inputs.back().place_limits = limits;
        }
    }
    for (const Input& input : inputs) {
        const Solver solver(input);
        const FrontView& view = solver.front_view();
        const PlaceLimits& limits = input.place_limits;
        const BuildableAngles all = buildable_angles(view);
        const BuildableAngles& cut = solver.buildable();
        const auto obeys = [&](double alpha, double miss) {
            const double x = view.centre_distance * std::sin(alpha);
            const double y = view.centre_distance * std::cos(alpha);
            const double turned =
                alpha -
                two_pi * std::floor((alpha - limits.shaft_angle_from.value_or(0.0)) / two_pi);
            const double last = limits.shaft_angle_to.value_or(two_pi);
            const bool is_over_0 = last < limits.shaft_angle_from.value_or(0.0);
            return x >= limits.left.value_or(-1.0) - miss &&
                   x <= limits.right.value_or(1.0) + miss &&
                   y >= limits.bottom.value_or(-1.0) - miss &&
                   y <= limits.top.value_or(1.0) + miss &&
                   turned <= (is_over_0 ? last + two_pi : last) + miss;
        };
        for (double angle = 0.05; angle < 360.0; angle += 0.37) {
            const double alpha = angle * degree;
            EXPECT_EQ(cut.contains(alpha), all.contains(alpha) && obeys(alpha, 0.0)) << angle;
        }
        double before = -1.0;
        for (const AngleStretch& stretch : cut.stretches) {
            EXPECT_GT(stretch.from, before);
            EXPECT_LT(stretch.from, two_pi);
            EXPECT_GT(stretch.to, stretch.from);
            before = stretch.to;
        }
        // The map says the same of the best places, which lie at ends.
        ASSERT_FALSE(cut.stretches.empty()) << cut.reason.english();
        const PositionStudy study(solver);
        for (const Optimum& best :
             {solver.result().best_range_buildable, solver.result().best_rms_buildable}) {
            ASSERT_TRUE(best.shaft_angle);
            EXPECT_TRUE(cut.contains(*best.shaft_angle));
            EXPECT_EQ(study.obstacle(ShaftPosition::at(input.centre_distance, *best.shaft_angle)),
                      Obstacle::none);
        }
        const Result at = solver.result();
        EXPECT_EQ(at.is_buildable,
                  all.contains(input.shaft_angle) && obeys(input.shaft_angle, 1e-12));
    }
}

TEST(BuildableAnglesTest, ABandOfSpeedsHoldsToTheLimitsToo) {
    Input band = diesel();
    band.place_limits.right = 0.05;
    const SpeedStudy study(band, {.from = 150.0, .to = 300.0, .speeds = 3});
    EXPECT_EQ(study.buildable().stretches,
              buildable_angles(front_view(band), band.place_limits).stretches);
    EXPECT_FALSE(study.buildable().contains(90.0 * degree));
}

}  // namespace
}  // namespace ravnoves::balance_shaft
