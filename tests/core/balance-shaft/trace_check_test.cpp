#include "balance-shaft/trace_check.h"

#include <gtest/gtest.h>

#include <random>

#include "balance-shaft/engine_torque.h"
#include "test_cases.h"

namespace ravnoves::balance_shaft {
namespace {

using test::diesel;
using test::two_stroke;

/// How a trace is written down: in this unit, with this zero, this late, this noisy.
struct Written {
    double per_bar = 1.0;
    double zero_bar = 0.0;
    double late_deg = 0.0;
    double noise_bar = 0.0;
    std::string heading = "angle;pressure bar";
};

/// The trace of a computed cycle as an indicator would give it.
Input traced(const Input& computed, const Written& written) {
    const CylinderGas cycle = *cylinder_gas(computed);
    std::mt19937 generator(3);
    std::normal_distribution<double> noise(0.0, 1.0);
    const int rows = static_cast<int>(computed.cycle_deg());
    std::string csv = written.heading + "\n";
    for (int i = 0; i < rows; ++i) {
        const double bar = cycle.pressure((i - written.late_deg) * degree) / 1e5 +
                           written.zero_bar + written.noise_bar * noise(generator);
        csv +=
            std::to_string(i) + ";" + std::to_string(std::max(bar, 1e-6) * written.per_bar) + "\n";
    }
    Input input = computed;
    input.torque.kind = TorqueSource::Kind::pressure;
    input.torque.trace = parse_cycle(Measured::pressure, csv).trace;
    return input;
}

std::string note_of(const Input& input) {
    return check_trace(input, *cylinder_gas(input)).english();
}

Input petrol() {
    Input input = diesel();
    GasCycle& cycle = input.torque.cycle;
    cycle.compression_ratio = 10.0;
    cycle.intake_pressure = 0.95e5;
    cycle.exhaust_pressure = 1.05e5;
    cycle.combustion_start = 340.0 * degree;
    cycle.combustion_duration = 55.0 * degree;
    cycle.wiebe_m = 2.5;
    cycle.heat = 1500.0;
    return input;
}

Input idling() {
    Input input = petrol();
    input.torque.cycle.intake_pressure = 0.35e5;
    input.torque.cycle.heat = 350.0;
    return input;
}

Input supercharged(double bar) {
    Input input = diesel();
    input.torque.cycle.compression_ratio = 14.0;
    input.torque.cycle.intake_pressure = bar * 1e5;
    input.torque.cycle.exhaust_pressure = 0.9 * bar * 1e5;
    input.torque.cycle.heat = 1300.0 * bar;
    return input;
}

Input motored() {
    Input input = diesel();
    input.torque.cycle.heat = 0.0;
    return input;
}

std::vector<Input> sane_engines() {
    return {diesel(),          petrol(),  idling(),    supercharged(2.5),
            supercharged(5.0), motored(), two_stroke()};
}

TEST(TraceCheck, SaneTracesAreNotAccused) {
    for (const Input& engine : sane_engines()) {
        EXPECT_EQ(note_of(traced(engine, {})), "");
        EXPECT_EQ(note_of(traced(engine, {.noise_bar = 0.02})), "");
        EXPECT_EQ(note_of(traced(engine, {.late_deg = 1.0})), "");
        EXPECT_EQ(note_of(traced(engine, {.heading = "angle;pressure"})), "");
        EXPECT_EQ(note_of(traced(engine, {.per_bar = 100.0, .heading = "angle;p, kPa"})), "");
    }
    for (const double exponent : {1.28, 1.39}) {
        Input engine = diesel();
        engine.torque.cycle.polytropic_compression = exponent;
        EXPECT_EQ(note_of(traced(engine, {})), "");
    }
    Input flat = traced(diesel(), {});
    std::fill(flat.torque.trace.pressure.begin(), flat.torque.trace.pressure.end(), 1e5);
    EXPECT_EQ(note_of(flat), "");
}

TEST(TraceCheck, RowsFarApartNearThePeakAreDoubted) {
    const PressureTrace fine = traced(diesel(), {}).torque.trace;
    const auto doubt = [&](int step) {
        PressureTrace trace;
        for (std::size_t i = 0; i < fine.pressure.size(); ++i) {
            if (static_cast<int>(i) % step == 0 || i + 1 == fine.pressure.size()) {
                trace.crank_angle_deg.push_back(fine.crank_angle_deg[i]);
                trace.pressure.push_back(fine.pressure[i]);
            }
        }
        return coarse_rows(trace).english();
    };
    EXPECT_EQ(doubt(1), "");
    EXPECT_EQ(doubt(6), "");
    EXPECT_TRUE(doubt(28).starts_with("Pressure trace: 28° between rows near the peak;"))
        << doubt(28);
}

TEST(TraceCheck, FindsTheExponentOfTheCompression) {
    for (const Input& engine : sane_engines()) {
        const auto fit = fit_compression(*cylinder_gas(traced(engine, {})));
        ASSERT_TRUE(fit);
        EXPECT_NEAR(fit->exponent, engine.torque.cycle.polytropic_compression, 0.01);
        EXPECT_NEAR(fit->missing_pressure, 0.0, 0.06 * engine.torque.cycle.intake_pressure);
    }
}

TEST(TraceCheck, GaugePressureIsNoticed) {
    for (const Input& engine : {diesel(), petrol(), supercharged(2.5), motored(), two_stroke()}) {
        const Input gauge = traced(engine, {.zero_bar = -1.0});
        EXPECT_EQ(note_of(gauge).rfind("The trace looks like gauge pressure", 0), 0U)
            << note_of(gauge);
        // It stands in the result.
        const Result result = solve(gauge);
        EXPECT_NE(std::find(result.doubts.begin(), result.doubts.end(),
                            check_trace(gauge, *cylinder_gas(gauge))),
                  result.doubts.end());
        // With the crankcase in gauge pressure, too, the torque is right.
        Input both = gauge;
        both.torque.crankcase_pressure = 0.0;
        EXPECT_EQ(note_of(both), "");
    }
}

TEST(TraceCheck, AnotherUnitIsNoticed) {
    const struct {
        double per_bar;
        const char* name;
    } units[] = {{100.0, "kPa"}, {0.1, "MPa"}, {14.5037738, "psi"}};
    for (const Input& engine : {diesel(), petrol(), supercharged(2.5), two_stroke()}) {
        for (const auto& unit : units) {
            // 0.25 bar or 36 psi at the dead centre might be a throttled engine's bar or kPa as
            // well.
            if (unit.per_bar < 100.0 && engine.torque.cycle.intake_pressure > 2e5) {
                continue;
            }
            const std::string named = note_of(traced(engine, {.per_bar = unit.per_bar}));
            EXPECT_NE(named.find(std::string("look like ") + unit.name + "; bar is used"),
                      std::string::npos)
                << unit.name << ": " << named;
            // Without a unit in the heading the likely one is used, and the result has a note.
            const Input unnamed =
                traced(engine, {.per_bar = unit.per_bar, .heading = "angle;pressure"});
            EXPECT_EQ(note_of(unnamed), "");
            EXPECT_EQ(unnamed.torque.trace.unit.name, unit.name);
            const Result result = solve(unnamed);
            EXPECT_EQ(
                std::ranges::count(result.notes, assumed_unit_note(unnamed.torque.trace.unit)), 1);
        }
    }
}

TEST(TraceCheck, AWrongPhaseIsNoticed) {
    for (const Input& engine : sane_engines()) {
        for (const double late : {-180.0, -90.0, -40.0, 90.0, 180.0}) {
            const std::string note = note_of(traced(engine, {.late_deg = late}));
            EXPECT_EQ(note.rfind("The peak of the pressure trace is ", 0), 0U)
                << late << ": " << note;
        }
        // A few degrees: the peak may be anywhere near, but not the exponent.
        for (const double late : {-7.0, 7.0}) {
            EXPECT_NE(note_of(traced(engine, {.late_deg = late})), "") << late;
        }
    }
    const std::string turn = note_of(traced(diesel(), {.late_deg = 360.0}));
    EXPECT_NE(turn.find("shift the trace by one turn"), std::string::npos) << turn;
}

TEST(TraceCheck, ATurnOffIsCorrectedByTheShift) {
    Input input = traced(diesel(), {.late_deg = 360.0});
    EXPECT_TRUE(peaks_a_turn_off(input, cylinder_gas(input)->indicated()));
    input.torque.trace_shift = two_pi;
    EXPECT_EQ(note_of(input), "");
    EXPECT_FALSE(peaks_a_turn_off(input, cylinder_gas(input)->indicated()));
    const CylinderGas there = *cylinder_gas(input);
    const CylinderGas right = *cylinder_gas(traced(diesel(), {}));
    for (const double angle : {-100.0, 3.0, 350.5, 372.0, 719.0}) {
        EXPECT_NEAR(there.pressure(angle * degree), right.pressure(angle * degree), 1.0) << angle;
    }
}

}  // namespace
}  // namespace ravnoves::balance_shaft
