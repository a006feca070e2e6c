#include "numerics/harmonics.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "numerics/constants.h"
#include "numerics/slider_crank.h"

namespace ravnoves {
namespace {

using Decimal50 = boost::multiprecision::cpp_bin_float_50;

/// Orders of −s″/R.
template <typename Scalar>
std::vector<Harmonic<Scalar>> piston_orders(const SliderCrank<Scalar>& crank, int max_order,
                                            std::size_t samples) {
    const UniformTransform<Scalar> transform(samples);
    std::vector<Scalar> values(samples);
    for (std::size_t j = 0; j < samples; ++j) {
        values[j] =
            -crank.at(transform.node_sin()[j], transform.node_cos()[j]).d2s / crank.crank_radius;
    }
    return transform.orders(values, max_order);
}

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

// Exact order amplitudes for a centred and an offset mechanism (times m r ω²).
TEST(UniformTransform, PublishedOrdersOfThePistonAcceleration) {
    const auto centred = piston_orders(SliderCrank<double>{0.300, 1.000, 0.0}, 6, 64);
    EXPECT_NEAR(centred[2].cos, 0.307050659, 5e-10);
    EXPECT_NEAR(centred[4].cos, -0.007237695, 5e-10);
    EXPECT_NEAR(centred[6].cos, 0.000191937, 5e-10);
    const auto offset = piston_orders(SliderCrank<double>{0.050, 0.150, 0.0125}, 4, 64);
    EXPECT_NEAR(offset[1].sin, 0.0874317, 5e-8);
    EXPECT_NEAR(offset[2].cos, 0.3471724, 5e-8);
    EXPECT_NEAR(offset[3].sin, -0.0118560, 5e-8);
    EXPECT_NEAR(offset[4].cos, -0.0107052, 5e-8);
    // Symmetry: an offset mechanism has odd orders in the sine and even ones in the cosine only.
    for (std::size_t k = 2; k <= 4; ++k) {
        EXPECT_NEAR(k % 2 == 0 ? offset[k].sin : offset[k].cos, 0.0, 1e-15);
    }
    EXPECT_NEAR(offset[1].cos, 1.0, 1e-15);
}

// The chosen length keeps the tolerance over the whole range of λ and K, against 50 digits with
// twice the length, which shares no rounding and folds far less.
TEST(TransformLengthTest, KeepsTheAccuracyAskedUpToNearLocking) {
    constexpr int max_order = 12;
    for (const double tolerance : {1e-6, 1e-12}) {
        for (const double lambda : {0.01, 0.1, 0.265, 0.5, 0.8, 0.95, 0.99}) {
            for (const double k : {0.0, 0.05, 0.278, 0.9}) {
                const SliderCrank<double> crank{1.0, 1.0 / lambda, k};
                if (crank.locks()) {
                    continue;
                }
                const auto length = transform_length(crank.harmonic_decay(), max_order, tolerance);
                ASSERT_TRUE(length.sufficient);
                const auto found = piston_orders(crank, max_order, length.samples);
                const SliderCrank<Decimal50> exact{1, crank.rod_length, crank.offset};
                const auto reference = piston_orders(exact, max_order, 2 * length.samples);
                for (std::size_t i = 1; i <= max_order; ++i) {
                    EXPECT_NEAR(found[i].cos, static_cast<double>(reference[i].cos), tolerance)
                        << lambda << " " << k << " order " << i << " n " << length.samples;
                    EXPECT_NEAR(found[i].sin, static_cast<double>(reference[i].sin), tolerance);
                }
            }
        }
    }
}

TEST(TransformLengthTest, IsShortForRealEnginesAndSaysWhenItIsCut) {
    const SliderCrank<double> vr5{45.0, 45.0 / 0.265, 12.5};
    EXPECT_LE(transform_length(vr5.harmonic_decay(), 12, 1e-13).samples, 64U);
    EXPECT_GE(transform_length(50.0, 12, 1e-13).samples, 26U);
    EXPECT_TRUE(transform_length(9e-5, 12, 1e-13).sufficient);
    EXPECT_FALSE(transform_length(1e-6, 12, 1e-13).sufficient);
    EXPECT_FALSE(transform_length(0.0, 12, 1e-13).sufficient);
    EXPECT_EQ(transform_length(1e-6, 12, 1e-13, 1024).samples, 1024U);
}

}  // namespace
}  // namespace ravnoves
