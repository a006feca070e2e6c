// Studies, parts and progress of versions before this one.

#include <gtest/gtest.h>

#include <vector>

#include "case-file/json.h"
#include "command_line.h"
#include "fixtures.h"

namespace ravnoves {
namespace {

namespace fs = std::filesystem;

using test::CommandLine;
using test::Difference;
using test::fixture;
using test::Outcome;

/// "CASE/METHOD/POINTER", where the method of the case's own study is empty. Whoever takes a value
/// out of a study's result adds it here and says why.
const std::vector<Difference> differences_of_studies{
    {"*sha256", "of the file that the test writes"},
    {"*/linear/standard_deviation_error", "rounding, which no two machines share"},
    {"*/derivatives/*/error", "the same"},
    {"*/notes/*",
     "errors of replicates decide whether samples are too few, the linear answer fails"},
    {"*/robust_best", "the sweep over the angle shows it"},
    {"*/first_order*", "by products of independent replicates, null where samples do not tell"},
    {"*/total*", "the same"},
    {"*/linear/samples", "those that try the linear answer, without those of its derivatives"},
    {"*/linear/solved", "the same"},
    {"*/linear/refused", "the same"},
    {"*/linear/watched/*/percentiles/*", "of points scrambled otherwise", 1e-3},
    {"*/linear/watched/*/m[ia][nx]", "the same"},
    {"*/linear/watched/*/within/*", "the same"},
    {"*/sobol/watched/*/percentiles/*", "of points scrambled otherwise, each replicate by itself"},
    {"*/sobol/watched/*/m[ia][nx]", "the same"},
    {"*/sobol/watched/*/within/*", "the same"},
    {"*/sobol/watched/*/mean", "the same"},
    {"*/sobol/watched/*/standard_deviation", "the same"},
};

class Fixtures : public CommandLine {
  protected:
    void SetUp() override {
        CommandLine::SetUp();
        fs::copy(test::fixture_folder(), folder);
    }
    void expect_same(const std::string& name, const Json& was, const Outcome& outcome) const {
        ASSERT_EQ(outcome.status, 0) << name << ": " << outcome.err;
        const auto found =
            test::differences(name, was, Json::parse(outcome.out), differences_of_studies);
        EXPECT_TRUE(found.empty()) << test::first_of(found);
    }
};

TEST_F(Fixtures, AStudyGivesWhatItGave) {
    for (const std::string& name : test::fixtures_with(".studies.json")) {
        const Json studies = fixture(name + ".studies.json");
        for (const auto& study : studies.items()) {
            Json document = fixture(name + ".case.json");
            if (!study.key().empty()) {
                document["study"]["method"] = study.key();
                document["study"]["samples"] = 300;
                document["study"]["seed"] = 3;
            }
            write("now.case.json", document.dump());
            const Outcome outcome = run("study now.case.json");
            const std::string method = study.value().at("method");
            if (method == "second-order" || method == "latin-hypercube") {
                EXPECT_EQ(outcome.status, 2);
                EXPECT_TRUE(outcome.err.starts_with("now.case.json: /study/method: must be \"") &&
                            outcome.err.ends_with("no longer supported\n"))
                    << outcome.err;
            } else {
                expect_same(name + "/" + method, study.value(), outcome);
            }
        }
    }
}

TEST_F(Fixtures, PartsOfOtherVersionsAreRejected) {
    const Outcome outcome = run("study --merge two-stroke.part-*.json");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.err,
              "two-stroke.part-1.json: /version: must be 4; run the parts of other versions again, "
              "got 1\n");
}

TEST_F(Fixtures, AStudyThatAnotherVersionBeganIsComputed) {
    const fs::path left = folder / "interrupted.study.json.unfinished";
    const std::string was = test::read_all(left);
    ASSERT_FALSE(was.empty());
    expect_same("interrupted/" +
                    fixture("interrupted.result-of-study.json").at("method").get<std::string>(),
                fixture("interrupted.result-of-study.json"),
                run("study interrupted.case.json -o interrupted.study.json && cat "
                    "interrupted.study.json"));
    EXPECT_EQ(test::read_all(left), was);
}

}  // namespace
}  // namespace ravnoves
