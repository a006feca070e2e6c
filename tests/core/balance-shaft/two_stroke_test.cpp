#include <gtest/gtest.h>

#include <cmath>

#include "balance-shaft/cylinder_gas.h"
#include "balance-shaft/engine_torque.h"
#include "balance-shaft/gear_error.h"
#include "balance-shaft/input.h"
#include "case-file/json.h"
#include "test_cases.h"

namespace ravnoves::balance_shaft {
namespace {

using test::as_table;
using test::error_of;
using test::two_stroke;

/// The same table twice, as of a four-stroke engine.
Input repeated(const Input& one_turn) {
    Input input = one_turn;
    input.strokes = 4;
    TorqueTable& table = input.torque.table;
    const std::size_t rows = table.size();
    for (std::size_t i = 1; i < rows; ++i) {
        table.crank_angle_deg.push_back(table.crank_angle_deg[i] + 360.0);
        table.torque.push_back(table.torque[i]);
    }
    return input;
}

TEST(TwoStroke, ATableMustSpanTheCycle) {
    const Input one_turn = as_table(two_stroke());
    Json json = write_input(one_turn);
    EXPECT_EQ(json.at("strokes"), 2);
    EXPECT_EQ(read_input(json, {}), one_turn);
    json.erase("strokes");
    EXPECT_EQ(error_of([&] { read_input(json, {}); }),
              "/input/strokes: must be 2, since the torque table spans 360°, got 4");
    json = write_input(preset_tmz_650d());
    EXPECT_FALSE(json.contains("strokes"));
    json["strokes"] = 2;
    EXPECT_EQ(error_of([&] { read_input(json, {}); }),
              "/input/strokes: must be 4, since the torque table spans 720°, got 2");
    json["strokes"] = 3;
    EXPECT_EQ(error_of([&] { read_input(json, {}); }), "/input/strokes: must be 2 or 4, got 3");
}

TEST(TwoStroke, OneTurnIsWhatTheSameTurnTwiceIs) {
    for (const Interpolation interpolation :
         {Interpolation::linear, Interpolation::periodic_cubic}) {
        Input one = as_table(two_stroke());
        one.interpolation = interpolation;
        const Result turn = solve(one);
        const Result turns = solve(repeated(one));
        const double size = turn.M_up.range;
        const auto same = [&](const MomentMetrics& a, const MomentMetrics& b) {
            EXPECT_NEAR(a.mean, b.mean, 1e-10 * size);
            EXPECT_NEAR(a.max, b.max, 1e-10 * size);
            EXPECT_NEAR(a.min, b.min, 1e-10 * size);
            EXPECT_NEAR(a.rms, b.rms, 1e-10 * size);
            EXPECT_LT(a.max_angle, two_pi + 1e-9);
            EXPECT_LT(a.min_angle, two_pi + 1e-9);
            EXPECT_NEAR(std::remainder(a.max_angle - b.max_angle, two_pi), 0.0, 1e-6);
            EXPECT_NEAR(std::remainder(a.min_angle - b.min_angle, two_pi), 0.0, 1e-6);
        };
        same(turn.M_up, turns.M_up);
        same(turn.M_ups, turns.M_ups);
        EXPECT_NEAR(turn.best_range.value, turns.best_range.value, 1e-9 * size);
        EXPECT_NEAR(*turn.best_rms.shaft_angle, *turns.best_rms.shaft_angle, 1e-9);
        EXPECT_NEAR(turn.flywheel.excess_work, turns.flywheel.excess_work, 1e-9 * size);
        // Whole orders, and they are those of the two turns; the halves of these are nothing.
        ASSERT_EQ(turn.spectrum_M_up.size(), spectrum_orders);
        for (std::size_t k = 0; k < spectrum_orders; ++k) {
            EXPECT_EQ(turn.spectrum_M_up[k].order, static_cast<double>(k + 1));
            EXPECT_NEAR(turn.spectrum_M_up[k].amplitude, turns.spectrum_M_up[2 * k + 1].amplitude,
                        1e-9 * size);
            EXPECT_NEAR(turn.spectrum_M_ups[k].amplitude, turns.spectrum_M_ups[2 * k + 1].amplitude,
                        1e-9 * size);
            EXPECT_NEAR(turns.spectrum_M_up[2 * k].amplitude, 0.0, 1e-9 * size);
        }
        EXPECT_EQ(turn.curves.crank_angle_deg.back(), 360.0);
        // 13 nodes every 30°, the end counted twice.
        double sum = 0.0;
        const Solver solver(one);
        for (int i = 0; i <= 12; ++i) {
            sum += solver.M_s(30.0 * i * degree, one.shaft_angle) / 13.0;
        }
        EXPECT_NEAR(turn.printed_mean_M_s, sum, 1e-9);
        EXPECT_EQ(gear_error(solver, 0.0).crank_angle_deg.back(), 360.0);
        EXPECT_FALSE(turn.inertia_check.consistent);
        EXPECT_NE(turn.inertia_check.text.english().find("two-stroke"), std::string::npos);
    }
}

TEST(TwoStroke, TheInertiaCheckOfAMotoredTableWorksOverOneTurn) {
    Input input = two_stroke();
    const SliderCrank<double> crank = slider_crank(input);
    Input table = as_table(input);
    for (std::size_t i = 0; i < table.torque.table.size(); ++i) {
        table.torque.table.torque[i] =
            inertia_torque(crank.at(static_cast<double>(i % 360) * degree),
                           input.reciprocating_mass(), input.angular_speed);
    }
    const InertiaCheck check = solve(table).inertia_check;
    ASSERT_TRUE(check.consistent);
    EXPECT_TRUE(*check.consistent);
    EXPECT_NEAR(*check.fitted, check.entered, 1e-6 * check.entered);
}

TEST(TwoStroke, TheCycleIsContinuousAndItsWorkThatOfItsTorque) {
    for (const double offset : {0.0, 0.006}) {
        for (const double ports : {95.0, 120.0}) {
            Input input = two_stroke();
            input.cylinder.offset = offset;
            input.torque.cycle.ports_open = ports * degree;
            const CylinderGas gas = *cylinder_gas(input);
            const double top = gas.top_dead_centre();
            // Everywhere but at the bottom dead centre, where the piston stands still.
            const SliderCrank<double> crank = slider_crank(input);
            double largest = 0.0;
            for (int i = 0; i < 72'000; ++i) {
                const double theta = two_pi * i / 72'000;
                largest = std::max(largest, std::abs(gas.torque(theta + 1e-7) - gas.torque(theta)));
            }
            EXPECT_LT(largest, 0.1);
            // The ports close at the place of their opening, and compression begins there.
            const double place = crank.at(top + ports * degree).s;
            double closing = crank.bottom_dead_centre();
            for (double step = 0.1; step > 1e-9; step /= 2.0) {
                while (crank.at(closing + step).s < place) {
                    closing += step;
                }
            }
            EXPECT_NEAR(gas.pressure(closing - 1e-6), 1.2e5, 1e-3);
            EXPECT_GT(gas.pressure(closing + 0.01), 1.2e5 + 10.0);
            const double n = input.torque.cycle.polytropic_compression;
            EXPECT_NEAR(gas.pressure(top + 300.0 * degree),
                        1.2e5 * std::pow(gas.volume(closing) / gas.volume(top + 300.0 * degree), n),
                        1.0);
            double work = 0.0;
            constexpr int steps = 360'000;
            for (int i = 0; i < steps; ++i) {
                work += gas.torque(two_pi * (i + 0.5) / steps) * two_pi / steps;
            }
            EXPECT_NEAR(gas.indicated().work, work, 1e-5 * std::abs(work));
            const Result result = solve(input);
            EXPECT_NEAR(result.curves.crank_angle_deg.back(), 360.0, 1e-12);
        }
    }
}

}  // namespace
}  // namespace ravnoves::balance_shaft
