#pragma once

#include <QString>
#include <optional>

namespace ravnoves {

/// A number as a table shows it, with what stands behind it.
struct ShownNumber {
    double value = 0.0;
    int decimals = 0;
    bool isPlain = true;  ///< without an exponent
    QString unit;         ///< "%" and the like, where it stands behind the number
};

/// Reads a cell; nothing where it is no number: "0.6580", "−10.4 %", "63.86°", "1.2E-5".
std::optional<ShownNumber> readShownNumber(const QString& text);

/// How a shown number differs from a reference, in its own decimals.
struct ShownDifference {
    QString absolute;  ///< with its sign
    QString percent;   ///< of the reference; empty where it says nothing: of percents, of angles
};

/// @param isAngle  both are degrees: the way round that is shorter
std::optional<ShownDifference> difference(const QString& present, const QString& reference,
                                          bool isAngle = false);

/// A difference with a sign, "0" for none.
QString signedNumber(double value, int decimals);
QString signedPercent(double value, double reference);

}  // namespace ravnoves
