#include "methods/validation/validation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "bibliography/bibliography.h"
#include "case-file/decimal.h"
#include "case-file/field.h"
#include "methods/plain_text.h"
#include "methods/validation/rows.h"

namespace ravnoves::methods {

namespace {

Paper paper(std::string_view scene, std::string_view key) {
    const Source& entry = source(key);
    return {scene, entry.cited_as, citation(entry)};
}

/// In the order of the enumeration.
constexpr Word verdict_words[]{
    {"reproduced", Text::tr("reproduced")}, {"artefact", Text::tr("artefact")},
    {"slip", Text::tr("misprint")},         {"not-derivable", Text::tr("not derivable")},
    {"given", Text::tr("given")},           {"differs", Text::tr("differs")},
};

bool is_in_minutes(const ValidationRow& row) {
    return row.printed_text.find("′") != std::string::npos;
}

/// "3°20.3′"
std::string in_minutes(double angle) {
    const double size = std::abs(angle);
    double whole = std::floor(size);
    double minutes = std::round((size - whole) * 600.0) / 10.0;
    if (minutes >= 60.0) {
        whole += 1.0;
        minutes -= 60.0;
    }
    return (angle < 0.0 ? "-" : "") + fixed_decimals(whole, 0) + "°" + fixed_decimals(minutes, 1) +
           "′";
}

/// The place of a reason in the list, from 1; added where it is new.
std::size_t number_of(const std::string& reason, std::vector<std::string>& reasons) {
    const auto found = std::find(reasons.begin(), reasons.end(), reason);
    const auto place = static_cast<std::size_t>(found - reasons.begin());
    if (found == reasons.end()) {
        reasons.push_back(reason);
    }
    return place + 1;
}

}  // namespace

std::string_view verdict_id(Verdict verdict) {
    return verdict_words[static_cast<std::size_t>(verdict)].word;
}

Text verdict_title(Verdict verdict) {
    return verdict_words[static_cast<std::size_t>(verdict)].label;
}

std::span<const Paper> papers() {
    static const std::array all{
        paper("balance-shaft", "gots-klevtsov"), paper("elastic-hinge", "zotov-sviridov"),
        paper("v8-plugs", "nazarov"), paper("inertia-moments", "chainov-vallejo-maldonado")};
    return all;
}

std::optional<double> ValidationRow::relative_difference() const {
    if (!ours || printed == 0.0) {
        return std::nullopt;
    }
    return (*ours - printed) / std::abs(printed);
}

std::string ValidationRow::ours_text() const {
    if (!ours) {
        return "—";
    }
    if (is_in_minutes(*this)) {
        return in_minutes(*ours);
    }
    const int decimals = static_cast<int>(std::lround(-std::log10(last_digit)));
    return fixed_decimals(*ours, std::max(decimals, 0) + 1);
}

std::string ValidationRow::difference_text() const {
    const auto difference = relative_difference();
    if (!difference) {
        return "";
    }
    // Against a number beside nothing a share says nothing.
    constexpr double maximum = 10.0;
    if (std::abs(*difference) >= maximum) {
        const int decimals = static_cast<int>(std::lround(-std::log10(last_digit)));
        const std::string text = fixed_decimals(*ours - printed, std::max(decimals, 0));
        return (*ours > printed ? "+" : "") + text + (unit.empty() ? "" : " " + unit);
    }
    constexpr double rounding = 1e-12;
    const double percent = std::abs(*difference) < rounding ? 0.0 : 100.0 * *difference;
    return (std::abs(percent) >= 10.0 ? fixed_decimals(percent, 0) : format_number(percent, 2)) +
           " %";
}

std::size_t ValidationReport::count(Verdict verdict, std::string_view scene) const {
    return static_cast<std::size_t>(
        std::count_if(rows.begin(), rows.end(), [&](const ValidationRow& row) {
            return row.verdict == verdict && (scene.empty() || row.scene == scene);
        }));
}

std::string ValidationReport::summary() const {
    std::string text = std::to_string(rows.size()) + " printed numbers: ";
    bool first = true;
    for (const Verdict verdict : all_verdicts) {
        const std::size_t number = count(verdict);
        if (number == 0 && verdict == Verdict::differs) {
            continue;
        }
        text += (first ? "" : ", ") + std::to_string(number) + " ";
        text += verdict_title(verdict).english;
        first = false;
    }
    return text;
}

ValidationReport validate() {
    ValidationReport report;
    for (auto* const paper : {validate_gots_klevtsov, validate_zotov_sviridov, validate_nazarov,
                              validate_chainov_vallejo_maldonado}) {
        for (ValidationRow& row : paper()) {
            report.rows.push_back(std::move(row));
        }
    }
    return report;
}

std::string write_text(const ValidationReport& report, std::size_t width) {
    std::string text = report.summary() + "\n";
    for (const Paper& paper : papers()) {
        AlignedTable table({{"quantity"},
                            {"unit"},
                            {"printed", true},
                            {"ours", true},
                            {"difference", true},
                            {"verdict"},
                            {"why"}});
        std::vector<std::string> reasons;
        std::string place;
        for (const ValidationRow& row : report.rows) {
            if (row.scene != paper.scene) {
                continue;
            }
            if (row.place.english() != place) {
                place = row.place.english();
                table.heading(place);
            }
            const std::size_t note = number_of(row.reason.english(), reasons);
            table.add({"  " + row.quantity.english(), row.unit, row.printed_text, row.ours_text(),
                       row.difference_text(), verdict_title(row.verdict).english,
                       "[" + std::to_string(note) + "]"});
        }
        text += "\n" + paper.citation.english() + "\n\n" + table.text(width) + "\n";
        for (std::size_t i = 0; i < reasons.size(); ++i) {
            text += hanging("[" + std::to_string(i + 1) + "] ", reasons[i], width);
        }
    }
    return text;
}

std::string write_csv(const ValidationReport& report) {
    std::string text = csv_line({"scene", "place", "quantity", "unit", "printed", "ours",
                                 "relative_difference", "verdict", "reason"});
    for (const ValidationRow& row : report.rows) {
        const auto difference = row.relative_difference();
        text += csv_line({row.scene, row.place.english(), row.quantity.english(), row.unit,
                          format_number(row.printed), row.ours ? format_number(*row.ours) : "",
                          difference ? format_number(*difference) : "",
                          std::string(verdict_id(row.verdict)), row.reason.english()});
    }
    return text;
}

}  // namespace ravnoves::methods
