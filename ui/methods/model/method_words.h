#pragma once

#include <QString>

#include "case-file/message.h"
#include "methods/kernel.h"

namespace ravnoves {

/// A message of core's methods as messageText(), but with small and large numbers as powers of ten,
/// and with the numbers as text of no language ("0.1°", "1e-6") in the user's way.
QString methodText(const Message& message);

/// A hard parameter's name with its unit: "shaft angle α, °".
QString sweepTitle(const methods::SweepInfo& sweep);

QString timeText(double nanoseconds);  ///< "12.3 ns", "1.2 ms"
/// Three digits, and the rest zeros: "1 230 000"; a dash where there is no time.
QString nanosecondsText(double nanoseconds);
QString errorNumber(double error);  ///< "3.2·10⁻⁹"
/// The error, or "rejected".
QString resultText(const methods::Result& result);

}  // namespace ravnoves
