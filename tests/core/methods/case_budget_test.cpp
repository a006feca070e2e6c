#include "methods/case_budget.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "case-file/case_file.h"
#include "case-file/json.h"
#include "case-file/text_file.h"
#include "core/balance-shaft/synthetic_engine.h"
#include "examples.h"
#include "numerics/constants.h"
#include "scenes/scenes.h"
#include "studies/study_run.h"
#include "support.h"
#include "temporary_folder.h"

namespace ravnoves::methods {
namespace {

using Kind = Contribution::Kind;

/// A leading result as the command line prints it, SI.
double printed(const CaseFile& file, const Json& input, const ResultEntry& result,
               const std::string& pointer) {
    CaseFile changed = file;
    changed.input = input;
    const Json solved = solve_case(changed, {}, Wanted({pointer}));
    return solved.at("result").at(Json::json_pointer(pointer)).get<double>() * result.unit;
}

const Contribution* find(const CaseDoubt& doubt, Kind kind, const std::string& pointer) {
    const auto found =
        std::find_if(doubt.contributions.begin(), doubt.contributions.end(),
                     [&](const Contribution& c) { return c.kind == kind && c.pointer == pointer; });
    return found == doubt.contributions.end() ? nullptr : &*found;
}

/// What a change contributes is the difference of two results that the command line prints.
void expect_differences(const CaseFile& file, Kind kind, const std::string& pointer,
                        const std::vector<Json>& inputs, const std::string& from = {},
                        const std::string& to = {}) {
    int found = 0;
    for (const CaseDoubt& doubt : case_budget(file, {})) {
        std::string other = doubt.result.pointer;
        if (!from.empty()) {
            other.replace(0, from.size(), to);
        }
        double expected = 0.0;
        for (const Json& input : inputs) {
            double change = printed(file, input, doubt.result, other) -
                            printed(file, file.input, doubt.result, doubt.result.pointer);
            change = doubt.result.unit == units::degree ? std::remainder(change, two_pi) : change;
            expected = std::max(expected, std::abs(change));
        }
        const Contribution* contribution = find(doubt, kind, pointer);
        const double minimum = find(doubt, Kind::rounding, "")->change.value();
        ASSERT_EQ(contribution != nullptr, expected > minimum) << doubt.result.pointer;
        if (contribution != nullptr) {
            EXPECT_NEAR(*contribution->change, expected, 1e-12 * std::abs(*doubt.result.si))
                << doubt.result.pointer;
            ++found;
        }
    }
    EXPECT_GT(found, 0) << pointer;
}

Json with(const CaseFile& file, const std::string& pointer, const Json& value) {
    Json input = file.input;
    input[Json::json_pointer(pointer)] = value;
    return input;
}

TEST(CaseBudget, AnotherChoiceContributesTheDifferenceOfTwoSolutions) {
    const CaseFile shaft = test::example("tmz-650d");
    expect_differences(shaft, Kind::choice, "/interpolation",
                       {with(shaft, "/interpolation", "periodic-cubic")});
    const CaseFile hinge = test::example("zotov-energy");
    expect_differences(hinge, Kind::choice, "/kinematics", {with(hinge, "/kinematics", "series")});
}

/// One degree of it is worth several percent of the work.
TEST(CaseBudget, ThePhaseOfATraceIsAsCertainAsItsCompressionLine) {
    CaseFile file = test::example("tmz-650d");
    const balance_shaft::PressureTrace trace = balance_shaft::test::trace_of(
        balance_shaft::test::synthetic_engines().front().pressure(1.0), 1.0);
    std::string rows = "deg;bar\n";
    for (std::size_t i = 0; i < trace.pressure.size(); ++i) {
        rows += std::to_string(i) + ';' + std::to_string(trace.pressure[i] / 1e5) + '\n';
    }
    const ravnoves::test::TemporaryFolder folder;
    const auto path = folder.path() / "p.csv";
    write_text_file(path, rows);
    file.input["torque"] = {{"pressure", {{"csv", path.string()}}}};
    file.input["cylinder"] = {{"bore_mm", 95.5}, {"rod_length_mm", 150}};
    const std::string pointer = "/torque/pressure/crank_angle_shift_deg";
    const auto budget = case_budget(file, {});
    const auto range = std::ranges::find(budget, "/metrics/M_ups/range_Nm",
                                         [](const auto& each) { return each.result.pointer; });
    ASSERT_NE(range, budget.end());
    const Contribution* phase = find(*range, Kind::tolerance, pointer);
    ASSERT_NE(phase, nullptr);
    // By its ± on either side, found here from the change of a tenth of a degree.
    const auto change = [&](double shift) {
        return printed(file, with(file, pointer, shift), range->result, range->result.pointer) -
               *range->result.si;
    };
    const double slope = (change(0.1) - change(-0.1)) / 0.2;
    const double half = *phase->change / std::abs(slope);
    EXPECT_GT(half, 0.1);
    EXPECT_LT(half, 2.0);
    // A study varies what is typed: that it leaves the phase out is said.
    const auto notes_of = [&](const std::string& varied, const Json& spread) {
        file.study = {{"vary", {{varied, spread}}},
                      {"watch", {{"/metrics/M_ups/range_Nm", Json::object()}}}};
        return studies::problem_of(file, {}).file_notes;
    };
    const auto notes = notes_of("/crank_radius_mm", {{"plus_minus", 0.02}});
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_TRUE(notes[0].english().starts_with(
        "The uncertain dead centre of the trace is not included: give " + pointer +
        " a tolerance of ± 0."))
        << notes[0].english();
    EXPECT_TRUE(notes_of("/crank_radius_mm", {{"values", {46, 47}}}).empty());
    // A tolerance of the user's own takes its place.
    file.input["torque"]["pressure"]["crank_angle_shift_deg"] = 0.0;
    EXPECT_TRUE(notes_of(pointer, {{"plus_minus", 0.25}}).empty());
    expect_differences(file, Kind::tolerance, pointer,
                       {with(file, pointer, -0.25), with(file, pointer, 0.25)});
}

TEST(CaseBudget, TheApproximateFormContributesItsDifference) {
    const CaseFile engine = test::example("vr5-volkswagen");
    expect_differences(engine, Kind::approximate, "/two_term", {engine.input}, "/exact",
                       "/two_term");
}

/// A torque that the case keeps beside its source has no part in the numbers.
TEST(CaseBudget, ATorqueThatTheCaseKeepsIsNoDoubt) {
    CaseFile table = test::example("tmz-650d");
    const std::string alone = write_text(case_budget(table, {}));
    table.kept = {{"torque", test::example("../templates/balance-shaft").input.at("torque")}};
    EXPECT_EQ(write_text(case_budget(table, {})), alone);
}

TEST(CaseBudget, AToleranceContributesItsFartherEnd) {
    CaseFile shaft = test::example("tmz-650d");
    shaft.study = {{"vary",
                    {{"/crank_radius_mm", {{"plus_minus", 0.5}}},
                     {"/centre_distance_mm", {{"normal_sd", 0.2}}},
                     {"/angular_speed_rad_s", {{"plus_minus_percent", 1.0}}},
                     {"/cylinder/bore_mm", {{"plus_minus", 0.1}}}}},
                   {"watch", Json::object()}};
    const auto ends = [&](const char* pointer, double size) {
        const double nominal = shaft.input.at(Json::json_pointer(pointer)).get<double>();
        return std::vector{with(shaft, pointer, nominal - size),
                           with(shaft, pointer, nominal + size)};
    };
    expect_differences(shaft, Kind::tolerance, "/crank_radius_mm", ends("/crank_radius_mm", 0.5));
    expect_differences(shaft, Kind::tolerance, "/centre_distance_mm",
                       ends("/centre_distance_mm", 0.2));
    const double speed = shaft.input.at("angular_speed_rad_s").get<double>();
    expect_differences(shaft, Kind::tolerance, "/angular_speed_rad_s",
                       ends("/angular_speed_rad_s", speed / 100.0));
    // A bore that this source of the torque does not have changes nothing.
    for (const CaseDoubt& doubt : case_budget(shaft, {})) {
        EXPECT_EQ(find(doubt, Kind::tolerance, "/cylinder/bore_mm"), nullptr);
    }
}

/// Every scene leads with something; its rounding is that of doubles, and the largest is first.
TEST(CaseBudget, HoldsForTheExamplesOfEveryScene) {
    std::set<std::string> scenes;
    for (const auto& path : ravnoves::test::example_files()) {
        const CaseFile file = parse_case(read_text_file(path));
        scenes.insert(file.scene);
        const auto budget = case_budget(file, {RAVNOVES_EXAMPLES});
        EXPECT_FALSE(budget.empty()) << path;
        for (const CaseDoubt& doubt : budget) {
            const auto& all = doubt.contributions;
            EXPECT_TRUE(std::is_sorted(all.begin(), all.end(), [](const auto& a, const auto& b) {
                return a.change.value_or(-1.0) > b.change.value_or(-1.0);
            })) << doubt.result.pointer;
            const Contribution* const rounding = find(doubt, Kind::rounding, "");
            ASSERT_NE(rounding, nullptr) << path << doubt.result.pointer;
            EXPECT_LT(rounding->change.value(), 1e-10 * std::abs(*doubt.result.si))
                << path << doubt.result.pointer;
        }
    }
    EXPECT_EQ(scenes.size(), scene_solvers().size());
}

}  // namespace
}  // namespace ravnoves::methods
