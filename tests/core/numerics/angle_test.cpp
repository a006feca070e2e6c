#include <gtest/gtest.h>

#include <limits>

#include "numerics/angle.h"

namespace ravnoves {
namespace {

TEST(Angle, IsWrappedIntoOneTurn) {
    EXPECT_EQ(wrap(725.5, 720.0), 5.5);
    EXPECT_EQ(wrap(720.0, 720.0), 0.0);
    EXPECT_EQ(wrap(-0.25, 360.0), 359.75);
    EXPECT_EQ(wrap(-1080.0, 360.0), 0.0);
    // An angle just below 0 rounds to the whole turn, which is 0 again.
    EXPECT_EQ(wrap(-1e-20, 360.0), 0.0);
    EXPECT_EQ(wrap_turn(-std::numeric_limits<double>::denorm_min()), 0.0);
    // 2^60 is far beyond where angle − 360 ⌊angle / 360⌋ has digits left.
    EXPECT_EQ(wrap(0x1p60, 360.0), 136.0);
    EXPECT_DOUBLE_EQ(wrap_turn(-pi / 2.0), 1.5 * pi);
}

}  // namespace
}  // namespace ravnoves
