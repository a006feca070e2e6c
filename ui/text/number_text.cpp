#include "text/number_text.h"

#include <QRegularExpression>
#include <algorithm>
#include <cmath>

#include "case-file/decimal.h"
#include "text/message_text.h"
#include "text/preferences.h"

namespace ravnoves {

namespace {

QLocale plain(QLocale locale) {
    locale.setNumberOptions(QLocale::OmitGroupSeparator | QLocale::RejectGroupSeparator);
    return locale;
}

}  // namespace

QString unitText(std::string_view unit) {
    return shownText({std::string(unit).c_str()});
}

QString unbroken(QString text) {
    static const QRegularExpression units(
        QStringLiteral(
            "(?<=[\\d½]) (?=(?:[%°‰]|(?:µm|mm|cm|m|kg|g|l|kN|N|J|[kMG]?Pa|bar|s|rad|min⁻¹|мкм|"
            "мм|см|м|кг|г|л|кН|Н|Дж|[кМГ]?Па|бар|с|рад|мин⁻¹|oz|lb)[²³]?(?:[·/]\\w+[²³]?)*)"
            "(?![\\w]))"),
        QRegularExpression::UseUnicodePropertiesOption);
    static const QRegularExpression signs(QStringLiteral("(?<=[±⌀]|\\bG|\\bISO|\\bИСО) (?=\\d)"),
                                          QRegularExpression::UseUnicodePropertiesOption);
    // No article, no pronoun.
    static const QRegularExpression symbols(
        QStringLiteral("(?<=[\\w.,%)]) (?=&?(?![aAI](?![\\w&]))Δ?[A-Za-zℓ\\x{391}-\\x{3C9}]"
                       "(?:&?[₀-₉ₐ-ₜᵢ-ᵪⱼ′″])*(?![\\w&]))"),
        QRegularExpression::UseUnicodePropertiesOption);
    static const QRegularExpression numbers(QStringLiteral("(?<=[\\w)]) (?=&?\\d{1,2}$)"),
                                            QRegularExpression::UseUnicodePropertiesOption);
    for (const QRegularExpression& each : {units, signs, symbols, numbers}) {
        text.replace(each, QString(QChar(0x00A0)));
    }
    return text;
}

QString withUnit(const QString& number, const QString& unit) {
    if (unit.isEmpty()) {
        return number;
    }
    return unit == QStringLiteral("°") ? number + unit : number + QChar(0x00A0) + unit;
}

QString formNumber(double value, const QLocale& locale, int significant) {
    if (!std::isfinite(value)) {
        return {};
    }
    if (value == 0.0) {
        return QStringLiteral("0");
    }
    // 'g' switches to an exponent where the number is very large or very small, which is right.
    return plain(locale).toString(value, 'g', significant);
}

QString writtenOut(double value, const QLocale& locale, int significant) {
    constexpr double minimum = 1e-9;
    constexpr double maximum = 1e15;
    const QString text = formNumber(value, locale, significant);
    if (!text.contains(locale.exponential(), Qt::CaseInsensitive) || std::abs(value) < minimum ||
        std::abs(value) >= maximum) {
        return text;
    }
    const int first = static_cast<int>(std::floor(std::log10(std::abs(value))));
    QString digits = plain(locale).toString(value, 'f', std::max(0, significant - 1 - first));
    while (first < 0 && digits.endsWith(locale.zeroDigit())) {
        digits.chop(1);
    }
    return digits;
}

QString shownFormNumber(double value, const QLocale& locale, int significant) {
    return trueMinus(formNumber(value, locale, significant));
}

QString wholeNumber(double value, const QString& text) {
    constexpr int digits = 15;
    const auto read = readFormNumber(text);
    return read && *read != rounded_to_digits(value, digits) ? writtenOut(value, QLocale(), digits)
                                                             : QString();
}

QString trueMinus(QString number) {
    return number.replace(QLatin1Char('-'), QChar(0x2212));
}

std::optional<double> readFormNumber(const QString& text) {
    return parse_decimal(text.trimmed().toStdString());
}

QString powerOfTen(int exponent) {
    static const QString raised = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
    QString text = QStringLiteral("10") + (exponent < 0 ? QStringLiteral("⁻") : QString());
    for (const QChar digit : QString::number(std::abs(exponent))) {
        text += raised.at(digit.digitValue());
    }
    return text;
}

QString fixedNumber(double value, int decimals, const QLocale& locale) {
    const int chosen = Preferences::instance().digits();
    // What is counted in whole numbers stays whole.
    const bool isWhole = decimals == 0 && value == std::round(value);
    if (chosen > 0 && !isWhole && std::isfinite(value) && std::abs(value) > 1e-9) {
        decimals = std::clamp(
            chosen - 1 - static_cast<int>(std::floor(std::log10(std::abs(value)))), 0, 9);
    }
    return fixedDecimals(value, decimals, locale);
}

QString percentText(double share, int decimals) {
    return withUnit(fixedNumber(share / units::percent, decimals, QLocale()), unitText("%"));
}

QString signedPercentText(double share, int decimals) {
    const bool isMore = share / units::percent >= 0.5 * std::pow(10.0, -decimals);
    return (isMore ? QStringLiteral("+") : QString()) + percentText(share, decimals);
}

QString fixedDecimals(double value, int decimals, const QLocale& locale) {
    if (!std::isfinite(value)) {
        return QStringLiteral("–");
    }
    constexpr double longest = 1e9;  // beyond it digits say nothing
    if (std::abs(value) >= longest) {
        return trueMinus(formNumber(value, locale, 6));
    }
    // −0.00 is no number that a person wants to see.
    const double scale = std::pow(10.0, decimals);
    double shown = std::round(value * scale) == 0.0 ? 0.0 : value;
    // A sum of 823.15 g may lie a bit below that: a half goes up, as it does by hand.
    constexpr double bit = 1e-13;
    constexpr double longestSum = 1e8;  // in units of the last decimal
    if (std::abs(value) * scale < longestSum) {
        shown *= 1.0 + bit;
    }
    return trueMinus(plain(locale).toString(shown, 'f', decimals));
}

QString rangeText(const Range& range, const QString& unit) {
    const std::string name = unit.toStdString();
    return messageText(range.message({name, 1.0}));
}

}  // namespace ravnoves
