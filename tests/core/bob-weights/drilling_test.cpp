// Holes against their volume integral, vectors against a search, patterns against their limits.

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>

#include "bob-weights/drilling.h"
#include "core/bob-weights/quadrature.h"
#include "numerics/constants.h"

namespace ravnoves::bob_weights {
namespace {

constexpr double mm = 1e-3;
constexpr double gram_mm = 1e-6;

using test::by_quadrature;

TEST(Drills, AreUsualByMillimetresAndInches) {
    for (const double usual : {8.0, 10.25, 12.7, 9.53}) {
        EXPECT_TRUE(is_usual_drill(usual * mm)) << usual;
    }
    EXPECT_FALSE(is_usual_drill(10.12 * mm));
}

TEST(Hole, TakesOffItsVolumeIntegral) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int i = 0; i < 40; ++i) {
        const Cut cut{(60 + 60 * unit(random)) * mm, 7000 + 1000 * unit(random),
                      (90 + 90 * unit(random)) * degree};
        const double diameter = (4 + 20 * unit(random)) * mm;
        const double depth = 30 * unit(random) * mm;
        const Removed exact = cut.removed(diameter, depth);
        const Removed sum = by_quadrature(cut, diameter, depth);
        EXPECT_NEAR(exact.mass, sum.mass, 1e-7 * exact.mass);
        EXPECT_NEAR(exact.unbalance, sum.unbalance, 1e-7 * exact.unbalance);
    }
    EXPECT_EQ((Cut{0.1, 7850, pi}.cone(0.01)), 0.0);
}

