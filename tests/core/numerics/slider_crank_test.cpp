#include "numerics/slider_crank.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <complex>
#include <vector>

#include "numerics/constants.h"

namespace ravnoves {
namespace {

using Decimal50 = boost::multiprecision::cpp_bin_float_50;

std::vector<SliderCrank<double>> mechanisms() {
    std::vector<SliderCrank<double>> list;
    for (const double lambda : {0.01, 0.2, 0.265, 1.0 / 3.0, 0.6, 0.9}) {
        for (const double k : {-0.9, -0.3, 0.0, 0.1, 0.278, 0.95}) {
            const SliderCrank<double> mechanism{0.045, 0.045 / lambda, 0.045 * k};
            if (!mechanism.locks()) {
                list.push_back(mechanism);
            }
        }
    }
    return list;
}

// Pin and piston pin as points, the rod between them: no derivative is used.
TEST(SliderCrank, RodKeepsItsLength) {
    for (const auto& m : mechanisms()) {
        for (double theta = -7.0; theta < 7.0; theta += 0.37) {
            const std::complex<double> pin = std::polar(m.crank_radius, theta);
            const std::complex<double> piston(m.at(theta).s, m.offset);
            EXPECT_NEAR(std::abs(piston - pin), m.rod_length, 1e-14 * m.rod_length);
            EXPECT_NEAR(std::arg(piston - pin), m.rod_at(theta).psi, 1e-13);
        }
    }
}

// In 50 digits central differences are good to 1e-20: the derivatives have no other source here.
TEST(SliderCrank, DerivativesAgreeWithDifferencesIn50Digits) {
    const Decimal50 h("1e-12");
    for (const auto& m : mechanisms()) {
        const SliderCrank<Decimal50> exact{m.crank_radius, m.rod_length, m.offset};
        for (double theta = 0.05; theta < two_pi; theta += 0.61) {
            const Decimal50 t(theta);
            const auto before = exact.at(Decimal50(t - h));
            const auto here = exact.at(t);
            const auto after = exact.at(Decimal50(t + h));
            const auto ds = static_cast<double>(Decimal50((after.s - before.s) / (2 * h)));
            const auto d2s = static_cast<double>(Decimal50((after.ds - before.ds) / (2 * h)));
            EXPECT_NEAR(static_cast<double>(here.ds), ds, 1e-15);
            EXPECT_NEAR(static_cast<double>(here.d2s), d2s, 1e-15);
            EXPECT_NEAR(m.at(theta).d2s, d2s, 1e-12 * m.rod_length);
            const auto rod = m.rod_at(theta);
            const Decimal50 dpsi =
                (exact.rod_at(Decimal50(t + h)).psi - exact.rod_at(Decimal50(t - h)).psi) / (2 * h);
            const Decimal50 d2psi =
                (exact.rod_at(Decimal50(t + h)).dpsi - exact.rod_at(Decimal50(t - h)).dpsi) /
                (2 * h);
            EXPECT_NEAR(rod.dpsi, static_cast<double>(dpsi), 1e-11);
            EXPECT_NEAR(rod.d2psi, static_cast<double>(d2psi), 1e-9);
        }
    }
}

TEST(SliderCrank, DeadCentresAreWhereThePistonTurns) {
    for (const auto& m : mechanisms()) {
        const double top = m.top_dead_centre();
        const double bottom = m.bottom_dead_centre();
        EXPECT_NEAR(m.at(top).ds, 0.0, 1e-14);
        EXPECT_NEAR(m.at(bottom).ds, 0.0, 1e-13);
        EXPECT_NEAR(m.at(top).s - m.at(bottom).s, m.stroke(), 1e-13 * m.rod_length);
        for (double theta = 0.0; theta < two_pi; theta += 0.1) {
            EXPECT_LE(m.at(theta).s, m.at(top).s + 1e-15);
            EXPECT_GE(m.at(theta).s, m.at(bottom).s - 1e-13);
        }
        EXPECT_GE(m.stroke(), 2.0 * m.crank_radius * (1.0 - 1e-15));
    }
    // The paper's engine: 3°20′.
    const SliderCrank<double> vr5{45.0, 45.0 / 0.265, 12.5};
    EXPECT_NEAR(vr5.top_dead_centre() / degree, 3.0 + 20.0 / 60.0, 1.0 / 120.0);
}

TEST(SliderCrank, OffsetTheOtherWayIsTheMirrorImage) {
    for (const auto& m : mechanisms()) {
        const SliderCrank<double> mirror{m.crank_radius, m.rod_length, -m.offset};
        for (double theta = 0.0; theta < two_pi; theta += 0.2) {
            EXPECT_DOUBLE_EQ(m.at(theta).s, mirror.at(-theta).s);
            EXPECT_DOUBLE_EQ(m.at(theta).ds, -mirror.at(-theta).ds);
            EXPECT_DOUBLE_EQ(m.at(theta).d2s, mirror.at(-theta).d2s);
        }
    }
}

// Up to the angle of locking the rod can be laid, beyond it no position of the piston exists.
TEST(SliderCrank, LocksWhereTheRodStandsAcross) {
    int checked = 0;
    for (const double lambda : {0.5, 0.8, 1.0, 1.25, 3.0, 20.0}) {
        for (const double k : {-1.5, -0.8, -0.3, 0.0, 0.3, 0.8, 1.2}) {
            const SliderCrank<double> m{1.0, 1.0 / lambda, k};
            EXPECT_EQ(m.locks(), lambda * (1.0 + std::abs(k)) >= 1.0) << lambda << " " << k;
            const auto angles = m.locking_angles();
            EXPECT_EQ(angles.has_value(), m.locks() && std::abs(k) <= 1.0 + 1.0 / lambda);
            if (!angles) {
                continue;
            }
            ++checked;
            const auto reach = [&](double theta) { return std::abs(std::sin(theta) - k); };
            EXPECT_NEAR(reach(angles->forward), m.rod_length, 1e-14);
            EXPECT_NEAR(reach(angles->backward), m.rod_length, 1e-14);
            const double top = m.top_dead_centre();
            EXPECT_LE(angles->backward, top + 1e-15);
            EXPECT_GE(angles->forward, top - 1e-15);
            EXPECT_LE(angles->forward - angles->backward, two_pi + 1e-12);
            for (int i = 1; i < 100; ++i) {
                const double theta =
                    angles->backward + (angles->forward - angles->backward) * i / 100.0;
                EXPECT_LE(reach(theta), m.rod_length * (1.0 + 1e-14));
            }
        }
    }
    EXPECT_GT(checked, 20);
    // Known by hand: L = R/2, centred: the rod lies across at 30° on both sides.
    const auto half = SliderCrank<double>{2.0, 1.0, 0.0}.locking_angles();
    ASSERT_TRUE(half.has_value());
    EXPECT_NEAR(half->forward, 30.0 * degree, 1e-15);
    EXPECT_NEAR(half->backward, -30.0 * degree, 1e-15);
    EXPECT_FALSE((SliderCrank<double>{1.0, 0.5, 1.6}.locking_angles().has_value()));
}

TEST(SliderCrank, HarmonicDecayIsTheDistanceOfTheBranchPoint) {
    for (const auto& m : mechanisms()) {
        // At θ = ±π/2 + i·decay the rod's root vanishes: sin(π/2 + iη) = cosh η.
        const double reach = m.crank_radius * std::cosh(m.harmonic_decay()) + std::abs(m.offset);
        EXPECT_NEAR(reach, m.rod_length, 1e-13 * m.rod_length);
    }
    // Near locking the margin must not drown: arcosh(1 + m) = √(2m).
    const double margin = 1e-14;
    const SliderCrank<double> near{1.0, 1.0 + margin, 0.0};
    EXPECT_NEAR(near.harmonic_decay() / std::sqrt(2.0 * (near.rod_length - 1.0)), 1.0, 1e-10);
    EXPECT_EQ((SliderCrank<double>{1.0, 0.9, 0.0}.harmonic_decay()), 0.0);
    const SliderCrank<Decimal50> fifty{1, 4, Decimal50("0.25")};
    EXPECT_NEAR(static_cast<double>(Decimal50(cosh(fifty.harmonic_decay()))), 3.75, 1e-15);
}

}  // namespace
}  // namespace ravnoves
