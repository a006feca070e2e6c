#include "methods/measure.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support.h"

namespace ravnoves::methods {
namespace {

/// The orders of convergence that theory gives, found from the errors.
TEST(Measure, FindsTheOrdersOfTheory) {
    const MeasureOptions quick{.batch_seconds = 1e-9, .batches = 3, .max_seconds = 1e-9};
    const auto order = [&](const char* kernel_id, const char* sweep, double value,
                           const char* method) {
        const Kernel& kernel = *find_kernel(kernel_id);
        const auto work = measure_work(kernel, find_sweep(kernel, sweep), value, quick);
        return work.order(kernel.find_method(method)).value_or(0.0);
    };
    // The error of the end counted twice falls as 1/nodes.
    EXPECT_NEAR(order("cycle-mean", "pure-sine", 90.0, "nodes-end-twice"), 1.0, 0.1);
    EXPECT_NEAR(order("guide", "preload", 1.0, "rk4"), 4.0, 0.4);
}

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

TEST(Measure, TellsWhereAMethodFails) {
    const Kernel& kernel = *find_kernel("slider-crank");
    StabilityMap map{&kernel, 0, {0.1, 0.2, 0.3, 0.4}, {}};
    const auto text = [&](std::vector<double> errors) {
        StabilityCurve curve;
        for (const double error : errors) {
            curve.results.push_back({std::abs(error), error < 0.0 ? "refused" : ""});
        }
        return failing_text(map, curve, 1.0).english();
    };
    EXPECT_EQ(text({0, 0, 0, 0}), "nowhere");
    EXPECT_EQ(text({2, 2, -1, 2}), "everywhere");
    EXPECT_EQ(text({0, 0, 2, -1}), "from 0.3");
    EXPECT_EQ(text({2, 2, 0, 0}), "up to 0.2");
    EXPECT_EQ(text({0, 2, 2, 0}), "0.2 to 0.3");
    EXPECT_EQ(text({2, 0, 2, 0}), "at 0.1, at 0.3");
}

/// Every value of a sweep has its place on the sweep's scale, and the places keep their order.
TEST(Sweep, PlacesAndValuesAreInverse) {
    for (const Kernel& kernel : kernels()) {
        for (const SweepInfo& sweep : kernel.sweeps) {
            EXPECT_EQ(sweep.place(sweep.from), 0.0) << kernel.id << ' ' << sweep.id;
            EXPECT_NEAR(sweep.place(sweep.to), 1.0, 1e-12) << kernel.id << ' ' << sweep.id;
            double before = -1.0;
            for (int i = 0; i <= 50; ++i) {
                const double place = i / 50.0;
                const double value = sweep.at(place);
                EXPECT_NEAR(sweep.place(value), place, 1e-12) << kernel.id << ' ' << sweep.id;
                EXPECT_TRUE(i == 0 || value > before) << kernel.id << ' ' << sweep.id << place;
                before = value;
            }
        }
    }
}

}  // namespace
}  // namespace ravnoves::methods
