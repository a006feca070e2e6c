#include "balance-shaft/shaft_places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "test_cases.h"

namespace ravnoves::balance_shaft::test {

namespace {

/// Anywhere in a polygon: a mean of its corners.
Eigen::Vector2d within(const PlacePolygon& polygon, std::mt19937& random) {
    std::exponential_distribution<double> weight(1.0);
    Eigen::Vector2d sum(0.0, 0.0);
    double all = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const double part = weight(random);
        sum += part * polygon[i];
        all += part;
    }
    return sum / all;
}

TEST(ShaftPlacesTest, nothingCanBeBuiltInWhatIsCutOff) {
    const Solver solver(preset_tmz_650d());
    const ShaftPlaces places(solver.front_view(), {});
    std::mt19937 random(7);
    std::uniform_real_distribution<double> coordinate(-0.15, 0.2);
    std::uniform_real_distribution<double> side(0.001, 0.06);
    std::uniform_real_distribution<double> angle(0.0, two_pi);
    int empty = 0;
    int cut_off = 0;
    for (int i = 0; i < 4000; ++i) {
        const Eigen::Vector2d middle(coordinate(random), coordinate(random));
        const Eigen::Vector2d half(side(random), side(random));
        const Eigen::AlignedBox2d rectangle(middle - half, middle + half);
        PlacePolygon part(rectangle);
        const double alpha = angle(random);
        const Eigen::Vector2d normal(std::cos(alpha), std::sin(alpha));
        part.cut({normal, normal.dot(middle) - 0.3 * half.norm()});
        const auto cuts = places.find_cuts(rectangle);
        empty += cuts ? 0 : 1;
        for (int k = 0; k < 20; ++k) {
            const Eigen::Vector2d at = within(part, random);
            const bool is_cut =
                !cuts || std::ranges::any_of(cuts->outer, [&](const HalfPlane& line) {
                    return line.normal.dot(at) < line.minimum;
                });
            cut_off += is_cut ? 1 : 0;
            if (is_cut) {
                ASSERT_NE(places.obstacle(at.x(), at.y()), Obstacle::none) << at.transpose();
            }
        }
    }
    EXPECT_GT(empty, 50);
    EXPECT_GT(cut_off, 1000);
}

/// What is left out would be taken for what nothing can be built in.
TEST(ShaftPlacesTest, aPolygonLosesNothingThatItHasNoRoomFor) {
    PlacePolygon polygon({Eigen::Vector2d(-2.0, -2.0), Eigen::Vector2d(2.0, 2.0)});
    constexpr int sides = 40;
    for (int i = 0; i < sides; ++i) {
        const double angle = two_pi * i / sides;
        polygon.cut({{std::cos(angle), std::sin(angle)}, -1.0});
    }
    // The circle that all lines touch lies within.
    for (int i = 0; i < 1000; ++i) {
        const Eigen::Vector2d at(std::cos(two_pi * i / 1000), std::sin(two_pi * i / 1000));
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            const Eigen::Vector2d from = polygon[k];
            const Eigen::Vector2d along = polygon[k + 1 < polygon.size() ? k + 1 : 0] - from;
            EXPECT_GE(along.x() * (at.y() - from.y()) - along.y() * (at.x() - from.x()), -1e-12);
        }
    }
}

TEST(RodSweepTest, theNearestRodIsThatOfBruteForce) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> coordinate(-0.15, 0.35);
    for (int i = 0; i < 300; ++i) {
        Input input = preset_tmz_650d();
        input.cylinder.rod_length = 0.150;
        input.cylinder.offset = 0.012 * (i % 3 - 1);
        const FrontView view = front_view(input);
        const RodSweep rods(view);
        const SliderCrank<double> crank = view.crank();
        const double x = coordinate(random);
        const double y = coordinate(random);
        const Eigen::Vector2d place(x, y);
        const RodSweep::Nearest found = rods.nearer_than(place, 1e3).value();
        double minimum = 1e300;
        constexpr int angles = 20000;
        for (int k = 0; k < angles; ++k) {
            const double theta = two_pi * k / angles;
            const double pin_x = crank.crank_radius * std::sin(theta);
            const double pin_y = crank.crank_radius * std::cos(theta);
            const Eigen::Vector2d along(crank.offset - pin_x, crank.at(theta).s - pin_y);
            const Eigen::Vector2d to(x - pin_x, y - pin_y);
            const double t = std::clamp(to.dot(along) / along.squaredNorm(), 0.0, 1.0);
            minimum = std::min(minimum, (to - t * along).squaredNorm());
        }
        // Beside the nearest of the angles the square is less by no more than the second order.
        EXPECT_LE(found.distance * found.distance, minimum + 1e-15);
        EXPECT_GE(found.distance * found.distance, minimum - 1e-8);
        EXPECT_NEAR((found.place - place).norm(), found.distance, 1e-12);
        EXPECT_FALSE(rods.nearer_than(place, found.distance));
    }
}

}  // namespace

}  // namespace ravnoves::balance_shaft::test
