#include <gtest/gtest.h>

#include <algorithm>

#include "balance-shaft/input.h"
#include "balance-shaft/presets.h"
#include "balance-shaft/results.h"
#include "balance-shaft/solver.h"
#include "case-file/field_index.h"
#include "case-file/json.h"
#include "case-file/text_file.h"
#include "examples.h"
#include "temporary_folder.h"
#include "test_cases.h"

namespace ravnoves::balance_shaft {
namespace {

using test::error_of;

Json example() {
    return ravnoves::test::example("tmz-650d").input;
}

TEST(BalanceShaftCase, FirstCasesFitAndGainByBothCriteria) {
    for (const char* name : {"with-shaft-88x75", "../templates/balance-shaft"}) {
        const Result result = solve(read_input(ravnoves::test::example(name).input, {}));
        EXPECT_TRUE(result.is_buildable) << name;
        EXPECT_LT(result.range_change.value_or(0.0), -0.02) << name;
        EXPECT_LT(result.rms_change.value_or(0.0), -0.02) << name;
        EXPECT_EQ(verdict(result).severity, Severity::good) << name;
    }
}

TEST(BalanceShaftCase, TheVerdictSaysChangesAsTheyAreRounded) {
    Result result = solve(read_input(example(), {}));
    result.doubts.clear();
    result.inertia_check = {};
    result.is_buildable = true;
    result.buildable.stretches = {{0.0, 1.0}};
    result.best_range_buildable.value = 0.9 * result.M_up.range;
    result.best_rms_buildable.value = 0.9 * result.M_up.rms;
    const struct {
        double range, rms;
        Severity severity;
        const char* text;
    } rows[] = {
        {-0.1, -0.2, Severity::good,
         "Fits: the range is 10.0 % smaller than without shaft. The RMS is 20.0 % smaller."},
        {-0.1, 0.2, Severity::note,
         "Fits: the range is 10.0 % smaller than without shaft. The RMS is 20.0 % larger."},
        {-0.0004, 0.2, Severity::note,
         "Fits, but does not change the range. The RMS is 20.0 % larger."},
        {0.0004, 0.0, Severity::note,
         "Fits, but does not change the range. The RMS does not change."},
        {0.1, -0.2, Severity::warning,
         "Fits, but the range is 10.0 % larger than without shaft. The RMS is 20.0 % smaller."},
    };
    for (const auto& row : rows) {
        result.range_change = row.range;
        result.rms_change = row.rms;
        const Verdict found = verdict(result);
        EXPECT_EQ(found.text.english(), row.text);
        EXPECT_EQ(found.severity, row.severity) << row.text;
    }
    result.best_range_buildable.value = 1.1 * result.M_up.range;
    EXPECT_NE(verdict(result).text.english().find(
                  "At every feasible α, the range is larger than without shaft."),
              std::string::npos);
    EXPECT_EQ(verdict(result).act, best_place_act);
}

TEST(BalanceShaftInput, ThePresetIsTheExample) {
    const Input preset = preset_tmz_650d();
    EXPECT_EQ(read_input(write_input(preset), {}), preset);
    EXPECT_EQ(read_input(example(), {}), preset);
}

// Of a range, a kind and a choice the tests of fields have the rest.
TEST(BalanceShaftInput, WhatCannotBeIsRejected) {
    const std::pair<const char*, const char*> cases[] = {
        {R"({"crank_radius_mm": -46})", "crank_radius_mm: must be greater than 0, got -46"},
        {R"({"speed_rpm": 3600})", "angular_speed_rad_s: must be left out if speed_rpm is given"},
        {R"({"angular_speed_rad_s": null})",
         "speed_rpm: is required and missing (or angular_speed_rad_s)"},
        {R"({"reciprocating_masses_kg": {"piston": 0, "pin": 0, "rings": 0,
                          "rod_small_end": 0}})",
         "reciprocating_masses_kg: must add up to more than 0 and to a finite mass, got 0"},
        {R"({"reciprocating_masses_kg": null})",
         "reciprocating_masses_kg: is required and missing (or reciprocating_mass_kg)"},
        {R"({"reciprocating_mass_kg": 1})",
         "reciprocating_mass_kg: must be left out if reciprocating_masses_kg is given"},
        {R"({"cylinder": {"rod_length_mm": 40}})",
         "cylinder/rod_length_mm: must be greater than the crank radius plus the offset, 46 mm, "
         "got 40 mm"},
        {R"({"torque": null})", "torque: is required and missing"},
        {R"({"torque": 5})", "torque: must be an object, got 5"},
        {R"({"torque": {"crank_angle_deg": null, "torque_Nm": null}})",
         "torque: must have one of: crank_angle_deg with torque_Nm, csv, pressure, cycle, got none "
         "of them"},
        {R"({"torque": {"crank_angle_deg": [], "torque_Nm": []}})",
         "torque/crank_angle_deg: must have at least 3 numbers, got 0"},
        {R"({"torque": {"crank_angle_deg": [0, 100, 720],
                                     "torque_Nm": [0, null, 0]}})",
         "torque/torque_Nm/1: must be a number, got null"},
        {R"({"gears": {"teeth": 40, "shifted_teeth": 40}})",
         "gears/shifted_teeth: must be less than the teeth, which must be from 6 to 1000, got 40"},
        {R"({"flywheel": {}})",
         "flywheel: must have either inertia_kg_m2 or fluctuation, got neither"},
        {R"({"flywheel": {"inertia_kg_m2": 1, "fluctuation": 0.1}})",
         "flywheel: must have either inertia_kg_m2 or fluctuation, got both"},
        {R"({"speed_band": {"from_rpm": 2000, "to_rpm": 1000}})",
         "speed_band/to_rpm: must be at least the minimum speed of the band, 2000 min⁻¹, got 1000 "
         "min⁻¹"},
        // Sizes that no engine has: each ended in an internal error or in no end at all.
        {R"({"relieved_shaft": {"depth_mm": 1e-110, "length_mm": 400}})",
         "relieved_shaft/depth_mm: must be from 1e-06 to 100000, got 1e-110"},
        {R"({"crank_radius_mm": 1e-300})",
         "crank_radius_mm: must be from 0.001 to 1000000, got 1e-300"},
        {R"({"centre_distance_mm": 1e20})",
         "centre_distance_mm: must be from 0 to 1000000, got 1e+20"},
        {R"({"angular_speed_rad_s": 1e-300})",
         "angular_speed_rad_s: must be from 1e-06 to 10000000, got 1e-300"},
        {R"({"speed_band": {"from_rpm": 1e-9, "to_rpm": 3600}})",
         "speed_band/from_rpm: must be at least 0.1, got 1e-09"}};
    for (const auto& [patch, error] : cases) {
        EXPECT_EQ(test::rejection(preset_tmz_650d(), patch), std::string("/input/") + error);
    }
}

