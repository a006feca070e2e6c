/// Methods that rival the ones in use: that they are what they are called, and what they reach.

#include <gtest/gtest.h>

#include <cmath>

#include "elastic-hinge/presets.h"
#include "methods/enclosure.h"
#include "methods/hinge_mechanism.h"
#include "methods/kernel.h"
#include "numerics/chebyshev.h"
#include "numerics/constants.h"
#include "numerics/runge_kutta.h"

namespace ravnoves::methods {
namespace {

Result result_of(const char* kernel_id, const char* sweep, double value, const char* method,
                 const char* setting) {
    const Kernel& kernel = *find_kernel(kernel_id);
    const std::size_t m = kernel.find_method(method);
    return evaluate(*kernel.problem(kernel.find_sweep(sweep), value), m,
                    kernel.find_setting(m, setting));
}

double reached(const char* kernel_id, const char* sweep, double value, const char* method,
               const char* setting) {
    const Result result = result_of(kernel_id, sweep, value, method, setting);
    EXPECT_EQ(result.refusal.english(), "") << kernel_id << " " << method << " " << setting;
    return result.error;
}

// ---------------------------------------------------------------------------------- integrators

/// φ̈ = −sin φ, from rest at 2 rad: swings with the period 4 K(sin 1).
double pendulum(double angle, double /*speed*/) {
    return -std::sin(angle);
}
const double pendulum_period = 4.0 * std::comp_ellint_1(std::sin(1.0));

/// Distance from the start after a period of so many equal steps.
template <std::size_t S>
double miss(const ImplicitTable<S>& table, int steps) {
    TurnState x{2.0, 0.0};
    std::array<double, S> rates{};
    for (int i = 0; i < steps; ++i) {
        implicit_step(table, pendulum, pendulum_period / steps, x, rates);
    }
    return std::hypot(x.angle - 2.0, x.speed);
}

template <std::size_t S>
double order_of(const ImplicitTable<S>& table, int steps) {
    return std::log2(miss(table, steps) / miss(table, 2 * steps));
}

TEST(RivalIntegrators, HaveTheirOrders) {
    EXPECT_NEAR(order_of(implicit_midpoint, 400), 2.0, 0.05);
    EXPECT_NEAR(order_of(gauss_6, 40), 6.0, 0.3);
    EXPECT_NEAR(order_of(radau_5, 40), 5.0, 0.3);
}

/// bᵢ aᵢⱼ + bⱼ aⱼᵢ = bᵢ bⱼ makes a method symplectic: Gauss's are, Radau's is not.
TEST(RivalIntegrators, GaussIsSymplecticAndRadauIsNot) {
    const auto defect = [](const auto& table) {
        double worst = 0.0;
        for (std::size_t i = 0; i < table.b.size(); ++i) {
            for (std::size_t j = 0; j < table.b.size(); ++j) {
                worst =
                    std::max(worst, std::abs(table.b[i] * table.a[i][j] +
                                             table.b[j] * table.a[j][i] - table.b[i] * table.b[j]));
            }
        }
        return worst;
    };
    EXPECT_LT(defect(implicit_midpoint), 1e-16);
    EXPECT_LT(defect(gauss_6), 1e-16);
    EXPECT_GT(defect(radau_5), 1e-2);
}

/// Order 8: a million times the accuracy for 10^(6/8) times the work.
TEST(RivalIntegrators, Dop853HasOrderEight) {
    double last_calls = 0.0;
    for (const double tolerance : {1e-6, 1e-12}) {
        double calls = 0.0;
        Dop853 method(tolerance, 1.0, 0.1);
        TurnState x{2.0, 0.0};
        EXPECT_TRUE(method.advance(
            [&](double angle, double speed) {
                ++calls;
                return pendulum(angle, speed);
            },
            10.0 * pendulum_period, x));
        EXPECT_LT(std::hypot(x.angle - 2.0, x.speed), 1000.0 * tolerance);
        if (last_calls > 0.0) {
            EXPECT_GT(calls / last_calls, 3.5);
            EXPECT_LT(calls / last_calls, 8.0);
        }
        last_calls = calls;
    }
}

TEST(ChebyshevSeries, GoesThroughItsPointsAndIntegrates) {
    const ChebyshevPoints points(24);
    std::vector<double> values;
    for (std::size_t j = 0; j < points.size(); ++j) {
        values.push_back(std::exp(points[j]));
    }
    std::vector<double> series(points.size());
    std::vector<double> integral(points.size() + 1);
    points.transform(values, series);
    chebyshev_integral(series, integral);
    for (const double x : {-1.0, -0.9, 0.0, 0.123, 0.8, 1.0}) {
        EXPECT_NEAR(chebyshev_value(series, x), std::exp(x), 1e-14);
        EXPECT_NEAR(chebyshev_value(integral, x), std::exp(x) - std::exp(-1.0), 1e-14);
    }
}

// ----------------------------------------------------------------------------------- enclosures

TEST(Enclosures, HoldWhatTheyEnclose) {
    const auto mechanism = mechanism_in<Enclosure>(elastic_hinge::preset_zotov());
    const auto exact = mechanism_in<Real50>(elastic_hinge::preset_zotov());
    double wider = 0.0;
    for (int i = 0; i < 60; ++i) {
        const double from = 0.1 * i;
        const double to = from + 0.01;
        const auto box = energy_rise_at(mechanism, Enclosure(100.0), Enclosure(from, to));
        for (const double phi : {from, 0.3 * from + 0.7 * to, to}) {
            const auto rise = energy_rise_at(exact, Real50(100), Real50(phi));
            EXPECT_LE(Real50(box.rise.lower()), rise.rise);
            EXPECT_GE(Real50(box.rise.upper()), rise.rise);
            EXPECT_LE(Real50(box.slope.lower()), rise.slope);
            EXPECT_GE(Real50(box.slope.upper()), rise.slope);
        }
        wider = std::max(wider, box.rise.upper() - box.rise.lower());
    }
    EXPECT_LT(wider, 2.0);  // J, of 20: an enclosure, and not just any
}

TEST(Enclosures, ProveThatTheGuideExistsOrThatItDoesNot) {
    for (const double spare : {1e2, 1.0, 1e-3, 1e-6}) {
        EXPECT_EQ(result_of("guide", "preload", spare, "intervals", "boxes to 1e-9 rad").refusal,
                  "")
            << spare;
    }
    // The spring stores too little: the closed form sees it at an angle, the intervals too.
    EXPECT_NE(result_of("guide", "preload", -1e-6, "intervals", "boxes to 1e-9 rad")
                  .refusal.english()
                  .find("give out more energy"),
              std::string::npos);
    // Too coarse to tell, and it says so instead of guessing.
    EXPECT_NE(result_of("guide", "preload", 1e-9, "intervals", "boxes to 1e-3 rad")
                  .refusal.english()
                  .find("cannot prove"),
              std::string::npos);
}

/// The bound is above the range, by no more than it says.
TEST(Enclosures, MissNoPeakHoweverNarrow) {
    for (const double width : {0.05, 0.2, 5.0, 60.0}) {
        EXPECT_LT(reached("moment-range", "peak-width", width, "intervals", "to 1e-3"), 1e-3);
        EXPECT_LT(reached("moment-range", "peak-width", width, "intervals", "to 1e-9"), 1e-9);
    }
    EXPECT_LT(reached("moment-range", "spline-rows", 24, "intervals", "to 1e-6"), 1e-6);
}

// ---------------------------------------------------------------------------------- what they do

/// Kinks are at the rows: on the pieces between them three points do what the whole cycle's panels
/// do not.
TEST(RivalQuadrature, GaussLegendreOnThePiecesIsAsGoodAsExact) {
    const auto error = [](const char* method, const char* setting) {
        return reached("cycle-mean", "shaft-angle", 50.0, method, setting);
    };
    EXPECT_LT(error("gauss-pieces", "3 points a piece"), 1e-9);
    EXPECT_LT(error("gauss-pieces", "4 points a piece"), 1e-13);
    EXPECT_GT(error("gauss-legendre", "16 panels"), 1e-6);
    // Pieces of 120° and more.
    EXPECT_GT(reached("cycle-mean", "irregular-rows", 6, "gauss-pieces", "4 points a piece"), 1e-7);
    EXPECT_LT(
        reached("cycle-mean", "irregular-rows", 6, "gauss-pieces", "4 points, at most 30° apart"),
        1e-9);
}

/// What is said of Simpson's rule: worse than the trapezoid rule where kinks lie between its nodes,
/// and order 4 where they do not (the paper has a row every 15°).
TEST(RivalQuadrature, SimpsonsOrderShowsOnlyWithTheRowsOnItsNodes) {
    const auto error = [](const char* method, const char* steps) {
        return reached("cycle-mean", "shaft-angle", 50.0, method, steps);
    };
    for (const char* steps : {"12 steps", "24 steps", "48 steps", "144 steps", "720 steps"}) {
        const double ratio = error("simpson", steps) / error("trapezoid", steps);
        EXPECT_GT(ratio, 1.0) << steps;
        EXPECT_LT(ratio, 1.6) << steps;
    }
    EXPECT_LT(error("simpson", "7200 steps"), 1e-6 * error("trapezoid", "7200 steps"));
}

/// Taken as an equation for the square of the deflection, nothing in the guide is singular.
TEST(RivalGuide, TheSquareIsNotSingular) {
    const auto error = [](double spare, const char* method, const char* setting) {
        return reached("guide", "preload", spare, method, setting);
    };
    for (const double spare : {1e-6, 1e-12}) {
        EXPECT_LT(error(spare, "square-rk4", "3600 steps"),
                  1e-2 * error(spare, "rk4", "3600 steps"))
            << spare;
    }
    EXPECT_LT(error(1e-12, "square-rk4", "3600 steps"), 1e-7);
    EXPECT_LT(error(1e-6, "square-dormand-prince", "1e-12"),
              1e-1 * error(1e-6, "dormand-prince", "1e-12"));
}

TEST(RivalGuide, AChebyshevInterpolantFailsAtTheCornerOnly) {
    EXPECT_LT(reached("guide", "preload", 1.0, "chebyshev", "16 points"), 1e-10);
    EXPECT_GT(reached("guide", "preload", 1e-12, "chebyshev", "16 points"), 1e-4);
    EXPECT_GT(reached("guide", "lambda", 1.0 - 1e-6, "chebyshev", "16 points"), 1e-4);
}

/// As many terms, one digit more at least, and none at locking.
TEST(RivalSliderCrank, AChebyshevInterpolantBeatsTheSeries) {
    for (const double lambda : {0.2, 0.4, 0.6}) {
        for (const char* terms : {"4 terms", "6 terms", "10 terms"}) {
            const double error = reached("slider-crank", "lambda", lambda, "chebyshev", terms);
            EXPECT_LT(
                error,
                std::max(0.2 * reached("slider-crank", "lambda", lambda, "series", terms), 1e-13))
                << lambda << " " << terms;
        }
    }
    EXPECT_GT(reached("slider-crank", "lambda", 0.9999, "chebyshev", "10 terms"), 0.1);
}

/// By energy a motion is known to ten digits for a tenth of what integrating its equation costs.
TEST(RivalMotion, TheEnergyNeedsFewerPlacesThanAnyEquation) {
    const Kernel& kernel = *find_kernel("hinge-motion");
    for (const char* sweep : {"lambda", "start-speed"}) {
        const auto problem = kernel.present_problem(kernel.find_sweep(sweep));
        const auto cost = [&](const char* method, const char* setting) {
            const std::size_t m = kernel.find_method(method);
            const std::size_t s = kernel.find_setting(m, setting);
            EXPECT_LT(evaluate(*problem, m, s).error, 1e-9) << method;
            return problem->operations(m, s);
        };
        const double by_energy = cost("energy-series", "1e-8");
        EXPECT_GT(cost("dop853", "1e-11"), 5.0 * by_energy);
        EXPECT_GT(cost("dormand-prince", "1e-11"), 10.0 * by_energy);
        EXPECT_GT(cost("gauss-6", "180 steps a turn"), 10.0 * by_energy);
    }
}

// --------------------------------------------------------------------------------------- scatter

TEST(RivalSamples, ErrorsFallAtTheirRates) {
    const auto order = [&](const char* sweep, double value, const char* method) {
        const bool chance = std::string(method) == "monte-carlo";
        return std::log(reached("scatter", sweep, value, method, "64 samples") /
                        reached("scatter", sweep, value, method,
                                chance ? "8192 samples" : "4096 samples")) /
               std::log(chance ? 128.0 : 64.0);
    };
    EXPECT_NEAR(order("scatter", 0.01, "monte-carlo"), 0.5, 0.15);
    EXPECT_NEAR(order("corner", -0.5, "monte-carlo"), 0.5, 0.15);
    EXPECT_GT(order("scatter", 0.01, "sobol"), 0.9);
    EXPECT_GT(order("jump", 0.8, "sobol"), 0.6);
    EXPECT_GT(order("corner", -0.5, "sobol"), 0.9);
}

TEST(RivalSamples, SlopesFailAtAJumpAndAtACorner) {
    for (const char* method : {"linear", "second-order"}) {
        EXPECT_LT(reached("scatter", "scatter", 1e-4, method, "differences"), 1e-3) << method;
        EXPECT_GT(reached("scatter", "jump", 0.8, method, "differences"), 0.5) << method;
        EXPECT_GT(reached("scatter", "corner", -0.5, method, "differences"), 0.1) << method;
    }
    // What is curved takes the second order.
    EXPECT_GT(reached("scatter", "scatter", 0.2, "linear", "differences"), 3e-2);
    EXPECT_LT(reached("scatter", "scatter", 0.2, "second-order", "differences"), 1e-2);
}

}  // namespace
}  // namespace ravnoves::methods
