// `ravnoves-cli study` as a user, a batch system or a cluster runs it.

#include <gtest/gtest.h>

#include <string>

#include "case-file/json.h"
#include "command_line.h"

namespace ravnoves {
namespace {

namespace fs = std::filesystem;

using test::CommandLine;
using test::Outcome;
using test::read_all;

class StudyCommandLine : public CommandLine {
  protected:
    static Json study_case(int samples = 600, const char* method = "sobol") {
        Json document = example();
        document["study"] = {{"vary",
                              {{"/crank_radius_mm", {{"plus_minus", 0.02}}},
                               {"/reciprocating_masses_kg/piston", {{"normal_sd", 0.002}}},
                               {"/torque/torque_Nm/26", {{"plus_minus_percent", 1}}}}},
                             {"watch",
                              {{"/metrics/M_ups/range_Nm", {{"max", 1083}}},
                               {"/optimum/rms/shaft_angle_deg", Json::object()}}},
                             {"method", method},
                             {"samples", samples},
                             {"seed", 1}};
        return document;
    }
};

TEST_F(StudyCommandLine, PrintsTheContract) {
    write("case.json", study_case().dump());
    const Outcome outcome = run("study case.json");
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const Json result = Json::parse(outcome.out);
    EXPECT_EQ(result.at("format"), "ravnoves-study");
    EXPECT_EQ(result.at("scene"), "balance-shaft");
    EXPECT_EQ(run("study case.json -o r.json && sha256sum case.json").out.substr(0, 64),
              result.at("case_sha256").get<std::string>());
    EXPECT_EQ(read_all(folder / "r.json"), outcome.out);
    EXPECT_EQ(result.at("samples"), 600);
    EXPECT_EQ(result.at("solved"), 600);
    const Json& range = result.at("watched").at("/metrics/M_ups/range_Nm");
    EXPECT_NEAR(range.at("nominal").get<double>(), 1082.3567, 1e-4);
    for (const char* key : {"mean", "standard_deviation", "min", "max", "percentiles", "within",
                            "linear", "first_order", "total"}) {
        EXPECT_TRUE(range.contains(key)) << key;
    }
}

// Keys of a study are anybody's text, and its answers go to a terminal.
TEST_F(StudyCommandLine, ShowsPointersPrintableAndShort) {
    for (const char* list : {"vary", "watch"}) {
        for (const std::string& key :
             {std::string("/a\x1b[31m\nb"), "/" + std::string(1'000'000, 'k')}) {
            Json document = study_case();
            document["study"][list][key] =
                list == std::string("vary") ? Json{{"plus_minus", 1}} : Json::object();
            write("case.json", document.dump());
            const Outcome outcome = run("study case.json");
            EXPECT_EQ(outcome.status, 2);
            EXPECT_LT(outcome.err.size(), 300U);
            EXPECT_EQ(outcome.err.find('\x1b'), std::string::npos) << outcome.err;
            EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
            EXPECT_NE(outcome.err.find(std::string("case.json: /study/") + list),
                      std::string::npos);
        }
    }
}

TEST_F(StudyCommandLine, ShardsAreTheWholeToTheLastDigit) {
    write("case.json", study_case().dump());
    for (const char* shard : {"3/3", "1/3", "2/3"}) {
        EXPECT_EQ(
            run(std::string("study case.json --threads 2 --shard ") + shard + " -o part" + shard[0])
                .status,
            0);
    }
    EXPECT_TRUE(run("study --merge part2 part3 part1").out == run("study case.json").out);
    EXPECT_LT(fs::file_size(folder / "part1"), 64U * 1024U);
    expect_rejected(run("study --merge part1 part3"),
                    "--merge: 1 of 3 parts are missing; run them again: --shard 2/3");
    std::string changed = read_all(folder / "part3");
    changed[changed.find("\"values\":[") + 10] = '9';
    write("part3", changed);
    expect_rejected(
        run("study --merge part1 part3"),
        "part3: /sha256: is not the checksum of the part: the part was changed; run it again");
    write("part2", "{}");
    expect_rejected(run("study --merge part1 part2"), "part2: /format: is required");
}

TEST_F(StudyCommandLine, LeavesNothingWhereItIsEnded) {
    write("case.json", study_case(1'000'000'000).dump());
    EXPECT_NE(run("study case.json -o r.json", "", "timeout -s TERM 1 ").status, 0);
    EXPECT_FALSE(fs::exists(folder / "r.json"));
}

TEST_F(StudyCommandLine, WritesOverNoStudyOfAnotherCase) {
    write("case.json", study_case().dump());
    ASSERT_EQ(run("study case.json -o r.json").status, 0);
    const std::string finished = read_all(folder / "r.json");
    Json other = study_case();
    other["input"]["crank_radius_mm"] = 47;
    write("other.json", other.dump());
    for (const char* options : {"", " --shard 1/2"}) {
        expect_rejected(run(std::string("study other.json -o r.json") + options),
                        "r.json: has the study of another case, or of this one before it "
                        "changed; move it or choose another file");
        EXPECT_EQ(read_all(folder / "r.json"), finished);
    }
    // Its own it writes again, and over what is no study.
    EXPECT_EQ(run("study case.json -o r.json").status, 0);
    EXPECT_EQ(read_all(folder / "r.json"), finished);
    for (const char* text : {"my notes", "[1]", "{\"format\": 1}"}) {
        write("r.json", text);
        EXPECT_EQ(run("study case.json -o r.json").status, 0);
        EXPECT_EQ(read_all(folder / "r.json"), finished);
    }
}

TEST_F(StudyCommandLine, PrintsAGridAsATable) {
    Json document = study_case();
    document["study"] = {{"vary",
                          {{"/shaft_angle_deg", {{"from", 40}, {"to", 50}, {"steps", 3}}},
                           {"/centre_distance_mm", {{"values", {90, -1}}}}}},
                         {"watch", {{"/metrics/M_ups/range_Nm", Json::object()}}},
                         {"method", "grid"}};
    write("case.json", document.dump());
    const Json result = Json::parse(run("study case.json").out);
    ASSERT_EQ(result.at("table").size(), 6U);
    EXPECT_EQ(result.at("table")[2][0], 45);
    EXPECT_TRUE(result.at("table")[2][2].is_number());
    EXPECT_TRUE(result.at("table")[3][2].is_null());
    EXPECT_EQ(result.at("solved"), 3);
    EXPECT_EQ(result.at("refused")[0].at("count"), 3);
}

TEST_F(StudyCommandLine, BadStudiesAreOneLine) {
    const auto with = [&](const char* pointer, const Json& value) {
        Json document = study_case();
        document[Json::json_pointer(pointer)] = value;
        write("case.json", document.dump());
        return run("study case.json");
    };
    write("case.json", example().dump());
    expect_rejected(run("study case.json"), "case.json: /study: is required and missing");
    expect_rejected(with("/study/vary/~1crank_radius", {{"plus_minus", 1}}),
                    "case.json: /study/vary/~1crank_radius: must point to a number of the input");
    expect_rejected(
        with("/study/watch/~1metrics~1M_up", Json::object()),
        "case.json: /study/watch/~1metrics~1M_up: must point to a number of the result");
    expect_rejected(with("/study/watch/~1metric", Json::object()),
                    "case.json: /study/watch/~1metric: must be a value that the result has");
    expect_rejected(with("/study/vary/~1crank_radius_mm", {{"plus_minus", 1e200}}),
                    "case.json: /study/vary/~1crank_radius_mm: must scatter less");
    expect_rejected(with("/input/crank_radius_mm", -46), "case.json: /input/crank_radius_mm: must");
}

}  // namespace
}  // namespace ravnoves
