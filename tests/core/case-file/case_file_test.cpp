#include "case-file/case_file.h"

#include <gtest/gtest.h>

#include "case-file/text_file.h"
#include "error_of.h"
#include "scenes/case_sources.h"
#include "scenes/scenes.h"

namespace ravnoves {
namespace {

Json envelope(const char* more = "{}") {
    Json document = parse_json(
        R"({"format": "ravnoves-case", "version": 1, "scene": "s", "title": "t", "input": {"a": 1}})");
    document.update(parse_json(more));
    return document;
}

std::string rejection(const Json& document) {
    return test::error_of([&] { read_case(document, {"s"}); });
}

TEST(CaseFileTest, NotesVariantsStudyAndWhatIsKeptComeBackAsTheyWere) {
    const Json document = envelope(R"({"notes": "two\nlines",
        "variants": [{"name": "A", "input": {"a": 2}}, {"name": "Б", "input": {"wrong": []}}],
        "reference": "Б",
        "study": {"vary": {"/a": {"plus_minus": 1}}, "samples": 10},
        "kept": {"torque": {"csv": "x.csv"}}})");
    const CaseFile file = read_case(document, {"s"});
    EXPECT_EQ(file.notes, "two\nlines");
    ASSERT_EQ(file.variants.size(), 2U);
    EXPECT_EQ(file.variants[1].name, "Б");
    EXPECT_EQ(file.variants[0].input, Json({{"a", 2}}));
    EXPECT_EQ(file.study, document["study"]);
    EXPECT_EQ(file.kept, document["kept"]);
    const Json written = write_case(file);
    EXPECT_TRUE(nlohmann::json(written) == nlohmann::json(document)) << written.dump(2);
    EXPECT_EQ(read_case(written, {"s"}).variants, file.variants);
    EXPECT_EQ(read_case(written, {"s"}).reference, "Б");
}

TEST(CaseFileTest, WhatIsEmptyIsLeftOut) {
    EXPECT_EQ(write_case(read_case(envelope(), {"s"})), envelope());
    EXPECT_EQ(write_case(read_case(envelope(R"({"notes": "", "variants": []})"), {"s"})),
              envelope());
}

TEST(CaseFileTest, RejectionsNamePlaceRuleAndFinding) {
    EXPECT_EQ(rejection(envelope(R"({"format": "ravnoves-result"})")),
              "/format: must be one of \"ravnoves-case\", got \"ravnoves-result\"");
    EXPECT_EQ(rejection(envelope(R"({"scene": "balance"})")),
              "/scene: must be one of \"s\", got \"balance\"");
    EXPECT_EQ(rejection(envelope(R"({"notes": 3})")), "/notes: must be a text, got 3");
    EXPECT_EQ(rejection(envelope(R"({"study": []})")), "/study: must be an object, got []");
    EXPECT_EQ(rejection(envelope(R"({"kept": 1})")), "/kept: must be an object, got 1");
    EXPECT_EQ(rejection(envelope(R"({"reference": "A"})")),
              "/reference: must be the name of a variant, got \"A\"");
    EXPECT_EQ(rejection(envelope(R"({"variants": {}})")), "/variants: must be a list, got {}");
    EXPECT_EQ(rejection(envelope(R"({"variants": [7]})")), "/variants/0: must be an object, got 7");
    EXPECT_EQ(rejection(envelope(R"({"variants": [{"input": {}}]})")),
              "/variants/0/name: is required and missing");
    EXPECT_EQ(rejection(envelope(R"({"variants": [{"name": "", "input": {}}]})")),
              "/variants/0/name: must not be empty");
    EXPECT_EQ(rejection(envelope(R"({"variants": [{"name": "A", "input": {}},
                                                {"name": "A", "input": {}}]})")),
              "/variants/1/name: must differ from the names of the other variants, got \"A\"");
    EXPECT_EQ(rejection(envelope(R"({"variants": [{"name": "A", "input": 1}]})")),
              "/variants/0/input: must be an object, got 1");
    EXPECT_EQ(rejection(envelope(R"({"variants": [{"name": "A", "input": {}, "nam": 1}]})")),
              "/variants/0/nam: is not a known key; the nearest is \"name\"");
    EXPECT_EQ(rejection(envelope(R"({"note": ""})")),
              "/note: is not a known key; the nearest is \"notes\"");
}

TEST(CaseFileTest, ANewerVersionIsRejectedInWords) {
    EXPECT_EQ(rejection(envelope(R"({"version": 2})")),
              "/version: must be at most 1 (a newer program wrote this case; update to open it), "
              "got 2");
    EXPECT_EQ(rejection(envelope(R"({"tolerances_of_drawing": {}})")),
              "/tolerances_of_drawing: is not a known key (a newer program may have written this "
              "case; update to open it)");
}

/// One case of every version there was; a file here is never changed again.
TEST(CaseFileTest, EveryVersionThereWasIsRead) {
    const std::filesystem::path folder =
        std::filesystem::path(RAVNOVES_EXPECTED).parent_path() / "versions";
    for (int version = 1; version <= case_version; ++version) {
        const auto path = folder / (std::to_string(version) + ".case.json");
        const CaseFile file = parse_case(read_text_file(path));
        EXPECT_EQ(file.title, "Of version " + std::to_string(version));
        EXPECT_TRUE(solve_case(file, CaseContext{folder}).contains("result"));
        const Json written = write_case(file);
        EXPECT_EQ(written.at("version"), case_version);
        EXPECT_NO_THROW(solve_case(read_case(written), CaseContext{folder}));
    }
}

TEST(CaseFileTest, EveryFileThatACaseNamesIsFound) {
    CaseFile file{"s", "", {{"torque", {{"csv", "a.csv"}}}}};
    file.kept = {{"torque", {{"pressure", {{"csv", "b.csv"}}}}}};
    file.variants.push_back({"A", {{"torque", {{"csv", "c.csv"}}}}});
    EXPECT_EQ(files_named_by(file, {"/d"}),
              (std::vector<std::filesystem::path>{"/d/a.csv", "/d/b.csv", "/d/c.csv"}));
}

TEST(CaseFileTest, ACaseThatMovesNamesTheSameFiles) {
    const auto moved = [](const char* name, const char* from, const char* to) {
        CaseFile file{"s", "", {{"torque", {{"csv", name}}}}};
        move_files(file, {from}, {to});
        return file.input["torque"]["csv"].get<std::string>();
    };
    EXPECT_EQ(moved("a.csv", "/none/x", "/none/x"), "a.csv");
    EXPECT_EQ(moved("../b/a.csv", "/none/x/.", "/none/x"), "../b/a.csv");
    EXPECT_EQ(moved("a.csv", "/none/x", "/none"), "x/a.csv");
    EXPECT_EQ(moved("a.csv", "/none/x", "/none/y/z"), "../../x/a.csv");
    EXPECT_EQ(moved("мотор/a.csv", "/none/x", "/none/ы"), "../x/мотор/a.csv");
    EXPECT_EQ(moved("/none/x/a.csv", "/none/q", "/none/x"), "a.csv");
    EXPECT_EQ(moved("/none/x/a.csv", "/none/x", "/none/x"), "a.csv");
    EXPECT_EQ(moved("/other/a.csv", "/none/x", "/none/y"), "/other/a.csv");
}

}  // namespace
}  // namespace ravnoves
