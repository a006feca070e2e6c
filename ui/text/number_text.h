#pragma once

#include <QLocale>
#include <QString>
#include <optional>
#include <string_view>

#include "case-file/range.h"

namespace ravnoves {

/// A number as forms show it: at most `significant` digits, no trailing zeros, the locale's decimal
/// sign, no thousands separators.
QString formNumber(double value, const QLocale& locale, int significant = 10);

/// The same without a power of ten, unless that were a row of zeros: "0.0000393701".
QString writtenOut(double value, const QLocale& locale, int significant = 10);

/// A number of forms to be read, not to be typed over: with a true minus.
QString shownFormNumber(double value, const QLocale& locale, int significant = 10);
/// The number with all its digits where the text has fewer; else empty.
QString wholeNumber(double value, const QString& text);
/// A number with true minus signs in place of hyphens.
QString trueMinus(QString number);

/// Reads what a person typed: decimal comma or point (core's parse_decimal). Nothing where it is no
/// number.
std::optional<double> readFormNumber(const QString& text);

/// The rule of a range in the user's language: "must be greater than 0 mm".
QString rangeText(const Range& range, const QString& unit);

/// A unit of core ("mm", "min⁻¹") as the language writes it.
QString unitText(std::string_view unit);
/// What belongs together does not come apart at the end of a line: a number and its unit, a sign
/// and its number, a word and the symbol after it ("5 g·mm", "± 0.2", "Crank radius r").
QString unbroken(QString text);
/// "46 mm", "50.65°": a number and its unit, which may be empty.
QString withUnit(const QString& number, const QString& unit);

/// "10²⁰"
QString powerOfTen(int exponent);

/// Fixed decimals with the locale's decimal sign and a true minus.
QString fixedDecimals(double value, int decimals, const QLocale& locale);
/// A number of a result: `decimals`, unless the user has chosen significant digits.
QString fixedNumber(double value, int decimals, const QLocale& locale);
/// A share as percent on one line: "12.3 %".
QString percentText(double share, int decimals = 1);
/// The same of a change: "+12.3 %", "−4.0 %"; what rounds to zero has no sign.
QString signedPercentText(double share, int decimals = 1);

}  // namespace ravnoves
