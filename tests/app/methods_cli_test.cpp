// The commands that say how far the numbers can be trusted: methods and validate.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "case-file/decimal.h"
#include "case-file/json.h"
#include "command_line.h"
#include "methods/kernel.h"
#include "methods/validation/validation.h"

namespace ravnoves {
namespace {

using test::CommandLine;
using test::lines_of;
using test::Outcome;
using test::read_all;

bool says(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST_F(CommandLine, ValidatePrintsTheCountsAndEveryNumber) {
    const Outcome outcome = run("validate");
    EXPECT_EQ(outcome.status, 0);  // no number without an explanation
    EXPECT_EQ(outcome.err, "");
    const auto report = methods::validate();
    EXPECT_EQ(lines_of(outcome.out).front(), report.summary());
    EXPECT_TRUE(outcome.out == methods::write_text(report));
}

TEST_F(CommandLine, MethodsPrintsAKernelsTableAndWhy) {
    const Outcome outcome = run("methods --kernel moment-range --csv table.csv");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_TRUE(says(outcome.err, "moment-range: 0 %")) << outcome.err;
    EXPECT_TRUE(says(outcome.err, "100 %")) << outcome.err;
    const methods::Kernel& kernel = *methods::find_kernel("moment-range");
    EXPECT_TRUE(says(outcome.out, kernel.title.english));
    EXPECT_TRUE(read_all(folder / "table.csv").starts_with("kernel,sweep,value,"));
}

TEST_F(CommandLine, AnUnknownKernelGetsTheListOfThem) {
    write("table.csv", "kept");
    const Outcome outcome = run("methods --kernel slider --csv table.csv");
    expect_rejected(outcome, "ravnoves-cli: --kernel: must be one of ");
    for (const methods::Kernel& kernel : methods::kernels()) {
        EXPECT_TRUE(says(outcome.err, kernel.id)) << outcome.err;
    }
    EXPECT_TRUE(says(outcome.err, ", got slider")) << outcome.err;
    EXPECT_EQ(read_all(folder / "table.csv"), "kept");
    expect_rejected(run("methods --kernel ''"), "ravnoves-cli: --kernel: must be one of ");
}

/// Said before anything is measured, so the answer comes at once and alone.
TEST_F(CommandLine, ATableThatCannotBeWrittenIsSaidFirst) {
    for (const char* command : {"validate", "methods --kernel best-angle"}) {
        const std::string start(command);
        expect_rejected(run(start + " --csv no/such/table.csv"), "no/such/table.csv: cannot be ");
        expect_rejected(run(start + " --csv ."), ".: must be a file");
    }
    EXPECT_EQ(run("validate --csv /dev/full").status, 2);
}

/// What the table prints of a choice is the difference of two results that solve prints.
TEST_F(CommandLine, MethodsOfACaseSaysWhatContributesToItsResults) {
    write("case.json", read_all(RAVNOVES_EXAMPLES "/tmz-650d.case.json"));
    const Outcome table = run("methods --case case.json");
    EXPECT_EQ(table.status, 0) << table.err;
    EXPECT_TRUE(says(table.out, "/interpolation: periodic-cubic")) << table.out;
    Json other = Json::parse(read_all(folder / "case.json"));
    other["input"]["interpolation"] = "periodic-cubic";
    write("other.json", other.dump());
    const auto range = [&](const char* name) {
        const Outcome solved = run(std::string("solve --only /metrics/M_ups/range_Nm ") + name);
        const Json::json_pointer pointer("/result/metrics/M_ups/range_Nm");
        return Json::parse(solved.out).at(pointer).get<double>();
    };
    const std::string change = format_number(std::abs(range("other.json") - range("case.json")), 3);
    EXPECT_TRUE(says(table.out, "  " + change + "  /interpolation: periodic-cubic")) << table.out;
    expect_rejected(run("methods --case case.json --kernel guide"), "ravnoves-cli: ");
    other["input"]["crank_radius_mm"] = -1;
    write("other.json", other.dump());
    expect_rejected(run("methods --case other.json"),
                    "other.json: /input/crank_radius_mm: must be");
}

}  // namespace
}  // namespace ravnoves
