// One record of the cylinder, whatever the source of the torque.

#include <gtest/gtest.h>

#include "balance-shaft/engine_torque.h"
#include "balance-shaft/input.h"
#include "case-file/json.h"
#include "scenes/scenes.h"
#include "test_cases.h"

namespace ravnoves::balance_shaft {
namespace {

CaseFile older(const char* patch) {
    Json document = {{"format", case_format},
                     {"version", 1},
                     {"scene", "balance-shaft"},
                     {"input", write_input(test::diesel())}};
    document["input"].erase("cylinder");
    document["input"].merge_patch(
        parse_json(R"({"torque": {"cycle": {"bore_mm": 95.5, "rod_length_mm": 150}}})"));
    document.merge_patch(parse_json(patch));
    return read_case(document);
}

TEST(OlderCases, SizesOfTheCylinderAreGathered) {
    EXPECT_EQ(read_input(older("{}").input, {}), test::diesel());
    Input offset = test::diesel();
    offset.cylinder.offset = 3e-3;
    EXPECT_EQ(read_input(older(R"({"input": {"torque": {"cycle": {"offset_mm": 3}},
                                             "envelope": {"cylinder_bore_mm": 95.5}}})")
                             .input,
                         {}),
              offset);
    const CaseFile table = older(R"({"input": {"torque": {"cycle": null, "csv": "t.csv"},
        "rod_length_mm": 150, "offset_mm": -2, "envelope": {"cylinder_bore_mm": 90}},
        "variants": [{"name": "a", "input": {"rod_length_mm": 140}}]})");
    EXPECT_EQ(table.input.at("cylinder"),
              Json({{"bore_mm", 90}, {"rod_length_mm", 150}, {"offset_mm", -2}}));
    EXPECT_EQ(table.variants[0].input, Json({{"cylinder", {{"rod_length_mm", 140}}}}));
}

TEST(OlderCases, SizesThatDifferAreRejectedWithBothPlaces) {
    EXPECT_EQ(test::error_of([] { older(R"({"input": {"envelope": {"cylinder_bore_mm": 90}}})"); }),
              "/input/envelope/cylinder_bore_mm: must be 95.5 as in /input/torque/cycle/bore_mm, "
              "or be left out, got 90");
    EXPECT_EQ(test::error_of([] { older(R"({"input": {"cylinder": {"rod_length_mm": 149}}})"); }),
              "/input/torque/cycle/rod_length_mm: must be 149 as in "
              "/input/cylinder/rod_length_mm, or be left out, got 150");
    EXPECT_EQ(test::error_of([] { read_input(older(R"({"input": {"cylinder": 3}})").input, {}); }),
              "/input/cylinder: must be an object, got 3");
}

TEST(OlderCases, StudiesVaryTheSizesWhereTheyAreNow) {
    const CaseFile file = older(R"({"study": {"vary": {
        "/torque/cycle/bore_mm": {"plus_minus": 0.1}, "/torque/cycle/offset_mm": {"plus_minus": 1},
        "/crank_radius_mm": {"plus_minus": 0.1}}}})");
    EXPECT_EQ(file.study.at("vary").dump(),
              R"({"/cylinder/bore_mm":{"plus_minus":0.1},"/cylinder/offset_mm":{"plus_minus":1},)"
              R"("/crank_radius_mm":{"plus_minus":0.1}})");
}

TEST(OlderCases, TwoSpreadsOfOneSizeAreRejectedUnlessTheyAreTheSame) {
    const auto rejection = [](const char* study) { return test::error_of([&] { older(study); }); };
    EXPECT_EQ(rejection(R"({"study": {"vary": {"/torque/cycle/bore_mm": {"plus_minus": 0.1},
                                             "/cylinder/bore_mm": {"plus_minus": 0.2}}}})"),
              "/study/vary/~1cylinder~1bore_mm: must be {\"plus_minus\":0.1} as in "
              "/study/vary/~1torque~1cycle~1bore_mm, or be left out, got {\"plus_minus\":0.2}");
    EXPECT_EQ(rejection(R"({"study": {"vary": {"/torque/cycle/bore_mm": {"plus_minus": 0.1},
                                             "/cylinder/bore_mm": {"plus_minus": 0.1}}}})"),
              "no error");
}

TEST(OlderCases, ANullIsRejectedWhereItWouldBeNow) {
    Json document = {{"format", case_format},
                     {"version", 1},
                     {"scene", "balance-shaft"},
                     {"input", write_input(test::diesel())}};
    document["input"].erase("cylinder");
    document["input"]["cylinder"]["bore_mm"] = 95.5;
    document["input"]["rod_length_mm"] = nullptr;
    EXPECT_EQ(test::error_of([&] { read_input(read_case(document).input, {}); }),
              "/input/cylinder/rod_length_mm: must be a number, got null");
}

TEST(OlderCases, OfAKeptTorqueTheBoreIsSaid) {
    EXPECT_TRUE(older(R"({"kept": {"torque": {"pressure": {"csv": "p.csv", "bore_mm": 95.5,
                                                           "rod_length_mm": 140}}}})")
                    .changes.empty());
    const CaseFile file = older(R"({"kept": {"torque": {"pressure": {"csv": "p.csv",
                                                                     "bore_mm": 88}}}})");
    ASSERT_EQ(file.changes.size(), 1U);
    EXPECT_NE(file.changes[0].english().find("had the bore 88"), std::string::npos);
    EXPECT_EQ(file.kept, Json({{"torque", {{"pressure", {{"csv", "p.csv"}}}}}}));
}

}  // namespace
}  // namespace ravnoves::balance_shaft
