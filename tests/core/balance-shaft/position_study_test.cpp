#include "balance-shaft/position_study.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>

#include "test_cases.h"

namespace ravnoves::balance_shaft::test {

namespace {

TEST(PositionStudyTest, thePapersEngineHasTheseBestPlaces) {
    const Solver solver(preset_tmz_650d());
    const PositionStudy study(solver);
    const BestPositions best = study.best();
    ASSERT_TRUE(best.range && best.rms);
    EXPECT_NEAR(best.range->position.centre_distance() / units::mm, 108.20975, 5e-6);
    EXPECT_NEAR(best.range->position.shaft_angle() / degree, 53.10975, 5e-6);
    EXPECT_NEAR(best.range->criteria.range, 1063.504264, 5e-7);
    EXPECT_LE(best.range->gap, 1e-10);
    EXPECT_NEAR(best.rms->position.centre_distance() / units::mm, 36.950446, 5e-7);
    EXPECT_NEAR(best.rms->position.shaft_angle() / degree, 11.758583, 5e-7);
    EXPECT_NEAR(best.rms->criteria.rms, 180.519414517, 5e-10);
}

TEST(PositionStudyTest, zzSpeed) {
    for (const std::size_t rows : {49, 49, 721, 721}) {
        Input input = preset_tmz_650d();
        if (rows != 49) {
            input.torque.table = random_table(3, rows);
        }
        const Solver solver(input);
        const auto t0 = std::chrono::steady_clock::now();
        const PositionStudy study(solver);
        const auto t1 = std::chrono::steady_clock::now();
        const BestPositions best = study.best();
        const auto t2 = std::chrono::steady_clock::now();
        const PositionMap map = study.map(-0.25, 0.25, -0.25, 0.25, 200, 200);
        const auto t3 = std::chrono::steady_clock::now();
        const auto us = [](auto d) { return std::chrono::duration<double, std::micro>(d).count(); };
        double worst = 0.0;
        for (std::size_t i = 0; i < map.range.size(); i += 7) {
            const std::size_t row = i / 200, column = i % 200;
            const ShaftPosition at{-0.25 + 0.5 * static_cast<double>(column) / 199,
                                   -0.25 + 0.5 * static_cast<double>(row) / 199};
            worst = std::max(worst, std::abs(map.range[i] - study.at(at).range));
        }
        const auto t4 = std::chrono::steady_clock::now();
        const BestPositions built = study.best_buildable();
        const auto t5 = std::chrono::steady_clock::now();
        const auto front = study.front();
        const auto t6 = std::chrono::steady_clock::now();
        std::vector<int> seen(6);
        for (int i = 0; i < 40000; ++i) {
            ++seen[static_cast<std::size_t>(
                study.obstacle({-0.25 + 0.0025 * (i % 200), -0.25 + 0.0025 * (i / 200)}))];
        }
        const auto t7 = std::chrono::steady_clock::now();
        std::printf("buildable %.0f us: range %.9f at %.6f mm %.6f deg gap %g; rms %.9f at %.6f mm %.6f gap %g\n",
                    us(t5 - t4), built.range->criteria.range, built.range->position.centre_distance() * 1e3,
                    built.range->position.shaft_angle() / degree, built.range->gap,
                    built.rms->criteria.rms, built.rms->position.centre_distance() * 1e3,
                    built.rms->position.shaft_angle() / degree, built.rms->gap);
        std::printf("front %zu in %.0f us; obstacles %.0f us: %d %d %d %d %d %d\n", front.size(), us(t6 - t5),
                    us(t7 - t6), seen[0], seen[1], seen[2], seen[3], seen[4], seen[5]);
        if (rows == 49) {
            for (const auto& p : front) {
                std::printf("  %.4f %.4f: %.5f %.5f %.7f\n", p.position.centre_distance() * 1e3,
                            p.position.shaft_angle() / degree, p.criteria.range, p.criteria.rms, p.criteria.size);
            }
        }
        std::printf("%zu rows: prepare %.1f best %.1f (gap %.3g) map %.0f us, off %.3g\n", rows,
                    us(t1 - t0), us(t2 - t1), best.range->gap, us(t3 - t2), worst);
    }
}

}  // namespace

}  // namespace ravnoves::balance_shaft::test
