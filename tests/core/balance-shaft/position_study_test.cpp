#include "balance-shaft/position_study.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

#include "test_cases.h"

namespace ravnoves::balance_shaft::test {

namespace {

Input with_table(TorqueTable table) {
    Input input = test::with_table(preset_tmz_650d(), std::move(table));
    input.step_deg = 90.0;
    return input;
}

/// Of every kind of torque.
std::vector<Input> torques() {
    Input offset = diesel();
    offset.cylinder.offset = 0.008;
    Input cubic = with_table(random_table(5, 30));
    cubic.interpolation = Interpolation::periodic_cubic;
    return {preset_tmz_650d(), diesel(), two_stroke(), offset, cubic};
}

/// weight × range + (1 − weight) × RMS.
double sum(double weight, const PositionCriteria& of) {
    return weight * of.range + (1.0 - weight) * of.rms;
}

/// Range and RMS of a solver that is told the place.
PositionCriteria by_solver(Input input, const ShaftPosition& at) {
    input.centre_distance = at.centre_distance();
    input.shaft_angle = at.shaft_angle();
    const Solver solver(input);
    return {solver.range(input.shaft_angle), solver.rms(input.shaft_angle),
            envelope(solver.front_view(), input.shaft_angle).width() *
                envelope(solver.front_view(), input.shaft_angle).height()};
}

TEST(PositionStudyTest, thePapersEngineHasTheseBestPlaces) {
    const PositionStudy study{Solver(preset_tmz_650d())};
    const BestPositions best = study.best();
    ASSERT_TRUE(best.range && best.rms);
    EXPECT_TRUE(best.reason.empty());
    EXPECT_NEAR(best.range->position.centre_distance() / units::mm, 108.20975, 5e-6);
    EXPECT_NEAR(best.range->position.shaft_angle() / degree, 53.10975, 5e-6);
    EXPECT_NEAR(best.range->criteria.range, 1063.504264, 5e-7);
    EXPECT_LE(best.range->gap, 1e-10);
    EXPECT_NEAR(best.rms->position.centre_distance() / units::mm, 36.950446, 5e-7);
    EXPECT_NEAR(best.rms->position.shaft_angle() / degree, 11.758583, 5e-7);
    EXPECT_NEAR(best.rms->criteria.rms, 180.519414517, 5e-10);
}

TEST(PositionStudyTest, circlesAboutTheCrankHaveTheseBestAngles) {
    const PositionStudy study{Solver(preset_tmz_650d())};
    EXPECT_NEAR(study.range_without(), 1208.0, 0.005);
    EXPECT_NEAR(study.rms_without(), 212.590, 0.0005);
    // At 60 mm both are smaller than without a shaft.
    EXPECT_NEAR(study.at(ShaftPosition::at(0.060, 29.15 * degree)).rms, 198.0, 0.5);
    const struct {
        double distance_mm, angle_deg, range;
    } expected[] = {{40, 0.0, 1119.02},   {50, 15.6, 1100.87}, {60, 29.15, 1091.44},
                    {70, 37.05, 1083.72}, {80, 42.6, 1077.04}, {90, 47.0, 1071.49}};
    for (const auto& row : expected) {
        Input input = preset_tmz_650d();
        input.centre_distance = row.distance_mm * units::mm;
        const Result best = solve(input);
        EXPECT_NEAR(std::remainder(*best.best_range.shaft_angle / degree - row.angle_deg, 360.0),
                    0.0, 0.05);
        // The angles are those of a grid of 0.05°, so the best is a little better.
        EXPECT_NEAR(
            study.at(ShaftPosition::at(row.distance_mm * units::mm, row.angle_deg * degree)).range,
            row.range, 0.00501);
        EXPECT_LE(best.best_range.value, row.range + 0.00501);
        EXPECT_GE(best.best_range.value, row.range - 0.02);
        EXPECT_NEAR(*best.best_rms.shaft_angle / degree, 11.758583, 5e-7);
    }
}

TEST(PositionStudyTest, aPlaceHasWhatASolverThatIsPutThereFinds) {
    std::mt19937 generator(7);
    std::uniform_real_distribution<double> metres(-0.3, 0.3);
    std::vector<Input> inputs = torques();
    inputs.push_back(with_table(random_table(6, 4)));
    inputs.push_back(with_table(random_table(8, 721)));
    for (const Input& input : inputs) {
        const PositionStudy study{Solver(input)};
        const double scale = study.range_without() + study.rms_without();
        for (int i = 0; i < 20; ++i) {
            const ShaftPosition at{metres(generator), metres(generator)};
            const PositionCriteria here = study.at(at);
            const PositionCriteria solved = by_solver(input, at);
            EXPECT_NEAR(here.range, solved.range, 2e-12 * (scale + solved.range));
            EXPECT_NEAR(here.rms, solved.rms, 1e-11 * (scale + solved.rms));
            EXPECT_NEAR(here.size, solved.size, 1e-12 * solved.size);
        }
        const PositionCriteria none = study.at({});
        EXPECT_NEAR(none.range, study.range_without(), 1e-12 * scale);
        EXPECT_NEAR(none.rms, study.rms_without(), 1e-9 * scale);
        const BestPositions best = study.best();
        ASSERT_TRUE(best.range);
        EXPECT_LE(best.range->gap, 1e-11 * study.range_without());
        EXPECT_NEAR(by_solver(input, best.range->position).range, best.range->criteria.range,
                    1e-10 * study.range_without());
    }
}

TEST(PositionStudyTest, noPlaceOfAFineGridBeatsTheBestOf1000Torques) {
    for (unsigned seed = 0; seed < 1000; ++seed) {
        const Solver solver(with_table(random_table(seed, 4 + seed % 60)));
        const PositionStudy study(solver);
        const BestPositions best = study.best();
        ASSERT_TRUE(best.range && best.rms);
        const double minimum = best.range->criteria.range;
        EXPECT_LE(best.range->gap, 1e-11 * study.range_without()) << seed;
        // The best lies within |m| ≤ the range without a shaft; the range there moves by at most
        // 2 per N·m.
        const double force = solver.moments().forces.counterweight_force;
        const double reach = study.range_without();
        constexpr std::size_t nodes = 41;
        const double edge = reach / force;
        const PositionMap map = study.map(-edge, edge, -edge, edge, nodes, nodes);
        const double found = *std::min_element(map.range.begin(), map.range.end());
        EXPECT_GE(found, minimum - 1e-11 * reach) << seed;
        EXPECT_LE(found, minimum + 2.0 * (2.0 * reach / (nodes - 1.0)) / std::numbers::sqrt2);
        // And none of a grid about the best, as fine as you like.
        for (const double fine : {1e-2, 1e-4, 1e-6}) {
            for (int i = 0; i < 8; ++i) {
                const double dx = fine * reach * std::cos(pi * i / 4) / force;
                const double dy = fine * reach * std::sin(pi * i / 4) / force;
                const ShaftPosition& at = best.range->position;
                EXPECT_GE(study.at({at.x + dx, at.y + dy}).range, minimum - 1e-11 * reach);
            }
        }
    }
}

TEST(PositionStudyTest, theRmsAtTheBestPlaceIsThatWithoutTheFirstOrder) {
    for (const Input& input : torques()) {
        const Solver solver(input);
        const Result result = solver.result();
        const BestPositions best = PositionStudy(solver).best();
        ASSERT_TRUE(best.rms);
        EXPECT_NEAR(best.rms->criteria.rms,
                    std::sqrt(result.M_up.rms * result.M_up.rms -
                              result.order_1_amplitude * result.order_1_amplitude / 2.0),
                    1e-9 * result.M_up.rms);
        Input there = input;
        there.centre_distance = best.rms->position.centre_distance();
        there.shaft_angle = best.rms->position.shaft_angle();
        const Result moved = solve(there);
        const std::size_t first = input.strokes == 2 ? 0 : 1;
        EXPECT_NEAR(moved.spectrum_M_ups[first].amplitude, 0.0, 1e-9 * result.M_up.rms);
        EXPECT_NEAR(moved.M_ups.rms, best.rms->criteria.rms, 1e-9 * result.M_up.rms);
    }
}

TEST(PositionStudyTest, theMapHoldsWhatItsPlacesHave) {
    Input cubic = with_table(random_table(9, 12));
    cubic.interpolation = Interpolation::periodic_cubic;
    Input offset = two_stroke();
    offset.cylinder.offset = -0.006;
    for (const Input& input : {preset_tmz_650d(), cubic, offset, with_table(random_table(10, 4))}) {
        const PositionStudy study{Solver(input)};
        const PositionMap map = study.map(-0.21, 0.3, -0.4, 0.1, 53, 29);
        ASSERT_EQ(map.range.size(), 53u * 29u);
        ASSERT_EQ(map.rms.size(), 53u * 29u);
        for (std::size_t row = 0; row < 29; ++row) {
            for (std::size_t column = 0; column < 53; ++column) {
                const PositionCriteria here =
                    study.at({-0.21 + 0.51 * static_cast<double>(column) / 52.0,
                              -0.4 + 0.5 * static_cast<double>(row) / 28.0});
                EXPECT_NEAR(map.range[row * 53 + column], here.range, 1e-9);
                EXPECT_NEAR(map.rms[row * 53 + column], here.rms, 1e-9);
            }
        }
    }
    const PositionMap one = PositionStudy(Solver(preset_tmz_650d())).map(0.1, 0.1, 0.2, 0.2, 1, 1);
    EXPECT_EQ(one.range.size(), 1u);
}

/// Engines and limits among which the place is looked for.
std::vector<Input> restricted() {
    std::vector<Input> inputs{preset_tmz_650d(), diesel(), two_stroke()};
    inputs.push_back(diesel());
    inputs.back().cylinder.offset = 0.012;
    inputs.push_back(preset_tmz_650d());
    inputs.back().envelope.gear_tip_radius = 0.055;
    const PlaceLimits all[] = {
        {.right = 0.070, .bottom = -0.090},
        {.centre_distance_min = 0.120,
         .centre_distance_max = 0.150,
         .shaft_angle_from = 100.0 * degree,
         .shaft_angle_to = 160.0 * degree},
        {.centre_distance_min = 0.120, .centre_distance_max = 0.120},
        // The sector goes over 0 and is wider than half a turn.
        {.shaft_angle_from = -130.0 * degree, .shaft_angle_to = 75.0 * degree}};
    for (const PlaceLimits& limits : all) {
        inputs.push_back(preset_tmz_650d());
        inputs.back().place_limits = limits;
    }
    inputs.back().envelope.shaft_swing_radius = 0.04;
    for (unsigned seed = 0; seed < 12; ++seed) {
        Input random = with_table(random_table(seed, 30, 400.0 + 100.0 * seed));
        random.envelope.shaft_swing_radius = 0.02 + 0.003 * seed;
        random.place_limits.top = 0.05;
        inputs.push_back(random);
    }
    return inputs;
}

TEST(PositionStudyTest, noPlaceThatCanBeBuiltBeatsTheBestOne) {
    for (const Input& input : restricted()) {
        const PositionStudy study{Solver(input)};
        const BestPositions best = study.best_buildable();
        const BestPositions free = study.best();
        ASSERT_TRUE(best.range && best.rms) << best.reason.english();
        const double size = study.range_without();
        for (const auto& found : {*best.range, *best.rms}) {
            EXPECT_EQ(study.obstacle(found.position), Obstacle::none)
                << study.obstacle_reason(found.position).english();
            EXPECT_EQ(study.obstacle(ShaftPosition::at(found.position.centre_distance(),
                                                       found.position.shaft_angle())),
                      Obstacle::none);
            EXPECT_LE(found.gap, 1e-9 * size);
        }
        EXPECT_GE(best.range->criteria.range, free.range->criteria.range - 1e-9);
        EXPECT_GE(best.rms->criteria.rms, free.rms->criteria.rms - 1e-9);
        // Grids: all of the front view, and about the best, finer and finer.
        const auto look = [&](const ShaftPosition& about, double half) {
            constexpr int cells = 60;
            for (int i = 0; i <= cells; ++i) {
                for (int k = 0; k <= cells; ++k) {
                    const ShaftPosition at{about.x + half * (2.0 * i / cells - 1.0),
                                           about.y + half * (2.0 * k / cells - 1.0)};
                    if (study.obstacle(at) == Obstacle::none) {
                        const PositionCriteria here = study.at(at);
                        ASSERT_GE(here.range, best.range->criteria.range - 1e-8 * size);
                        ASSERT_GE(here.rms, best.rms->criteria.rms - 1e-8 * size);
                    }
                }
            }
        };
        look({}, 0.6);
        for (const double half : {0.05, 1e-3, 1e-5}) {
            look(best.range->position, half);
            look(best.rms->position, half);
        }
    }
}

TEST(PositionStudyTest, anObstacleIsWhatTheClearancesSay) {
    const Input input = preset_tmz_650d();
    const PositionStudy study{Solver(input)};
    std::array<int, 4> seen{};
    for (int i = 0; i < 60; ++i) {
        for (int k = 0; k < 60; ++k) {
            const ShaftPosition at{-0.2 + 0.4 * i / 59.0, -0.2 + 0.5 * k / 59.0};
            Input there = input;
            there.centre_distance = at.centre_distance();
            const FrontView view = front_view(there);
            const ShaftClearance free = shaft_clearance(view, at.shaft_angle());
            const double minimum = view.clearance;
            const Obstacle expected = free.crank < minimum      ? Obstacle::crank
                                      : free.cylinder < minimum ? Obstacle::cylinder
                                      : free.rod < minimum      ? Obstacle::rod
                                                                : Obstacle::none;
            EXPECT_EQ(study.obstacle(at), expected) << at.x << " " << at.y;
            EXPECT_EQ(study.obstacle_reason(at).empty(), expected == Obstacle::none);
            ++seen[static_cast<std::size_t>(expected)];
        }
    }
    for (const int count : seen) {
        EXPECT_GT(count, 0);
    }
}

TEST(PositionStudyTest, noPlaceThatCanBeBuiltBeatsTheFrontInAllThree) {
    for (const Input& input : restricted()) {
        const PositionStudy study{Solver(input)};
        const std::vector<BestPosition> front = study.front();
        ASSERT_GE(front.size(), 1u);
        EXPECT_LE(front.size(), 60u);
        std::vector<PositionCriteria> others;
        for (int i = 0; i <= 100; ++i) {
            for (int k = 0; k <= 100; ++k) {
                const ShaftPosition at{-0.25 + 0.5 * i / 100.0, -0.25 + 0.5 * k / 100.0};
                if (study.obstacle(at) == Obstacle::none) {
                    others.push_back(study.at(at));
                }
            }
        }
        for (std::size_t i = 0; i < front.size(); ++i) {
            const PositionCriteria& one = front[i].criteria;
            EXPECT_EQ(study.obstacle(front[i].position), Obstacle::none);
            if (i > 0) {
                EXPECT_GE(one.size, front[i - 1].criteria.size);
            }
            constexpr double gap = 1e-5;
            for (const PositionCriteria& other : others) {
                EXPECT_FALSE(other.range < one.range * (1.0 - gap) &&
                             other.rms < one.rms * (1.0 - gap) &&
                             other.size < one.size * (1.0 - gap));
            }
        }
        const BestPositions best = study.best_buildable();
        const auto has = [&](const BestPosition& wanted) {
            return std::any_of(front.begin(), front.end(), [&](const BestPosition& one) {
                return one.criteria.range <= wanted.criteria.range * (1.0 + 1e-5) &&
                       one.criteria.rms <= wanted.criteria.rms * (1.0 + 1e-5);
            });
        };
        EXPECT_TRUE(has(*best.range));
        EXPECT_TRUE(has(*best.rms));
    }
}

TEST(PositionStudyTest, aConstantTorqueAndAShaftWithoutMomentAreSaidInWords) {
    TorqueTable table;
    table.crank_angle_deg = {0.0, 300.0, 720.0};
    table.torque = {55.0, 55.0, 55.0};
    const PositionStudy constant{Solver(with_table(table))};
    const BestPositions best = constant.best();
    ASSERT_TRUE(best.range && best.rms);
    EXPECT_FALSE(best.reason.empty());
    EXPECT_EQ(best.range->position.centre_distance(), 0.0);
    EXPECT_EQ(best.range->criteria.range, 0.0);
    const BestPositions built = constant.best_buildable();
    ASSERT_TRUE(built.range);
    EXPECT_FALSE(built.reason.empty());
    EXPECT_EQ(constant.obstacle(built.range->position), Obstacle::none);
    EXPECT_TRUE(std::isfinite(built.range->criteria.range + built.rms->criteria.rms));
    EXPECT_FALSE(constant.front().empty());
    for (const double value : constant.map(-0.1, 0.1, -0.1, 0.1, 9, 9).range) {
        EXPECT_TRUE(std::isfinite(value));
    }

    Input input = preset_tmz_650d();
    input.counterweight_mass = 0.0;
    const PositionStudy still{Solver(input)};
    EXPECT_FALSE(still.best().range);
    EXPECT_FALSE(still.best_buildable().rms);
    EXPECT_FALSE(still.best_buildable().reason.empty());
    EXPECT_TRUE(still.front().empty());
    EXPECT_NEAR(still.at({0.1, 0.1}).range, still.range_without(), 1e-9);
}

TEST(PositionStudyTest, limitsThatLeaveNothingGiveAReason) {
    Input input = preset_tmz_650d();
    for (const PlaceLimits& limits :
         {PlaceLimits{.centre_distance_max = 0.05},
          PlaceLimits{.left = -0.02, .right = 0.02, .bottom = 0.05, .top = 0.20}}) {
        input.place_limits = limits;
        const PositionStudy study{Solver(input)};
        EXPECT_FALSE(study.best_buildable().range);
        EXPECT_FALSE(study.best_buildable().reason.empty());
        EXPECT_TRUE(study.front().empty());
    }
}

TEST(PositionStudyTest, theSmallestGoodPlaceIsGoodAndNoneSmallerIs) {
    Input input = preset_tmz_650d();
    for (const bool limited : {false, true}) {
        input.place_limits.top = limited ? std::optional(0.02) : std::nullopt;
        const PositionStudy study{Solver(input)};
        const BestPositions built = study.best_buildable();
        for (const bool by_range : {false, true}) {
            const auto& best = by_range ? built.range : built.rms;
            const double weight = by_range ? 1.0 : 0.0;
            ASSERT_TRUE(best);
            SCOPED_TRACE(testing::Message() << limited << ' ' << weight);
            const BestPosition found = study.smallest_buildable(*best, by_range);
            const double maximum = 1.01 * sum(weight, best->criteria);
            const double other = sum(1.0 - weight, found.criteria);
            EXPECT_EQ(study.obstacle(found.position), Obstacle::none);
            EXPECT_LE(sum(weight, found.criteria), maximum * (1.0 + 1e-8));
            EXPECT_LE(found.criteria.size, (1.0 + 2.1e-3) * best->criteria.size);
            EXPECT_LE(found.gap, 2.1e-3 * best->criteria.size);
            // On circles about the best place, closer and closer.
            double reach = 0.1;
            for (int i = 0; i < 24; ++i, reach *= 0.8) {
                for (int k = 0; k < 180; ++k) {
                    const ShaftPosition at{best->position.x + reach * std::cos(k * 2.0 * degree),
                                           best->position.y + reach * std::sin(k * 2.0 * degree)};
                    const PositionCriteria there = study.at(at);
                    if (study.obstacle(at) != Obstacle::none || sum(weight, there) > maximum) {
                        continue;
                    }
                    EXPECT_GE(there.size, found.criteria.size - found.gap - 1e-12);
                    if (there.size <= found.criteria.size - found.gap) {
                        EXPECT_GE(sum(1.0 - weight, there),
                                  other - 1e-3 * sum(1.0 - weight,
                                                     {study.range_without(), study.rms_without()}));
                    }
                }
            }
        }
    }
    EXPECT_EQ(trade_off({200.0, 100.0, 0.0}, {199.0, 143.0, 0.0}).english(),
              "range 0.5 % smaller, RMS 43.0 % larger");
    EXPECT_EQ(trade_off({200.0, 100.0, 0.05}, {200.01, 99.99, 0.06}).english(),
              "range unchanged, RMS unchanged, box 20.0 % larger");
}

}  // namespace

}  // namespace ravnoves::balance_shaft::test
