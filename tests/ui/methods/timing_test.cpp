/// What the window measures is what the command line measures, whatever painting has left in the
/// vector registers.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "methods/model/method_measurements.h"
#include "methods_support.h"
#include "numerics/vector_state.h"
#include "vector_registers.h"

namespace ravnoves {
namespace {

using methods::Kernel;

constexpr double most = 1.5;

class MethodTiming : public ::testing::TestWithParam<std::size_t> {
  protected:
    using Times = std::vector<double>;  ///< ns, by row, the least seen

    void take(Times& least, const methods::WorkPrecision& work) {
        least.resize(work.points.size(), std::numeric_limits<double>::infinity());
        for (std::size_t i = 0; i < least.size(); ++i) {
            least[i] = std::min(least[i], work.points[i].timing.low);
        }
    }
    /// In this thread, with clear registers.
    void measureAsTheCommandLine() {
        clear_vector_state();
        take(commandLine, methods::measure_work(kernel, 0, kernel.sweeps.front().present, quick));
    }
    /// In the worker, which inherits what painting left.
    void measureAsTheWindow() {
        QSignalSpy measured(&measurements, &MethodMeasurements::measured);
        test::dirty_vector_registers();
        measurements.start(kernel, 0, kernel.sweeps.front().present, MeasurementEffort::quick);
        ASSERT_TRUE(measured.wait(test::patience));
        take(window, measurements.newest(kernel)->work);
    }
    /// How far apart the two are, as a factor.
    double factor(std::size_t row) const {
        return std::max(window[row] / commandLine[row], commandLine[row] / window[row]);
    }
    bool agree() const {
        for (std::size_t row = 0; row < window.size(); ++row) {
            if (!(factor(row) <= most)) {
                return false;
            }
        }
        return !window.empty();
    }

    static constexpr methods::MeasureOptions quick{
        .batch_seconds = 1e-4, .batches = 9, .most_seconds = 0.03};
    const Kernel& kernel = methods::kernels()[GetParam()];
    MethodMeasurements measurements;
    Times window;
    Times commandLine;
};

/// Other programs can only make a run slower, so of runs in turn the fastest of each are compared,
/// as many as it takes.
TEST_P(MethodTiming, WindowAndCommandLineAgree) {
    constexpr int attempts = 40;
    for (int attempt = 0; attempt < attempts && !agree(); ++attempt) {
        measureAsTheCommandLine();
        measureAsTheWindow();
    }
    for (std::size_t row = 0; row < window.size(); ++row) {
        const auto& point = measurements.newest(kernel)->work.points[row];
        EXPECT_LE(factor(row), most)
            << kernel.methods[point.method].id << ", setting " << point.setting << ": "
            << commandLine[row] << " ns, in the window " << window[row] << " ns";
    }
}

INSTANTIATE_TEST_SUITE_P(Methods, MethodTiming,
                         ::testing::Range<std::size_t>(0, methods::kernels().size()),
                         [](const auto& info) {
                             std::string name = methods::kernels()[info.param].id;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

}  // namespace
}  // namespace ravnoves
