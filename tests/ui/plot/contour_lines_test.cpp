#include "plot/model/contour_lines.h"

#include <gtest/gtest.h>

#include <QPainterPath>
#include <cmath>
#include <limits>
#include <numbers>

namespace ravnoves {
namespace {

/// f over a square grid of places −1…1.
template <typename Function>
std::vector<double> grid(std::size_t points, const Function& f) {
    std::vector<double> values;
    const auto at = [&](std::size_t i) {
        return -1.0 + 2.0 * static_cast<double>(i) / static_cast<double>(points - 1);
    };
    for (std::size_t row = 0; row < points; ++row) {
        for (std::size_t column = 0; column < points; ++column) {
            values.push_back(f(at(column), at(row)));
        }
    }
    return values;
}

double area(const QPolygonF& line) {
    double sum = 0.0;
    for (qsizetype i = 0; i + 1 < line.size(); ++i) {
        sum += line[i].x() * line[i + 1].y() - line[i + 1].x() * line[i].y();
    }
    return std::abs(sum / 2.0);
}

constexpr std::size_t points = 81;
constexpr double scale = 2.0 / (points - 1);  // of a step

TEST(ContourLines, OfAParaboloidIsOneCircle) {
    const auto values = grid(points, [](double x, double y) { return x * x + y * y; });
    const auto lines = contourLines({values, points, points}, 0.49);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0].front(), lines[0].back());
    for (const QPointF& point : lines[0]) {
        EXPECT_NEAR(std::hypot(point.x() * scale - 1.0, point.y() * scale - 1.0), 0.7, 2e-4);
    }
    EXPECT_NEAR(area(lines[0]) * scale * scale, 0.49 * std::numbers::pi, 2e-3);
}

TEST(ContourLines, ThatLeaveTheGridAreOpen) {
    const auto values = grid(points, [](double x, double y) { return x + 0.3 * y; });
    const auto lines = contourLines({values, points, points}, 0.101);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0].size(), static_cast<qsizetype>(points) + 24);  // rows, and columns crossed
    for (const QPointF& point : lines[0]) {
        EXPECT_NEAR(point.x() * scale - 1.0 + 0.3 * (point.y() * scale - 1.0), 0.101, 1e-12);
    }
    EXPECT_TRUE(contourLines({values, points, points}, 9.0).empty());
}

TEST(ContourLines, CrosswiseCornersGoByTheirMean) {
    const std::vector<double> high{1.0, 0.0, 0.0, 1.1};
    const std::vector<double> low{1.0, 0.0, 0.0, 0.9};
    // 0.5 lies below the mean of the first: its high corners hang together.
    const auto joined = contourLines({high, 2, 2}, 0.5);
    const auto apart = contourLines({low, 2, 2}, 0.5);
    ASSERT_EQ(joined.size(), 2U);
    ASSERT_EQ(apart.size(), 2U);
    const auto cuts = [](const std::vector<QPolygonF>& lines, const QPointF& corner) {
        for (const QPolygonF& line : lines) {
            const QPointF middle = 0.5 * (line.front() + line.back());
            const QPointF away = middle - corner;
            if (std::hypot(away.x(), away.y()) < 0.5) {
                return true;
            }
        }
        return false;
    };
    EXPECT_TRUE(cuts(joined, {1, 0}));
    EXPECT_FALSE(cuts(joined, {0, 0}));
    EXPECT_TRUE(cuts(apart, {0, 0}));
    EXPECT_FALSE(cuts(apart, {1, 0}));
}

TEST(ContourRegion, HoldsWhatIsAtTheLevelAndNothingElse) {
    // A ring, and a corner that reaches the grid's edge.
    const auto f = [](double x, double y) {
        const double r = std::hypot(x, y);
        return std::max(0.2 - std::abs(r - 0.5), x + y - 1.5);
    };
    const auto values = grid(points, f);
    QPainterPath region;
    const auto crossing = [&](std::size_t from, std::size_t to) {
        return values[from] / (values[from] - values[to]);
    };
    for (const QPolygonF& line : contourRegion({values, points, points}, 0.0, crossing)) {
        EXPECT_EQ(line.front(), line.back());
        region.addPolygon(line);
    }
    int inside = 0;
    for (int i = 0; i < 4000; ++i) {
        const double x = -0.99 + 1.98 * std::fmod(i * 0.618034, 1.0);
        const double y = -0.99 + 1.98 * i / 4000.0;
        if (std::abs(f(x, y)) > 0.01) {
            const bool is = region.contains(QPointF((x + 1.0) / scale, (y + 1.0) / scale));
            EXPECT_EQ(is, f(x, y) > 0.0) << x << " " << y;
            inside += is ? 1 : 0;
        }
    }
    EXPECT_GT(inside, 500);
}

TEST(ContourRegion, TakesItsEdgesFromWhoKnowsThemBetter) {
    // Yes and no alone: the edge is where it is asked for.
    const auto values = grid(21, [](double x, double /*y*/) { return x > 0.33 ? 1.0 : 0.0; });
    const auto crossing = [](std::size_t from, std::size_t to) {
        EXPECT_EQ(to, from + 1);
        const double left = -1.0 + 0.1 * static_cast<double>(from % 21);
        return (0.33 - left) / 0.1;
    };
    const auto region = contourRegion({values, 21, 21}, 0.5, crossing);
    ASSERT_EQ(region.size(), 1U);
    EXPECT_NEAR(region[0].boundingRect().left(), 13.3, 1e-9);
    EXPECT_NEAR(region[0].boundingRect().right(), 20.0, 1e-9);
    EXPECT_NEAR(region[0].boundingRect().height(), 20.0, 1e-9);
}

TEST(ContourLines, WhatIsNoNumberIsBelow) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<double> values{1.0, 1.0, 1.0, 1.0, nan, 1.0, 1.0, 1.0, 1.0};
    const auto lines = contourLines({values, 3, 3}, 0.5);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_NEAR(area(lines[0]), 0.5, 1e-12);
}

}  // namespace
}  // namespace ravnoves
