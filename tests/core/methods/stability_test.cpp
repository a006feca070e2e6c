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

TEST(Stability, TheMethodsInUseHoldOverDecades) {
    for (const double gap : {1e-1, 1e-2, 1e-4, 1e-6}) {
        for (const char* sweep : {"locking", "offset"}) {
            EXPECT_LT(error_of("slider-crank", sweep, gap, "exact-table", "double"),
                      1e-14 + 1e-17 / gap)
                << gap;
        }
    }
    const auto guide = [](const char* sweep, double value) {
        return error_of("guide", sweep, value, "closed-form", "free of cancellation");
    };
    for (double c = 1e7; c <= 1.1e15; c *= 10.0) {
        EXPECT_LT(guide("stiffness-preloaded", c), 1e-9) << c;
    }
    for (const double speed : {1.0, 10.0, 100.0, 1000.0}) {
        EXPECT_LT(guide("speed", speed), 1e-10) << speed;
    }
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

/// The paper's conclusion in one number: a pure sine whose mean is 0 gets 17.2 N·m.
TEST(MeanStability, TheEndCountedTwiceGivesAPureSineAMean) {
    const Kernel& kernel = *find_kernel("cycle-mean");
    const auto problem = kernel.problem(find_sweep(kernel, "pure-sine"), 90.0);
    std::vector<double> out(problem.outputs);
    const auto mean = [&](const char* method, const char* setting) {
        const std::size_t m = kernel.find_method(method);
        EXPECT_EQ(problem.prepare(m, kernel.find_setting(m, setting))(out), "");
        return out[0];
    };
    EXPECT_NEAR(mean("nodes-end-twice", "24 steps"), 17.22, 0.005);  // printed 17.22
    EXPECT_NEAR(mean("trapezoid", "24 steps"), 0.0, 1e-12);
    EXPECT_NEAR(mean("exact", "pieces"), 0.0, 1e-12);
    EXPECT_NEAR(problem.error(out), 0.0, 1e-12);
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

/// Ten thousand turns: the error of the energy grows in proportion to the turns.
TEST(MotionStability, TenThousandTurns) {
    const Kernel& kernel = *find_kernel("hinge-motion");
    const std::size_t sweep = find_sweep(kernel, "turns");
    const ReferenceBars bars(elastic_hinge::preset_zotov());
    constexpr double start = 80.0;  // rad/s, of the kernel's motion; the design speed is 100
    constexpr double design = 100.0;
    // With the hinge (φ̇² − ω²) I is constant: by how much it has changed, whatever the time.
    const auto drift = [&](double turns, const char* method, const char* setting) {
        const auto problem = kernel.problem(sweep, turns);
        const std::size_t m = kernel.find_method(method);
        std::vector<double> out(problem.outputs);
        EXPECT_EQ(problem.prepare(m, kernel.find_setting(m, setting))(out), "");
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
}

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
                    EXPECT_NO_THROW(result = evaluate(problem, method, 0))
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
