// Sources of the torque that a case keeps while another is in use.

#include <gtest/gtest.h>

#include "balance-shaft/input.h"
#include "case-file/case_file.h"
#include "case-file/sha256.h"
#include "case-file/text_file.h"
#include "temporary_folder.h"
#include "test_cases.h"

namespace ravnoves::balance_shaft {
namespace {

using Kind = TorqueSource::Kind;

void write_traces(const std::filesystem::path& folder) {
    std::string text = "deg;bar\n";
    for (int angle = 0; angle <= 720; angle += 10) {
        text += std::to_string(angle) + ";" + std::to_string(angle > 340 && angle < 400 ? 40 : 1) +
                "\n";
    }
    write_text_file(folder / "trace.csv", text);
    write_text_file(folder / "table.csv", "0;0\n180;-50\n360;0\n540;50\n720;0\n");
}

/// The input after it went through a case with another source in use.
Input through_case(const Input& input, const CaseContext& context) {
    Input read = read_input(parse_json(write_input(input).dump()), context);
    const Json kept = write_kept(input);
    read_kept(kept.is_null() ? kept : parse_json(kept.dump()), context, read);
    return read;
}

TEST(KeptTorque, EverySourceComesBackWhicheverIsInUse) {
    const ravnoves::test::TemporaryFolder folder;
    write_traces(folder.path());
    const CaseContext context{folder.path()};
    Input input = test::diesel();
    input.torque.table = preset_tmz_650d().torque.table;
    const auto read = [&](const char* name, DataFile& file) {
        const std::string text = read_text_file(context.directory / name);
        file.name = name;
        file.sum_then = file.sum_now = sha256(text);
        return text;
    };
    input.torque.trace =
        parse_cycle(Measured::pressure, read("trace.csv", input.torque.trace_file)).trace;
    for (const Kind kind : {Kind::table, Kind::pressure, Kind::cycle}) {
        input.torque.kind = kind;
        EXPECT_EQ(through_case(input, context), input) << static_cast<int>(kind);
    }
    input.torque.table = parse_cycle(Measured::torque, read("table.csv", input.torque.csv)).table;
    for (const Kind kind : {Kind::csv, Kind::pressure, Kind::cycle}) {
        input.torque.kind = kind;
        EXPECT_EQ(through_case(input, context), input) << static_cast<int>(kind);
    }
}

TEST(KeptTorque, OfATwoStrokeItComesBackAsOne) {
    const ravnoves::test::TemporaryFolder folder;
    const CaseContext context{folder.path()};
    std::string trace = "deg;bar\n";
    std::string table;
    for (int angle = 0; angle <= 720; angle += 10) {
        const bool is_high = angle % 360 > 160 && angle % 360 < 220;
        trace += std::to_string(angle) + (is_high ? ";40\n" : ";1\n");
        table += std::to_string(angle) + (is_high ? ";90\n" : ";-20\n");
    }
    write_text_file(folder.path() / "trace.csv", trace);
    write_text_file(folder.path() / "table.csv", table);
    for (const char* kept : {R"({"torque": {"pressure": {"csv": "trace.csv"}}})",
                             R"({"torque": {"csv": "table.csv"}})"}) {
        Input input = test::two_stroke();
        read_kept(parse_json(kept), context, input);
        const auto& angles = input.torque.csv.name.empty() ? input.torque.trace.crank_angle_deg
                                                           : input.torque.table.crank_angle_deg;
        ASSERT_EQ(angles.size(), 37U) << kept;
        EXPECT_EQ(angles.back(), 360.0) << kept;
    }
}

TEST(KeptTorque, NothingIsKeptWhereThereIsOneSource) {
    EXPECT_TRUE(write_kept(preset_tmz_650d()).is_null());
    EXPECT_TRUE(write_kept(test::diesel()).is_null());
}

TEST(KeptTorque, AFileThatIsNotThereStaysNamed) {
    const CaseContext nowhere{"/nonexistent"};
    Input input = test::diesel();
    const Json kept = {{"torque", {{"csv", "gone.csv"}}}};
    read_kept(kept, nowhere, input);
    EXPECT_EQ(input.torque.table.size(), 0U);
    EXPECT_EQ(write_kept(input), kept);
}

TEST(KeptTorque, CrankcasePressureStaysWhileTheTraceIsNotThere) {
    Input input = preset_tmz_650d();
    Input named = input;
    named.torque.trace_file.name = "gone.csv";
    named.torque.crankcase_pressure = 1.1e5;
    const Json kept = write_kept(named);
    ASSERT_EQ(kept.at("torque").count("pressure"), 1U) << kept.dump();
    read_kept(kept, CaseContext{"/nonexistent"}, input);
    EXPECT_EQ(input.torque.trace_file.name, "gone.csv");
    EXPECT_DOUBLE_EQ(input.torque.crankcase_pressure, 1.1e5);
    EXPECT_EQ(write_kept(input), kept);
}

TEST(KeptTorque, RejectionsNameThePlace) {
    const auto rejection = [](const char* kept) {
        Input input = preset_tmz_650d();
        return test::error_of([&] { read_kept(parse_json(kept), {}, input); });
    };
    EXPECT_EQ(rejection(R"({"torques": {}})"),
              "/kept/torques: is not a known key; the nearest is \"torque\"");
    EXPECT_EQ(rejection(R"({"torque": 1})"), "/kept/torque: must be an object, got 1");
    EXPECT_EQ(rejection(R"({"torque": {"csv": 3}})"), "/kept/torque/csv: must be a text, got 3");
    EXPECT_EQ(rejection(R"({"torque": {"cycle": {"compression_ratio": 1}}})"),
              "/kept/torque/cycle/compression_ratio: must be greater than 1 and at most 100, got "
              "1");
    EXPECT_NE(rejection(R"({"torque": {"crank_angle_deg": [0, 720], "torque_Nm": [0]}})"),
              "no error");
    EXPECT_EQ(rejection("{}"), "no error");
}

}  // namespace
}  // namespace ravnoves::balance_shaft
