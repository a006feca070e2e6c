#pragma once

#include <QString>
#include <string_view>
#include <vector>

#include "methods/kernel.h"

namespace ravnoves {

/// A text of core's methods in the user's language: titles, settings, reasons, refusals. Numbers
/// within it get the locale's decimal sign. A text without translation stays as core has it.
QString methodText(std::string_view english);
/// Whether the translators have been given this text (numbers apart), so that a test can tell what
/// was forgotten.
bool isKnownMethodText(std::string_view english);

/// A hard parameter's name with its unit: "shaft angle α, °".
QString sweepTitle(const methods::SweepInfo& sweep);
/// A value on a hard parameter's scale; close to a limit with the digits that tell it from it.
QString sweepNumber(const methods::SweepInfo& sweep, double value);
/// Along which stretches of its sweep a method exceeds the tolerance, as methods::failing_text().
QString failingText(const methods::SweepInfo& sweep, std::string_view english);

QString timeText(double nanoseconds);  ///< "12.3 ns", "1.2 ms"
QString errorNumber(double error);     ///< "3.2·10⁻⁹"
/// The error, or "refused".
QString resultText(const methods::Result& result);

}  // namespace ravnoves
