#include "balance-shaft/cylinder_gas.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/numeric/odeint.hpp>
#include <cmath>

#include "balance-shaft/engine_torque.h"
#include "case-file/json.h"
#include "test_cases.h"

namespace ravnoves::balance_shaft {
namespace {

using test::diesel;
using test::error_of;
using test::written;

/// Angles at which the cycle's pressure has a kink, a jump or no Taylor series, from 0 to 4π.
std::vector<double> breaks(const Input& input) {
    const SliderCrank<double> crank = slider_crank(input);
    const double top = crank.top_dead_centre();
    const double bottom = crank.bottom_dead_centre();
    const GasCycle& cycle = input.torque.cycle;
    std::vector<double> all{top, bottom, top + two_pi, bottom + two_pi, top + 2 * two_pi};
    if (input.torque.kind == TorqueSource::Kind::cycle) {
        for (const double part : {0.0, 1e-4, 1e-3, 1e-2, 0.1, 1.0}) {
            all.push_back(cycle.combustion_start + part * cycle.combustion_duration + top);
        }
    }
    std::sort(all.begin(), all.end());
    return all;
}

double integral(const Input& input, const auto& f) {
    const std::vector<double> ends = breaks(input);
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        sum += boost::math::quadrature::gauss_kronrod<double, 31>::integrate(f, ends[i],
                                                                             ends[i + 1], 8, 1e-12);
    }
    return sum;
}

/// ∮ p dV from pressures and volumes alone, dV/dθ by differences.
double area_of_indicator_diagram(const Input& input, const CylinderGas& gas) {
    constexpr double h = 1e-3;
    return integral(input, [&](double theta) {
        const auto v = [&](double step) { return gas.volume(theta + step * h); };
        return gas.pressure(theta) * (v(-2) - 8.0 * v(-1) + 8.0 * v(1) - v(2)) / (12.0 * h);
    });
}

TEST(CylinderGas, IsentropicMotoredCycleDoesNoWork) {
    for (const double offset : {0.0, 0.004, -0.006}) {
        Input input = diesel();
        input.cylinder.offset = offset;
        GasCycle& cycle = input.torque.cycle;
        cycle.heat = 0.0;
        cycle.polytropic_compression = cycle.polytropic_expansion = 1.4;
        for (const double crankcase : {0.0, 0.9e5, 3e5}) {
            input.torque.crankcase_pressure = crankcase;
            const CylinderGas gas = *cylinder_gas(input);
            const double work = integral(input, [&](double theta) { return gas.torque(theta); });
            const double scale =
                integral(input, [&](double theta) { return std::abs(gas.torque(theta)); });
            EXPECT_GT(scale, 100.0);
            EXPECT_LE(std::abs(work), 1e-11 * scale) << "offset " << offset;
            EXPECT_LE(std::abs(gas.indicated().work), 1e-11 * scale);
        }
    }
}

TEST(CylinderGas, IndicatedWorkIsTheAreaOfTheDiagramAndTheTorquesIntegral) {
    for (const double m : {0.0, 1.0, 2.0, 0.4, 1.7}) {
        for (const double offset : {0.0, 0.005}) {
            Input input = diesel();
            input.torque.cycle.wiebe_m = m;
            input.torque.cycle.intake_pressure = 0.93e5;
            input.torque.cycle.exhaust_pressure = 1.1e5;
            input.cylinder.offset = offset;
            const CylinderGas gas = *cylinder_gas(input);
            const double work = gas.indicated().work;
            EXPECT_GT(work, 300.0);
            EXPECT_NEAR(integral(input, [&](double theta) { return gas.torque(theta); }), work,
                        1e-9 * work)
                << "m = " << m;
            EXPECT_NEAR(area_of_indicator_diagram(input, gas), work,
                        (m == 0.4 ? 1e-7 : 1e-9) * work)
                << "m = " << m;
            EXPECT_NEAR(gas.indicated().imep, work / gas.indicated().displacement, 1e-9);
        }
    }
}

TEST(CylinderGas, PressureObeysTheEnergyBalance) {
    // dp/dφ = ((n − 1) dQ/dφ − n p dV/dφ)/V, integrated on its own with dV/dφ = −A s′.
    const Input input = diesel();
    const CylinderGas gas = *cylinder_gas(input);
    const GasCycle& cycle = input.torque.cycle;
    const SliderCrank<double> crank = slider_crank(input);
    const double area = pi / 4.0 * 0.0955 * 0.0955;
    const double a = std::log(1000.0);
    using State = std::vector<double>;
    State p{gas.pressure(cycle.combustion_start)};
    const double n = cycle.polytropic_expansion;
    bool burns = true;  // by stretch: the rate jumps at the end of combustion
    const auto slope = [&](const State& state, State& result, double theta) {
        const double tau = (theta - cycle.combustion_start) / cycle.combustion_duration;
        const double burning = burns ? a * (cycle.wiebe_m + 1.0) * std::pow(tau, cycle.wiebe_m) *
                                           std::exp(-a * std::pow(tau, cycle.wiebe_m + 1.0)) /
                                           (1.0 - std::exp(-a)) / cycle.combustion_duration
                                     : 0.0;
        const double dv = -area * crank.at(theta).ds;
        result[0] = ((n - 1.0) * *cycle.heat * burning - n * state[0] * dv) / gas.volume(theta);
    };
    namespace odeint = boost::numeric::odeint;
    auto stepper = odeint::make_controlled(1e-3, 1e-12, odeint::runge_kutta_fehlberg78<State>());
    double from = cycle.combustion_start;
    for (const double to : {355.0, 360.0, 370.0, 400.0, 412.0, 450.0, 535.0}) {
        burns = to <= 412.0;
        odeint::integrate_adaptive(stepper, slope, p, from, to * degree, 1e-4);
        from = to * degree;
        EXPECT_NEAR(gas.pressure(from), p[0], 1e-9 * p[0]) << to;
    }
    // Compression before it, closed form; the exchange strokes.
    const double bottom = gas.volume(pi);
    EXPECT_NEAR(gas.pressure(300.0 * degree),
                cycle.intake_pressure *
                    std::pow(bottom / gas.volume(300.0 * degree), cycle.polytropic_compression),
                1e-6);
    EXPECT_EQ(gas.pressure(90.0 * degree), cycle.intake_pressure);
    EXPECT_EQ(gas.pressure(630.0 * degree), cycle.exhaust_pressure);
    EXPECT_NEAR(bottom / gas.volume(0.0), cycle.compression_ratio, 1e-12);
}

TEST(CylinderGas, MeanEffectivePressureAskedForIsReached) {
    Input input = diesel();
    input.torque.cycle.heat.reset();
    for (const double imep : {1e5, 3e5, 9e5}) {
        input.torque.cycle.imep = imep;
        const CylinderGas gas = *cylinder_gas(input);
        EXPECT_NEAR(gas.indicated().imep, imep, 1e-9 * 9e5);
        EXPECT_GE(*gas.indicated().heat, 0.0);
    }
    input.torque.cycle.imep = -3e5;
    EXPECT_EQ(error_of([&] { solve(input); })
                  .rfind("/input/torque/cycle/indicated_mean_effective_pressure_bar: must be at "
                         "least ",
                         0),
              0U)
        << error_of([&] { solve(input); });
}

TEST(InertiaTorque, IsTheLossOfKineticEnergyOverTheAngle) {
    const SliderCrank<double> crank{0.046, 0.150, 0.004};
    const double mass = 1.316;
    const double speed = 376.8;
    const auto energy = [&](double theta) {
        const double velocity = crank.at(theta).ds * speed;
        return mass * velocity * velocity / 2.0;
    };
    const double h = 1e-3;
    for (double theta = 0.0; theta < two_pi; theta += 0.1) {
        // Fourth-order difference.
        const double slope = (8.0 * (energy(theta + h) - energy(theta - h)) -
                              (energy(theta + 2 * h) - energy(theta - 2 * h))) /
                             (12.0 * h);
        EXPECT_NEAR(inertia_torque(crank.at(theta), mass, speed), -slope, 1e-7 * 400.0);
    }
}

TEST(ComputedTorque, SolverSeesGasPlusInertia) {
    const Input input = diesel();
    const Solver solver(input);
    const Result result = solver.result();
    ASSERT_TRUE(result.indicated);
    const CylinderGas gas = *cylinder_gas(input);
    // The inertia torque has no mean.
    EXPECT_NEAR(-result.M_up.mean, result.indicated->work / (4.0 * pi),
                1e-7 * result.indicated->work / (4.0 * pi));
    EXPECT_NEAR(
        result.indicated_power,
        result.indicated->imep * result.indicated->displacement * input.angular_speed / (4.0 * pi),
        1e-6);
    const MomentCurves& curves = result.curves;
    ASSERT_EQ(curves.M_gas.size(), curves.M_up.size());
    for (std::size_t i = 0; i < curves.M_up.size(); ++i) {
        EXPECT_NEAR(curves.M_up[i], -(curves.M_gas[i] + curves.M_inertia[i]), 1e-9);
        EXPECT_EQ(curves.M_gas[i], gas.torque(curves.crank_angle_deg[i] * degree));
    }
    const Json json = written(input);
    EXPECT_EQ(json.at("curves").at("pressure_bar").size(), 721U);
    EXPECT_NEAR(json.at("indicated").at("displacement_cm3").get<double>(), 659.0, 0.5);
    EXPECT_NEAR(json.at("indicated").at("peak_pressure_crank_angle_deg").get<double>(), 365.0,
                10.0);
}

TEST(ComputedTorque, CriteriaAreThoseOfTheTorqueItself) {
    for (const double m : {0.4, 1.0, 2.0}) {
        for (const int strokes : {4, 2}) {
            Input input = diesel();
            input.strokes = strokes;
            input.torque.cycle.wiebe_m = m;
            input.torque.cycle.intake_pressure = 0.93e5;
            input.torque.cycle.exhaust_pressure = 1.1e5;
            const CylinderGas gas = *cylinder_gas(input);
            const SliderCrank<double> crank = slider_crank(input);
            const auto moment = [&](double theta) {
                return -gas.torque(theta) - inertia_torque(crank.at(theta),
                                                           input.reciprocating_mass(),
                                                           input.angular_speed);
            };
            const Result result = solve(input);
            double highest = -1e300;
            double lowest = 1e300;
            double square = 0.0;
            constexpr int samples = 288'000;  // miss less than 3e-5 N·m of an extremum
            for (int i = 0; i < samples; ++i) {
                const double value = moment(gas.period() * (i + 0.5) / samples);
                highest = std::max(highest, value);
                lowest = std::min(lowest, value);
                square += std::pow(value - result.M_up.mean, 2);
            }
            // 0.03 N·m when straight lines joined every half degree.
            EXPECT_NEAR(result.M_up.max, highest, 1e-4) << m;
            EXPECT_NEAR(result.M_up.min, lowest, 1e-4) << m;
            EXPECT_NEAR(result.M_up.rms, std::sqrt(square / samples), 1e-4) << m;
        }
    }
}

TEST(ComputedTorque, ATraceOfTheCycleGivesTheCyclesTorque) {
    for (Input input : {diesel(), test::two_stroke()}) {
        input.interpolation = Interpolation::periodic_cubic;
        const CylinderGas cycle = *cylinder_gas(input);
        Input traced = input;
        traced.torque.kind = TorqueSource::Kind::pressure;
        const int rows = 5 * static_cast<int>(input.cycle_deg());
        for (int i = 0; i <= rows; ++i) {
            traced.torque.trace.crank_angle_deg.push_back(0.2 * i);
            traced.torque.trace.pressure.push_back(cycle.pressure((i % rows) * 0.2 * degree));
        }
        const Result computed = solve(input);
        const Result measured = solve(traced);
        const IndicatedCycle& indicated = *measured.indicated;
        // A cycle of one turn counted as a four-stroke one had twice the mean pressure.
        EXPECT_NEAR(indicated.imep, computed.indicated->imep, 1e-3 * computed.indicated->imep);
        EXPECT_NEAR(measured.M_up.range, computed.M_up.range, 1e-3 * computed.M_up.range);
        EXPECT_NEAR(-measured.M_up.mean, indicated.work / cycle.period(), 1e-5);
        EXPECT_NEAR(measured.indicated_power, indicated.work * input.angular_speed / cycle.period(),
                    1e-9);
        EXPECT_NEAR(indicated.peak_pressure, computed.indicated->peak_pressure, 1e2);
        EXPECT_FALSE(indicated.clearance);
        EXPECT_FALSE(indicated.heat);
        EXPECT_TRUE(measured.doubts.empty()) << measured.doubts.front().english();
        traced.strokes = 6 - input.strokes;
        EXPECT_NE(error_of([&] { solve(traced); }).find("since the pressure trace spans"),
                  std::string::npos);
    }
}

TEST(ComputedTorque, BadCyclesAreRejected) {
    const std::string missing =
        ": is required with a pressure trace or a computed cycle, and missing";
    const std::pair<const char*, std::string> cases[] = {
        {R"({"torque": {"cycle": {"indicated_mean_effective_pressure_bar": 7}}})",
         "torque/cycle: must have either heat_J or indicated_mean_effective_pressure_bar, got "
         "both"},
        {R"({"torque": {"cycle": {"heat_J": null}}})",
         "torque/cycle: must have either heat_J or indicated_mean_effective_pressure_bar, got "
         "neither"},
        {R"({"cylinder": {"rod_length_mm": null}})", "cylinder/rod_length_mm" + missing},
        {R"({"cylinder": {"bore_mm": null}})", "cylinder/bore_mm" + missing},
        {R"({"torque": {"cycle": {"combustion_start_deg": 440, "combustion_duration_deg": 101}}})",
         "torque/cycle/combustion_duration_deg: must end the combustion before the bottom dead "
         "centre at 540°, got 541°"},
        {R"({"strokes": 2, "torque": {"cycle": {"combustion_duration_deg": 130}}})",
         "torque/cycle/combustion_duration_deg: must end the combustion before the ports open at "
         "470°, got 482°"},
        {R"({"strokes": 2,
             "torque": {"cycle": {"ports_open_deg": 62, "combustion_start_deg": 280}}})",
         "torque/cycle/combustion_start_deg: must be after the ports have closed, 298°, got 280°"},
        {R"({"cylinder": {"bore_mm": 1e-3}})",
         "cylinder/bore_mm: must give a displacement from 1e-6 cm³ to 1e9 cm³, got 7.22566e-08 "
         "cm³"},
        {R"({"torque": {"csv": "x.csv"}})",
         "torque: must have one of: crank_angle_deg with torque_Nm, csv, pressure, cycle, got more "
         "than one of them"}};
    for (const auto& [patch, error] : cases) {
        EXPECT_EQ(test::rejection(diesel(), patch), "/input/" + error);
    }
}

