/// A kernel's table as page and command line show it.

#include "methods/report.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "csv_lines.h"
#include "methods/plain_text.h"
#include "support.h"

namespace ravnoves::methods {
namespace {

constexpr MeasureOptions quick{
    .batch_seconds = 1e-9, .batches = 3, .max_seconds = 1e-9, .sweep_points = 5};

TEST(MethodsReport, HasARowForEveryMethodAndSetting) {
    const Kernel& kernel = *find_kernel("cycle-mean");
    const KernelReport report = measure_kernel(kernel, quick);
    std::size_t settings = 0;
    for (const MethodInfo& method : kernel.methods) {
        settings += method.settings.size();
    }
    ASSERT_EQ(report.rows.size(), settings);
    EXPECT_EQ(std::count_if(report.rows.begin(), report.rows.end(),
                            [](const MethodRow& row) { return row.in_use; }),
              1);
    std::size_t with_limit = 0;
    for (const MethodRow& row : report.rows) {
        // Counting the end twice holds nowhere.
        const bool is_papers = report.method(row).id == "nodes-end-twice";
        EXPECT_FALSE(is_papers && row.holds);
        EXPECT_TRUE(!is_papers || row.fails.empty() ||
                    row.fails.front().where.english() == "everywhere");
        EXPECT_EQ(row.holds, !row.result.rejected() && row.result.error <= kernel.choice.tolerance);
        EXPECT_GT(row.timing.median, 0.0);
        EXPECT_LE(row.timing.low, row.timing.median);
        EXPECT_LE(row.timing.median, row.timing.high);
        with_limit += row.fails.empty() ? 0 : 1;
        if (row.in_use) {
            EXPECT_TRUE(row.holds);
            ASSERT_EQ(row.fails.size(), kernel.sweeps.size());
            EXPECT_EQ(failing_summary(kernel, row).english(), "nowhere");
        }
    }
    EXPECT_EQ(with_limit, kernel.methods.size());
}

/// A method that the first hard parameter does not trouble may fail along another: every one is
/// looked along, and the row names it.
TEST(MethodsReport, TellsWhereMethodsFailAlongEveryHardParameter) {
    const Kernel& kernel = *find_kernel("guide");
    const KernelReport report = measure_kernel(kernel, quick);
    const std::string text = write_text(report);
    bool only_along_another = false;
    for (const MethodRow& row : report.rows) {
        if (row.fails.empty()) {
            continue;
        }
        ASSERT_EQ(row.fails.size(), kernel.sweeps.size());
        const std::string summary = failing_summary(kernel, row).english();
        for (std::size_t sweep = 0; sweep < kernel.sweeps.size(); ++sweep) {
            const Failing& failing = row.fails[sweep];
            EXPECT_EQ(failing.sweep, sweep);
            const bool fails = failing.where.english() != "nowhere";
            EXPECT_EQ(fails && summary != "everywhere",
                      says(summary, std::string(kernel.sweeps[sweep].title.english) + ": "))
                << summary;
            only_along_another |= fails && row.fails.front().where.english() == "nowhere";
        }
        const std::string by_id = failing_summary(kernel, row, SweepName::id).english();
        EXPECT_TRUE(says(text, by_id.substr(0, by_id.find(' ')))) << by_id;
    }
    EXPECT_TRUE(only_along_another);  // the closed form, at speeds that no spring here allows
}

TEST(MethodsReport, TextAndCsvHoldTheSameRows) {
    const KernelReport report = measure_kernel(*find_kernel("moment-range"), quick);
    const std::string text = write_text(report);
    EXPECT_TRUE(says(text, report.kernel->title.english));
    // Wrapped, so the words are compared without the line feeds between them.
    std::string one_line = text;
    std::replace(one_line.begin(), one_line.end(), '\n', ' ');
    EXPECT_TRUE(says(one_line, choice_paragraph(*report.kernel))) << text;
    const std::vector<KernelReport> reports{report, report};
    const auto lines = test::csv_lines(write_csv(reports));
    ASSERT_EQ(lines.size(), 2 * report.rows.size() + 1);
    const auto column = [&](const char* name) {
        const auto& header = lines.front();
        return static_cast<std::size_t>(std::find(header.begin(), header.end(), name) -
                                        header.begin());
    };
    for (std::size_t i = 0; i < report.rows.size(); ++i) {
        const MethodRow& row = report.rows[i];
        const auto& fields = lines[i + 1];
        ASSERT_EQ(fields.size(), lines.front().size());
        EXPECT_TRUE(says(text, report.method(row).title.english)) << row.method;
        EXPECT_EQ(fields[column("kernel")], "moment-range");
        EXPECT_EQ(fields[column("setting")], report.setting(row).english());
        EXPECT_EQ(std::stod(fields[column("median_ns")]), row.timing.median);
        EXPECT_EQ(fields[column("error")].empty(), row.result.rejected());
        EXPECT_EQ(fields[column("in_use")], row.in_use ? "yes" : "no");
        EXPECT_EQ(fields[column("limits")], report.method(row).limits.english);
    }
}

TEST(MethodsReport, ProgressRunsOnceFromEndToEndAndCancels) {
    double last = 0.0;
    const auto watch = [&](double part) {
        EXPECT_GE(part, last);
        EXPECT_LE(part, 1.0);
        last = part;
        return true;
    };
    static_cast<void>(measure_kernel(*find_kernel("slider-crank"), quick, watch));
    EXPECT_EQ(last, 1.0);
    for (const double limit : {0.1, 0.6}) {  // of the times, of a map
        EXPECT_THROW(static_cast<void>(measure_kernel(*find_kernel("slider-crank"), quick,
                                                      [&](double part) {
                                                          last = part;
                                                          return part < limit;
                                                      })),
                     Cancelled);
        EXPECT_LT(last, limit + 0.2);
    }
}

TEST(PlainText, CsvQuotesWhatWouldSplit) {
    EXPECT_EQ(csv_line({"a", "", "b c"}), "a,,b c\n");
    EXPECT_EQ(csv_line({"a,b", "say \"x\"", "two\nlines"}),
              "\"a,b\",\"say \"\"x\"\"\",\"two\nlines\"\n");
    const auto back = test::csv_lines(csv_line({"a,b", "say \"x\"", "two\nlines"}));
    EXPECT_EQ(back.front(), (std::vector<std::string>{"a,b", "say \"x\"", "two\nlines"}));
}

TEST(PlainText, WidthCountsCharactersNotBytes) {
    EXPECT_EQ(shown_width("N·m"), 3U);
    EXPECT_EQ(shown_width("φ = 3°20′"), 9U);
    EXPECT_EQ(shown_width("z\xCC\x84"), 1U);  // z with a bar over it
}

TEST(PlainText, AlignsAndWrapsTheLastColumn) {
    AlignedTable table({{"λ"}, {"ns", true}, {"why"}});
    table.add({"a", "5", "one two three four five six seven"});
    table.add({"bb", "100", "short"});
    EXPECT_EQ(table.text(29),
              "λ    ns  why\n"
              "─────────────────────────────\n"
              "a     5  one two three four\n"
              "         five six seven\n"
              "bb  100  short\n");
    EXPECT_THROW(table.add({"too few"}), std::logic_error);
}

}  // namespace
}  // namespace ravnoves::methods
