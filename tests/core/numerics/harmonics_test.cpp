#include "numerics/harmonics.h"

#include <gtest/gtest.h>

#include "numerics/constants.h"
#include "numerics/slider_crank.h"

namespace ravnoves {
namespace {

TEST(UniformTransform, FindsTheOrdersOfATrigonometricPolynomial) {
    for (const std::size_t n : {9U, 10U, 11U, 64U, 101U}) {
        const UniformTransform<double> transform(n);
        std::vector<double> values(n);
        for (std::size_t j = 0; j < n; ++j) {
            const double phi = two_pi * static_cast<double>(j) / static_cast<double>(n);
            values[j] = 3.0 + 2.0 * std::cos(phi) - std::sin(3.0 * phi) + 0.5 * std::cos(4.0 * phi);
        }
        const auto orders = transform.orders(values, 4);
        EXPECT_NEAR(orders[0].cos, 3.0, 1e-14);
        EXPECT_NEAR(orders[1].cos, 2.0, 1e-14);
        EXPECT_NEAR(orders[1].sin, 0.0, 1e-14);
        EXPECT_NEAR(orders[2].cos, 0.0, 1e-14);
        EXPECT_NEAR(orders[3].sin, -1.0, 1e-14);
        EXPECT_NEAR(orders[4].cos, 0.5, 1e-14);
    }
}

TEST(TransformLengthTest, IsShortForRealEnginesAndNeverEndless) {
    const SliderCrank<double> vr5{45.0, 45.0 / 0.265, 12.5};
    EXPECT_LE(transform_length(vr5.harmonic_decay(), 12, 1e-13), 64U);
    EXPECT_GE(transform_length(50.0, 12, 1e-13), 26U);
    for (const double decay : {1e-6, 0.0}) {
        EXPECT_EQ(transform_length(decay, 12, 1e-13), 1U << 20U);
    }
}

}  // namespace
}  // namespace ravnoves
