/// The report on every number printed in the papers: verdicts are decided, not typed.

#include "methods/validation/validation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

#include "bibliography/bibliography.h"
#include "csv_lines.h"
#include "methods/plain_text.h"
#include "methods/validation/rows.h"
#include "support.h"

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
    const auto of = [](const char* scene) {
        return std::count_if(report().rows.begin(), report().rows.end(),
                             [&](const ValidationRow& row) { return row.scene == scene; });
    };
    // Tables 3, 2 (both columns) and 1, means, text.
    EXPECT_GE(of("balance-shaft"), 300 + 2 * 49 + 7 + 12 + 15);
    EXPECT_GE(of("elastic-hinge"), 17 + 10 + 14);
    EXPECT_GE(of("v8-plugs"), 2 * (19 + 7) + 4 + 20 + 4);
    EXPECT_GE(of("inertia-moments"), 16 + 8 + 5 + 4 + 8);
}

/// What a verdict claims holds in the row's own numbers.
TEST(Validation, EveryVerdictIsShownByItsNumbers) {
    for (const ValidationRow& row : report().rows) {
        const std::string what = row.scene + ", " + row.quantity.english();
        EXPECT_EQ(row.printed, read_printed(row.printed_text).value) << what;
        const bool agrees = row.ours && std::abs(*row.ours - row.printed) <= 1.001 * row.tolerance;
        if (row.verdict == Verdict::given) {
            EXPECT_TRUE(agrees || !row.ours) << what;
        } else if (row.verdict != Verdict::not_derivable) {  // there ours may agree by chance
            EXPECT_EQ(row.verdict == Verdict::reproduced, agrees) << what;
        }
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

/// Groups of rows with one verdict. What the program was told, or what only inverts another row,
/// is given: it tests nothing.
TEST(Validation, EveryGroupHasItsVerdict) {
    const struct {
        const char *scene, *quantity;
        std::size_t count;
        Verdict verdict;
        const char* engine = "";  ///< in the quantity, too
    } groups[] = {
        {"balance-shaft", "Mᵢ(φ", 49, Verdict::given},
        {"balance-shaft", "Mᵤₚ(φ", 49, Verdict::given},
        {"balance-shaft", "piston mₚ,", 1, Verdict::given},
        {"balance-shaft", "piston pin", 1, Verdict::given},
        {"balance-shaft", "piston rings", 1, Verdict::given},
        {"balance-shaft", "rod's part", 1, Verdict::given},
        {"balance-shaft", "connecting rod mₛₕ", 2, Verdict::given},
        {"balance-shaft", "Mₛ(", 25 * 11, Verdict::reproduced},
        // So is the cut of the mean moment in the abstract.
        {"balance-shaft", "cut of the mean moment", 2, Verdict::artefact},
        // The last column is not what it is headed: M_up would be another at nearly every angle.
        {"balance-shaft", "last column", 25, Verdict::slip},
        {"balance-shaft", "angular speed", 1, Verdict::slip},
        // The two ends of an advised range are judged by one standard, whichever of them agrees.
        {"balance-shaft", "rational α", 2, Verdict::not_derivable},
        {"balance-shaft", "advised α", 2, Verdict::not_derivable},
        {"balance-shaft", "maximum α advised", 1, Verdict::not_derivable},
        {"elastic-hinge", "∮", 8, Verdict::reproduced},
        {"elastic-hinge", "factor of M₁₂", 2, Verdict::slip},
        {"elastic-hinge", "ρ₀", 1, Verdict::slip},
        {"v8-plugs", "k_ш", 2, Verdict::given},
        {"v8-plugs", "Δm_pm", 2, Verdict::given},
        {"v8-plugs", "Δm_am", 2, Verdict::given},
        {"v8-plugs", "maximum shift Δr, to", 1, Verdict::given},
        {"v8-plugs", "maximum Δk", 2, Verdict::reproduced},
        {"v8-plugs", "k_p", 4, Verdict::reproduced},
        {"v8-plugs", "k_y", 4, Verdict::reproduced},
        {"v8-plugs", "slope", 2, Verdict::reproduced},
        // m_p of the 4.25 l engine was found from (12), so (13) alone is a test.
        {"v8-plugs", "Δm_yra (12)", 1, Verdict::given, "4.25 l"},
        {"v8-plugs", "Δm_yra (12)", 1, Verdict::reproduced, "6 and 7 l"},
        {"v8-plugs", "Δm_yhr (13)", 2, Verdict::reproduced},
        {"v8-plugs", "Δm_yna (14)", 2, Verdict::reproduced},
        {"v8-plugs", "Δm_yk", 8, Verdict::reproduced},
        {"inertia-moments", "offset e", 1, Verdict::given},
        {"inertia-moments", "relative offset K", 1, Verdict::reproduced},
        {"inertia-moments", "ΣM", 16, Verdict::reproduced},
    };
    for (const auto& [scene, quantity, count, verdict, engine] : groups) {
        std::size_t found = 0;
        for (const ValidationRow& row : rows_of(scene, quantity)) {
            if (says(row.quantity.english(), engine)) {
                ++found;
                EXPECT_EQ(row.verdict, verdict) << row.quantity.english();
            }
        }
        EXPECT_EQ(found, count) << scene << ", " << quantity;
    }
    // One lost sign among the rotating masses; it is found because all else is reproduced.
    EXPECT_EQ(report().count(Verdict::slip, "inertia-moments"), 1U);
    EXPECT_EQ(report().count(Verdict::artefact, "inertia-moments"), 0U);
}

TEST(Validation, OurNumbersBesideWhatIsWrongInPrintAreRight) {
    const auto only = [](const char* scene, const char* quantity) {
        return *rows_of(scene, quantity).at(0).ours;
    };
    // The means of Table 3 are of counting the end twice, but for those that are 0 anyway.
    const auto means = rows_of("balance-shaft", "mean Mₛₘ");
    ASSERT_EQ(means.size(), 11U);
    for (const ValidationRow& row : means) {
        EXPECT_EQ(row.verdict, row.printed == 0.0 ? Verdict::reproduced : Verdict::artefact);
        EXPECT_EQ(*row.ours, 0.0);
    }
    EXPECT_NEAR(only("balance-shaft", "cut of the mean moment"), 0.0, 1e-9);
    EXPECT_NEAR(only("balance-shaft", "speed of Table 2"), 2600.0, 30.0);
    for (const ValidationRow& row : rows_of("elastic-hinge", "factor of M₁₂")) {
        EXPECT_NEAR(*row.ours, 1.0, 1e-9) << row.place.english();  // by virtual power
    }
    EXPECT_NEAR(only("elastic-hinge", "ρ₀"), 0.1 - 0.60e-3, 5e-6);
    // A steel cup of that thread weighs six times what is printed.
    EXPECT_GT(only("v8-plugs", "mass m_p"), 20.0);
    for (const char* quantity : {"rational α", "advised α"}) {
        const auto ends = rows_of("balance-shaft", quantity);
        EXPECT_EQ(ends.at(0).reason, ends.at(1).reason);
        EXPECT_LT(*ends[0].ours, *ends[1].ours);
    }
}

TEST(Validation, DecidesByTheNumbersAlone) {
    constexpr double half = 0.05;
    const auto none = std::optional<double>{};
    EXPECT_EQ(decide(Verdict::reproduced, 1.2, half, 1.24, none), Verdict::reproduced);
    EXPECT_EQ(decide(Verdict::reproduced, 1.2, half, 1.25, none), Verdict::reproduced);
    EXPECT_EQ(decide(Verdict::reproduced, 1.2, half, 1.26, none), Verdict::differs);
    EXPECT_EQ(decide(Verdict::reproduced, 1.2, half, none, none), Verdict::differs);
    EXPECT_EQ(decide(Verdict::slip, 1.2, half, 2.0, 1.2), Verdict::slip);
    EXPECT_EQ(decide(Verdict::artefact, 1.2, half, 2.0, 1.2), Verdict::artefact);
    EXPECT_EQ(decide(Verdict::artefact, 1.2, half, none, 1.2), Verdict::artefact);
    // A mistake that does not give the printed number explains nothing…
    EXPECT_EQ(decide(Verdict::slip, 1.2, half, 2.0, 1.3), Verdict::differs);
    EXPECT_EQ(decide(Verdict::slip, 1.2, half, 2.0, none), Verdict::differs);
    // …and where the right number is printed there was none.
    EXPECT_EQ(decide(Verdict::slip, 1.2, half, 1.2, 1.2), Verdict::reproduced);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(decide(Verdict::reproduced, 1.2, half, nan, none), Verdict::differs);
    EXPECT_EQ(decide(Verdict::not_derivable, 1.2, half, nan, none), Verdict::differs);
    EXPECT_EQ(decide(Verdict::not_derivable, 1.2, half, none, none), Verdict::not_derivable);
    EXPECT_EQ(decide(Verdict::given, 1.2, half, none, none), Verdict::given);
    EXPECT_EQ(decide(Verdict::given, 1.2, half, 1.21, none), Verdict::given);
    EXPECT_EQ(decide(Verdict::given, 1.2, half, 1.3, none), Verdict::differs);
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
        EXPECT_THROW(static_cast<void>(read_printed(text)), std::logic_error) << text;
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
    // Beside next to nothing a share says nothing.
    row.unit = "N·m";
    row.printed = -0.01;
    row.last_digit = 0.01;
    row.ours = -798.0;
    EXPECT_EQ(row.difference_text(), "-797.99 N·m");
    row.ours = 0.05;
    EXPECT_EQ(row.difference_text(), "600 %");
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
