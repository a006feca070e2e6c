/// The report on every number printed in the papers: verdicts are decided, not typed.

#include "methods/validation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

#include "csv_lines.h"
#include "methods/plain_text.h"
#include "methods/validation/rows.h"

namespace ravnoves::methods {
namespace {

const ValidationReport& report() {
    static const ValidationReport once = validate();
    return once;
}

/// The rows of a paper whose quantity begins so.
std::vector<ValidationRow> rows_of(const char* scene, const std::string& quantity) {
    std::vector<ValidationRow> found;
    for (const ValidationRow& row : report().rows) {
        if (row.scene == scene && row.quantity.english().starts_with(quantity)) {
            found.push_back(row);
        }
    }
    return found;
}

TEST(Validation, NoPrintedNumberIsWithoutAnExplanation) {
    for (const ValidationRow& row : report().rows) {
        EXPECT_NE(row.verdict, Verdict::differs)
            << row.scene << ", " << row.place.english() << ", " << row.quantity.english()
            << ": printed " << row.printed_text << ", ours " << row.ours_text() << ", by slip "
            << row.by_slip.value_or(std::nan(""));
    }
    EXPECT_EQ(report().count(Verdict::differs), 0U);
}

TEST(Validation, CoversThePapers) {
    std::size_t sum = 0;
    for (const Verdict verdict : all_verdicts) {
        sum += report().count(verdict);
    }
    EXPECT_EQ(sum, report().rows.size());
    const auto of = [](const char* scene) {
        return std::count_if(report().rows.begin(), report().rows.end(),
                             [&](const ValidationRow& row) { return row.scene == scene; });
    };
    EXPECT_GE(of("balance-shaft"), 300 + 49 + 12 + 15);  // Tables 3 and 2, means, text
    EXPECT_GE(of("elastic-hinge"), 17);
    EXPECT_GE(of("v8-plugs"), 2 * 19 + 4);
    EXPECT_GE(of("inertia-moments"), 16 + 8 + 5 + 4);
    EXPECT_GE(report().count(Verdict::reproduced), 380U);
    EXPECT_GE(report().count(Verdict::artefact), 15U);
    EXPECT_GE(report().count(Verdict::slip), 25U);
    EXPECT_GE(report().count(Verdict::not_derivable), 8U);
}

/// What a verdict claims holds in the row's own numbers.
TEST(Validation, EveryVerdictIsShownByItsNumbers) {
    for (const ValidationRow& row : report().rows) {
        const std::string what = row.scene + ", " + row.quantity.english();
        EXPECT_EQ(row.printed, read_printed(row.printed_text).value) << what;
        const bool agrees = row.ours && std::abs(*row.ours - row.printed) <= 1.001 * row.tolerance;
        EXPECT_EQ(row.verdict == Verdict::reproduced, agrees) << what;
        if (row.verdict == Verdict::slip || row.verdict == Verdict::artefact) {
            EXPECT_TRUE(row.by_slip || row.ours) << what;
            if (row.by_slip) {
                EXPECT_NEAR(*row.by_slip, row.printed, 1.001 * row.tolerance) << what;
            }
        }
        for (const auto& value : {row.ours, row.by_slip, row.relative_difference()}) {
            EXPECT_TRUE(!value || std::isfinite(*value)) << what;
        }
        // A wider rule than half a digit is never silent.
        if (row.verdict == Verdict::reproduced && row.tolerance > 0.51 * row.last_digit) {
            EXPECT_TRUE(row.reason.english().starts_with("To "))
                << what << ": " << row.reason.english();
        }
    }
}

TEST(Validation, EveryRowSaysWhatWhereAndWhy) {
    std::set<std::string> seen;
    for (const ValidationRow& row : report().rows) {
        EXPECT_FALSE(row.place.empty()) << row.quantity.english();
        EXPECT_FALSE(row.quantity.empty()) << row.place.english();
        EXPECT_FALSE(row.reason.empty()) << row.quantity.english();
        EXPECT_EQ(row.reason.english().back(), '.') << row.reason.english();
        EXPECT_TRUE(seen.insert(row.scene + row.place.english() + row.quantity.english()).second)
            << row.place.english() << ", " << row.quantity.english() << " stands there twice";
        EXPECT_TRUE(std::any_of(papers().begin(), papers().end(),
                                [&](const Paper& paper) { return paper.scene == row.scene; }));
    }
}

TEST(Validation, GotsAndKlevtsov) {
    EXPECT_EQ(rows_of("balance-shaft", "M_s(").size(), 25U * 11U);
    for (const ValidationRow& row : rows_of("balance-shaft", "M_s(")) {
        EXPECT_EQ(row.verdict, Verdict::reproduced) << row.quantity.english();
    }
    // The means of Table 3 are of counting the end twice, but for those that are 0 anyway.
    const auto means = rows_of("balance-shaft", "mean M_sm");
    ASSERT_EQ(means.size(), 11U);
    for (const ValidationRow& row : means) {
        EXPECT_EQ(row.verdict, row.printed == 0.0 ? Verdict::reproduced : Verdict::artefact);
        EXPECT_EQ(*row.ours, 0.0);
    }
    // So is the cut of the mean moment in the abstract.
    for (const ValidationRow& row : rows_of("balance-shaft", "cut of the mean moment")) {
        EXPECT_EQ(row.verdict, Verdict::artefact);
        EXPECT_NEAR(*row.ours, 0.0, 1e-9);
    }
    // The last column is not what it is headed: M_up would be another at nearly every angle.
    const auto column = rows_of("balance-shaft", "last column");
    ASSERT_EQ(column.size(), 25U);
    EXPECT_EQ(std::count_if(column.begin(), column.end(),
                            [](const auto& row) { return row.verdict == Verdict::slip; }),
              25);
    EXPECT_EQ(rows_of("balance-shaft", "angular speed").front().verdict, Verdict::slip);
    EXPECT_NEAR(*rows_of("balance-shaft", "speed of Table 2").front().ours, 2600.0, 30.0);
}

TEST(Validation, ZotovAndSviridov) {
    for (const ValidationRow& row : rows_of("elastic-hinge", "∮")) {
        EXPECT_EQ(row.verdict, Verdict::reproduced) << row.place.english();
    }
    const auto factors = rows_of("elastic-hinge", "factor of M₁₂");
    ASSERT_EQ(factors.size(), 2U);
    for (const ValidationRow& row : factors) {
        EXPECT_EQ(row.verdict, Verdict::slip) << row.place.english();
        EXPECT_NEAR(*row.ours, 1.0, 1e-9) << row.place.english();  // by virtual power
    }
    const auto preload = rows_of("elastic-hinge", "ρ₀");
    ASSERT_EQ(preload.size(), 1U);
    EXPECT_EQ(preload.front().verdict, Verdict::slip);
    EXPECT_NEAR(*preload.front().ours, 0.1 - 0.60e-3, 5e-6);
}

TEST(Validation, Nazarov) {
    for (const char* quantity : {"k_", "Δm_y", "slope"}) {
        for (const ValidationRow& row : rows_of("v8-plugs", quantity)) {
            EXPECT_EQ(row.verdict, Verdict::reproduced) << row.quantity.english();
        }
    }
    // A steel cup of that thread weighs six times what is printed.
    EXPECT_GT(*rows_of("v8-plugs", "mass m_p").front().ours, 20.0);
}

TEST(Validation, ChainovAndVallejoMaldonado) {
    int coefficients = 0;
    for (const ValidationRow& row : rows_of("inertia-moments", "ΣM")) {
        EXPECT_EQ(row.verdict, Verdict::reproduced) << row.quantity.english();
        ++coefficients;
    }
    EXPECT_EQ(coefficients, 16);
    // One lost sign among the rotating masses; it is found because all else is reproduced.
    EXPECT_EQ(report().count(Verdict::slip, "inertia-moments"), 1U);
    EXPECT_EQ(report().count(Verdict::artefact, "inertia-moments"), 0U);
}

TEST(Validation, DecidesByTheNumbersAlone) {
    constexpr double half = 0.05;
    const auto none = std::optional<double>{};
    EXPECT_EQ(decide(Claim::reproduced, 1.2, half, 1.24, none), Verdict::reproduced);
    EXPECT_EQ(decide(Claim::reproduced, 1.2, half, 1.25, none), Verdict::reproduced);
    EXPECT_EQ(decide(Claim::reproduced, 1.2, half, 1.26, none), Verdict::differs);
    EXPECT_EQ(decide(Claim::reproduced, 1.2, half, none, none), Verdict::differs);
    EXPECT_EQ(decide(Claim::slip, 1.2, half, 2.0, 1.2), Verdict::slip);
    EXPECT_EQ(decide(Claim::artefact, 1.2, half, 2.0, 1.2), Verdict::artefact);
    EXPECT_EQ(decide(Claim::artefact, 1.2, half, none, 1.2), Verdict::artefact);
    // A mistake that does not give the printed number explains nothing…
    EXPECT_EQ(decide(Claim::slip, 1.2, half, 2.0, 1.3), Verdict::differs);
    EXPECT_EQ(decide(Claim::slip, 1.2, half, 2.0, none), Verdict::differs);
    // …and where the right number is printed there was none.
    EXPECT_EQ(decide(Claim::slip, 1.2, half, 1.2, 1.2), Verdict::reproduced);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(decide(Claim::reproduced, 1.2, half, nan, none), Verdict::differs);
    EXPECT_EQ(decide(Claim::not_derivable, 1.2, half, nan, none), Verdict::differs);
    EXPECT_EQ(decide(Claim::not_derivable, 1.2, half, none, none), Verdict::not_derivable);
}

TEST(Validation, ReadsNumbersAsPrinted) {
    EXPECT_DOUBLE_EQ(read_printed("430.39").value, 430.39);
    EXPECT_DOUBLE_EQ(read_printed("430.39").last_digit, 0.01);
    EXPECT_DOUBLE_EQ(read_printed("-0.0738").last_digit, 1e-4);
    EXPECT_DOUBLE_EQ(read_printed("3600").last_digit, 1.0);
    EXPECT_DOUBLE_EQ(read_printed("3°20′").value, 3.0 + 20.0 / 60.0);
    EXPECT_DOUBLE_EQ(read_printed("3°20′").last_digit, 1.0 / 60.0);
    EXPECT_DOUBLE_EQ(read_printed("-75°43′").value, -75.0 - 43.0 / 60.0);
    for (const char* text : {"", "1,5", "3°20", "about 3", "1.5 N"}) {
        EXPECT_THROW(static_cast<void>(read_printed(text)), std::invalid_argument) << text;
    }
}

TEST(Validation, ShowsOursWithOneDigitMoreThanThePaper) {
    ValidationRow row;
    row.printed_text = "430.39";
    row.printed = 430.39;
    row.last_digit = 0.01;
    EXPECT_EQ(row.ours_text(), "—");
    EXPECT_EQ(row.difference_text(), "");
    row.ours = 430.38434;
    EXPECT_EQ(row.ours_text(), "430.384");
    EXPECT_EQ(row.difference_text(), "-0.0013 %");
    row.ours = -1e-9;
    EXPECT_EQ(row.ours_text(), "0.000");
    row.printed_text = "3°20′";
    row.printed = 3.0 + 1.0 / 3.0;
    row.last_digit = 1.0 / 60.0;
    row.ours = 3.33863;
    EXPECT_EQ(row.ours_text(), "3°20.3′");
    row.ours = -3.99999;
    EXPECT_EQ(row.ours_text(), "-4°0.0′");
    row.printed = 0.0;
    EXPECT_FALSE(row.relative_difference());
}

TEST(Validation, TheTextBeginsWithTheCountsAndFitsItsWidth) {
    const std::string text = write_text(report(), 120);
    EXPECT_TRUE(text.starts_with(report().summary() + "\n")) << text.substr(0, 200);
    EXPECT_NE(report().summary().find(std::to_string(report().rows.size()) + " printed numbers"),
              std::string::npos);
    EXPECT_EQ(report().summary().find("differs"), std::string::npos);
    for (const Paper& paper : papers()) {
        EXPECT_NE(text.find(paper.citation.english()), std::string::npos);
    }
    std::size_t begin = 0;
    while (begin < text.size()) {
        const std::size_t end = text.find('\n', begin);
        const std::string line = text.substr(begin, end - begin);
        const bool is_citation = std::any_of(papers().begin(), papers().end(), [&](const auto& p) {
            return p.citation.english() == line;
        });
        EXPECT_TRUE(is_citation || shown_width(line) <= 120) << line;
        begin = end + 1;
    }
}

TEST(Validation, TheCsvReadsBack) {
    const auto lines = test::csv_lines(write_csv(report()));
    ASSERT_EQ(lines.size(), report().rows.size() + 1);
    for (std::size_t i = 0; i < report().rows.size(); ++i) {
        const ValidationRow& row = report().rows[i];
        const auto& fields = lines[i + 1];
        ASSERT_EQ(fields.size(), lines.front().size());
        EXPECT_EQ(fields[0], row.scene);
        EXPECT_EQ(fields[2], row.quantity.english());
        EXPECT_EQ(std::stod(fields[4]), row.printed);
        EXPECT_EQ(fields[5].empty(), !row.ours);
        if (row.ours) {
            EXPECT_EQ(std::stod(fields[5]), *row.ours);
        }
        EXPECT_EQ(fields[7], verdict_id(row.verdict));
        EXPECT_EQ(fields[8], row.reason.english());
    }
}

}  // namespace
}  // namespace ravnoves::methods
