#pragma once

#include <optional>

#include "workshop/model/words.h"

namespace ravnoves {

/// The machine's verdict, as the journal keeps it: "passes" or "fails" as measured; where it fails
/// and a correction is known, "fails-then-passes" or "fails-then-fails"; empty without limits.
QString verdictWord(const std::optional<bool>& measured, const std::optional<bool>& corrected);

/// The verdict of readings that were taken with another bob weight: none.
extern const QString otherBobWeight;
/// What is to be done about them.
QString otherBobWeightText(const Words& words, double then, double now);

/// The same as page, card and journal say it: "fails → passes" is measured → after correction.
QString verdictText(const Words& words, const QString& verdict);

}  // namespace ravnoves
