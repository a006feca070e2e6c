#include <gtest/gtest.h>

#include <cmath>

#include "bob-weights/matching.h"
#include "numerics/constants.h"

namespace ravnoves::bob_weights {
namespace {

shop::Crank crank_with(const shop::WeighIn& sheet) {
    Input input;
    input.engine.bank_angle = 90 * degree;
    input.weigh_in = sheet;
    return crank_of(input);
}

TEST(Crank, OfAVEightHasItsPinsCrosswise) {
    const shop::Crank crank = crank_with({});
    ASSERT_EQ(crank.angles.size(), 4U);
    const double turned[] = {0.0, 0.5 * pi, 1.5 * pi, pi};
    for (std::size_t pin = 0; pin < 4; ++pin) {
        EXPECT_NEAR(crank.angles[pin], turned[pin], 1e-15);
    }
    // Static balance, and a couple that a weight at each end takes up.
    EXPECT_NEAR(std::cos(crank.angles[0]) + std::cos(crank.angles[3]), 0.0, 1e-15);
    shop::WeighIn sheet;
    sheet.matching.crankpin_angles_deg = {0, 180, 180, 0};
    EXPECT_NEAR(crank_with(sheet).angles[1], pi, 1e-15);
}

TEST(Crank, HasItsPinsByBothNumberings) {
    using shop::CylinderNumbering;
    shop::WeighIn sheet;
    for (const auto& [numbering, other] :
         {std::pair(CylinderNumbering::bank_by_bank, 5), {CylinderNumbering::alternating, 2}}) {
        sheet.numbering = numbering;
        const auto places = places_of(crank_with(sheet));
        EXPECT_EQ(places[static_cast<std::size_t>(other)].crankpin, 1);
        EXPECT_EQ(places[numbering == CylinderNumbering::alternating ? 3 : 1].crankpin, 1);
    }
}

}  // namespace
}  // namespace ravnoves::bob_weights
