/// What the window measures is what the command line measures, whatever painting has left in the
/// vector registers.

#include <gtest/gtest.h>

#include <atomic>

#include "methods/model/method_measurements.h"
#include "methods_support.h"
#include "vector_registers.h"

namespace ravnoves {
namespace {

using methods::Kernel;

struct Seen {
    std::atomic<int> runs = 0;
    std::atomic<int> dirty = 0;
};

/// A problem whose only method looks at the registers.
class Looking : public methods::Problem {
  public:
    explicit Looking(Seen& seen) : seen_(seen) {}

    std::size_t outputs() const override { return 1; }
    double evaluations() const override { return 1.0; }
    methods::Run prepare(std::size_t /*method*/, std::size_t /*setting*/) const override {
        return [this](std::span<double> out) {
            out[0] = 0.0;
            ++seen_.runs;
            seen_.dirty += test::are_vector_registers_dirty() ? 1 : 0;
            return Message();
        };
    }
    double error(std::span<const double> out) const override { return out[0]; }

  private:
    Seen& seen_;
};

TEST(MethodTiming, RegistersAreClearWhereTheWindowMeasures) {
    if (!test::has_wide_vectors()) {
        GTEST_SKIP() << "this processor has no registers to clear";
    }
    Seen seen;
    Kernel kernel = methods::kernels().front();
    kernel.methods = {kernel.methods[kernel.chosen_method()]};
    kernel.sweeps.erase(kernel.sweeps.begin() + 1, kernel.sweeps.end());
    kernel.problem = [&seen](std::size_t /*sweep*/, double /*value*/) {
        return std::make_unique<Looking>(seen);
    };
    MethodMeasurements measurements;
    QSignalSpy measured(&measurements, &MethodMeasurements::measured);
    test::dirty_vector_registers();
    measurements.start(kernel, 0, kernel.sweeps.front().present, MeasurementEffort::quick);
    ASSERT_TRUE(measured.wait(test::patience));
    EXPECT_GT(seen.runs, 0);
    EXPECT_EQ(seen.dirty, 0);
}

}  // namespace
}  // namespace ravnoves
