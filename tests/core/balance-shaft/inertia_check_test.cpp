#include "balance-shaft/inertia_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "balance-shaft/engine_torque.h"
#include "balance-shaft/presets.h"
#include "test_cases.h"

namespace ravnoves::balance_shaft {
using test::as_table;
using test::with_table;
using test::written;

namespace {

double angle_of(const Optimum& optimum) {
    return *optimum.shaft_angle / degree;
}

TEST(InertiaCheck, FindsHalfTheInertiaInThePapersTable) {
    const Input input = preset_tmz_650d();
    const Result result = solve(input);
    const InertiaCheck& check = result.inertia_check;
    // Least squares over the eleven rows in a script of its own: 204.914, 0.3275, 0.8377.
    EXPECT_NEAR(*check.fitted, 204.91, 0.05);
    EXPECT_NEAR(check.fitted_lambda, 0.3275, 0.0005);
    EXPECT_NEAR(check.residual_rms, 0.8377, 0.0005);
    EXPECT_NEAR(check.entered, 395.0, 0.5);
    EXPECT_FALSE(*check.consistent);
    EXPECT_NEAR(check.matching_speed / units::rpm, 2600.0, 10.0);
    EXPECT_NEAR(check.matching_mass, 0.682, 0.001);
    EXPECT_EQ(result.notes.front(), check.text);
}

// Rows that are put in on the lines of a table tell nothing: they moved the speed by 24 min⁻¹.
TEST(InertiaCheck, IsTheSameHoweverFinelyTheLinesAreSampled) {
    const Input input = preset_tmz_650d();
    const PeriodicPiecewise lines = torque_curve(input.torque.table, Interpolation::linear);
    for (const int steps : {3, 15, 150}) {
        TorqueTable fine;
        for (int i = 0; i <= 48 * steps; ++i) {
            fine.crank_angle_deg.push_back(15.0 * i / steps);
            fine.torque.push_back(lines(fine.crank_angle_deg.back()));
        }
        const InertiaCheck check = check_inertia(with_table(input, fine));
        EXPECT_NEAR(check.matching_speed / units::rpm, 2590.3, 0.1) << steps;
        EXPECT_EQ(check.warning, check_inertia(input).warning);
    }
}

TEST(InertiaCheck, TheMatchingSpeedMakesTheShaftUseful) {
    const Input input = preset_tmz_650d();
    Input slower = input;
    slower.angular_speed = solve(input).inertia_check.matching_speed;
    const Result matched = solve(slower);
    EXPECT_TRUE(*matched.inertia_check.consistent);
    EXPECT_NEAR(*matched.inertia_check.fitted, matched.inertia_check.entered, 1e-6);
    EXPECT_NEAR(slower.angular_speed / units::rpm, 2590.3, 0.5);
    EXPECT_LT(matched.best_range.value, 0.911 * matched.M_up.range);
    EXPECT_NEAR(matched.best_rms.value, 186.15, 0.05);
    Input near = input;
    near.angular_speed = 2600.0 * units::rpm;
    const Result result = solve(near);
    // With M_s at 2600 min⁻¹: α ≈ 20° cuts the range by 9 %, α ≈ 12° the RMS from 213 to 186.
    EXPECT_NEAR(angle_of(result.best_range), 20.0, 1.0);
    EXPECT_NEAR(result.best_range.value / result.M_up.range, 0.91, 0.005);
    EXPECT_NEAR(angle_of(result.best_rms), 12.0, 0.5);
    EXPECT_NEAR(result.best_rms.value, 186.0, 0.5);
}

TEST(InertiaCheck, TheRebuiltTorqueLeavesNothingToGain) {
    const Input input = preset_tmz_650d();
    const InertiaCheck check = solve(input).inertia_check;
    const Input rebuilt = with_rebuilt_torque(input, check);
    const Result result = solve(rebuilt);
    EXPECT_TRUE(*result.inertia_check.consistent);
    EXPECT_NEAR(*result.inertia_check.fitted, 395.4, 1.0);
    // At 3600 min⁻¹ with its whole inertia no α lowers the range.
    EXPECT_GE(result.best_range.value, result.M_up.range);
    // The mean torque is gas work: inertia has no part in it.
    const auto mean = [](const Input& i) {
        const auto& t = i.torque.table.torque;
        return std::accumulate(t.begin(), t.end() - 1, 0.0) / static_cast<double>(t.size() - 1);
    };
    EXPECT_NEAR(mean(rebuilt), mean(input), 1e-9);
    // At the dead centres there is none, and no rounding in its place: the table shows every digit.
    for (std::size_t i = 0; i < rebuilt.torque.table.size(); ++i) {
        if (std::fmod(rebuilt.torque.table.crank_angle_deg[i], 180.0) == 0.0) {
            EXPECT_EQ(rebuilt.torque.table.torque[i], input.torque.table.torque[i]);
        }
    }
}

/// The table of an engine with noise as a part of the inertia torque's amplitude.
TorqueTable noisy_table(const Input& engine, int step_deg, double noise, unsigned seed) {
    TorqueTable table = as_table(engine, step_deg).torque.table;
    std::mt19937 generator(seed);
    std::normal_distribution<double> normal(
        0.0, noise * engine.reciprocating_mass() *
                 std::pow(engine.crank_radius * engine.angular_speed, 2));
    for (double& torque : table.torque) {
        torque += normal(generator);
    }
    table.torque.back() = table.torque.front();
    return table;
}

Input engine(double mass, double rod_length) {
    Input input = test::diesel();
    input.reciprocating_masses = {{"", mass}};
    input.rod_mass.reset();
    input.cylinder.rod_length = rod_length;
    input.torque.cycle.intake_pressure = 0.95e5;
    input.torque.cycle.heat = 1200.0;
    return input;
}

TEST(InertiaCheck, RecoversKnownMassesThroughNoiseAndWarnsAtAQuarterOff) {
    for (unsigned seed = 1; seed <= 40; ++seed) {
        const double mass = 0.4 + 0.05 * seed;
        const double rod = 0.12 + 0.002 * seed;
        const Input truth = engine(mass, rod);
        const TorqueTable table = noisy_table(truth, seed % 2 == 0 ? 15 : 5, 0.02, seed);
        Input entered = with_table(truth, table);
        const InertiaCheck right = check_inertia(entered);
        ASSERT_TRUE(right.fitted) << seed;
        EXPECT_NEAR(*right.fitted / right.entered, 1.0, 0.05) << seed;
        EXPECT_NEAR(right.fitted_lambda, truth.crank_radius / rod, 0.05) << seed;
        EXPECT_TRUE(*right.consistent);
        const Result solved = solve(entered);
        EXPECT_FALSE(solved.notes.size() > 0 && solved.notes[0] == solved.inertia_check.text);
        for (const double factor : {0.75, 1.25}) {
            entered.reciprocating_masses[0].mass = mass * factor;
            const InertiaCheck wrong = check_inertia(entered);
            EXPECT_FALSE(*wrong.consistent) << seed;
            EXPECT_NEAR(wrong.matching_mass, mass, 0.05 * mass) << seed;
        }
    }
}

// 13 % of the inertia torque is within the tolerance, and was nothing to speak of.
TEST(InertiaCheck, ATableOfAnotherSpeedIsToldBeyondTheDoubt) {
    Input input = engine(1.3, 0.15);
    input.angular_speed = 3000.0 * units::rpm;
    const TorqueTable table = as_table(input, 5).torque.table;
    const struct {
        double speed, noise;
        const char* said;
    } rows[] = {
        {3000, 0.0, ""},
        {2950, 0.0, ""},  // the masses are not known better
        {2800, 0.0, "Torque and masses differ by 14.8 %: the torque fits 3000 min⁻¹ or 1.49 kg."},
        {3180, 0.0, "Torque and masses differ by 11.0 %: the torque fits 3000 min⁻¹ or 1.16 kg."},
        {2870, 0.0, "Torque and masses differ by 9.3 %: the torque fits 3000 min⁻¹ or 1.42 kg."},
        {2870, 0.03, ""},  // nor is the torque
        {2700, 0.0, "Torque and masses do not match: the torque fits 3000 min⁻¹ or 1.6 kg."},
    };
    for (const auto& row : rows) {
        SCOPED_TRACE(row.speed);
        Input typed =
            with_table(input, row.noise > 0.0 ? noisy_table(input, 5, row.noise, 3) : table);
        typed.angular_speed = row.speed * units::rpm;
        const Result result = solve(typed);
        EXPECT_EQ(result.inertia_check.warning.english(), row.said);
        EXPECT_EQ(result.inertia_check.consistent, row.speed > 2700);
        const bool warns = *row.said != '\0';
        EXPECT_EQ(verdict(result).text.english().ends_with(row.said), true);
        EXPECT_EQ(std::ranges::count(result.notes, result.inertia_check.text), warns ? 1 : 0);
    }
}

TEST(InertiaCheck, FindsTheGasExchangeWhereverTheCycleBegins) {
    const Input truth = engine(1.3, 0.15);
    const TorqueTable table = as_table(truth, 5).torque.table;
    TorqueTable shifted = table;  // firing dead centre at 0°
    std::rotate(shifted.torque.begin(), shifted.torque.begin() + 72, shifted.torque.end() - 1);
    shifted.torque.back() = shifted.torque.front();
    const InertiaCheck first = check_inertia(with_table(truth, table));
    const InertiaCheck second = check_inertia(with_table(truth, shifted));
    EXPECT_NEAR(*second.fitted, *first.fitted, 1e-9);
    EXPECT_NEAR(*first.fitted, first.entered, 0.01 * first.entered);
    EXPECT_NEAR(first.fitted_lambda, 0.046 / 0.15, 0.01);
}

TEST(InertiaCheck, AComputedTorqueIsNotComparedWithItself) {
    const InertiaCheck check = solve(engine(1.3, 0.15)).inertia_check;
    EXPECT_FALSE(check.consistent);
    EXPECT_FALSE(check.fitted);
    EXPECT_GT(check.entered, 0.0);
}

/// C (−s′ s″) − d s′ on a crank of r/L = λ, every 15°, with a wave of a part of C for what a fit
/// leaves.
TorqueTable synthetic(double scale, double lambda, double gas, double wave = 0.0) {
    const SliderCrank<double> crank{1.0, 1.0 / lambda};
    TorqueTable table;
    for (int i = 0; i <= 48; ++i) {
        const double angle = 15.0 * (i % 48) * degree;
        const PistonMotion<double> motion = crank.at(angle);
        table.crank_angle_deg.push_back(15.0 * i);
        table.torque.push_back(-scale * motion.ds * motion.d2s - gas * motion.ds +
                               wave * scale * std::sin(7.0 * angle));
    }
    return table;
}

TEST(InertiaCheck, ASteadyPressureOnThePistonDoesNotMoveTheFit) {
    // Half a bar on the piston of the paper's engine against an inertia of 20 N·m; sin φ in place
    // of −s′ made 25.05 of it.
    const double gas = 0.5e5 * pi / 4.0 * 0.0955 * 0.0955 * 0.046;
    Input input = preset_tmz_650d();
    for (const double sign : {1.0, -1.0}) {
        input.cylinder.rod_length.reset();
        const InertiaCheck free =
            check_inertia(with_table(input, synthetic(20.0, 0.3, sign * gas)));
        ASSERT_TRUE(free.fitted);
        EXPECT_NEAR(*free.fitted, 20.0, 1e-4);
        EXPECT_NEAR(free.fitted_lambda, 0.3, 1e-5);
        EXPECT_TRUE(free.lambda_fitted);
        input.cylinder.rod_length = 0.046 / 0.3;
        const InertiaCheck held =
            check_inertia(with_table(input, synthetic(20.0, 0.3, sign * gas)));
        EXPECT_NEAR(*held.fitted, 20.0, 1e-9);
        EXPECT_NEAR(held.fitted_lambda, 0.3, 1e-12);
        EXPECT_FALSE(held.lambda_fitted);
    }
}

TEST(InertiaCheck, SaysNothingWhereTheFitLeavesMuchOrEndsOnABound) {
    Input input = preset_tmz_650d();
    input.cylinder.rod_length.reset();
    EXPECT_TRUE(check_inertia(with_table(input, synthetic(400.0, 0.3, 5.0, 0.01))).consistent);
    const InertiaCheck rough = check_inertia(with_table(input, synthetic(400.0, 0.3, 5.0, 0.2)));
    EXPECT_FALSE(rough.consistent);
    EXPECT_FALSE(rough.fitted);
    EXPECT_EQ(rough.text.english().rfind("The torque during gas exchange does not resemble", 0),
              0U);
    // No slider-crank has r/L = 0.7, or none at all; the search ends at 0.6 and at 0.02.
    for (const double lambda : {0.7, 0.001}) {
        const InertiaCheck bound = check_inertia(with_table(input, synthetic(400.0, lambda, 0.0)));
        EXPECT_FALSE(bound.consistent) << lambda;
        EXPECT_FALSE(bound.fitted) << lambda;
        EXPECT_NE(bound.text.english(), "") << lambda;
    }
    EXPECT_NE(check_inertia(with_table(input, synthetic(400.0, 0.001, 0.0)))
                  .text.english()
                  .find("at the limit of the search"),
              std::string::npos);
}

TEST(InertiaCheck, ATorqueOfAnotherRodIsReportedHoweverFarItIsOff) {
    Input input = with_table(preset_tmz_650d(), synthetic(200.0, 0.3, 5.0));
    for (const double rod : {0.046 / 0.5, 0.046 / 0.2, 0.046 / 0.09}) {
        input.cylinder.rod_length = rod;
        const InertiaCheck check = check_inertia(input);
        ASSERT_TRUE(check.consistent) << rod;
        EXPECT_FALSE(*check.consistent) << rod;
        EXPECT_TRUE(check.is_of_other_rod) << rod;
        EXPECT_TRUE(check.lambda_fitted) << rod;
        EXPECT_NEAR(check.fitted_lambda, 0.3, 1e-4) << rod;
        EXPECT_NE(check.text.english().find("a rod length of 153"), std::string::npos)
            << check.text.english();
    }
    // Rebuilt, the torque is that of the rod entered.
    input = with_rebuilt_torque(input, check_inertia(input));
    EXPECT_EQ(check_inertia(input).consistent, true);
    EXPECT_FALSE(check_inertia(input).is_of_other_rod);
}

TEST(InertiaCheck, SaysWhereNoFitIsPossible) {
    Input input = preset_tmz_650d();
    for (const double torque : {0.0, 42.0}) {
        std::fill(input.torque.table.torque.begin(), input.torque.table.torque.end(), torque);
        const Result result = solve(input);
        EXPECT_FALSE(result.inertia_check.fitted);
        EXPECT_FALSE(result.inertia_check.consistent);
        EXPECT_FALSE(result.inertia_check.text.empty());
        EXPECT_TRUE(written(input).at("inertia_check").at("consistent").is_null());
        EXPECT_EQ(with_rebuilt_torque(input, result.inertia_check), input);
    }
    input.torque.table = {{0, 180, 360, 720}, {0, 10, -10, 0}};
    EXPECT_FALSE(solve(input).inertia_check.fitted);
}

TEST(OrderSpectrum, IsThatOfTheInterpolantAndOnlyTheFirstOrderMoves) {
    const Solver solver(preset_tmz_650d());
    Result result = solver.result();
    ASSERT_EQ(result.spectrum_M_up.size(), 2 * spectrum_orders);
    // Every line against a sum over a fine grid (a trapezium rule, exact enough for lines).
    constexpr int samples = 72'000;
    for (const std::size_t k : {0U, 1U, 2U, 3U, 7U, 23U}) {
        const OrderLine& line = result.spectrum_M_up[k];
        EXPECT_EQ(line.order, static_cast<double>(k + 1) / 2.0);
        double a = 0.0;
        double b = 0.0;
        for (int i = 0; i < samples; ++i) {
            const double phi = 4.0 * pi * i / samples;
            a += solver.M_up(phi) * std::cos(line.order * phi) * 2.0 / samples;
            b += solver.M_up(phi) * std::sin(line.order * phi) * 2.0 / samples;
        }
        EXPECT_NEAR(line.amplitude * std::sin(line.phase), a, 1e-3);
        EXPECT_NEAR(line.amplitude * std::cos(line.phase), b, 1e-3);
    }
    solver.move_shaft(*result.best_rms.shaft_angle, result);
    for (std::size_t k = 0; k < 2 * spectrum_orders; ++k) {
        if (k != 1) {
            EXPECT_EQ(result.spectrum_M_ups[k].amplitude, result.spectrum_M_up[k].amplitude);
        }
    }
    // At the best RMS angle the shaft's moment opposes the first order.
    EXPECT_NEAR(result.spectrum_M_ups[1].amplitude,
                std::abs(result.order_1_amplitude - result.moment_amplitude), 1e-9);
    // Parseval: what the first twelve orders hold is not more than the whole, and near it.
    double sum = 0.0;
    for (const OrderLine& line : result.spectrum_M_up) {
        sum += line.amplitude * line.amplitude / 2.0;
    }
    const double variance = result.M_up.rms * result.M_up.rms;
    EXPECT_LE(sum, variance);
    EXPECT_GE(sum, 0.98 * variance);
}

}  // namespace
}  // namespace ravnoves::balance_shaft
