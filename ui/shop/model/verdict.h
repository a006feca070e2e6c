#pragma once

#include <QStringList>
#include <optional>

#include "shop/model/words.h"

namespace ravnoves {

/// The machine's verdict, as the journal keeps it: "passes" or "fails" as measured; where it fails
/// and a correction is known, "fails-then-passes" or "fails-then-fails", or "fails-without-hole"
/// where nothing is planned; empty without limits.
QString verdictWord(const std::optional<bool>& measured, const std::optional<bool>& corrected,
                    bool isPlanned = true);

/// The verdicts of readings that were taken with another bob weight, or of another crankshaft:
/// none.
inline const QString otherBobWeight = QStringLiteral("other-bob-weight");
inline const QString otherCrankshaft = QStringLiteral("other-crankshaft");
/// The verdict where a doubt blocks any.
inline const QString stopped = QStringLiteral("stopped");
/// Passes as measured, beside a warning.
inline const QString passesWithWarnings = QStringLiteral("passes-with-warnings");
/// No verdict on the crankshaft.
inline bool isWithheld(const QString& verdict) {
    return verdict == otherBobWeight || verdict == otherCrankshaft || verdict == stopped;
}
/// The word of a run or the sheet: its state (`read_on` and `read_with`), else its verdict.
template <typename Read>
QString readWord(const Read& read, const std::optional<bool>& measured,
                 const std::optional<bool>& corrected = {}, bool isPlanned = true) {
    return read.read_on     ? otherCrankshaft
           : read.read_with ? otherBobWeight
                            : verdictWord(measured, corrected, isPlanned);
}
/// What a verdict says of the crankshaft.
enum class VerdictKind {
    None,
    Pass,
    Fail,
    Open  ///< to be drilled or measured again
};
VerdictKind verdictKind(const QString& verdict);

/// A verdict's word as page, card and journal say it: "fails → passes" is measured → after
/// correction.
QString verdictText(const Words& words, const QString& verdict);

}  // namespace ravnoves
