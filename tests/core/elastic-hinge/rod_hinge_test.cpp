#include "elastic-hinge/kinematics.h"

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <numbers>

#include "elastic-hinge/design.h"
#include "elastic-hinge/presets.h"
#include "support.h"

namespace ravnoves::elastic_hinge {
namespace {

using test::derivative;
using test::Fifty;
using test::turn_integral;

/// The side force at any crank speed, N, by Newton and Euler on rod, slider and counterweight, with
/// the moment of a hinge between crank and rod; of the slider on its guide, up.
double side_force(const Mechanism<double>& m, double phi, double speed, double hinge_moment) {
    const double s = std::sin(phi);
    const double c = std::cos(phi);
    const auto rod = rod_angle_exact(m.lambda, s, c);
    const double l = m.rod_length();
    const double square = speed * speed;
    const struct {
        double mass, along;  // kg; distance from A towards B, m
    } bodies[] = {{m.slider_mass, l},
                  {m.rod_mass, 0.5 * l},
                  {m.counterweight_mass, -m.counterweight_distance}};
    // Moments about A: Σ (r × m (a − g)) + I α = hinge moment + (B − A) × force on the slider; the
    // rod turns through −ψ.
    double sum = -m.rod_mass * l * l / 12.0 * rod.d2psi * square;
    for (const auto& body : bodies) {
        const double ax = -m.crank_radius * c * square + body.along * rod.d2cos * square;
        const double ay = -m.crank_radius * s * square + body.along * m.lambda * s * square;
        const double x = body.along * rod.cos_psi;
        const double y = -body.along * rod.sin_psi;
        sum += body.mass * (x * (ay + m.gravity) - y * ax);
    }
    return (hinge_moment - sum) / (l * rod.cos_psi);
}

Input with_counterweight(double distance, CounterweightInertia inertia) {
    Input input = preset_zotov();
    input.rod_counterweight = RodCounterweight{distance, std::nullopt, inertia};
    return input;
}

/// By a quadrature of its own, between whose ends the integrand is smooth; near λ = 1 too, where
/// the angle of the rod turns over within a fraction of a degree.
TEST(ElasticHingeRod, WorkIsTheIntegralOfItsMomentOverItsAngle) {
    for (const double lambda : {0.3, 0.9, 0.975, 0.995, 0.9999}) {
        Input input = preset_zotov();
        input.kinematics = Kinematics::exact;
        input.lambda = lambda;
        const Design design(input);
        const auto slope = [&](double phi) {
            const double s = std::sin(phi);
            const double c = std::cos(phi);
            const double dpsi = lambda * c / std::sqrt((1.0 - lambda * s) * (1.0 + lambda * s));
            return (design.rod_moment(s, c).value(design.angular_speed()) -
                    design.rod_hinge_mean()) *
                   (1.0 + dpsi);
        };
        boost::math::quadrature::tanh_sinh<double> quadrature;
        double work = 0.0;
        double largest = 0.0;
        double from = 0.0;
        // At none of the table's angles, but for the dead ends and the turning over of the rod.
        for (const double to :
             {0.4004, 1.2, 0.5 * std::numbers::pi, 1.9003, 2.7, 3.6005, 4.4, 5.9}) {
            work += quadrature.integrate(slope, from, to);
            largest = std::max(largest, std::abs(work));
            EXPECT_NEAR(design.rod_work(to), work, 1e-8 * largest) << lambda << ' ' << to;
            EXPECT_NEAR(design.rod_work(to - 2.0 * std::numbers::pi), work, 1e-8 * largest);
            from = to;
        }
    }
}

TEST(ElasticHingeRod, SlopeIsTheDerivativeOfTheMoment) {
    for (const Kinematics kinematics : {Kinematics::series, Kinematics::exact}) {
        for (const auto inertia :
             {CounterweightInertia::as_printed, CounterweightInertia::newton_euler}) {
            auto m = test::with_counterweight<Fifty>(test::zotov_mechanism<Fifty>(), Fifty(1) / 20);
            m.counterweight_mass *= 2;
            m.counterweight_inertia = inertia;
            const auto at = [&](const Fifty& phi) {
                const Fifty s = sin(phi);
                const Fifty c = cos(phi);
                return rod_hinge_moment(m, m.static_moment(), s, c,
                                        rod_angle(kinematics, m.lambda, s, c));
            };
            const Fifty omega(200);
            for (const char* text : {"0.3", "1.4", "2.2", "4.1"}) {
                const Fifty phi(text);
                const Fifty numeric =
                    derivative([&](const Fifty& x) { return at(x).value(omega); }, phi);
                EXPECT_LT(abs(at(phi).slope(omega) - numeric), Fifty("1e-20"));
            }
        }
    }
}

TEST(ElasticHingeRod, CounterweightsOfThePaper) {
    for (const double distance : {0.05, 0.1, 0.15}) {
        for (const double omega : {100.0, 500.0}) {
            Input input = with_counterweight(distance, CounterweightInertia::as_printed);
            input.angular_speed = omega;
            const Result result = solve(input);
            EXPECT_EQ(result.design->rod_hinge_integral(), 0.0);
            EXPECT_NEAR(turn_integral(result.curves.rod_hinge_moment), 0.0, 1e-12 * omega * omega);
            EXPECT_EQ(result.largest_side_force_with, 0.0);
            // The same weight given by hand does the same, to rounding.
            input.rod_counterweight->mass = result.design->mechanism().counterweight_mass;
            EXPECT_NEAR(solve(input).design->rod_hinge_integral(), 0.0, 1e-13);
        }
    }
}

TEST(ElasticHingeRod, SideForcesFollowFromNewtonAndEuler) {
    // (7): without a hinge, and zero with the moment M₁₂ on the rod; no counterweight.
    Input input = preset_zotov();
    input.angular_speed = 300.0;
    const Result result = solve(input);
    const auto& m = result.design->mechanism();
    for (std::size_t i = 0; i < result.crank_angle_deg.size(); i += 37) {
        const double phi = result.crank_angle_deg[i] * degree;
        EXPECT_NEAR(side_force(m, phi, 300.0, 0.0), result.curves.side_force_without_hinge[i],
                    1e-9);
        EXPECT_NEAR(side_force(m, phi, 300.0, result.curves.rod_hinge_moment[i]), 0.0, 1e-9);
        EXPECT_NEAR(side_force(m, phi, 300.0, result.curves.rod_hinge_moment_potential[i]),
                    result.curves.side_force_with_hinge[i], 1e-9);
    }
}

TEST(ElasticHingeRod, CounterweightNeedsTheSignsOfNewtonAndEuler) {
    // With (9) as printed the slider's guide bears kilonewtons, with moments about A nothing.
    for (const auto inertia :
         {CounterweightInertia::as_printed, CounterweightInertia::newton_euler}) {
        Input input = with_counterweight(0.1, inertia);
        input.angular_speed = 300.0;
        const Result result = solve(input);
        const auto& m = result.design->mechanism();
        double worst = 0.0;
        // The largest is that of the continuous turn: by brute force on a grid so fine that what it
        // misses is rounding.
        const double mean = result.design->rod_hinge_mean();
        constexpr int n = 1'000'000;
        for (int i = 0; i < n; ++i) {
            const double phi = two_pi * i / n;
            const double moment =
                result.design->rod_moment(std::sin(phi), std::cos(phi)).value(300.0) - mean;
            worst = std::max(worst, std::abs(side_force(m, phi, 300.0, moment)));
        }
        EXPECT_NEAR(*result.largest_side_force_true, worst, 1e-8 + 1e-11 * worst);
        if (inertia == CounterweightInertia::newton_euler) {
            EXPECT_LT(worst, 1e-8);
        } else {
            EXPECT_GT(worst, 1e4);
            EXPECT_FALSE(result.notes.empty());
        }
    }
}

TEST(ElasticHingeRod, BothHingesTogetherKeepTheEnergy) {
    for (const bool counterweight : {false, true}) {
        Input input = counterweight ? with_counterweight(0.05, CounterweightInertia::newton_euler)
                                    : preset_zotov();
        input.spring = Spring{1e5, 0.2, 0.05};
        const Result result = solve(input);
        ASSERT_TRUE(result.crank_guide_with_rod.feasible)
            << result.crank_guide_with_rod.reason.english();
        ASSERT_TRUE(result.rod_guide.feasible) << result.rod_guide.reason.english();
        const auto total = [&](double phi) {
            return result.design->demand(Hinge::crank, phi).energy +
                   test::energy_in(
                       *result.crank_guide_with_rod.shape,
                       result.crank_guide_with_rod.shape->at(Branch::compressed, phi).radius) +
                   test::energy_in(*result.rod_guide.shape,
                                   result.rod_guide.shape->at(Branch::compressed, phi).radius);
        };
        for (int i = 0; i < 360; i += 5) {
            EXPECT_NEAR(total(i * degree), total(0.0), 1e-11 * total(0.0));
        }
    }
}

TEST(ElasticHingeRod, AtLambdaOneTheSeriesIsStillDrawn) {
    Input input = preset_zotov();
    input.lambda = 1.0;
    const std::string rejection = test::error_of([&] { solve(input); });
    EXPECT_EQ(rejection.find("/input/lambda: must be less than 1"), 0U) << rejection;
    EXPECT_NE(rejection.find("locks"), std::string::npos);

    input.kinematics = Kinematics::series;
    const Result result = solve(input);
    EXPECT_EQ(result.curves.rod_hinge_moment.size(), result.crank_angle_deg.size());
    for (std::size_t i = 0; i < result.crank_angle_deg.size(); ++i) {
        EXPECT_TRUE(std::isfinite(result.curves.side_force_without_hinge[i]));
        EXPECT_TRUE(std::isfinite(result.curves.side_force_with_hinge[i]));
    }
    EXPECT_TRUE(result.curves.crank_moment.empty());
    EXPECT_FALSE(result.crank_guide.feasible);
    EXPECT_FALSE(result.crank_guide.lacks_preload);
    EXPECT_NEAR(turn_integral(result.curves.rod_hinge_moment), result.design->rod_hinge_integral(),
                1e-11);
}

TEST(ElasticHingeRod, CurvesAtAnotherSpeedAreThoseOfItsOwnSolution) {
    Input input = with_counterweight(0.1, CounterweightInertia::newton_euler);
    const MechanismCurves other = curves_at(Design(input, false), 300.0);
    input.angular_speed = 300.0;
    const MechanismCurves alone = solve(input).curves;
    EXPECT_EQ(other.crank_moment_with_rod_hinge, alone.crank_moment_with_rod_hinge);
    EXPECT_EQ(other.side_force_without_hinge, alone.side_force_without_hinge);
}

}  // namespace
}  // namespace ravnoves::elastic_hinge
