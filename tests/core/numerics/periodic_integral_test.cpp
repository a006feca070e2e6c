#include "numerics/periodic_integral.h"

#include <gtest/gtest.h>

#include <cmath>

#include "numerics/constants.h"

namespace ravnoves {
namespace {

TEST(PeriodicIntegral, ErrorFallsWithTheSixthPowerOfTheStep) {
    // ∫ cos x exp(sin x) = exp(sin x) − 1
    double before = 0.0;
    for (const std::size_t n : {24U, 48U, 96U}) {
        const double step = two_pi / static_cast<double>(n);
        std::vector<double> samples(n);
        for (std::size_t i = 0; i < n; ++i) {
            const double x = step * static_cast<double>(i);
            samples[i] = std::cos(x) * std::exp(std::sin(x));
        }
        const auto integral = cumulative_periodic_integral(samples, step);
        ASSERT_EQ(integral.size(), n + 1);
        double error = 0.0;
        for (std::size_t i = 0; i <= n; ++i) {
            const double x = step * static_cast<double>(i);
            error = std::max(error, std::abs(integral[i] - (std::exp(std::sin(x)) - 1.0)));
        }
        if (before > 0.0) {
            EXPECT_NEAR(std::log2(before / error), 6.0, 0.4);
        }
        before = error;
    }
    EXPECT_LT(before, 5e-8);
}

TEST(PeriodicIntegral, TooFewSamplesAreRejected) {
    EXPECT_THROW(cumulative_periodic_integral(std::vector<double>(5), 1.0), std::logic_error);
}

}  // namespace
}  // namespace ravnoves
