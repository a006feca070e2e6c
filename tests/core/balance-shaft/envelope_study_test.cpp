#include "balance-shaft/position_study.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "balance-shaft/presets.h"

namespace ravnoves::balance_shaft {
namespace {

TEST(EnvelopeStudyTest, MirrorsAboutTheCylinderAxis) {
    const EnvelopeStudy study = envelope_study(Solver(preset_tmz_650d()));
    for (std::size_t i = 1; i < 720; ++i) {
        EXPECT_NEAR(study.width[i], study.width[720 - i], 1e-12);
        EXPECT_NEAR(study.height[i], study.height[720 - i], 1e-12);
    }
    // The shaft beside the crank makes the engine widest; below it, tallest.
    const auto widest = std::max_element(study.width.begin(), study.width.end());
    EXPECT_NEAR(study.shaft_angle_deg[static_cast<std::size_t>(widest - study.width.begin())], 90.0,
                1e-9);
    const auto tallest = std::max_element(study.height.begin(), study.height.end());
    EXPECT_NEAR(study.shaft_angle_deg[static_cast<std::size_t>(tallest - study.height.begin())],
                180.0, 1e-9);
}

// At 200, 220 and 250 mm the boxes of ±α differ by rounding, their ranges do not.
TEST(EnvelopeStudyTest, EfficientAnglesAreThoseThatNothingBeats) {
    Input input = preset_tmz_650d();
    for (const double distance : {0.10015, 0.2, 0.22, 0.25}) {
        input.centre_distance = distance;
        if (distance > 0.15) {
            input.envelope.shaft_swing_radius = 0.02;
            input.envelope.crank_swing_radius = 0.05;
        }
        const Solver solver(input);
        const EnvelopeStudy study = envelope_study(solver);
        const auto beats = [&](std::size_t j, std::size_t i) {
            constexpr double same = 1.0 + 1e-12;
            return study.area[j] <= study.area[i] * same &&
                   study.range[j] <= study.range[i] * same &&
                   (study.area[j] * same < study.area[i] || study.range[j] * same < study.range[i]);
        };
        int efficient = 0;
        for (std::size_t i = 0; i < study.area.size(); ++i) {
            EXPECT_EQ(study.buildable[i],
                      solver.buildable().contains(study.shaft_angle_deg[i] * degree));
            bool beaten = !study.buildable[i];
            bool equalled = false;
            for (std::size_t j = 0; j < study.area.size(); ++j) {
                beaten = beaten || (study.buildable[j] && beats(j, i));
                equalled = equalled || (study.efficient[j] && j != i && !beats(i, j) &&
                                        study.range[j] <= study.range[i] * (1.0 + 1e-12) &&
                                        study.area[j] <= study.area[i] * (1.0 + 1e-12));
            }
            EXPECT_EQ(study.efficient[i], !beaten && !equalled) << study.shaft_angle_deg[i];
            efficient += study.efficient[i] ? 1 : 0;
        }
        EXPECT_GT(efficient, distance < 0.15 ? 1 : 0);
    }
}

}  // namespace
}  // namespace ravnoves::balance_shaft
