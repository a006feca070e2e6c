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
                const auto found = piston_orders(crank, max_order, length);
                const SliderCrank<Decimal50> exact{1, crank.rod_length, crank.offset};
                const auto reference = piston_orders(exact, max_order, 2 * length);
                for (std::size_t i = 1; i <= max_order; ++i) {
                    EXPECT_NEAR(found[i].cos, static_cast<double>(reference[i].cos), tolerance)
                        << lambda << " " << k << " order " << i << " n " << length;
                    EXPECT_NEAR(found[i].sin, static_cast<double>(reference[i].sin), tolerance);
                }
            }
        }
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
