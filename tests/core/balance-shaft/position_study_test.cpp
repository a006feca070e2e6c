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
        std::printf("%zu rows: prepare %.1f best %.1f (gap %.3g) map %.0f us, off %.3g\n", rows,
                    us(t1 - t0), us(t2 - t1), best.range->gap, us(t3 - t2), worst);
    }
}

}  // namespace

}  // namespace ravnoves::balance_shaft::test
