#include "balance-shaft/results.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "balance-shaft/crank_balance.h"
#include "balance-shaft/engine_torque.h"
#include "balance-shaft/gear_error.h"
#include "balance-shaft/input.h"
#include "balance-shaft/solver.h"
#include "case-file/json.h"
#include "test_cases.h"

namespace ravnoves::balance_shaft {
namespace {

using test::diesel;
using test::error_of;

/// 1.316 kg, r 46 mm, L 150 mm at 3000 min⁻¹ with 1100 J per cycle.
Input offset_engine(double offset = 8e-3) {
    Input input = diesel();
    input.angular_speed = 3000.0 * units::rpm;
    input.cylinder.offset = offset;
    input.torque.cycle.heat = 1100.0;
    input.torque.cycle.combustion_start = 350.0 * degree;
    return input;
}

/// s″ by differences of the position alone.
double acceleration(const SliderCrank<double>& crank, double theta) {
    constexpr double h = 1e-3;
    const auto s = [&](double step) { return crank.at(theta + step * h).s; };
    return (-s(2) + 16.0 * s(1) - 30.0 * s(0) + 16.0 * s(-1) - s(-2)) / (12.0 * h * h);
}

// Of a table it was that of the torque alone: 31.59 for 22.17 N·m.
TEST(OffsetCylinder, TheMeanOfTheRowsIsThatOfTheTippingMoment) {
    Input input = preset_tmz_650d();
    input.cylinder.rod_length = 0.150;
    for (const double offset : {0.0, 8e-3, -25e-3}) {
        input.cylinder.offset = offset;
        const SliderCrank<double> crank = slider_crank(input);
        const double factor =
            input.reciprocating_mass() * input.angular_speed * input.angular_speed * offset;
        const TorqueTable& table = input.torque.table;
        double sum = 0.0;
        for (std::size_t i = 0; i < table.size(); ++i) {
            const double theta = table.crank_angle_deg[i] * degree + crank.top_dead_centre();
            sum += factor * acceleration(crank, theta) - table.torque[i];
        }
        EXPECT_NEAR(solve(input).printed_mean_M_up, sum / static_cast<double>(table.size()), 1e-6)
            << offset;
    }
}

/// Clockwise moment about the crank axis.
double moment(const Vector2& at, const Vector2& force) {
    return at.y * force.x - at.x * force.y;
}

TEST(OffsetCylinder, TippingMomentByNewtonAndEulerOnTheBlock) {
    for (const double offset : {8e-3, -8e-3, 0.0, 25e-3}) {
        const Input input = offset_engine(offset);
        const Solver solver(input);
        const CylinderGas gas = *cylinder_gas(input);
        const SliderCrank<double> crank = slider_crank(input);
        const double area = pi / 4.0 * 0.0955 * 0.0955;
        const double mass = input.reciprocating_mass();
        const double speed2 = input.angular_speed * input.angular_speed;
        const double head = 0.3;
        for (int i = 0; i < 1440; i += 11) {
            const double phi = i / 2.0 * degree;  // a row of the computed torque
            const double theta = phi + crank.top_dead_centre();
            const Vector2 pin{crank.crank_radius * std::sin(theta),
                              crank.crank_radius * std::cos(theta)};
            const Vector2 piston{offset, crank.at(theta).s};
            const double pressed = (gas.pressure(theta) - 1e5) * area;
            // The piston: m a = rod − gas along the cylinder, rod = wall across it.
            const double rod_y = pressed + mass * speed2 * acceleration(crank, theta);
            const double rod_x = rod_y * (piston.x - pin.x) / (piston.y - pin.y);
            // The block: gas on the head, piston on the wall; the main bearing has no lever.
            const double tipping =
                moment({offset, head}, {0.0, pressed}) + moment(piston, {rod_x, 0.0});
            EXPECT_NEAR(solver.M_up(phi), tipping, 1e-5) << offset << " " << i;
            // The engine torque is what the rod does to the crank.
            const double torque = moment(pin, {-rod_x, -rod_y});
            const double term = offset * mass * speed2 * crank.at(theta).d2s;
            EXPECT_NEAR(tipping, -torque + term, 1e-5);
        }
    }
}

TEST(OffsetCylinder, TheExamplesNumbers) {
    const Result result = solve(offset_engine());
    const auto& curves = result.curves;
    const auto [low, high] = std::minmax_element(curves.M_offset.begin(), curves.M_offset.end());
    EXPECT_NEAR(std::max(-*low, *high), 62.53, 0.01);
    EXPECT_NEAR(result.dead_centre / degree, 2.3393, 1e-4);
    EXPECT_NEAR(result.counterweight_lag / degree, 3.1723, 1e-4);
    // Weights left opposite the crankpin would be best at 35.67°; they lag, so α grows by the lag.
    EXPECT_NEAR((*result.best_rms.shaft_angle - result.counterweight_lag) / degree, 35.67, 0.02);
    EXPECT_NEAR(*result.best_rms.shaft_angle / degree, 38.84, 0.02);
    EXPECT_NEAR(result.best_rms.value / result.M_up.rms - 1.0, -0.0685, 5e-4);
    // That angle cannot be built, and the user is told.
    EXPECT_FALSE(result.buildable.contains(*result.best_rms.shaft_angle));
    EXPECT_GT(result.best_rms_buildable.value, result.M_up.rms);
    EXPECT_NE(verdict(result).text.english().find(
                  "At every feasible α, the RMS is larger than without shaft."),
              std::string::npos);
    // Without the moment of the reciprocating masses the shaft seems to be of no use.
    Input centred = offset_engine();
    centred.cylinder.offset = 0.0;
    const Result without = solve(centred);
    EXPECT_GT(without.best_rms.value, without.M_up.rms);
    for (std::size_t i = 0; i < curves.M_up.size(); i += 7) {
        EXPECT_NEAR(curves.M_up[i], curves.M_offset[i] - curves.M_gas[i] - curves.M_inertia[i],
                    1e-9);
    }
}

TEST(OffsetCylinder, CounterweightsMeetTheFirstOrder) {
    for (const double offset : {0.0, 8e-3, -8e-3}) {
        const Input input = offset_engine(offset);
        const Solver solver(input);
        const CrankBalance balance = crank_balance(solver);
        // Fourier coefficients of the drawn forces' sum, over a turn.
        std::complex<double> across;
        std::complex<double> along;
        std::complex<double> first_order;
        constexpr int count = 720;
        for (int i = 0; i < count; ++i) {
            const double phi = two_pi * i / count;
            const MechanismPose pose = mechanism_pose(solver, phi, 1.0);
            const double inertia = -input.reciprocating_mass() * std::pow(input.angular_speed, 2) *
                                   solver.moments().crank.at(phi + solver.moments().top).d2s;
            const auto turn = std::polar(2.0 / count, phi);
            across += (pose.crank_counterweight_force.x + pose.shaft_counterweight_force.x) * turn;
            along +=
                (inertia + pose.crank_counterweight_force.y + pose.shaft_counterweight_force.y) *
                turn;
            first_order += inertia * turn;
        }
        EXPECT_NEAR(std::abs(across), 0.0, 1e-8);
        EXPECT_NEAR(std::abs(along), balance.with_shaft, 1e-8);
        EXPECT_NEAR(std::abs(first_order), balance.first_order, 1e-8);
        if (offset == 0.0) {
            EXPECT_NEAR(balance.with_shaft, 0.0, 1e-9);
            continue;
        }
        // Equation (1) leaves the little by which r₁ exceeds r, not the 331 N that weights opposite
        // the crankpin leave.
        EXPECT_NEAR(balance.with_shaft, 9.17, 0.01);
        const double in_quadrature =
            balance.first_order * std::sin(std::abs(solver.moments().piston_1.lag));
        EXPECT_NEAR(in_quadrature, 331.14, 0.01);
        // And with m₁ by r₁ nothing is left.
        Input exact = input;
        exact.counterweight_mass =
            input.reciprocating_mass() * solver.moments().piston_1.radius / (2.0 * 0.046);
        EXPECT_NEAR(crank_balance(Solver(exact)).with_shaft, 0.0, 1e-9);
    }
}

TEST(Mechanism, PictureObeysRodAndMoments) {
    for (const Input& input : {preset_tmz_650d(), offset_engine()}) {
        const Solver solver(input);
        const SliderCrank<double> crank = slider_crank(input);
        const double e = crank.offset;
        const double longest =
            std::sqrt(std::pow(crank.rod_length + crank.crank_radius, 2) - e * e);
        EXPECT_NEAR(mechanism_pose(solver, 0.0, 1.0).piston_pin.y, longest, 1e-15);
        for (double phi = 0.0; phi < 12.6; phi += 0.37) {
            const double alpha = phi / 2.0;
            const MechanismPose pose = mechanism_pose(solver, phi, alpha);
            EXPECT_LE(pose.piston_pin.y, longest + 1e-15);
            EXPECT_EQ(pose.piston_pin.x, e);
            EXPECT_NEAR(std::hypot(pose.piston_pin.x - pose.crankpin.x,
                                   pose.piston_pin.y - pose.crankpin.y),
                        crank.rod_length, 1e-12);
            EXPECT_NEAR(moment(pose.shaft_counterweight, pose.shaft_counterweight_force) +
                            moment(pose.crank_counterweight, pose.crank_counterweight_force),
                        solver.M_s(phi, alpha), 1e-9);
            // What the first order's forces leave.
            EXPECT_LE(std::abs(pose.inertia_force_1.y + pose.crank_counterweight_force.y +
                               pose.shaft_counterweight_force.y),
                      crank_balance(solver).with_shaft + 1e-8);
            EXPECT_NEAR(pose.crank_counterweight_force.x + pose.shaft_counterweight_force.x, 0.0,
                        1e-8);
        }
    }
    Input left = offset_engine(-8e-3);
    left.centre_distance = 0.0;
    left.envelope.crank_swing_radius = left.envelope.shaft_swing_radius = 0.01;
    const Envelope box = envelope(Solver(left).front_view(), 1.0);
    EXPECT_NEAR(box.left, -8e-3 - 0.0955 * 0.56, 1e-15);
    EXPECT_NEAR(box.right, -8e-3 + 0.0955 * 0.56, 1e-15);
}

TEST(OffsetCylinder, MirrorImageHasTheMirroredTerm) {
    // e → −e and time reversed: φ → −φ.
    const Solver right(offset_engine());
    const Solver left(offset_engine(-8e-3));
    const auto& a = right.result().curves.M_offset;
    const auto& b = left.result().curves.M_offset;
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_NEAR(a[i], -b[a.size() - 1 - i], 1e-9);
    }
    EXPECT_NEAR(right.moments().phase, -left.moments().phase, 1e-15);
}

TEST(OffsetCylinder, AngleSweepMetricsAndGearsFollow) {
    const Solver solver(offset_engine());
    Result result = solver.result();
    for (const double alpha : {0.3, 2.0, 5.0}) {
        solver.move_shaft(alpha, result);
        constexpr int count = 14400;
        double high = -1e300;
        double low = 1e300;
        double mean = 0.0;
        double square = 0.0;
        std::complex<double> first_order;
        for (int i = 0; i < count; ++i) {
            const double phi = 4.0 * pi * i / count;
            const double value = solver.M_up(phi) + solver.M_s(phi, alpha);
            high = std::max(high, value);
            low = std::min(low, value);
            mean += value / count;
            square += value * value / count;
            first_order += value * std::polar(2.0 / count, phi);
        }
        EXPECT_NEAR(result.M_ups.range, high - low, 0.02);
        EXPECT_GE(result.M_ups.range, high - low - 1e-9);
        EXPECT_NEAR(result.M_ups.rms, std::sqrt(square - mean * mean), 1e-3);
        EXPECT_NEAR(result.spectrum_M_ups[1].amplitude, std::abs(first_order), 1e-2);
        EXPECT_NEAR(solver.M_s(result.M_s.max_angle, alpha), result.moment_amplitude, 1e-9);
        EXPECT_NEAR(solver.range(alpha), result.M_ups.range, 1e-9);
        const std::size_t at = 137;
        EXPECT_NEAR(result.curves.M_ups[at],
                    solver.M_up(137.0 * degree) + solver.M_s(137.0 * degree, alpha), 1e-9);
        EXPECT_NEAR(gear_error(solver, alpha).M_ups[at], result.curves.M_ups[at], 1e-9);
    }
}

TEST(OffsetCylinder, AMeasuredTableHasTheTermToo) {
    const Input computed = offset_engine();
    const Result expected = solve(computed);
    const PeriodicPiecewise torque =
        torque_parts(computed, *cylinder_gas(computed)).at(computed.angular_speed);
    Input table = computed;
    table.torque.kind = TorqueSource::Kind::table;
    for (int i = 0; i <= 1440; ++i) {
        table.torque.table.crank_angle_deg.push_back(i / 2.0);
        table.torque.table.torque.push_back(torque(i % 1440 / 2.0));
    }
    const Result result = solve(table);
    // Straight lines between the rows are all that differs.
    EXPECT_NEAR(result.M_up.range, expected.M_up.range, 0.1);
    EXPECT_NEAR(result.best_rms.value, expected.best_rms.value, 0.02);
    // The check of the table knows the offset too.
    ASSERT_TRUE(result.inertia_check.fitted);
    EXPECT_NEAR(*result.inertia_check.fitted, result.inertia_check.entered,
                1e-6 * result.inertia_check.entered);
    table.cylinder.rod_length.reset();
    const InertiaCheck check = solve(table).inertia_check;
    ASSERT_TRUE(check.fitted) << check.text.english();
    EXPECT_NEAR(check.fitted_lambda, 46.0 / 150.0, 1e-4);
    table.cylinder.rod_length = computed.cylinder.rod_length;
    // The torque stays as measured, the term follows the speed.
    table.angular_speed *= 2.0;
    const Result faster = solve(table);
    for (std::size_t i = 0; i < expected.curves.M_up.size(); i += 10) {
        EXPECT_NEAR(faster.curves.M_up[i],
                    result.curves.M_up[i] + 3.0 * expected.curves.M_offset[i], 1e-6);
    }
    // Few rows: the term is smooth between them.
    table.torque.table = {{0.0, 240.0, 480.0, 720.0}, {0.0, 0.0, 0.0, 0.0}};
    const Solver smooth(table);
    const SliderCrank<double> crank = slider_crank(table);
    const double factor = table.reciprocating_mass() * table.angular_speed * table.angular_speed;
    for (double phi = 0.0; phi < 12.0; phi += 0.123) {
        EXPECT_NEAR(smooth.M_up(phi), factor * offset_lever(crank, phi + crank.top_dead_centre()),
                    1e-6);
    }

    Json locked = write_input(table);
    const double room = 1e3 * (crank.rod_length - crank.crank_radius);
    locked["cylinder"]["offset_mm"] = 0.999 * room;
    EXPECT_NO_THROW(Solver{read_input(locked, {})});
    locked["cylinder"]["offset_mm"] = 1.001 * room;
    EXPECT_TRUE(error_of([&] {
                    read_input(locked, {});
                }).starts_with("/input/cylinder/rod_length_mm: must be"));
}

TEST(OffsetCylinder, AnglesCountFromTheTrueDeadCentre) {
    const Result result = solve(offset_engine());
    // The piston is highest, and the volume least, at φ = 0.
    const auto& volume = result.curves.volume;
    EXPECT_EQ(std::min_element(volume.begin(), volume.end()), volume.begin());
    const auto& pressure = result.curves.pressure;
    const auto peak = std::max_element(pressure.begin(), pressure.end()) - pressure.begin();
    EXPECT_NEAR(result.indicated->peak_pressure_angle / degree, static_cast<double>(peak), 1.0);
}

}  // namespace
}  // namespace ravnoves::balance_shaft