TEST(Slug, LeavesTheConeOfItsHoleEmpty) {
    for (const double point_deg : {90.0, 118.0, 180.0}) {
        const Cut hole{85 * mm, 7850, point_deg * degree};
        const Cut slug{hole.radius, hole.density, hole.point_angle, 17'500};
        const Removed out = by_quadrature(hole, 14 * mm, 12 * mm);
        const Removed in = by_quadrature({hole.radius, 17'500, pi}, 14 * mm, 12 * mm);
        const Removed found = slug.removed(14 * mm, 12 * mm);
        EXPECT_NEAR(found.slug, in.mass, 1e-7 * in.mass);
        EXPECT_NEAR(found.mass, in.mass - out.mass, 1e-7 * in.mass);
        EXPECT_NEAR(found.unbalance, in.unbalance - out.unbalance, 1e-7 * in.unbalance);
    }
    // By hand: what a cone of 118° is of the hole of a slug ⌀ 14 mm.
    const double cone = Cut{85 * mm, 7850, pi, 17'500}.removed(14 * mm, 12 * mm).mass -
                        Cut{85 * mm, 7850, 118 * degree, 17'500}.removed(14 * mm, 12 * mm).mass;
    EXPECT_NEAR(cone, 1.694e-3, 1e-6);
}

TEST(Vectors, AreCarriedOverWithForceAndMoment) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int i = 0; i < 50; ++i) {
        const std::array<std::complex<double>, 2> read{
            std::complex<double>(unit(random), unit(random)),
            std::complex<double>(unit(random), unit(random))};
        const std::array<double, 2> from{unit(random), 2.0 + unit(random)};
        const std::array<double, 2> to{-2.0 + unit(random), 4.0 + unit(random)};
        const auto there = carried_over(read, from, to);
        for (const double z : {-3.0, 0.0, 5.0}) {  // the moment about any point
            const auto before = read[0] * (from[0] - z) + read[1] * (from[1] - z);
            const auto after = there[0] * (to[0] - z) + there[1] * (to[1] - z);
            EXPECT_LT(std::abs(before - after), 1e-13);
        }
        EXPECT_LT(std::abs(read[0] + read[1] - there[0] - there[1]), 1e-13);
    }
}

/// Angle between two neighbours whose wall is still the smallest.
std::optional<double> hole_spacing(const Cut& cut, double diameter, double depth, double wall) {
    const auto half = half_width(cut, diameter, depth, wall);
    return half ? std::optional(2.0 * *half) : std::nullopt;
}

/// Least distance between two holes, by points on their outlines in the plane of both axes.
double wall_between(const Cut& cut, const Hole& first, const Hole& second) {
    const auto outline = [&](const Hole& hole, double turn, double side) {
        const double diameter = hole.diameter;
        const double depth = hole.depth;
        std::vector<std::complex<double>> points;
        const double point = cut.cone(diameter);
        for (int i = 0; i <= 400; ++i) {
            const double x = (depth + point) * i / 400.0;
            const double half =
                x <= depth ? 0.5 * diameter : 0.5 * diameter * (1.0 - (x - depth) / point);
            points.push_back(std::complex<double>(cut.radius - x, side * half) *
                             std::polar(1.0, turn));
        }
        return points;
    };
    double minimum = 1.0;
    const double angle = std::abs(std::remainder(second.angle - first.angle, 2.0 * pi));
    const auto other = outline(second, angle, -1.0);
    for (const auto& a : outline(first, 0.0, 1.0)) {
        for (const auto& b : other) {
            minimum = std::min(minimum, std::abs(a - b));
        }
    }
    return minimum;
}

TEST(Spacing, LeavesTheWallAndNoMore) {
    for (const double point_deg : {90.0, 118.0, 180.0}) {
        const Cut cut{80 * mm, 7850, point_deg * degree};
        for (const double depth : {0.0, 10 * mm, 30 * mm}) {
            const auto angle = hole_spacing(cut, 12 * mm, depth, 3 * mm);
            ASSERT_TRUE(angle);
            EXPECT_NEAR(
                wall_between(cut, {12 * mm, depth, 0, 0, 0}, {12 * mm, depth, *angle, 0, 0}),
                3 * mm, 0.05 * mm);
        }
    }
    EXPECT_FALSE(hole_spacing({20 * mm, 7850, pi}, 12 * mm, 19 * mm, 3 * mm));
}

const HoleLimits usual{35 * mm, 0.0, 3 * mm, 5, 60 * degree, std::nullopt};
const Cut rim{80 * mm, 7850, 118 * degree};
const double drills[] = {8 * mm, 12 * mm, 16 * mm};

std::complex<double> sum_of(const HolePlan& plan) {
    std::complex<double> sum;
    for (const Hole& hole : plan.holes) {
        sum += std::polar(hole.unbalance, hole.angle);
    }
    return sum;
}

TEST(Plan, TakesOffTheVectorWithAsFewHolesAsCanBe) {
    for (const double target : {300.0, 1000.0, 3500.0, 6000.0, 9000.0}) {
        const HolePlan plan = plan_holes(target * gram_mm, 0.7, rim, drills, usual, -1.0);
        EXPECT_EQ(plan.shortfall, Shortfall::none) << target;
        EXPECT_LT(std::abs(sum_of(plan) - std::polar(target * gram_mm, 0.7)), 1e-6 * gram_mm);
        // By brute force: no drill does it with one hole less, though they lay all in one place.
        double maximum = 0.0;
        for (const double diameter : drills) {
            maximum = std::max(maximum, rim.removed(diameter, usual.maximum_depth).unbalance);
        }
        EXPECT_GE(maximum * static_cast<double>(plan.holes.size()), target * gram_mm);
        if (plan.holes.size() == 1) {
            EXPECT_NEAR(plan.holes[0].angle, 0.7, 1e-12);
        }
    }
}

TEST(Plan, KeepsItsLimits) {
    HoleLimits limits = usual;
    limits.depth_step = 0.5 * mm;
    for (double target = 200.0; target < 12'000.0; target *= 1.17) {
        const HolePlan plan = plan_holes(target * gram_mm, -2.0, rim, drills, limits, -1.0);
        ASSERT_LE(plan.holes.size(), 5u);
        for (std::size_t i = 0; i < plan.holes.size(); ++i) {
            const Hole& hole = plan.holes[i];
            EXPECT_LE(hole.depth, limits.maximum_depth + 1e-12);
            EXPECT_NEAR(std::remainder(hole.depth, limits.depth_step), 0.0, 1e-12);
            EXPECT_LE(std::abs(std::remainder(hole.angle + 2.0, 2.0 * pi)), 60 * degree + 1e-12);
            if (i > 0) {
                EXPECT_GE(wall_between(rim, hole, plan.holes[i - 1]), 3 * mm - 1e-9);
            }
        }
        EXPECT_NEAR(plan.left, target * gram_mm - std::abs(sum_of(plan)), 1e-12);
    }
}

TEST(Plan, KeepsClearOfEarlierHoles) {
    int planned = 0;
    int without_room = 0;
    for (const double earlier : {400.0, 2800.0, 7000.0}) {
        const HolePlan before = plan_holes(earlier * gram_mm, 1.0, rim, drills, usual, -1.0);
        HoleLimits limits = usual;
        for (const Hole& hole : before.holes) {
            limits.taken.push_back(
                {hole.angle, half_width(rim, hole.diameter, hole.depth, 3 * mm)});
        }
        for (const double angle : {1.0, 1.01, 1.15, 0.8, 1.4, 4.0}) {
            for (double target = 200.0; target < 8000.0; target *= 1.6) {
                const HolePlan plan =
                    plan_holes(target * gram_mm, angle, rim, drills, limits, -1.0);
                for (const Hole& hole : plan.holes) {
                    for (const Hole& old : before.holes) {
                        EXPECT_GE(wall_between(rim, hole, old), 3 * mm - 1e-9)
                            << earlier << ' ' << angle << ' ' << target;
                    }
                    for (const Hole& other : plan.holes) {
                        EXPECT_TRUE(&hole == &other ||
                                    wall_between(rim, hole, other) >= 3 * mm - 1e-9);
                    }
                }
                EXPECT_NEAR(plan.left, target * gram_mm - std::abs(sum_of(plan)), 1e-12);
                if (plan.shortfall == Shortfall::none) {
                    EXPECT_LT(std::abs(sum_of(plan) - std::polar(target * gram_mm, angle)),
                              1e-6 * gram_mm);
                    ++planned;
                } else {
                    EXPECT_TRUE(plan.shortfall == Shortfall::too_little_room ||
                                std::abs(plan.left) >= target * gram_mm);
                    ++without_room;
                }
            }
        }
    }
    EXPECT_GT(planned, 80);
    EXPECT_GT(without_room, 3);
    // In a hole that is there one alone has no room: it says so rather than that it is too large.
    HoleLimits alone = usual;
    alone.maximum_holes = 1;
    alone.taken = {{1.0, 0.1}};
    const HolePlan none = plan_holes(400 * gram_mm, 1.0, rim, drills, alone, -1.0);
    EXPECT_EQ(none.shortfall, Shortfall::too_little_room);
    EXPECT_TRUE(none.holes.empty());
}

TEST(Plan, TheLastHoleMayLieAtTheLargestAngleAndNoFurther) {
    const double one[] = {drills[0]};
    int checked = 0;
    for (double target = 200.0; target < 12'000.0; target *= 1.17) {
        const auto planned = [&](double maximum_angle) {
            HoleLimits limits = usual;
            limits.maximum_angle = maximum_angle;
            return plan_holes(target * gram_mm, 0.0, rim, one, limits, -1.0);
        };
        const HolePlan free = planned(pi);
        const std::size_t count = free.holes.size();
        if (free.shortfall != Shortfall::none || count < 2) {
            continue;
        }
        const double last = std::abs(std::remainder(free.holes.back().angle, 2.0 * pi));
        const HolePlan wide = planned(last + 1e-6);
        EXPECT_EQ(wide.shortfall, Shortfall::none) << target;
        EXPECT_EQ(wide.holes.size(), count) << target;
        const HolePlan narrow = planned(last - 1e-6);
        EXPECT_TRUE(narrow.shortfall != Shortfall::none || narrow.holes.size() != count) << target;
        for (const Hole& hole : narrow.holes) {
            EXPECT_LT(std::abs(std::remainder(hole.angle, 2.0 * pi)), last) << target;
        }
        checked += count > 2 ? 1 : 0;
    }
    EXPECT_GT(checked, 2);
}

TEST(Plan, RoundsToTheDeepestStepThatHasRoom) {
    HoleLimits limits = usual;
    limits.depth_step = 0.5 * mm;
    const double one[] = {16 * mm};
    int checked = 0;
    for (int angle = 6; angle < 60; ++angle) {
        limits.maximum_angle = angle * degree;
        const HolePlan plan = plan_holes(50'000 * gram_mm, 0.0, rim, one, limits, -1.0);
        ASSERT_EQ(plan.shortfall, Shortfall::too_little_room);
        const double depth = plan.holes.at(0).depth;
        EXPECT_NEAR(std::remainder(depth, limits.depth_step), 0.0, 1e-12);
        if (depth >= limits.maximum_depth) {
            continue;
        }
        const double gaps = 0.5 * (static_cast<double>(plan.holes.size()) - 1.0);
        const auto reach = [&](double at) {
            const auto apart = hole_spacing(rim, one[0], at, limits.minimum_wall);
            return apart ? gaps * *apart : pi;
        };
        EXPECT_LE(reach(depth), limits.maximum_angle) << angle;
        EXPECT_GT(reach(depth + limits.depth_step), limits.maximum_angle) << angle;
        ++checked;
    }
    EXPECT_GT(checked, 10);
}

TEST(Plan, AWholeHoleHasNoRoomAtTheLimitOfASector) {
    HoleLimits limits = usual;
    limits.sector = {-7 * degree, 90 * degree};
    EXPECT_EQ(plan_holes(1000 * gram_mm, limits.sector->first, rim, drills, limits, -1.0).shortfall,
              Shortfall::too_little_room);
    EXPECT_EQ(edge_beyond(rim, {0.0, 2.0 * pi}, {16 * mm, 0.0, 0.0, 0.0, 0.0}), 0.0) << "whole rim";
}

TEST(Plan, KeepsWholeHolesInAnySector) {
    std::mt19937 random(5);
    const auto any = [&](double minimum, double maximum) {
        return std::uniform_real_distribution(minimum, maximum)(random);
    };
    int drilled = 0;
    int many = 0;
    for (int i = 0; i < 200; ++i) {
        HoleLimits limits = usual;
        const double from = any(0.0, 360.0) * degree;
        const double width = any(5.0, 120.0) * degree;
        limits.sector = {from, from + width};
        const double angle = from + any(-0.3, 1.3) * width;
        const double target = any(100.0, 6000.0) * gram_mm;
        for (const HolePlan& plan :
             {plan_holes(target, angle, rim, drills, limits, -1.0),
              plan_beside_sector(target, angle, rim, drills, limits, -1.0)}) {
            many += plan.holes.size() > 1 ? 1 : 0;
            for (const Hole& hole : plan.holes) {
                // By the corners of the hole at its bottom, as far as they are beyond a limit.
                EXPECT_EQ(edge_beyond(rim, *limits.sector, hole), 0.0) << i;
                for (const double turn : {-0.02, 0.02}) {
                    Hole moved = hole;
                    moved.angle += turn;
                    double beyond = 0.0;
                    for (const double side : {-1.0, 1.0}) {
                        const double limit = side < 0.0 ? from : from + width;
                        const auto corner =
                            std::complex(rim.radius - hole.depth, side * 0.5 * hole.diameter) *
                            std::polar(1.0, moved.angle - limit);
                        beyond = std::max(beyond, corner.real() > 0.0 ? side * corner.imag() : 0.0);
                    }
                    EXPECT_NEAR(edge_beyond(rim, *limits.sector, moved), beyond, 1e-9) << i;
                }
                // Half a diameter beside the middle, seen from the axis at the bottom of the hole.
                const double half =
                    std::atan(0.5 * hole.diameter / (rim.radius - hole.depth)) - 1e-7;
                const double place = turn_of(hole.angle - from);
                EXPECT_GE(place, half) << i;
                EXPECT_LE(place, width - half) << i;
                EXPECT_LE(std::abs(std::remainder(hole.angle - angle, 2.0 * pi)),
                          limits.maximum_angle + 1e-12)
                    << i;
                ++drilled;
            }
            EXPECT_LE(plan.left, target * (1.0 + 1e-12)) << i;
        }
    }
    EXPECT_GT(drilled, 100);
    EXPECT_GT(many, 20);
}

TEST(Plan, BesideTheSectorLeavesMinimum) {
    HoleLimits limits = usual;
    limits.maximum_angle = 85 * degree;
    limits.sector = {70 * degree, 140 * degree};
    for (const double angle : {20.0, 55.0, 69.0, 141.0, 170.0, 200.0}) {
        for (const double target : {600.0, 2000.0, 4000.0}) {
            for (const double tolerance : {-1.0, 300.0}) {
                const HolePlan plan =
                    plan_beside_sector(target * gram_mm, angle * degree, rim, drills, limits,
                                       tolerance < 0.0 ? -1.0 : tolerance * gram_mm);
                ASSERT_FALSE(plan.holes.empty()) << angle;
                for (const Hole& hole : plan.holes) {
                    EXPECT_TRUE(limits.allows(hole.angle));
                }
                const auto heavy = std::polar(target * gram_mm, angle * degree);
                EXPECT_NEAR(plan.left, std::abs(heavy - sum_of(plan)), 1e-12);
                EXPECT_EQ(plan.shortfall == Shortfall::none, plan.left <= tolerance * gram_mm);
                // One whole hole of any size, a degree inside the limit, does no better.
                for (double depth = 0.0; depth < limits.maximum_depth; depth += 0.5 * mm) {
                    for (const double drill : drills) {
                        const double inside =
                            1.0 * degree + std::atan(0.5 * drill / (rim.radius - depth));
                        const double at =
                            angle < 100.0 ? 70.0 * degree + inside : 140.0 * degree - inside;
                        const double left =
                            std::abs(heavy - std::polar(rim.removed(drill, depth).unbalance, at));
                        EXPECT_TRUE(plan.shortfall == Shortfall::none || left >= plan.left - 1e-9)
                            << angle << ' ' << target;
                    }
                }
            }
        }
    }
    const auto none_for = [&](double angle) {
        return plan_beside_sector(600 * gram_mm, angle * degree, rim, drills, limits, -1.0)
            .holes.empty();
    };
    EXPECT_TRUE(none_for(250) && none_for(340)) << "a quarter turn away or more";
    EXPECT_FALSE(none_for(200));
    limits.maximum_angle = usual.maximum_angle;
    EXPECT_TRUE(none_for(200)) << "farther from the heavy spot than the limit";
    // A hole that is there at the limit: beside it.
    limits.taken = {{70 * degree, 0.1}};
    EXPECT_GT(plan_beside_sector(600 * gram_mm, 69 * degree, rim, drills, limits, 300 * gram_mm)
                  .holes.at(0)
                  .angle,
              75 * degree);
}

TEST(Plan, SaysWhyItFallsShort) {
    // Within the limit nothing is drilled; what the point alone exceeds cannot be.
    EXPECT_TRUE(plan_holes(90 * gram_mm, 0, rim, drills, usual, 100 * gram_mm).holes.empty());
    const double thick[] = {16 * mm};
    const HolePlan small = plan_holes(50 * gram_mm, 0, rim, thick, usual, -1.0);
    EXPECT_EQ(small.shortfall, Shortfall::nothing_fits);
    EXPECT_TRUE(small.holes.empty());
    const HolePlan great = plan_holes(50'000 * gram_mm, 0, rim, drills, usual, -1.0);
    EXPECT_EQ(great.shortfall, Shortfall::too_little_room);
    EXPECT_GT(great.left, 0.0);
    EXPECT_FALSE(great.holes.empty());
    HoleLimits limits = usual;
    limits.sector = {90 * degree, 200 * degree};
    EXPECT_EQ(plan_holes(500 * gram_mm, 1.0, rim, drills, limits, -1.0).shortfall,
              Shortfall::outside_sector);
    EXPECT_EQ(plan_holes(500 * gram_mm, 2.0, rim, drills, limits, -1.0).shortfall, Shortfall::none);
    // A slug that may not be long enough to outweigh its hole's cone is none.
    limits.maximum_depth = 1 * mm;
    limits.sector.reset();
    const Cut light{rim.radius, rim.density, rim.point_angle, 8500};
    const HolePlan none = plan_holes(500 * gram_mm, 1.0, light, thick, limits, -1.0);
    EXPECT_EQ(none.shortfall, Shortfall::too_little_room);
    EXPECT_TRUE(none.holes.empty());
    limits = usual;
    limits.sector = {90 * degree, 200 * degree};
    // At its two ends a hole is as near as it has room.
    for (const double end : {90 * degree, 200 * degree}) {
        const HolePlan one = plan_beside_sector(200 * gram_mm, end, rim, drills, limits, -1.0);
        ASSERT_EQ(one.holes.size(), 1U);
        EXPECT_NEAR(std::abs(one.holes[0].angle - end),
                    std::atan(0.5 * one.holes[0].diameter / (rim.radius - one.holes[0].depth)),
                    1.0 * degree);
    }
    // A sector over the zero mark.
    limits.sector = {300 * degree, 40 * degree};
    EXPECT_EQ(plan_holes(500 * gram_mm, 0.1, rim, drills, limits, -1.0).shortfall, Shortfall::none);
    limits = usual;
    limits.depth_step = 5 * mm;
    EXPECT_EQ(plan_holes(1000 * gram_mm, 0, rim, thick, limits, 1 * gram_mm).shortfall,
              Shortfall::rounding);
}

}  // namespace
}  // namespace ravnoves::bob_weights
