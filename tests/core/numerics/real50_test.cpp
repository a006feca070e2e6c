#include "numerics/real50.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "numerics/periodic_piecewise.h"

namespace ravnoves {
namespace {

/// sin φ + sin(φ/2) every 30° of a cycle of 720°, in any scalar.
template <typename Scalar>
BasicPeriodicPiecewise<Scalar> table(bool cubic) {
    const std::vector<double> values{0.0,  0.8,  1.4,  1.7,  1.7,  1.5,  1.0, 0.5, 0.0,
                                     -0.3, -0.4, -0.3, 0.0,  0.3,  0.4,  0.3, 0.0, -0.5,
                                     -1,   -1.5, -1.7, -1.7, -1.4, -0.8, 0.0};
    std::vector<Scalar> x;
    std::vector<Scalar> y;
    for (std::size_t i = 0; i < values.size(); ++i) {
        x.emplace_back(30 * static_cast<int>(i));
        y.emplace_back(values[i]);
    }
    return cubic ? BasicPeriodicPiecewise<Scalar>::cubic(x, y)
                 : BasicPeriodicPiecewise<Scalar>::linear(x, y);
}

double gap(const Real50& exact, double found) {
    return std::abs(static_cast<double>(exact - found));
}

TEST(Real50, IntegralsOfThePiecesAreThoseOfDouble) {
    for (const bool cubic : {false, true}) {
        const auto f = table<double>(cubic);
        const auto exact = table<Real50>(cubic);
        EXPECT_LT(gap(exact.mean(), f.mean()), 1e-15);
        EXPECT_LT(gap(exact.variance(), f.variance()), 1e-14);
        const Real50 frequency = boost::math::constants::degree<Real50>();
        const auto order = exact.fourier(frequency);
        EXPECT_LT(gap(order.a, f.fourier(M_PI / 180.0).a), 1e-14);
        EXPECT_LT(gap(order.b, f.fourier(M_PI / 180.0).b), 1e-14);
    }
}

}  // namespace
}  // namespace ravnoves
