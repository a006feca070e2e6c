#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "case-file/message.h"
#include "case-file/result_visitor.h"

namespace ravnoves {

/// Severity of the verdict.
enum class Severity { good, note, warning, error };

constexpr std::string_view severity_word(Severity severity) {
    constexpr std::array<std::string_view, 4> words{"good", "note", "warning", "error"};
    return words[static_cast<std::size_t>(severity)];
}

/// The first thing that a page, a report, a card or a result says: what the answer is worth.
struct Verdict {
    Severity severity = Severity::good;
    Message text;
    /// The remedy, by its name on the scene's page; empty without one.
    std::string_view act{};

    /// Adds a warning to the verdict; an empty one adds nothing.
    void warn(const Message& warning) {
        if (!warning.empty()) {
            text = text.empty() ? warning : Message(Text{"%1 %2"}, text, warning);
            severity = std::max(severity, Severity::warning);
        }
    }
};

namespace result_field {
inline constexpr ResultField verdict{"verdict", Text::tr("Verdict")};
inline constexpr ResultField severity{"severity", Text::tr("Severity")};
inline constexpr ResultField text{"text"};
inline constexpr ResultField reason{"reason", Text::tr("Reason")};
inline constexpr ResultField note{"note", Text::tr("Note")};
inline constexpr ResultField notes{"notes", Text::tr("Notes")};
inline constexpr ResultField feasible{"feasible", Text::tr("Feasible")};
}  // namespace result_field

/// As in every result; computed where it is wanted.
template <typename Compute>
void visit_verdict(ResultVisitor& visitor, const Compute& compute) {
    visitor.object(result_field::verdict, [&] {
        const Verdict verdict = compute();
        visitor.word(result_field::severity, severity_word(verdict.severity));
        visitor.text(result_field::text, verdict.text);
    });
}

}  // namespace ravnoves
