// Files of measured pressure as they come: columns, separators, units, steps, starts, cycles.

#include "balance-shaft/table_reading.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "balance-shaft/engine_torque.h"
#include "balance-shaft/input.h"
#include "case-file/decimal.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/text_file.h"
#include "synthetic_engine.h"
#include "temporary_folder.h"
#include "test_cases.h"

namespace ravnoves::balance_shaft {
namespace {

using test::SyntheticEngine;

enum class Counted { on, by_turn, by_cycle };

/// How a file is written.
struct FileStyle {
    int columns = 2;  ///< 1: pressures alone
    int angle = 0;
    int pressure = 1;
    char separator = ';';
    bool decimal_comma = false;
    Unit unit = units::bar;
    bool gauge = false;
    bool is_named = true;  ///< the unit, by the heading
    double step = 1.0;
    double first = 0.0;
    int cycles = 1;
    Counted count = Counted::on;
    std::string above{};  ///< lines of words
};

std::string cell_text(double value, bool comma) {
    std::string text = fixed_decimals(value, 7);
    std::replace(text.begin(), text.end(), '.', comma ? ',' : '.');
    return text;
}

std::string file_as(const SyntheticEngine& engine, const FileStyle& written) {
    const auto pressure = engine.pressure(written.step);
    const double cycle = 180.0 * engine.strokes;
    std::string text = written.above;
    const auto row = [&](const auto& cell) {
        for (int column = 0; column < written.columns; ++column) {
            text += column > 0 ? std::string(1, written.separator) : "";
            text += cell(column);
        }
        text += "\n";
    };
    const std::string blank = written.separator == ' ' ? "_" : " ";
    if (written.is_named || written.columns > 2) {
        row([&](int column) {
            return column == written.angle      ? "CA" + blank + "[deg]"
                   : column != written.pressure ? "channel" + std::to_string(column)
                   : !written.is_named          ? std::string("cyl1")
                                       : "p1" + blank + "[" + std::string(written.unit.name) +
                                             (written.gauge ? "]" + blank + "(g)" : "]");
        });
    }
    const auto rows = static_cast<int>(pressure.size());
    for (int i = 0; i < rows * written.cycles; ++i) {
        const auto at = static_cast<std::size_t>(i % rows);
        double angle = written.first + i * written.step;
        if (written.count != Counted::on) {
            const double period = written.count == Counted::by_turn ? 360.0 : cycle;
            angle = written.first + std::fmod(i * written.step, period);
        }
        const double value = (pressure[at] - (written.gauge ? 101325.0 : 0.0)) / written.unit;
        row([&](int column) {
            return column == written.angle && written.columns > 1
                       ? cell_text(angle, written.decimal_comma)
                   : column == written.pressure || written.columns == 1
                       ? cell_text(value, written.decimal_comma)
                   : column % 3 == 0 ? cell_text(20.0 + std::sin(0.1 * i), written.decimal_comma)
                   : column % 3 == 1
                       ? cell_text(1e-3 * i, written.decimal_comma)
                       : cell_text(300.0 * std::cos(angle * degree), written.decimal_comma);
        });
    }
    return text;
}

/// Work of a cycle of a trace whose firing dead centre is half a cycle after its first angle.
double work_of(const SyntheticEngine& engine, const PressureTrace& trace) {
    PressureTrace shifted = trace;
    const double half = 90.0 * engine.strokes;
    const double shift = (engine.strokes == 4 ? 360.0 : 0.0) - (trace.crank_angle_deg[0] + half);
    for (double& angle : shifted.crank_angle_deg) {
        angle += shift;
    }
    return CylinderGas(engine.crank, engine.bore, 1e5, shifted, false).indicated().work;
}

TEST(TableReading, FilesAsTheyComeHaveTheRightWork) {
    std::mt19937 random(46);
    const auto any = [&](auto... choices) {
        const std::array list{choices...};
        return list[random() % list.size()];
    };
    const auto engines = test::synthetic_engines();
    for (int i = 0; i < 91; ++i) {
        const SyntheticEngine& engine = engines[random() % engines.size()];
        FileStyle written;
        written.columns = 1 + i % 13;
        written.angle =
            written.columns < 2 ? 0 : static_cast<int>(random() % 2) * (written.columns - 1);
        written.pressure =
            written.columns < 2
                ? 0
                : (written.angle + 1 +
                   static_cast<int>(random() % static_cast<unsigned>(written.columns - 1))) %
                      written.columns;
        written.separator = any(';', '\t', ',', ' ');
        written.decimal_comma = written.separator != ',' && written.columns > 1 && any(true, false);
        written.unit = any(units::bar, units::kPa, units::MPa, units::pascal, units::psi);
        written.is_named = any(true, true, false) && written.columns > 1;
        written.gauge = any(true, false);
        if (!written.is_named && written.unit == units::psi) {
            written.unit = units::kPa;
        }
        written.step = any(0.1, 0.25, 0.5, 1.0, 2.0, 10.0);
        written.first = any(-360.0, 0.0, 180.0, 298.0);
        written.cycles = written.columns > 1 ? any(1, 1, 2, 3) : 1;
        written.count = any(Counted::on, Counted::by_turn, Counted::by_cycle);
        written.above = any("", "Indicated pressure\nengine;no. 7\n\n", "# comment\n");
        const std::string text = file_as(engine, written);
        SCOPED_TRACE(std::string(engine.name) + " " + std::to_string(i) + "\n" +
                     text.substr(0, 400));
        TableReading known;
        known.strokes = engine.strokes;
        if (!written.is_named) {  // one pressure of many, or a unit that is not written
            known.unit = written.unit;
            known.gauge = written.gauge;
            if (written.columns > 1) {
                known.columns = {std::to_string(written.angle + 1),
                                 std::to_string(written.pressure + 1)};
            }
        }
        ReadingProposal proposal;
        ASSERT_NO_THROW(proposal = propose_reading(text, Measured::pressure, known));
        if (written.columns > 1) {
            EXPECT_EQ(proposal.reading.columns[0], std::to_string(written.angle + 1));
            EXPECT_EQ(proposal.reading.columns[1], std::to_string(written.pressure + 1));
        }
        EXPECT_EQ(proposal.reading.gauge, written.gauge);
        EXPECT_EQ(proposal.reading.unit, written.unit);
        ParsedCycle read;
        ASSERT_NO_THROW(read = parse_cycle(Measured::pressure, text, proposal.reading));
        EXPECT_EQ(read.cycles, static_cast<std::size_t>(written.cycles));
        EXPECT_EQ(read.strokes, engine.strokes);
        const double work =
            work_of(engine, test::trace_of(engine.pressure(written.step), written.step));
        const double scale = std::abs(work) + 0.02 * engine.intake * 6e-4;
        EXPECT_NEAR(work_of(engine, read.trace), work, 1e-3 * scale);
        if (HasFailure()) {
            break;
        }
    }
}

TEST(TableReading, RowsThatDoNotDivideTheCycleAreAveragedToo) {
    const SyntheticEngine engine = test::synthetic_engines()[0];
    const auto pressure = engine.pressure(0.1);
    std::string text = "deg;bar\n";
    for (double angle = -360.0; angle < -360.0 + 10 * 720.0; angle += 2.8) {
        const auto at = static_cast<std::size_t>(std::llround((angle + 360.0) * 10.0)) % 7200;
        text += cell_text(angle, false) + ";" + cell_text(pressure[at] / 1e5, false) + "\n";
    }
    const auto read = parse_cycle(Measured::pressure, text);
    EXPECT_EQ(read.cycles, 10U);
    EXPECT_EQ(read.strokes, 4);
    EXPECT_NEAR(work_of(engine, read.trace),
                work_of(engine, test::trace_of(engine.pressure(0.1), 0.1)), 5.0);
    // 28° are few rows, and read as they are.
    std::string coarse = "deg;bar\n";
    for (int i = 0; i < 26; ++i) {
        coarse += cell_text(28.0 * i, false) + ";" + (i == 13 ? "40" : "1") + "\n";
    }
    coarse += "720;1\n";
    EXPECT_EQ(parse_cycle(Measured::pressure, coarse).trace.pressure[13], 40e5);
}

TEST(TableReading, ProposesWhatANumberLooksLike) {
    const SyntheticEngine engine = test::synthetic_engines()[0];
    for (const auto& [unit, gauge] :
         {std::pair(units::bar, false), std::pair(units::kPa, false), std::pair(units::MPa, false),
          std::pair(units::pascal, false), std::pair(units::bar, true), std::pair(units::kPa, true),
          std::pair(units::MPa, true)}) {
        const std::string text = file_as(engine, {.unit = unit, .gauge = gauge, .is_named = false});
        const auto proposal = propose_reading(text, Measured::pressure);
        EXPECT_EQ(proposal.reading.unit, unit) << unit.name;
        EXPECT_EQ(proposal.reading.gauge, gauge) << unit.name;
        std::string doubts;
        for (const Message& doubt : proposal.doubts) {
            doubts += doubt.english() + "\n";
        }
        EXPECT_NE(doubts.find("look like " + std::string(unit.name)), std::string::npos) << doubts;
        EXPECT_EQ(doubts.find("gauge pressure?") != std::string::npos, gauge) << doubts;
    }
    const auto negative = propose_reading(
        "deg;bar\n0;-0.113\n180;-0.1\n360;59\n540;2\n720;-0.113\n", Measured::pressure);
    EXPECT_EQ(negative.reading.gauge, true);
    ASSERT_EQ(negative.doubts.size(), 1U);
    EXPECT_EQ(negative.doubts[0].english(), "The minimum pressure is -0.113 bar: gauge pressure?");
    // What is decided stays so.
    TableReading absolute;
    absolute.gauge = false;
    EXPECT_EQ(
        propose_reading("deg;bar\n0;1\n180;1\n360;59\n540;2\n720;1\n", Measured::pressure, absolute)
            .reading.gauge,
        false);
    const auto torque =
        propose_reading("time,crank angle,M (kN·m)\n0,0,0\n1,180,2\n2,360,3\n3,540,-1\n4,720,0\n",
                        Measured::torque);
    EXPECT_EQ(torque.reading.columns, (std::array<std::string, 2>{"2", "3"}));
    EXPECT_EQ(torque.reading.unit, units::kN_m);
    EXPECT_EQ(torque.headings, (std::vector<std::string>{"time", "crank angle", "M (kN·m)"}));
    EXPECT_THROW(propose_reading("no\nnumbers\n", Measured::pressure), InputError);
}

TEST(TableReading, ACaseNamesColumnsUnitAndGauge) {
    const ravnoves::test::TemporaryFolder folder;
    const SyntheticEngine engine = test::synthetic_engines()[0];
    write_text_file(folder.path() / "p.csv", file_as(engine, {.columns = 13,
                                                              .angle = 4,
                                                              .pressure = 7,
                                                              .unit = units::MPa,
                                                              .gauge = true,
                                                              .is_named = false,
                                                              .cycles = 3}));
    Json json = write_input(test::diesel());
    json["torque"] = {
        {"pressure",
         {{"csv", "p.csv"}, {"columns", {5, "cyl1"}}, {"unit", "MPa"}, {"gauge", true}}}};
    const CaseContext context{folder.path()};
    const Input input = read_input(json, context);
    EXPECT_EQ(input.torque.trace.pressure.size(), 721U);
    EXPECT_NEAR(work_of(engine, input.torque.trace),
                work_of(engine, test::trace_of(engine.pressure(1.0), 1.0)), 0.5);
    EXPECT_EQ(write_input(input).at("torque").at("pressure").at("columns"), Json({5, "cyl1"}));
    EXPECT_EQ(read_input(write_input(input), context), input);
    // Names above units: the name, or both.
    write_text_file(folder.path() / "q.csv",
                    "t;Crank;P1\ns;deg;bar\n0;0;1\n1;180;1\n2;360;59\n3;540;2\n4;720;1\n");
    for (const char* name : {"P1", "P1 bar"}) {
        Json other = json;
        other["torque"]["pressure"] = {{"csv", "q.csv"}, {"columns", {"Crank", name}}};
        const auto pressure = read_input(other, context).torque.trace.pressure;
        EXPECT_EQ(*std::max_element(pressure.begin(), pressure.end()), 59 * units::bar) << name;
    }
    const auto rejection = [&](const char* key, const Json& value) {
        Json other = json;
        other["torque"]["pressure"][key] = value;
        return test::error_of([&] { read_input(other, context); });
    };
    const std::string place = "/input/torque/pressure/";
    EXPECT_EQ(rejection("columns", {1}),
              place +
                  "columns: must be two numbers from 1 or two headings: of the crank angle and "
                  "of the value, got [1]");
    EXPECT_EQ(rejection("columns", {5, 14}),
              place + "csv: p.csv: line 2: must have at least 14 columns, got 13 columns");
    EXPECT_EQ(
        rejection("columns", {"1", "0"}),
        place + "csv: p.csv: must have a column of values: columns are numbered from 1, got 0");
    EXPECT_EQ(rejection("columns", {"0", "0"}), rejection("columns", {"1", "0"}));
    EXPECT_TRUE(rejection("columns", {"CA", 8})
                    .starts_with(place + "csv: p.csv: must have a column with the heading \"CA\", "
                                         "got \""));
    EXPECT_EQ(rejection("unit", "mmHg"), place +
                                             "unit: must be one of \"bar\", \"kPa\", \"MPa\", "
                                             "\"psi\", \"mbar\", \"Pa\", got \"mmHg\"");
    EXPECT_EQ(rejection("gauge", 1), place + "gauge: must be true or false, got 1");
    EXPECT_NE(rejection("gauge", nullptr), "no error");
}

TEST(TableReading, CyclesOfATwoStrokeAreReportedByTheirValues) {
    const SyntheticEngine two = test::synthetic_engines()[10];
    ASSERT_EQ(two.strokes, 2);
    EXPECT_EQ(parse_cycle(Measured::pressure, file_as(two, {.cycles = 6})).strokes, 2);
    EXPECT_EQ(parse_cycle(Measured::pressure, file_as(two, {.cycles = 6})).cycles, 6U);
    const SyntheticEngine four = test::synthetic_engines()[0];
    EXPECT_EQ(parse_cycle(Measured::pressure, file_as(four, {.cycles = 3})).cycles, 3U);
    // 720° are a four-stroke cycle, unless both turns are the same and the case says two strokes.
    TableReading strokes;
    strokes.strokes = 2;
    EXPECT_EQ(parse_cycle(Measured::pressure, file_as(four, {}), strokes).strokes, 4);
    EXPECT_EQ(parse_cycle(Measured::pressure, file_as(two, {.cycles = 2}), strokes).cycles, 2U);
    EXPECT_EQ(parse_cycle(Measured::pressure, file_as(two, {.cycles = 2})).strokes, 4);
    // What is behind the last whole cycle is left out.
    const std::string whole = file_as(four, {.cycles = 2});
    const auto part =
        parse_cycle(Measured::pressure, whole.substr(0, whole.size() - whole.size() / 8));
    EXPECT_EQ(part.cycles, 1U);
    EXPECT_GT(part.left_over / degree, 300.0);
    EXPECT_NE(part.describe().english().find(" at the end left out"), std::string::npos);
}

TEST(TableReading, ATraceReadsBackAsItIsWritten) {
    const auto read =
        parse_cycle(Measured::pressure, "deg;bar\n0;1\n180;1.5\n360;60\n540;3\n720;1\n");
    EXPECT_EQ(parse_cycle(Measured::pressure, write_pressure_trace(read.trace)).trace, read.trace);
}

// A row that repeats the instant before is none: what is left may be no table.
TEST(TableReading, RowsAreCountedWithoutThoseThatRepeat) {
    const std::string text = "deg,bar\n0,1\n-360,2\n-720,1\n";
    EXPECT_EQ(test::error_of([&] { parse_cycle(Measured::torque, text); }),
              "the torque table must have at least 3 rows, got 1");
    EXPECT_EQ(test::error_of([&] { parse_cycle(Measured::pressure, text); }),
              "the pressure table must have at least 3 rows, got 1");
    for (const Measured what : {Measured::torque, Measured::pressure}) {
        const auto proposal = propose_reading(text, what);
        ASSERT_FALSE(proposal.doubts.empty());
        // Nor is it a column of angles.
        EXPECT_EQ(proposal.doubts.front().english(),
                  "The column of the crank angle is uncertain; column 1 is proposed.");
    }
}

TEST(TableReading, UnitsOfTorqueAreWholeWords) {
    const struct {
        const char* heading;
        std::optional<Unit> unit;
    } headings[] = {{"M (N·m)", units::N_m},
                    {"torque Nm", units::N_m},
                    {"torque_Nm", units::N_m},
                    {"M / N⋅m", units::N_m},
                    {"момент, Н·м", units::N_m},
                    {"torque [lbf·ft]", units::lbf_ft},
                    {"Torque\n;ft-lb", units::lbf_ft},
                    {"torque, lb-in", units::lbf_in},
                    {"M [kNm]", units::kN_m},
                    {"M kN*m", units::kN_m},
                    {"момент (кН·м)", units::kN_m},
                    {"torque, lb-ft", units::lbf_ft},
                    {"torque (ft.lbs)", units::lbf_ft},
                    {"torque lbf in", units::lbf_in},
                    {"M (daN·m)", {}},
                    {"M (daNm)", {}},
                    {"M (mNm)", {}},
                    {"M (MN·m)", {}},
                    {"M (kgf·m)", {}},
                    {"момент (кгс·м)", {}},
                    {"момент (даН·м)", {}},
                    {"c (Nm/rad)", {}},
                    {"p (N/m)", {}},
                    {"M", {}}};
    for (const auto& [heading, unit] : headings) {
        const std::string text = "deg;" + std::string(heading) + "\n0;1\n180;2\n720;1\n";
        const auto read = parse_cycle(Measured::torque, text);
        EXPECT_EQ(read.unit_named, unit.has_value()) << heading;
        EXPECT_EQ(read.unit, unit.value_or(units::N_m)) << heading;
        EXPECT_EQ(read.table.torque[0], unit.value_or(units::N_m).to_si) << heading;
        const std::string words = read.describe().english();
        const std::string assumed = "torque assumed in N·m, without a known unit in the heading";
        EXPECT_EQ(words.find(assumed) == std::string::npos, unit.has_value()) << heading;
        EXPECT_EQ(words.find(", torque in " + std::string(read.unit.name)) != std::string::npos,
                  read.unit != units::N_m)
            << words;
    }
    // 1 lbf is the weight of 0.45359237 kg at 9.80665 m/s²; 12 in of 25.4 mm are 1 ft.
    EXPECT_NEAR(units::lbf_ft.to_si, 1.3558179483314004, 1e-13);
    EXPECT_NEAR(units::lbf_in.to_si, 0.1129848290276167, 1e-14);
    EXPECT_EQ(units::kN_m.to_si, 1000.0);
    // Without words above the rows there is nothing to doubt.
    EXPECT_EQ(parse_cycle(Measured::torque, "0;1\n180;2\n720;1\n").describe().english(),
              "3 rows, separated by semicolons, angles in degrees");
}

TEST(TableReading, ACaseNamesAUnitAndNothingBeside) {
    const ravnoves::test::TemporaryFolder folder;
    write_text_file(folder.path() / "t.csv", "0;1\n180;2\n720;1\n");
    write_text_file(folder.path() / "p.csv", "0;1\n180;2\n360;40\n720;1\n");
    const CaseContext context{folder.path()};
    const auto read_with = [&](Measured what, const std::string& unit) {
        Json json = write_input(test::diesel());
        json["torque"] = what == Measured::torque
                             ? Json{{"csv", "t.csv"}, {"unit", unit}}
                             : Json{{"pressure", {{"csv", "p.csv"}, {"unit", unit}}}};
        return read_input(json, context);
    };
    for (const Unit& unit : units_of(Measured::torque)) {
        const Input input = read_with(Measured::torque, std::string(unit.name));
        EXPECT_EQ(input.torque.table.torque[0], unit.to_si) << unit.name;
    }
    for (const Unit& unit : units_of(Measured::pressure)) {
        const Input input = read_with(Measured::pressure, std::string(unit.name));
        EXPECT_NEAR(input.torque.trace.pressure[0], unit.to_si, 1e-9 * unit.to_si) << unit.name;
    }
    EXPECT_EQ(read_with(Measured::torque, "kNm").torque.table.torque[0], 1000.0);
    for (const char* unit : {"mNm", "daN·m", "MN·m", "kg pressure Nm", "N·m.", ""}) {
        EXPECT_EQ(test::error_of([&] { read_with(Measured::torque, unit); }),
                  "/input/torque/unit: must be one of \"N·m\", \"kN·m\", \"lbf·ft\", "
                  "\"lbf·in\", got \"" +
                      std::string(unit) + "\"");
    }
    EXPECT_NE(
        test::error_of([&] { read_with(Measured::pressure, "kg pressure kPa"); }).find("one of"),
        std::string::npos);
}

// As the field "columns" says: 0 for the angle.
TEST(TableReading, RowsWithoutAnglesAreEqualStepsOfATorqueToo) {
    TableReading reading;
    reading.columns = {"0", "1"};
    const TorqueTable table{{0, 240, 480, 720}, {1, 2, 3, 1}};
    EXPECT_EQ(parse_cycle(Measured::torque, "1\n2\n3\n1\n", reading).table,
              table);  // with a closing row
    EXPECT_EQ(parse_cycle(Measured::torque, "1\n2\n3\n", reading).table, table);
    reading.columns = {"0", "2"};
    reading.strokes = 2;
    EXPECT_EQ(parse_cycle(Measured::torque, "7;1\n7;2\n7;3\n7;1\n", reading).table,
              (TorqueTable{{0, 120, 240, 360}, {1, 2, 3, 1}}));
}

// 719.5° are nearer to a whole cycle with the step that is missing than without it.
TEST(TableReading, TracesOfFineStepsThatLackTheirLastRowAreClosedNotStretched) {
    for (const SyntheticEngine& engine :
         {test::synthetic_engines()[0], test::synthetic_engines()[10]}) {
        for (const double step : {1.0, 0.5, 0.25, 0.1}) {
            SCOPED_TRACE(std::string(engine.name) + " " + std::to_string(step));
            const auto exact = test::trace_of(engine.pressure(step), step);
            for (const bool is_closed : {false, true}) {
                std::string text = file_as(engine, {.step = step});
                if (is_closed) {
                    text += cell_text(180.0 * engine.strokes, false) + ";" +
                            cell_text(exact.pressure.front() / 1e5, false) + "\n";
                }
                ParsedCycle read;
                ASSERT_EQ(test::error_of([&] { read = parse_cycle(Measured::pressure, text); }),
                          "no error");
                EXPECT_EQ(read.closed, !is_closed);
                ASSERT_EQ(read.trace.pressure.size(), exact.pressure.size());
                double largest = 0.0;
                for (std::size_t i = 0; i < exact.pressure.size(); ++i) {
                    largest = std::max(
                        {largest,
                         1e5 * std::abs(read.trace.crank_angle_deg[i] - exact.crank_angle_deg[i]),
                         std::abs(read.trace.pressure[i] - exact.pressure[i])});
                }
                EXPECT_LT(largest, 0.01);
            }
        }
    }
    // The end far from the start, as between the strokes of a supercharged engine.
    std::string text = "deg;bar\n";
    for (int i = 0; i < 7200; ++i) {
        text += cell_text(0.1 * i, false) + ";" + cell_text(2.0 + i / 7200.0, false) + "\n";
    }
    EXPECT_EQ(test::error_of([&] {
                  EXPECT_EQ(parse_cycle(Measured::pressure, text).trace.pressure.size(), 7201U);
              }),
              "no error");
}

TEST(TableReading, StepsThatDoNotDivideTheChosenCycleEndWithinTheLast) {
    std::string csv = "angle;p, bar\n";
    for (int angle = 0; angle <= 700; angle += 28) {
        csv += std::to_string(angle) + ";" + std::to_string(angle == 364 ? 50 : 1) + "\n";
    }
    EXPECT_THROW(parse_cycle(Measured::pressure, csv), InputError);
    TableReading reading;
    reading.strokes = 4;
    const PressureTrace trace = parse_cycle(Measured::pressure, csv, reading).trace;
    EXPECT_EQ(trace.crank_angle_deg.size(), 27U);
    EXPECT_EQ(trace.crank_angle_deg.back(), 720.0);
    EXPECT_EQ(trace.pressure.back(), trace.pressure.front());
    csv.resize(csv.find("672;"));  // two steps are missing
    EXPECT_THROW(parse_cycle(Measured::pressure, csv, reading), InputError);
}

TEST(TableReading, TurnsOfATorqueOfATwoStrokeAreAveraged) {
    std::string text;
    for (int angle = 0; angle <= 3 * 360; angle += 10) {
        text += std::to_string(angle) + ";" + std::to_string(angle % 360 + angle / 360 % 3) + "\n";
    }
    TableReading reading;
    reading.strokes = 2;
    ParsedCycle read;
    ASSERT_EQ(test::error_of([&] { read = parse_cycle(Measured::torque, text, reading); }),
              "no error");
    EXPECT_EQ(read.cycles, 3U);
    EXPECT_NE(read.describe().english().find("mean of 3 cycles"), std::string::npos);
    EXPECT_EQ(read.strokes, 2);
    ASSERT_EQ(read.table.torque.size(), 37U);
    EXPECT_EQ(read.table.torque[9], 91.0);
}

// Each row of the first cycle would be looked for in each of the others.
TEST(TableReading, AFirstCycleOfManyRowsBeforeManyOfFewIsRejectedAtOnce) {
    std::string text;
    for (int i = 0; i < 100'000; ++i) {
        text += cell_text(0.007 * i, false) + ";1\n";
    }
    for (int i = 1; i < 200'000; ++i) {
        text += std::to_string(700 + 100 * i) + ";1\n";
    }
    EXPECT_NE(
        test::error_of([&] { parse_cycle(Measured::torque, text); }).find("at most 20000 rows"),
        std::string::npos);
}

TEST(TableReading, AProposalDecidesNoDecimalSign) {
    const std::string text = "deg;bar\n0;1,5\n180;1.5\n360;60\n540;3\n720;1,5\n";
    const auto proposal = propose_reading(text, Measured::pressure);
    EXPECT_FALSE(proposal.reading.layout.decimal_comma);
    EXPECT_EQ(proposal.reading.strokes, 4);
    EXPECT_TRUE(proposal.doubts.empty()) << proposal.doubts.front().english();
    TableReading decided;
    decided.layout.decimal_comma = true;
    EXPECT_FALSE(propose_reading(text, Measured::pressure, decided).doubts.empty());
}

}  // namespace
}  // namespace ravnoves::balance_shaft