TEST(ComputedTorque, ExtremeFiniteCyclesGiveNumbersOrWords) {
    int solved = 0;
    for (const double ratio : {1.0000001, 2.0, 100.0}) {
        for (const double n : {1.0000001, 1.4, 2.0}) {
            for (const double heat : {0.0, 1e-300, 1e12}) {
                for (const double m : {0.0, 10.0}) {
                    for (const double bore : {2e-5, 0.1, 10.0}) {
                        Input input = diesel();
                        input.step_deg = 30;
                        input.cylinder.bore = bore;
                        GasCycle& cycle = input.torque.cycle;
                        cycle.compression_ratio = ratio;
                        cycle.polytropic_expansion = n;
                        cycle.heat = heat;
                        cycle.wiebe_m = m;
                        try {
                            const Result result = solve(input);
                            EXPECT_TRUE(std::isfinite(result.best_range.value));
                            EXPECT_TRUE(std::isfinite(result.indicated->work));
                            EXPECT_TRUE(std::isfinite(result.M_ups.rms));
                            ++solved;
                        } catch (const InputError& error) {
                            EXPECT_NE(std::string(error.what()), "");
                        }
                    }
                }
            }
        }
    }
    EXPECT_GT(solved, 50);
}

TEST(ParsedCycle, KnowsUnitsAndClosesTheCycle) {
    const auto read =
        parse_cycle(Measured::pressure, "deg;MPa\n0;0,1\n180;0,1\n360;6\n540;0,3\n720;0,102\n");
    EXPECT_EQ(read.unit, units::MPa);
    EXPECT_TRUE(read.closed);
    EXPECT_NEAR(read.trace.pressure[2], 6e6, 1e-6);
    EXPECT_NEAR(read.trace.pressure.front(), 0.101e6, 1e-6);
    EXPECT_EQ(read.trace.pressure.front(), read.trace.pressure.back());
    EXPECT_EQ(read.describe().english(),
              "5 rows, separated by semicolons, decimal comma, angles in degrees, with a header, "
              "pressure in MPa, end joined to the start");
    const auto open = parse_cycle(Measured::pressure, "0 1\n180 1\n360 60\n540 3\n");
    EXPECT_EQ(open.unit, units::bar);
    EXPECT_FALSE(open.unit_named);
    EXPECT_TRUE(read.unit_named);
    EXPECT_TRUE(
        parse_cycle(Measured::pressure, "°;бар\n0;1\n180;1\n360;60\n540;3\n720;1\n").unit_named);
    EXPECT_NE(open.describe().english().find(
                  "pressure assumed in bar, without a known unit in the heading"),
              std::string::npos);
    EXPECT_EQ(parse_cycle(Measured::pressure, "°;mbar\n0;1\n180;1\n360;60\n540;3\n720;1\n").unit,
              units::mbar);
    for (const char* heading : {"°;bar(g)", "deg;barg", "angle;gauge pressure, bar"}) {
        const auto gauge = parse_cycle(
            Measured::pressure, std::string(heading) + "\n0;0\n180;0\n360;59\n540;2\n720;0\n");
        EXPECT_TRUE(gauge.gauge) << heading;
        EXPECT_EQ(gauge.unit, units::bar) << heading;
        EXPECT_NEAR(gauge.trace.pressure[2], 60.01325e5, 1e-6) << heading;
    }
    EXPECT_EQ(open.trace.crank_angle_deg.back(), 720.0);
    EXPECT_EQ(open.trace.pressure.back(), 1e5);
    EXPECT_EQ(
        error_of([] { parse_cycle(Measured::pressure, "0 1\n180 1\n360 60\n540 3\n720 9\n"); }),
        "line 5, column 2: must equal the first pressure, 1 bar, since the cycle repeats, "
        "got 9 bar");
    EXPECT_EQ(
        error_of([] { parse_cycle(Measured::pressure, "0 1\n180 -1\n360 60\n540 3\n720 1\n"); }),
        "line 2, column 2: must be from 0 to 100000; for gauge pressure set \"gauge\": true, "
        "got -1");
    EXPECT_EQ(error_of([] { parse_cycle(Measured::pressure, "0 1 2\n"); }),
              "line 1: must have two columns, crank angle and pressure, or the case must name two "
              "of them in \"columns\", got 3 columns");
}

}  // namespace
}  // namespace ravnoves::balance_shaft
