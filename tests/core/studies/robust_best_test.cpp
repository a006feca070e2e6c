// The angle that holds best when the inputs scatter, against what is known and what is tried out.

#include "studies/robust_best.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "case-file/case_file.h"
#include "case-file/text_file.h"
#include "numerics/constants.h"
#include "scenes/scenes.h"
#include "studies/sampler.h"
#include "support.h"

namespace ravnoves::studies {
namespace {

constexpr double nominal_angle = 130.0;

/// A value over x and an angle of which 130° + x is the best; it rises by so much per radian to
/// either side.
Problem chosen(const Json& vary, double below, double above, std::uint64_t samples = 2000) {
    const Json study = {
        {"vary", {{"/x0", vary}}}, {"watch", {{"/y", Json::object()}}}, {"samples", samples}};
    Problem made = problem(study, {0.0}, [](auto x, auto y) {
        y[0] = x[0];
        return true;
    });
    const Function value = [below, above](auto x, auto y) {
        const double off = std::remainder(x[1] - nominal_angle - x[0], 360.0) * degree;
        y[0] = 10.0 + std::max(above * off, -below * off);
        y[1] = 0.5 * std::max(above, below);
        return true;
    };
    made.choice = {
        .input = "/angle_deg", .value = "/y", .nominal_best = nominal_angle, .make = [value] {
            return std::make_unique<FunctionResponse>(value);
        }};
    return made;
}

TEST(RobustBest, WithoutScatterIsTheNominalBest) {
    const auto found = find_robust_best(chosen({{"plus_minus_percent", 1}}, 2.0, 1.0));
    ASSERT_TRUE(found && found->robust && found->nominal);
    EXPECT_NEAR(found->robust->angle, nominal_angle, 1e-3);
    EXPECT_NEAR(found->robust->percentile, 10.0, 1e-4);
    EXPECT_EQ(found->nominal->angle, nominal_angle);
    EXPECT_EQ(found->robust->percentile_error, 0.0);
    EXPECT_NEAR(found->gain, 0.0, 1e-4);
    EXPECT_EQ(found->gain_error, 0.0);
}

TEST(RobustBest, OfASymmetricCaseIsItsMiddle) {
    const auto found = find_robust_best(chosen({{"plus_minus", 10}}, 1.0, 1.0));
    ASSERT_TRUE(found && found->robust);
    EXPECT_NEAR(found->robust->angle, nominal_angle, 3.0 * found->robust->angle_error + 1e-3);
    EXPECT_LT(found->robust->angle_error, 2.0);
    // 95 % of |x| lie within 9.5°.
    EXPECT_NEAR(found->robust->percentile, 10.0 + 9.5 * degree,
                3.0 * found->robust->percentile_error);
    EXPECT_LE(std::abs(found->gain), 3.0 * found->gain_error + 1e-4);
}

TEST(RobustBest, LeansToTheSideThatCostsLess) {
    // Too far costs four times as much as not far enough: by the law α − x is from −10° + α to
    // 10° + α, and the worst twentieth is the least where both sides share it.
    const Problem tried = chosen({{"plus_minus", 10}}, 1.0, 4.0);
    const auto found = find_robust_best(tried, 2);
    ASSERT_TRUE(found && found->robust && found->nominal);
    EXPECT_LT(found->robust->angle, nominal_angle - 4.0);
    EXPECT_GT(found->gain, 10.0 * found->gain_error);
    EXPECT_LT(found->gain_error, found->nominal->percentile_error);
    EXPECT_EQ(*found, *find_robust_best(tried, 1));
    EXPECT_EQ(*found, read_robust_best(Json::parse(write_robust_best(*found).dump())));

    // The same samples at angles of a grid.
    Sampler sampler(Method::sobol, 2000, 1, 1);
    std::vector<double> x(2000);
    for (std::size_t i = 0; i < x.size(); ++i) {
        sampler.point(i, std::span(&x[i], 1));
        x[i] = 20.0 * x[i] - 10.0;
    }
    const auto percentile = [&](double angle) {
        std::vector<double> y;
        for (const double each : x) {
            const double off = (angle - nominal_angle - each) * degree;
            y.push_back(10.0 + std::max(4.0 * off, -off));
        }
        std::sort(y.begin(), y.end());
        return std::lerp(y[1899], y[1900], 0.05);
    };
    EXPECT_NEAR(found->robust->percentile, percentile(found->robust->angle), 1e-12);
    EXPECT_NEAR(found->nominal->percentile, percentile(nominal_angle), 1e-12);
    for (double angle = 110.0; angle < 150.0; angle += 0.05) {
        EXPECT_GT(percentile(angle),
                  found->robust->percentile - 0.05 * found->robust->percentile_error);
    }
}

TEST(RobustBest, IsNoneWhereNothingDependsOnTheAngle) {
    const auto found = find_robust_best(chosen({{"plus_minus", 10}}, 0.0, 0.0));
    ASSERT_TRUE(found);
    EXPECT_FALSE(found->robust || found->nominal);
    EXPECT_FALSE(find_robust_best(chosen({{"plus_minus", 10}}, 1.0, 1.0), 1, [] { return false; }));
    Problem without = chosen({{"plus_minus", 10}}, 1.0, 1.0);
    without.choice.reset();
    EXPECT_FALSE(find_robust_best(without));
}

TEST(RobustBest, LooksAtAnglesThatCanBeBuiltAlone) {
    Problem tried = chosen({{"plus_minus", 10}}, 1.0, 4.0);
    // The best of all lies between the first two; the third goes over 0°.
    tried.choice->buildable = {{100.0, 118.0}, {129.0, 140.0}, {350.0, 365.0}};
    const auto found = find_robust_best(tried, 1);
    ASSERT_TRUE(found && found->robust);
    EXPECT_NEAR(found->robust->angle, 118.0, 1e-9);
    tried.choice->buildable = {{350.0, 365.0}};
    tried.choice->nominal_best.reset();
    const auto over = find_robust_best(tried, 1);
    ASSERT_TRUE(over && over->robust);
    EXPECT_NEAR(over->robust->angle, 5.0, 1e-9);
    tried.choice->buildable.emplace();
    tried.choice->unbuildable = "no room";
    const auto none = find_robust_best(tried, 1);
    ASSERT_TRUE(none);
    EXPECT_FALSE(none->robust);
    EXPECT_EQ(none->reason.english(), "No angle can be built: no room");
    EXPECT_EQ(*none, read_robust_best(Json::parse(write_robust_best(*none).dump())));
}

TEST(RobustBest, LeavesRoomForWhatTheSamplesNeed) {
    // A sample can be built from 130° + 0.9 x on, x up to ±10°.
    Problem tried = chosen({{"plus_minus", 10}}, 4.0, 4.0);
    tried.choice->nominal_best = 118.0;
    tried.choice->buildable = {{118.0, 200.0}};
    tried.choice->make_buildable = [] {
        return [](std::span<const double> x) {
            return std::optional(AngleStretches{{130.0 + 0.9 * x[0], 200.0}});
        };
    };
    const auto found = find_robust_best(tried, 2);
    ASSERT_TRUE(found && found->robust && found->nominal);
    EXPECT_NEAR(found->robust->angle, 130.0 + 0.9 * 9.0, 0.02);
    EXPECT_NEAR(found->robust->buildable.value_or(0.0), 0.95, 1e-3);
    EXPECT_EQ(found->nominal->buildable, 0.0);
    EXPECT_EQ(*found, read_robust_best(Json::parse(write_robust_best(*found).dump())));
    // Where that many can be built at no angle, the angle at which most can.
    tried.choice->make_buildable = [] {
        return [](std::span<const double> x) {
            return std::optional(x[0] < 0.0 ? AngleStretches{{150.0, 160.0}} : AngleStretches{});
        };
    };
    const auto half = find_robust_best(tried, 1);
    ASSERT_TRUE(half && half->robust);
    EXPECT_NEAR(half->robust->angle, 150.0, 1e-6);
    EXPECT_NEAR(half->robust->buildable.value_or(0.0), 0.5, 1e-3);
}

TEST(RobustBest, LeavesRoomForTheToleranceOfTheAngleItself) {
    // Every sample can be built from 130° on; the shaft is set to ±10°.
    Problem tried = chosen({{"plus_minus", 1e-6}}, 4.0, 4.0);
    tried.study.vary.push_back(
        {.pointer = "/angle_deg", .spread = Varied::Spread::plus_minus, .size = 10.0});
    tried.nominal.push_back(nominal_angle);
    double to = 200.0;
    tried.choice->make_buildable = [&to] {
        return [&to](std::span<const double>) {
            return std::optional(AngleStretches{{130.0, to}});
        };
    };
    tried.choice->buildable = {{130.0, to}};
    const auto found = find_robust_best(tried, 2);
    ASSERT_TRUE(found && found->robust && found->nominal);
    EXPECT_NEAR(found->robust->angle, 130.0 + 0.9 * 10.0, 0.05);
    EXPECT_NEAR(found->robust->buildable.value_or(0.0), 0.95, 1e-3);
    EXPECT_NEAR(found->nominal->buildable.value_or(0.0), 0.5, 1e-3);
    // Narrower than the tolerance: the most there is.
    to = 136.0;
    tried.choice->buildable = {{130.0, to}};
    const auto narrow = find_robust_best(tried, 1);
    ASSERT_TRUE(narrow && narrow->robust);
    EXPECT_NEAR(narrow->robust->buildable.value_or(0.0), 6.0 / 20.0, 3e-3);
}

TEST(RobustBest, OfABalanceShaftIsTheLeastOfTheAnglesThatCanBeBuilt) {
    CaseFile file =
        parse_case(read_text_file(std::filesystem::path(RAVNOVES_EXAMPLES) / "tmz-650d.case.json"));
    file.study = {{"vary",
                   {{"/counterweight_radius_mm", {{"plus_minus_percent", 10}}},
                    {"/shaft_angle_deg", {{"plus_minus", 6}}},
                    {"/torque/torque_Nm/26", {{"plus_minus_percent", 10}}}}},
                  {"watch", {{"/metrics/M_ups/range_Nm", Json::object()}}},
                  {"samples", 256}};
    const Problem all = problem_of(file, {});
    ASSERT_TRUE(all.choice->buildable);
    ASSERT_EQ(all.choice->buildable->size(), 1U);
    EXPECT_EQ(all.choice->nominal_best, all.choice->buildable->front().first);
    ASSERT_TRUE(asks_for_robust_best(all));
    const auto found = find_robust_best(all);
    ASSERT_TRUE(found && found->robust && found->nominal);
    EXPECT_EQ(found->refused, 0U);
    EXPECT_GE(found->robust->buildable.value_or(0.0), RobustBest::least_buildable);
    // Whole studies at other angles: the 95 % point of each is one of the table's.
    for (const double angle : {found->robust->angle, found->nominal->angle, 70.0, 100.0, 200.0}) {
        CaseFile turned = file;
        turned.input["shaft_angle_deg"] = angle;
        const double percentile = whole(problem_of(turned, {})).tally.statistics(0).percentiles[6];
        if (angle == found->nominal->angle) {
            EXPECT_NEAR(percentile, found->nominal->percentile, 1e-3);
        } else {
            EXPECT_GT(percentile,
                      found->robust->percentile - 0.05 * found->robust->percentile_error);
        }
        if (angle == found->robust->angle) {
            EXPECT_NEAR(percentile, found->robust->percentile, 1e-3);
        }
    }
    file.study["vary"] = {{"/crank_radius_mm", {{"plus_minus", 1e-9}}}};
    const auto sharp = find_robust_best(problem_of(file, {}));
    ASSERT_TRUE(sharp && sharp->robust && sharp->nominal);
    EXPECT_NEAR(sharp->robust->angle, sharp->nominal->angle, 2e-3);
    EXPECT_NEAR(sharp->robust->percentile, sharp->nominal->percentile, 1e-2);
}

}  // namespace
}  // namespace ravnoves::studies
