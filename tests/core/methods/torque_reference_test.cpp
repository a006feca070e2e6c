/// The references of the torque's kernels against what is known without them.

#include "methods/torque_reference.h"

#include <gtest/gtest.h>

#include <cmath>

#include "numerics/constants.h"

namespace ravnoves::methods {
namespace {

double off(const Real50& value, const Real50& expected) {
    return static_cast<double>(abs(Real50(value - expected)));
}

TEST(TorqueReference, APureSineHasWhatIsKnownOfIt) {
    for (const double alpha : {0.0, 30.0, 217.0}) {
        const TorqueCycle cycle = pure_sine_cycle(alpha);
        const TorqueReference reference(cycle);
        const Real50 amplitude(cycle.amplitude);
        EXPECT_LT(off(reference.means().mean, Real50(0)), 1e-44);
        EXPECT_LT(off(reference.means().rms, amplitude / sqrt(Real50(2))), 1e-44);
        EXPECT_LT(off(reference.range(Real50(cycle.alpha)).range, 2 * amplitude), 1e-44);
    }
}

/// Rows of a triangle of height 1 over the cycle: mean ½, RMS 1/√12, range 1, whatever the rows.
TEST(TorqueReference, ATriangleHasWhatIsKnownOfIt) {
    TorqueCycle cycle;
    cycle.angle_deg = {0.0, 90.0, 360.0, 450.0, 720.0};
    cycle.moment = {0.0, 0.25, 1.0, 0.75, 0.0};
    const TorqueReference reference(cycle);
    EXPECT_LT(off(reference.means().mean, Real50("0.5")), 1e-44);
    EXPECT_LT(off(reference.means().rms, 1 / sqrt(Real50(12))), 1e-44);
    EXPECT_LT(off(reference.range(Real50(0)).range, Real50(1)), 1e-44);
}

/// With sin 2φ besides, and rows so close that the spline is as good as the sine.
TEST(TorqueReference, AFineSplineOfASineIsThatSine) {
    TorqueCycle cycle;
    constexpr int rows = 2880;
    for (int i = 0; i <= rows; ++i) {
        cycle.angle_deg.push_back(720.0 * i / rows);
        cycle.moment.push_back(3.0 * std::sin(two_pi * 2.0 * (i % rows) / rows));
    }
    cycle.cubic = true;
    cycle.amplitude = 4.0;
    cycle.alpha = 0.5 * pi;  // 3 sin φ + 4 cos φ
    const TorqueReference reference(cycle);
    EXPECT_LT(off(reference.means().rms, 5 / sqrt(Real50(2))), 1e-10);
    EXPECT_LT(off(reference.range(Real50(cycle.alpha)).range, Real50(10)), 1e-9);
}

/// A fine scan of samples of the paper's engine finds no smaller range, and comes near to it.
TEST(TorqueReference, NoSampledRangeIsSmallerThanTheMinimum) {
    const TorqueCycle cycle = paper_cycle();
    const auto moment = cycle.interpolant();
    const double minimum = static_cast<double>(TorqueReference(cycle).min_range());
    double sampled = 1e300;
    for (int k = 0; k < 7200; ++k) {
        const double alpha = two_pi * k / 7200.0;
        double high = -1e300;
        double low = 1e300;
        for (int i = 0; i < 1440; ++i) {
            const double m = moment(0.5 * i) + cycle.amplitude * std::sin(0.5 * i * degree + alpha);
            high = std::max(high, m);
            low = std::min(low, m);
        }
        sampled = std::min(sampled, high - low);
    }
    EXPECT_NEAR(sampled, minimum, 0.2);
    EXPECT_NEAR(minimum, 1066.745810132836, 1e-9);
}

}  // namespace
}  // namespace ravnoves::methods
