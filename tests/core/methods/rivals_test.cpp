/// Methods that rival the ones in use: that they are what they are called, and what they reach.

#include <gtest/gtest.h>

#include <cmath>

#include "support.h"

namespace ravnoves::methods {
namespace {

TEST(RivalSamples, ErrorsFallAtTheirRates) {
    const auto order = [&](const char* sweep, double value, const char* method) {
        const bool chance = std::string(method) == "monte-carlo";
        return std::log(error_of("scatter", sweep, value, method, "64 samples") /
                        error_of("scatter", sweep, value, method,
                                 chance ? "8192 samples" : "4096 samples")) /
               std::log(chance ? 128.0 : 64.0);
    };
    EXPECT_NEAR(order("scatter", 0.01, "monte-carlo"), 0.5, 0.15);
    EXPECT_NEAR(order("corner", -0.5, "monte-carlo"), 0.5, 0.15);
    EXPECT_GT(order("scatter", 0.01, "sobol"), 0.9);
    EXPECT_GT(order("jump", 0.8, "sobol"), 0.6);
    EXPECT_GT(order("corner", -0.5, "sobol"), 0.9);
}

}  // namespace
}  // namespace ravnoves::methods
