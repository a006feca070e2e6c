/// Where methods fail, and that the program then says so instead of printing a number.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "methods/kernel.h"
#include "support.h"

namespace ravnoves::methods {
namespace {

TEST(Stability, TheLastSettingOfAMethodIsItsFinest) {
    for (const Kernel& kernel : kernels()) {
        const auto problem = kernel.problem(0, kernel.sweeps[0].present);
        for (std::size_t method = 0; method < kernel.methods.size(); ++method) {
            const MethodInfo& info = kernel.methods[method];
            double minimum = std::numeric_limits<double>::infinity();
            Result result;
            for (std::size_t setting = 0; setting < info.settings.size(); ++setting) {
                result = evaluate(problem, method, setting);
                minimum = result.rejected() ? minimum : std::min(minimum, result.error);
            }
            if (std::isfinite(minimum)) {
                EXPECT_LE(result.error, 3.0 * minimum + 1e-15) << kernel.id << ", " << info.id;
            }
        }
    }
}

/// What the limits of the methods say, in numbers.
TEST(Stability, ErrorsAreWhatTheLimitsOfTheMethodsSay) {
    constexpr double any = std::numeric_limits<double>::infinity();
    const struct {
        const char *kernel, *sweep;
        double value;
        const char *method, *setting;
        double at_least, less_than = any;
    } all[] = {
        // The series has three digits at one half and none near locking.
        {"slider-crank", "locking", 0.75, "series", "4 terms", 0.0, 2e-5},
        {"slider-crank", "locking", 0.5, "series", "4 terms", 1e-3},
        {"slider-crank", "locking", 0.0001, "series", "10 terms", 0.9},
        // Float loses the angle.
        {"slider-crank", "locking", 0.735, "exact", "float", 1e-8},
        // A short transform folds high orders onto low ones.
        {"inertia-orders", "locking", 0.75, "transform", "32 points", 0.0, 1e-12},
        {"inertia-orders", "locking", 0.1, "transform", "32 points", 1e-4},
        {"inertia-orders", "locking", 0.0001, "transform", "512 points", 1e-5},
        {"inertia-orders", "offset", 0.0036, "transform", "64 points", 1e-5},
        {"inertia-orders", "locking", 0.0001, "transform-by-accuracy", "1e-13", 0.0, 1e-12},
        // As near to locking as the scene takes it.
        {"inertia-orders", "locking", 1e-6, "transform-by-accuracy", "1e-13", 0.0, 1e-11},
        {"inertia-orders", "locking", 1e-8, "transform-by-accuracy", "1e-13", 0.0, 1e-11},
        {"inertia-orders", "locking", 5e-9, "transform-by-accuracy", "1e-13", 0.0, 1e-11},
        // Few nodes miss a narrow peak: here 500 N·m and 0.05° wide, between nodes 1° apart.
        {"cycle-mean", "peak-width", 0.2, "trapezoid", "144 steps", 1e-4},
        {"cycle-mean", "peak-width", 0.2, "exact", "pieces", 0.0, 1e-14},
        {"moment-range", "peak-width", 0.05, "nodes", "1°", 0.1},
        {"moment-range", "peak-width", 0.05, "nodes", "5°", 0.1},
        {"moment-range", "peak-width", 0.05, "exact", "pieces", 0.0, 1e-14},
        // The differential equation is singular where the closed form is not.
        {"guide", "preload", 1e-12, "closed-form", "free of cancellation", 0.0, 1e-8},
        {"guide", "preload", 1e-12, "rk4", "3600 steps", 1e-6},
        {"guide", "preload", 1e-12, "dormand-prince", "1e-12", 1e-6},
        {"guide", "preload", 1.0, "rk4", "3600 steps", 0.0, 1e-7},
        {"guide", "preload", 1.0, "dormand-prince", "1e-12", 0.0, 1e-7},
        // The printed form loses its digits with the relief.
        {"guide", "stiffness-preloaded", 1e7, "printed-form", "(3)", 0.0, 1e-10},
        {"guide", "stiffness-preloaded", 1e15, "printed-form", "(3)", 1e-5},
        // A fixed step is lost near locking.
        {"hinge-motion", "locking", 0.01, "rk4", "180 steps a turn", 1e-5},
        {"hinge-motion", "locking", 0.01, "dormand-prince", "1e-11", 0.0, 1e-8},
        // Slopes fail at a jump, at a corner and where a curve bends.
        {"scatter", "scatter", 1e-4, "linear", "differences", 0.0, 1e-3},
        {"scatter", "jump", 0.8, "linear", "differences", 0.5},
        {"scatter", "corner", -0.5, "linear", "differences", 0.1},
        {"scatter", "scatter", 0.2, "linear", "differences", 3e-2},
    };
    for (const auto& [kernel, sweep, value, method, setting, at_least, less_than] : all) {
        const double error = error_of(kernel, sweep, value, method, setting);
        EXPECT_GE(error, at_least) << kernel << ", " << sweep << " = " << value << ", " << method;
        EXPECT_TRUE(less_than == any || error < less_than)
            << kernel << ", " << sweep << " = " << value << ", " << method << ": " << error;
    }
    // More terms help ever less: at 0.9999 ten of them are no better than four by a digit.
    EXPECT_LT(error_of("slider-crank", "locking", 0.0001, "series", "4 terms"),
              1.1 * error_of("slider-crank", "locking", 0.0001, "series", "10 terms"));
}

TEST(Stability, MethodsRejectInWordsWhereThereIsNothingToCompute) {
    const struct {
        const char *kernel, *sweep;
        double value;
        const char *method, *setting, *said;
    } all[] = {
        {"slider-crank", "locking", 0.0, "exact", "double", "locks"},
        {"slider-crank", "locking", -0.2, "exact", "double", "locks"},
        {"slider-crank", "locking", 1.0 - 1e3, "exact", "double", "locks"},
        {"inertia-orders", "locking", 0.0, "transform-by-accuracy", "1e-13", "locks"},
        {"inertia-orders", "locking", 1.0 - 1e3, "transform-by-accuracy", "1e-13", "locks"},
        {"inertia-orders", "locking", 3e-9, "transform-by-accuracy", "1e-13", "locks"},
        {"inertia-orders", "locking", 1e-10, "transform-by-accuracy", "1e-13", "locks"},
        // ρ₀ = ℓ₀/2: the preload is 0, 100 % below the smallest one.
        {"guide", "preload", -1.0, "closed-form", "free of cancellation", "too little energy"},
        {"guide", "preload", -1.0, "printed-form", "(3)", "too little energy"},
        {"guide", "preload", -1.0, "rk4", "360 steps", "singular"},
        {"guide", "preload", -1.0, "dormand-prince", "1e-10", "singular"},
    };
    for (const auto& [kernel, sweep, value, method, setting, said] : all) {
        const std::string text =
            result_of(kernel, sweep, value, method, setting).rejection.english();
        EXPECT_TRUE(says(text, said)) << kernel << ", " << method << ": " << text;
    }
}

}  // namespace
}  // namespace ravnoves::methods
