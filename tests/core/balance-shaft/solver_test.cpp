#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>

#include "balance-shaft/angle_search.h"
#include "balance-shaft/presets.h"
#include "balance-shaft/results.h"
#include "balance-shaft/solver.h"
#include "case-file/json.h"
#include "numerics/periodic_piecewise.h"
#include "test_cases.h"

namespace ravnoves::balance_shaft {
namespace {

using test::random_table;
using test::written;

double angular_distance(double a, double b) {
    return std::abs(std::remainder(a - b, two_pi));
}

/// Integral over the cycle of f(φ), piecewise between the table's rows.
double cycle_mean(const TorqueTable& table, const auto& f) {
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < table.size(); ++i) {
        const double from = table.crank_angle_deg[i] * degree;
        const double to = table.crank_angle_deg[i + 1] * degree;
        constexpr int parts = 8;
        for (int k = 0; k < parts; ++k) {
            sum += boost::math::quadrature::gauss<double, 15>::integrate(
                f, from + (to - from) * k / parts, from + (to - from) * (k + 1) / parts);
        }
    }
    return sum / (4.0 * pi);
}

TEST(BalanceShaftExample, MatchesTheContract) {
    const Solver solver(preset_tmz_650d());
    EXPECT_NEAR(solver.range(50.65 * degree), 1066.7481566759568, 1e-6 * 1066.7);
    EXPECT_NEAR(solver.rms(11.76 * degree), 263.56934456000073, 1e-6 * 263.6);
}

TEST(BalanceShaftPaper, PrintedMeansAreThoseOfItsNodes) {
    const Solver solver(preset_tmz_650d());
    Result result = solver.result();
    for (int alpha = 0; alpha < 360; alpha += 30) {
        double nodes = 0.0;
        for (int k = 0; k <= 24; ++k) {
            nodes += solver.M_s(30.0 * k * degree, alpha * degree) / 25.0;
        }
        solver.move_shaft(alpha * degree, result);
        EXPECT_NEAR(result.printed_mean_M_s, nodes, 1e-11);
        EXPECT_NEAR(result.printed_mean_M_ups, nodes + result.printed_mean_M_up, 1e-11);
    }
}

TEST(BalanceShaftPaper, RangeAndRms) {
    const Solver solver(preset_tmz_650d());
    const Result result = solver.result();
    EXPECT_NEAR(solver.range(240.0 * degree), 1821.0, 0.5);
    // The paper's claim that the RMS could fall does not hold at any angle.
    EXPECT_NE(verdict(result).text.english().find("At every feasible α, the RMS is larger"),
              std::string::npos);
    EXPECT_TRUE(std::all_of(result.sweep.rms.begin(), result.sweep.rms.end(),
                            [&](double rms) { return rms > result.M_up.rms; }));
    const Json json = written(solver.input());
    EXPECT_EQ(json.at("shaft_bearing_load_N"), json.at("counterweight_force_N"));
}

TEST(BalanceShaft, MeanOfTheShaftsMomentIsZeroForEveryAngle) {
    const Solver solver(preset_tmz_650d());
    Result result = solver.result();
    const TorqueTable& table = solver.input().torque.table;
    for (int alpha = 0; alpha < 360; alpha += 7) {
        const double angle = alpha * degree;
        solver.move_shaft(angle, result);
        const double mean = cycle_mean(table, [&](double phi) { return solver.M_s(phi, angle); });
        EXPECT_LE(std::abs(mean), 1e-12 * result.moment_amplitude) << alpha;
        EXPECT_NEAR(result.M_s.mean, mean, 1e-12 * result.moment_amplitude);
        const double total = cycle_mean(
            table, [&](double phi) { return solver.M_up(phi) + solver.M_s(phi, angle); });
        EXPECT_NEAR(result.M_ups.mean, total, 1e-11 * result.moment_amplitude);
    }
}

class AnyCycle : public testing::TestWithParam<std::tuple<Interpolation, int, unsigned>> {
  protected:
    static Input input() {
        Input input = preset_tmz_650d();
        const auto [interpolation, rows, seed] = GetParam();
        input.interpolation = interpolation;
        input.torque.table = random_table(seed, static_cast<std::size_t>(rows));
        input.centre_distance *= 0.05 + 0.35 * seed;  // from a small shaft moment to a large one
        return input;
    }
};

TEST_P(AnyCycle, CriteriaAreThoseOfTheContinuousCycle) {
    const Solver solver(input());
    Result result = solver.result();
    for (const double alpha : {0.0, 1.0, 3.3}) {
        solver.move_shaft(alpha, result);
        const double square = cycle_mean(solver.input().torque.table, [&](double phi) {
            const double value = solver.M_up(phi) + solver.M_s(phi, alpha) - result.M_ups.mean;
            return value * value;
        });
        EXPECT_NEAR(result.M_ups.rms, std::sqrt(square), 1e-10 * std::sqrt(square));
        EXPECT_EQ(solver.rms(alpha), result.M_ups.rms);
        EXPECT_EQ(solver.range(alpha), result.M_ups.range);
        EXPECT_EQ(result.M_ups.range, result.M_ups.max - result.M_ups.min);
        // The function takes these values at the angles given.
        for (const auto& [value, angle] : {std::pair(result.M_ups.max, result.M_ups.max_angle),
                                           std::pair(result.M_ups.min, result.M_ups.min_angle)}) {
            EXPECT_NEAR(solver.M_up(angle) + solver.M_s(angle, alpha), value, 1e-8);
        }
    }
}

TEST_P(AnyCycle, BestAnglesBeatADenseSearch) {
    const Solver solver(input());
    const Result result = solver.result();
    constexpr int angles = 2400;
    double min_range = 1e300;
    double min_rms = 1e300;
    double best_rms_angle = 0.0;
    for (int i = 0; i < angles; ++i) {
        const double alpha = two_pi * i / angles;
        min_range = std::min(min_range, solver.range(alpha));
        if (solver.rms(alpha) < min_rms) {
            min_rms = solver.rms(alpha);
            best_rms_angle = alpha;
        }
    }
    // Exact: never above the search; and not below it by more than |dR/dα| ≤ 2A allows.
    const double step = two_pi / angles;
    EXPECT_LE(result.best_range.value, min_range + 1e-9);
    EXPECT_GE(result.best_range.value, min_range - 2.0 * result.moment_amplitude * step / 2.0);
    EXPECT_NEAR(solver.range(*result.best_range.shaft_angle), result.best_range.value, 1e-9);
    EXPECT_LE(result.best_rms.value, min_rms + 1e-9);
    EXPECT_NEAR(result.best_rms.value, min_rms, 1e-3 * min_rms);
    EXPECT_LE(angular_distance(*result.best_rms.shaft_angle, best_rms_angle), step);
    EXPECT_NEAR(solver.rms(*result.best_rms.shaft_angle), result.best_rms.value, 1e-9);
    // A local proof: no neighbour is better.
    for (const double delta : {1e-7, 1e-5, 1e-3}) {
        EXPECT_GE(solver.range(*result.best_range.shaft_angle + delta),
                  result.best_range.value - 1e-9);
        EXPECT_GE(solver.range(*result.best_range.shaft_angle - delta),
                  result.best_range.value - 1e-9);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Tables, AnyCycle,
    testing::Combine(testing::Values(Interpolation::linear, Interpolation::periodic_cubic),
                     testing::Values(3, 4, 7, 49, 721), testing::Values(1U, 2U, 3U)));

TEST(BestRange, ProvesItsGap) {
    const Solver solver(preset_tmz_650d());
    const TorqueTable& table = solver.input().torque.table;
    const MomentPlane plane(PeriodicPiecewise::linear(table.crank_angle_deg, table.torque));
    const AngleMinimum best = minimise_range(plane, 430.0);
    EXPECT_EQ(best.gap, 0.0);
}

TEST(BestRange, FindsTheOnlyMinimumOfAPureFirstOrder) {
    // M_up = −A sin(φ + 1) sampled finely: the shaft at α = 1 cancels it.
    Input input = preset_tmz_650d();
    const double amplitude = Solver(input).result().moment_amplitude;
    TorqueTable& table = input.torque.table;
    table = {};
    for (int i = 0; i <= 7200; ++i) {
        table.crank_angle_deg.push_back(0.1 * i);
        table.torque.push_back(amplitude * std::sin(0.1 * (i % 3600) * degree + 1.0));
    }
    const Result result = solve(input);
    EXPECT_NEAR(*result.best_range.shaft_angle, 1.0, 1e-4);
    EXPECT_NEAR(result.best_range.value, 0.0, 1e-3);
    EXPECT_NEAR(*result.best_rms.shaft_angle, 1.0, 1e-6);
    EXPECT_NEAR(*result.order_1_share, 1.0, 1e-6);
    EXPECT_NEAR(result.order_1_amplitude, amplitude, 1e-5 * amplitude);
}

/// Every moment is that of a reference times `scale`, every angle the same.
void expect_same(const Result& result, const Result& reference, double scale = 1.0) {
    const double near = 1e-9 * scale;
    EXPECT_NEAR(result.M_ups.range, reference.M_ups.range * scale, near);
    EXPECT_NEAR(result.M_ups.rms, reference.M_ups.rms * scale, near);
    EXPECT_NEAR(result.M_ups.mean, reference.M_ups.mean * scale, near);
    EXPECT_NEAR(result.M_ups.max_angle, reference.M_ups.max_angle, 1e-9);
    EXPECT_NEAR(result.order_1_amplitude, reference.order_1_amplitude * scale, near);
    EXPECT_NEAR(result.best_range.value, reference.best_range.value * scale, near);
    EXPECT_NEAR(*result.best_range.shaft_angle, *reference.best_range.shaft_angle, 1e-8);
    EXPECT_NEAR(*result.best_rms.shaft_angle, *reference.best_rms.shaft_angle, 1e-9);
    for (std::size_t i = 0; i < reference.curves.M_ups.size(); ++i) {
        EXPECT_NEAR(result.curves.M_ups[i], reference.curves.M_ups[i] * scale, near);
    }
    for (std::size_t i = 0; i < reference.sweep.range.size(); ++i) {
        EXPECT_NEAR(result.sweep.range[i], reference.sweep.range[i] * scale, near);
        EXPECT_NEAR(result.sweep.rms[i], reference.sweep.rms[i] * scale, near);
    }
}

TEST(BalanceShaft, AShiftOfTheTableByACycleChangesNothing) {
    const Result reference = solve(preset_tmz_650d());
    for (const double shift : {720.0, -720.0, -360.0}) {
        Input input = preset_tmz_650d();
        TorqueTable& table = input.torque.table;
        if (shift == -360.0) {  // the same cycle begun at the other dead centre
            std::rotate(table.torque.begin(), table.torque.begin() + 24, table.torque.end() - 1);
            table.torque.back() = table.torque.front();
        }
        for (double& angle : table.crank_angle_deg) {
            angle += shift;
        }
        expect_same(solve(input), reference);
    }
}

TEST(BalanceShaft, NodesAddedOnALineChangeNothing) {
    const Result reference = solve(preset_tmz_650d());
    Input input = preset_tmz_650d();
    const TorqueTable coarse = input.torque.table;
    TorqueTable& fine = input.torque.table;
    fine = {};
    for (std::size_t i = 0; i + 1 < coarse.size(); ++i) {
        for (const double t : {0.0, 0.1, 0.37, 0.9}) {
            fine.crank_angle_deg.push_back(coarse.crank_angle_deg[i] + 15.0 * t);
            fine.torque.push_back(coarse.torque[i] + t * (coarse.torque[i + 1] - coarse.torque[i]));
        }
    }
    fine.crank_angle_deg.push_back(720.0);
    fine.torque.push_back(0.0);
    expect_same(solve(input), reference);
}

TEST(BalanceShaft, MomentsScaleTogether) {
    // Masses and torque times k: every moment times k, every angle the same.
    const Result reference = solve(preset_tmz_650d());
    for (const double k : {1e-3, 7.0, 1e6}) {
        Input input = preset_tmz_650d();
        for (NamedMass& part : input.reciprocating_masses) {
            part.mass *= k;
        }
        *input.rod_mass *= k;
        for (double& torque : input.torque.table.torque) {
            torque *= k;
        }
        expect_same(solve(input), reference, k);
    }
}

TEST(BalanceShaft, AShaftWithoutMomentChangesNothingAndSaysSo) {
    for (const bool by_distance : {true, false}) {
        Input input = preset_tmz_650d();
        if (by_distance) {
            input.centre_distance = 0.0;
        } else {
            input.counterweight_mass = 0.0;
        }
        const Result result = solve(input);
        EXPECT_FALSE(result.best_range.shaft_angle);
        EXPECT_FALSE(result.best_rms.shaft_angle);
        EXPECT_FALSE(result.best_range.note.empty());
        EXPECT_NEAR(result.best_range.value, 1208.0, 1e-9);
        EXPECT_NEAR(result.M_ups.range, 1208.0, 1e-9);
        EXPECT_TRUE(std::any_of(result.notes.begin(), result.notes.end(), [](const Message& note) {
            return note.english().starts_with("The shaft has no moment");
        }));
        EXPECT_TRUE(written(input).at("optimum").at("range").at("shaft_angle_deg").is_null());
    }
}

TEST(BalanceShaft, AConstantTorqueLeavesEveryAngleEqual) {
    Input input = preset_tmz_650d();
    std::fill(input.torque.table.torque.begin(), input.torque.table.torque.end(), 42.0);
    for (const Interpolation interpolation :
         {Interpolation::linear, Interpolation::periodic_cubic}) {
        input.interpolation = interpolation;
        const Result result = solve(input);
        EXPECT_FALSE(result.best_range.shaft_angle);
        EXPECT_FALSE(result.best_rms.shaft_angle);
        EXPECT_NEAR(result.best_range.value, 2.0 * result.moment_amplitude, 1e-9);
        EXPECT_FALSE(result.order_1_share);
        EXPECT_FALSE(result.range_change);
        EXPECT_NEAR(result.M_up.mean, -42.0, 1e-12);
    }
}

TEST(BalanceShaft, ASecondOrderTorqueHasNoBestRmsAngle) {
    Input input = preset_tmz_650d();
    TorqueTable& table = input.torque.table;
    table = {};
    for (int i = 0; i <= 720; ++i) {
        table.crank_angle_deg.push_back(i);
        table.torque.push_back(300.0 * std::sin(2.0 * (i % 180) * degree));
    }
    const Result result = solve(input);
    EXPECT_FALSE(result.best_rms.shaft_angle);
    EXPECT_FALSE(result.best_rms.note.empty());
    EXPECT_TRUE(result.best_range.shaft_angle);
}

TEST(BalanceShaft, AFlatMinimumSaysFromWhereToWhere) {
    Input input = preset_tmz_650d();
    EXPECT_TRUE(solve(input).best_range.note.empty());
    EXPECT_TRUE(solve(input).best_range_buildable.note.empty());  // at an end of what can be built
    // Maximum and minimum of the torque are a turn apart: the shaft moves them alike, until its own
    // extremes are beyond them.
    const double peak = 1.5 * solve(input).moment_amplitude;
    input.torque.table = {{0, 20, 40, 360, 380, 400, 720}, {0, peak, 0, 0, -peak, 0, 0}};
    const Solver solver(input);
    const Result result = solver.result();
    ASSERT_TRUE(result.best_range.shaft_angle);
    EXPECT_NEAR(result.best_range.value, 2.0 * peak, 1e-9 * peak);
    EXPECT_EQ(result.best_range.note.english(),
              "The range is the same at least from 310.0° to 10.0°.");
    for (const double same : {310.0, 340.0, 10.0}) {
        EXPECT_NEAR(solver.range(same * degree), 2.0 * peak, 1e-9 * peak);
    }
    for (const double larger : {309.0, 11.0}) {
        EXPECT_GT(solver.range(larger * degree), 2.005 * peak);
    }
    EXPECT_EQ(written(input).at("optimum").at("range").at("note"),
              result.best_range.note.english());
}

TEST(BalanceShaft, MovingTheShaftEqualsSolvingAgain) {
    Input input = preset_tmz_650d();
    const Solver solver(input);
    Result moved = solver.result();
    for (const double angle : {0.0, 0.1, 123.4, 359.9, 405.0, -45.0}) {
        solver.move_shaft(angle * degree, moved);
        input.shaft_angle = angle * degree;
        const Result again = solve(input);
        EXPECT_EQ(moved.M_s.max_angle, again.M_s.max_angle) << angle;
        EXPECT_EQ(moved.M_ups.range, again.M_ups.range) << angle;
        EXPECT_EQ(moved.rms_change, again.rms_change) << angle;
        EXPECT_EQ(moved.printed_mean_M_ups, again.printed_mean_M_ups) << angle;
        EXPECT_EQ(moved.curves.M_ups, again.curves.M_ups) << angle;
        EXPECT_EQ(moved.spectrum_M_ups[1].phase, again.spectrum_M_ups[1].phase) << angle;
        EXPECT_EQ(moved.envelope.width(), again.envelope.width()) << angle;
        EXPECT_EQ(verdict(moved).text, verdict(again).text) << angle;
    }
}

TEST(BalanceShaft, CounterweightGivenIsUsedAndJudged) {
    Input input = preset_tmz_650d();
    input.counterweight_mass = 0.329;  // half
    const Result result = solve(input);
    EXPECT_NEAR(result.counterweight_force, 4297.4 / 2.0, 0.05);
    ASSERT_FALSE(result.notes.empty());
    EXPECT_TRUE(result.notes.back().english().starts_with("The counterweight balances 50 % of"))
        << result.notes.back().english();
}

TEST(BalanceShaft, StepsThatDoNotDivideTheCycleEndAtItsEnd) {
    Input input = preset_tmz_650d();
    for (const double step : {0.01, 0.7, 1.0, 15.0, 90.0}) {
        input.step_deg = step;
        const Result result = solve(input);
        EXPECT_EQ(result.curves.crank_angle_deg.back(), 720.0);
        EXPECT_EQ(result.sweep.shaft_angle_deg.back(), 360.0);
        const auto& angles = result.curves.crank_angle_deg;
        EXPECT_TRUE(std::adjacent_find(angles.begin(), angles.end(), std::greater_equal<>()) ==
                    angles.end());
        EXPECT_EQ(result.curves.M_ups.size(), angles.size());
        EXPECT_NEAR(result.curves.M_ups.front(), result.curves.M_ups.back(), 1e-9);
    }
}

TEST(BalanceShaftEnvelope, BoxesTheCirclesAndTheCylinder) {
    Input input = preset_tmz_650d();
    input.envelope.crank_swing_radius = 0.070;
    input.envelope.shaft_swing_radius = 0.050;
    input.envelope.gear_tip_radius = 0.052;
    input.envelope.cylinder_top = 0.250;
    input.envelope.wall = 0.005;
    input.centre_distance = 0.1;
    const Solver solver(input);
    const Envelope right = envelope(solver.front_view(), 90.0 * degree);
    EXPECT_NEAR(right.width(), 0.075 + 0.1 + 0.057, 1e-12);
    EXPECT_NEAR(right.height(), 0.075 + 0.255, 1e-12);
    const Envelope below = envelope(solver.front_view(), 180.0 * degree);
    EXPECT_NEAR(below.width(), 0.150, 1e-12);
    EXPECT_NEAR(below.height(), 0.157 + 0.255, 1e-12);
    const Envelope above = envelope(solver.front_view(), 0.0);
    EXPECT_NEAR(above.height(), 0.075 + 0.255, 1e-12);
    // Mirror image.
    EXPECT_NEAR(envelope(solver.front_view(), 1.0).width(),
                envelope(solver.front_view(), -1.0).width(), 1e-12);
}

}  // namespace
}  // namespace ravnoves::balance_shaft
