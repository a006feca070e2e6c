#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "case-file/message.h"

namespace ravnoves::methods {

/// What became of a printed number.
enum class Verdict {
    reproduced,     ///< ours equals it to the printed digits, or within a wider rule that is stated
    artefact,       ///< the way it was computed makes it: that way gives it, the right way does not
    slip,           ///< a mistake in print: the mistake gives the printed number, ours is another
    not_derivable,  ///< the paper does not print what a computation needs
    given,          ///< an input that the paper states, or a row that only inverts another
    differs,        ///< none of these applies; there should be none
};

/// All verdicts in the order of their counts.
inline constexpr Verdict all_verdicts[] = {Verdict::reproduced, Verdict::artefact,
                                           Verdict::slip,       Verdict::not_derivable,
                                           Verdict::given,      Verdict::differs};

std::string_view verdict_id(Verdict verdict);  ///< "not-derivable", for files
Text verdict_title(Verdict verdict);           ///< "not derivable", for people

/// A paper that a scene rests on.
struct Paper {
    std::string_view scene;  ///< of the case files, "balance-shaft"
    Text authors;            ///< "Gots, Klevtsov"
    Message citation;        ///< authors, title, year
};

/// The four papers in the order of the scenes.
std::span<const Paper> papers();

/// One printed number.
struct ValidationRow {
    std::string scene;         ///< the paper, by its scene: Paper::scene
    Message place;             ///< "Table 3", "eq. (8)", "text", …
    Message quantity;          ///< its name
    std::string unit;          ///< "N·m", "°", "" for pure numbers
    std::string printed_text;  ///< as printed, with a decimal point: "430.39", "3°20′", "-0.01"
    double printed = 0.0;      ///< its value
    double last_digit = 1.0;   ///< one unit of its last digit: 0.01, or 1/60 for minutes
    /// How far ours may be off to count as reproduced: half of last_digit unless the reason says
    /// why it is more.
    double tolerance = 0.5;
    /// Computed from the presets; empty where nothing of ours represents it. In the unit above.
    std::optional<double> ours;
    /// The number that the mistake or the way of computing gives, for slip and artefact.
    std::optional<double> by_slip;
    Verdict verdict = Verdict::differs;
    Message reason;  ///< one sentence: why

    /// (ours − printed) / |printed|; empty without ours or where 0 is printed.
    std::optional<double> relative_difference() const;
    /// Ours with one digit more than the paper prints ("430.384", "3°20.3′"); "—" without.
    std::string ours_text() const;
    /// "0.01 %", "1.3e-05 %"; beyond a factor of ten in the row's unit, "+798.0 N·m"; empty without
    /// one.
    std::string difference_text() const;
};

/// Every quantity printed in the four papers beside ours: results, and the inputs that they state.
/// Not among them are the constants within formulas, the ticks of figures' axes, and a number that
/// the same passage repeats.
struct ValidationReport {
    std::vector<ValidationRow> rows;  ///< by paper, in the order of the print

    /// @param scene  of one paper; empty: of all
    std::size_t count(Verdict verdict, std::string_view scene = {}) const;
    /// "430 printed numbers: 370 reproduced, …": one line, without a full stop.
    std::string summary() const;
};

/// Computes the report from the scenes' presets: some milliseconds. Nothing is typed in but the
/// printed values and the words; each verdict is decided here.
ValidationReport validate();

/// The report as aligned text (UTF-8): counts, then for each paper its table and, below it, the
/// reasons that the table refers to by number.
/// @param width  that the reasons are wrapped to, in characters; the tables stay within 120
std::string write_text(const ValidationReport& report, std::size_t width = 120);
/// As CSV with a header: scene, place, quantity, unit, printed, ours, relative_difference, verdict,
/// reason. Decimal point, full precision.
std::string write_csv(const ValidationReport& report);

}  // namespace ravnoves::methods
