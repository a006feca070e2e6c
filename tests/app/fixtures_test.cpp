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
            expect_same(name + "/" + study.key(), study.value(), run("study now.case.json"));
        }
    }
}

TEST_F(Fixtures, PartsArePutTogether) {
    expect_same("two-stroke/", fixture("two-stroke.studies.json").at(""),
                run("study --merge two-stroke.part-*.json"));
}

TEST_F(Fixtures, AnInterruptedStudyGoesOn) {
    const std::string result = "interrupted.study.json";
    ASSERT_TRUE(fs::exists(folder / (result + ".unfinished")));
    const Outcome rest = run("study interrupted.case.json -o " + result + " && cat " + result);
    EXPECT_FALSE(fs::exists(folder / (result + ".unfinished")));
    expect_same("interrupted/", fixture("interrupted.result-of-study.json"), rest);
}

}  // namespace
}  // namespace ravnoves
