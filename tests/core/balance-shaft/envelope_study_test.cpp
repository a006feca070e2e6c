#include "balance-shaft/envelope_study.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "balance-shaft/presets.h"

namespace ravnoves::balance_shaft {
namespace {

TEST(EnvelopeStudyTest, MirrorsAboutTheCylinderAxis) {
    const EnvelopeStudy study = envelope_study(Solver(preset_tmz_650d()), 360);
    for (std::size_t i = 1; i < 360; ++i) {
        EXPECT_NEAR(study.width[i], study.width[360 - i], 1e-12);
        EXPECT_NEAR(study.height[i], study.height[360 - i], 1e-12);
    }
    // The shaft beside the crank makes the engine widest; below it, tallest.
    const auto widest = std::max_element(study.width.begin(), study.width.end());
    EXPECT_NEAR(study.shaft_angle_deg[static_cast<std::size_t>(widest - study.width.begin())], 90.0,
                1e-9);
    const auto tallest = std::max_element(study.height.begin(), study.height.end());
    EXPECT_NEAR(study.shaft_angle_deg[static_cast<std::size_t>(tallest - study.height.begin())],
                180.0, 1e-9);
}

TEST(EnvelopeStudyTest, EfficientAnglesAreThoseThatNothingBeats) {
    const Solver solver(preset_tmz_650d());
    const EnvelopeStudy study = envelope_study(solver, 240);
    int efficient = 0;
    for (std::size_t i = 0; i < 240; ++i) {
        EXPECT_EQ(study.buildable[i],
                  solver.buildable().contains(study.shaft_angle_deg[i] * degree));
        EXPECT_TRUE(study.buildable[i] || !study.efficient[i]) << study.shaft_angle_deg[i];
        bool beaten = false;
        for (std::size_t j = 0; j < 240; ++j) {
            beaten = beaten || (study.buildable[j] && study.area[j] < study.area[i] &&
                                study.range[j] < study.range[i]);
        }
        if (study.efficient[i]) {
            EXPECT_FALSE(beaten) << study.shaft_angle_deg[i];
            ++efficient;
        }
    }
    EXPECT_GT(efficient, 1);
    // The smallest range of what can be built is always among them.
    std::size_t minimum = 240;
    for (std::size_t i = 0; i < 240; ++i) {
        if (study.buildable[i] && (minimum == 240 || study.range[i] < study.range[minimum])) {
            minimum = i;
        }
    }
    ASSERT_LT(minimum, 240U);
    EXPECT_TRUE(study.efficient[minimum]);
}

}  // namespace
}  // namespace ravnoves::balance_shaft
