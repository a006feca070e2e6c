/// Where methods fail, and that the program then says so instead of printing a number.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "balance-shaft/angle_search.h"
#include "elastic-hinge/presets.h"
#include "methods/kernel.h"
#include "methods/reference_mechanism.h"
#include "methods/torque_cycle.h"
#include "numerics/constants.h"
#include "support.h"

namespace ravnoves::methods {
namespace {

#if defined(RAVNOVES_SANITIZED)
constexpr bool slow = true;
#else
constexpr bool slow = false;
#endif

/// Error of a method and setting at a value of a sweep; infinite where it rejects.
double error_of(const char* kernel_id, const char* sweep, double value, const char* method,
                const char* setting) {
    const Kernel& kernel = *find_kernel(kernel_id);
    const std::size_t m = kernel.find_method(method);
    const Result result = evaluate(*kernel.problem(kernel.find_sweep(sweep), value), m,
                                   kernel.find_setting(m, setting));
    return result.rejected() ? std::numeric_limits<double>::infinity() : result.error;
}

std::string rejection_of(const char* kernel_id, const char* sweep, double value, const char* method,
                         const char* setting) {
    const Kernel& kernel = *find_kernel(kernel_id);
    const std::size_t m = kernel.find_method(method);
    return evaluate(*kernel.problem(kernel.find_sweep(sweep), value), m,
                    kernel.find_setting(m, setting))
        .rejection.english();
}

std::string scene_rejection(const char* kernel_id, const char* sweep, double value) {
    const Kernel& kernel = *find_kernel(kernel_id);
    return kernel.problem(kernel.find_sweep(sweep), value)->scene_rejection().english();
}

TEST(Stability, TheLastSettingOfAMethodIsItsFinest) {
    for (const Kernel& kernel : kernels()) {
        const auto problem = kernel.problem(0, kernel.sweeps[0].present);
        for (std::size_t method = 0; method < kernel.methods.size(); ++method) {
            const MethodInfo& info = kernel.methods[method];
            double minimum = std::numeric_limits<double>::infinity();
            Result result;
            for (std::size_t setting = 0; setting < info.settings.size(); ++setting) {
                result = evaluate(*problem, method, setting);
                minimum = result.rejected() ? minimum : std::min(minimum, result.error);
            }
            if (std::isfinite(minimum)) {
                EXPECT_LE(result.error, 3.0 * minimum + 1e-15) << kernel.id << ", " << info.id;
            }
        }
    }
}

// ------------------------------------------------------------------------------- slider-crank

TEST(SliderCrankStability, TheSeriesHasThreeDigitsAtOneHalfAndNoneNearLocking) {
    EXPECT_LT(error_of("slider-crank", "locking", 0.75, "series", "4 terms"), 2e-5);
    EXPECT_GT(error_of("slider-crank", "locking", 0.5, "series", "4 terms"), 1e-3);
    EXPECT_GT(error_of("slider-crank", "locking", 0.0001, "series", "10 terms"), 0.9);
    // More terms help ever less: at 0.9999 ten of them are no better than four by a digit.
    EXPECT_LT(error_of("slider-crank", "locking", 0.0001, "series", "4 terms"),
              1.1 * error_of("slider-crank", "locking", 0.0001, "series", "10 terms"));
}

TEST(SliderCrankStability, TheExactFormHoldsUpToLocking) {
    for (const double gap : {1e-1, 1e-2, 1e-4, 1e-6}) {
        EXPECT_LT(error_of("slider-crank", "locking", gap, "exact-table", "double"),
                  1e-14 + 1e-17 / gap)
            << gap;
        EXPECT_LT(error_of("slider-crank", "offset", gap, "exact-table", "double"),
                  1e-14 + 1e-17 / gap)
            << gap;
    }
}

TEST(SliderCrankStability, FloatLosesTheAngle) {
    EXPECT_GT(error_of("slider-crank", "locking", 0.735, "exact", "float"), 1e-8);
}

TEST(SliderCrankStability, AtLockingTheSceneRejectsInWords) {
    for (const double lambda : {1.0, 1.2, 1e3}) {
        EXPECT_TRUE(says(scene_rejection("slider-crank", "locking", 1.0 - lambda), "locks"))
            << lambda;
        EXPECT_TRUE(says(rejection_of("slider-crank", "locking", 1.0 - lambda, "exact", "double"),
                         "locks"));
        EXPECT_TRUE(says(rejection_of("inertia-orders", "locking", 1.0 - lambda,
                                      "transform-by-accuracy", "1e-13"),
                         "locks"));
    }
    EXPECT_TRUE(says(scene_rejection("slider-crank", "offset", 0.0), "locks"));
    EXPECT_EQ(scene_rejection("slider-crank", "locking", 0.0001), "");
    EXPECT_TRUE(says(scene_rejection("guide", "locking", 0.0), "lambda"));
    EXPECT_TRUE(says(scene_rejection("hinge-motion", "locking", 0.0), "lambda"));
}

// ------------------------------------------------------------------------------------ orders

TEST(OrderStability, AShortTransformFoldsHighOrdersOntoLowOnes) {
    EXPECT_LT(error_of("inertia-orders", "locking", 0.75, "transform", "32 points"), 1e-12);
    EXPECT_GT(error_of("inertia-orders", "locking", 0.1, "transform", "32 points"), 1e-4);
    EXPECT_GT(error_of("inertia-orders", "locking", 0.0001, "transform", "512 points"), 1e-5);
    EXPECT_GT(error_of("inertia-orders", "offset", 0.0036, "transform", "64 points"), 1e-5);
    EXPECT_LT(error_of("inertia-orders", "locking", 0.0001, "transform-by-accuracy", "1e-13"),
              1e-12);
}

/// Right to its digits as near to locking as the scene takes it, and rejected beyond.
TEST(OrderStability, HoldsUpToWhereTheSceneRejects) {
    for (const double gap : {1e-6, 1e-8, 5e-9}) {
        EXPECT_LT(error_of("inertia-orders", "locking", gap, "transform-by-accuracy", "1e-13"),
                  1e-11)
            << gap;
    }
    for (const double gap : {3e-9, 1e-10}) {
        EXPECT_TRUE(
            says(rejection_of("inertia-orders", "locking", gap, "transform-by-accuracy", "1e-13"),
                 "locks"))
            << gap;
        EXPECT_TRUE(says(scene_rejection("inertia-orders", "locking", gap), "locks")) << gap;
    }
}

// --------------------------------------------------------------------------- balance shaft

/// The paper's conclusion in one number: a pure sine whose mean is 0 gets 17.2 N·m.
TEST(MeanStability, TheEndCountedTwiceGivesAPureSineAMean) {
    const Kernel& kernel = *find_kernel("cycle-mean");
    const auto problem = kernel.problem(kernel.find_sweep("pure-sine"), 90.0);
    std::vector<double> out(problem->outputs());
    const auto mean = [&](const char* method, const char* setting) {
        const std::size_t m = kernel.find_method(method);
        EXPECT_EQ(problem->prepare(m, kernel.find_setting(m, setting))(out), "");
        return out[0];
    };
    EXPECT_NEAR(mean("nodes-end-twice", "24 steps"), 17.22, 0.005);  // printed 17.22
    EXPECT_NEAR(mean("trapezoid", "24 steps"), 0.0, 1e-12);
    EXPECT_NEAR(mean("exact", "pieces"), 0.0, 1e-12);
    EXPECT_NEAR(problem->error(out), 0.0, 1e-12);
}

TEST(MeanStability, FewNodesMissANarrowPeak) {
    EXPECT_GT(error_of("cycle-mean", "peak-width", 0.2, "trapezoid", "144 steps"), 1e-4);
    EXPECT_LT(error_of("cycle-mean", "peak-width", 0.2, "exact", "pieces"), 1e-14);
}

TEST(RangeStability, APeakNarrowerThanTheNodesIsNotSeen) {
    // A peak of 500 N·m and width 0.05° between nodes 1° apart.
    EXPECT_GT(error_of("moment-range", "peak-width", 0.05, "nodes", "1°"), 0.1);
    EXPECT_GT(error_of("moment-range", "peak-width", 0.05, "nodes", "5°"), 0.1);
    EXPECT_LT(error_of("moment-range", "peak-width", 0.05, "exact", "pieces"), 1e-14);
}

/// Two equal minima, and kinks at both: any of the two is right, and its value is exact.
TEST(AngleStability, FindsOneOfTwoEqualMinimaOnTheirKinks) {
    for (const double share : {0.0, 1e-12, 1e-6, 1e-2}) {
        const TorqueCycle cycle = two_minima_cycle(share);
        const balance_shaft::MomentPlane plane(cycle.interpolant());
        const auto best = balance_shaft::minimise_range(plane, cycle.amplitude);
        // The other minimum lies half a turn on and is higher by no more than the share.
        const double other = plane.range(balance_shaft::shaft_at(cycle.amplitude, best.alpha + pi));
        EXPECT_GE(other, best.value - 1e-12 * cycle.size());
        EXPECT_LE(other, best.value + 4.0 * share * 600.0 + 1e-9);
        EXPECT_LT(best.gap, 1e-9);
    }
    // A kink: the slopes on both sides do not go to zero.
    const TorqueCycle paper = paper_cycle();
    const balance_shaft::MomentPlane plane(paper.interpolant());
    const auto best = balance_shaft::minimise_range(plane, paper.amplitude);
    const double step = 1e-4;
    const auto range = [&](double alpha) {
        return plane.range(balance_shaft::shaft_at(paper.amplitude, alpha));
    };
    const double left = (best.value - range(best.alpha - step)) / step;
    const double right = (range(best.alpha + step) - best.value) / step;
    EXPECT_LT(left, -10.0);
    EXPECT_GT(right, 10.0);
    EXPECT_GT(error_of("best-angle", "amplitude", paper.amplitude, "brent", "one start"), 1e-2);
}

// -------------------------------------------------------------------------------------- guide

TEST(GuideStability, WithTheSpringUnloadedAtTheStartThereIsNoGuide) {
    // ρ₀ = ℓ₀/2: the preload is 0, 100 % below the smallest one.
    const std::string reason = scene_rejection("guide", "preload", -1.0);
    EXPECT_TRUE(says(reason, "preload")) << reason;
    for (const auto& [method, setting] :
         {std::pair{"closed-form", "free of cancellation"}, std::pair{"printed-form", "(3)"},
          std::pair{"rk4", "360 steps"}, std::pair{"dormand-prince", "1e-10"}}) {
        EXPECT_NE(rejection_of("guide", "preload", -1.0, method, setting), "") << method;
    }
}

TEST(GuideStability, TheOdeIsSingularThereAndTheClosedFormIsNot) {
    EXPECT_LT(error_of("guide", "preload", 1e-12, "closed-form", "free of cancellation"), 1e-8);
    for (const auto& [method, setting] :
         {std::pair{"rk4", "3600 steps"}, std::pair{"dormand-prince", "1e-12"}}) {
        EXPECT_GT(error_of("guide", "preload", 1e-12, method, setting), 1e-6) << method;
        EXPECT_LT(error_of("guide", "preload", 1.0, method, setting), 1e-7) << method;
    }
}

/// Eight decades: the printed form loses its digits with the relief, the other keeps them.
TEST(GuideStability, SpringStiffnessOverEightDecades) {
    for (double c = 1e7; c <= 1.1e15; c *= 10.0) {
        EXPECT_LT(
            error_of("guide", "stiffness-preloaded", c, "closed-form", "free of cancellation"),
            1e-9)
            << c;
    }
    EXPECT_LT(error_of("guide", "stiffness-preloaded", 1e7, "printed-form", "(3)"), 1e-10);
    EXPECT_GT(error_of("guide", "stiffness-preloaded", 1e15, "printed-form", "(3)"), 1e-5);
}

TEST(GuideStability, CrankSpeedOverFourDecades) {
    for (const double speed : {1.0, 10.0, 100.0, 1000.0}) {
        EXPECT_LT(error_of("guide", "speed", speed, "closed-form", "free of cancellation"), 1e-10);
    }
    EXPECT_TRUE(says(scene_rejection("guide", "speed", 1e4), "preload"));
}

// ------------------------------------------------------------------------------------- motion

/// Ten thousand turns: the error of the energy grows in proportion to the turns.
TEST(MotionStability, TenThousandTurns) {
    const Kernel& kernel = *find_kernel("hinge-motion");
    const std::size_t sweep = kernel.find_sweep("turns");
    const ReferenceBars bars(elastic_hinge::preset_zotov());
    constexpr double start = 80.0;  // rad/s, of the kernel's motion; the design speed is 100
    constexpr double design = 100.0;
    // With the hinge (φ̇² − ω²) I is constant: by how much it has changed, whatever the time.
    const auto drift = [&](double turns, const char* method, const char* setting) {
        const auto problem = kernel.problem(sweep, turns);
        const std::size_t m = kernel.find_method(method);
        std::vector<double> out(problem->outputs());
        EXPECT_EQ(problem->prepare(m, kernel.find_setting(m, setting))(out), "");
        // At the end of the last turn.
        const double phi = out[out.size() - 2];
        const double speed = out.back();
        const auto inertia = static_cast<double>(bars.inertia(Real50(phi)));
        const double constant = (speed * speed - design * design) * inertia;
        const double at_start =
            (start * start - design * design) * static_cast<double>(bars.inertia(Real50(0)));
        return std::abs(constant / at_start - 1.0);
    };
    const double many = slow ? 300.0 : 1e4;
    EXPECT_LT(drift(many, "dormand-prince", "1e-11"), 1e-9 * many);
    // Fixed steps of order 4 lose energy turn by turn.
    EXPECT_GT(drift(many, "rk4", "45 steps a turn"),
              3.0 * drift(many / 10.0, "rk4", "45 steps a turn"));
    EXPECT_TRUE(says(scene_rejection("hinge-motion", "turns", 1e4), "/input/motion/turns"));
}

TEST(MotionStability, AFixedStepIsLostNearLocking) {
    EXPECT_GT(error_of("hinge-motion", "locking", 0.01, "rk4", "180 steps a turn"), 1e-5);
    EXPECT_LT(error_of("hinge-motion", "locking", 0.01, "dormand-prince", "1e-11"), 1e-8);
}

// ----------------------------------------------------------------------------- extreme inputs

/// A finite answer or a worded rejection, never a NaN: every method of every kernel.
TEST(ExtremeInputs, EveryMethodAnswersInNumbersOrWords) {
    constexpr double extremes[] = {5e-324, 1e-300, 1e300, 0.0, -1.0};
    // Counts of rows, points and turns are no physical quantities: such problems would be empty or
    // would not end.
    const auto is_count = [](const SweepInfo& sweep) {
        return sweep.id.ends_with("rows") || sweep.id == "turns";
    };
    for (const Kernel& kernel : kernels()) {
        for (std::size_t sweep = 0; sweep < kernel.sweeps.size(); ++sweep) {
            if (is_count(kernel.sweeps[sweep])) {
                continue;
            }
            for (const double value : extremes) {
                const auto problem = kernel.problem(sweep, value);
                for (std::size_t method = 0; method < kernel.methods.size(); ++method) {
                    Result result;
                    EXPECT_NO_THROW(result = evaluate(*problem, method, 0))
                        << kernel.id << " " << kernel.sweeps[sweep].id << " = " << value << " "
                        << kernel.methods[method].id;
                    EXPECT_TRUE(result.rejected() || std::isfinite(result.error))
                        << kernel.id << " " << kernel.sweeps[sweep].id << " = " << value << " "
                        << kernel.methods[method].id;
                }
            }
        }
    }
}

}  // namespace
}  // namespace ravnoves::methods