TEST(BalanceShaftInput, AMassIsAFieldByItsName) {
    Input input = preset_tmz_650d();
    EXPECT_TRUE(set_field(input, "/reciprocating_masses_kg/pin", FieldValue(0.3)));
    EXPECT_EQ(input.reciprocating_masses[1], (NamedMass{"pin", 0.3}));
    EXPECT_TRUE(set_field(input, "/reciprocating_masses_kg/coating", FieldValue(0.01)));
    EXPECT_EQ(input.reciprocating_masses.back(), (NamedMass{"coating", 0.01}));
    const auto entries = list_fields(input);
    EXPECT_TRUE(std::any_of(entries.begin(), entries.end(), [](const FieldEntry& entry) {
        return entry.pointer == "/reciprocating_masses_kg/coating" &&
               entry.value == FieldValue(0.01);
    }));
    // A sum stays as one part beside what is named.
    input.reciprocating_masses = {{"", 1.3}};
    EXPECT_TRUE(set_field(input, "/reciprocating_mass_kg", FieldValue(1.2)));
    EXPECT_EQ(write_input(input).at("reciprocating_mass_kg"), 1.2);
    EXPECT_EQ(read_input(write_input(input), {}), input);
    EXPECT_TRUE(set_field(input, "/reciprocating_masses_kg/piston", FieldValue(0.6)));
    EXPECT_EQ(input.reciprocating_masses,
              (std::vector<NamedMass>{{"other", 1.2}, {"piston", 0.6}}));
}

class CsvBesideTheCase : public testing::Test {
  protected:
    std::string rejection_with(const std::string& text) const {
        write_text_file(folder_ / "torque.csv", text);
        return error_of([&] { read_input(input(), CaseContext{folder_}); });
    }
    static Json input(const std::string& file = "torque.csv") {
        Json json = example();
        json["torque"] = {{"csv", file}};
        return json;
    }

    const ravnoves::test::TemporaryFolder temporary_;
    const std::filesystem::path folder_ = temporary_.path();
};

TEST_F(CsvBesideTheCase, AnotherFileUnderItsNameIsReported) {
    TorqueTable table = preset_tmz_650d().torque.table;
    write_text_file(folder_ / "torque.csv", write_torque_table(table));
    Json json = input();
    json["torque"] = write_input(read_input(json, CaseContext{folder_})).at("torque");
    const auto is_reported = [&] {
        const auto notes = solve(read_input(json, CaseContext{folder_})).notes;
        return std::any_of(notes.begin(), notes.end(), [](const Message& note) {
            return note.english().starts_with("torque.csv has changed since this case was made");
        });
    };
    EXPECT_FALSE(is_reported());
    std::string sum = json["torque"]["csv_sha256"];
    std::transform(sum.begin(), sum.end(), sum.begin(),
                   [](unsigned char digit) { return static_cast<char>(std::toupper(digit)); });
    json["torque"]["csv_sha256"] = sum;
    EXPECT_FALSE(is_reported()) << "in capitals";
    for (double& torque : table.torque) {
        torque *= 1.3;
    }
    write_text_file(folder_ / "torque.csv", write_torque_table(table));
    EXPECT_TRUE(is_reported());
    // Saving what was opened does not hide it.
    json["torque"] = write_input(read_input(json, CaseContext{folder_})).at("torque");
    EXPECT_TRUE(is_reported());
    json["torque"].erase("csv_sha256");
    EXPECT_FALSE(is_reported()) << "a case without a sum is of the file as it is";
}

TEST_F(CsvBesideTheCase, ErrorsNameFileLineAndColumn) {
    EXPECT_EQ(rejection_with("0;0\n180;x\n720;0\n"),
              "/input/torque/csv: torque.csv: line 2, column 2: must be a finite number, got "
              "\"x\"");
    EXPECT_EQ(error_of([&] { read_input(input("absent.csv"), CaseContext{folder_}); }),
              "/input/torque/csv: absent.csv: cannot be read: No such file or directory");
    EXPECT_EQ(error_of([&] { read_input(input("."), CaseContext{folder_}); }),
              "/input/torque/csv: .: must be a file, not a folder");
    EXPECT_EQ(error_of([&] { read_input(input(""), CaseContext{folder_}); }),
              "/input/torque/csv: must be a file name, got \"\"");
}

}  // namespace
}  // namespace ravnoves::balance_shaft
