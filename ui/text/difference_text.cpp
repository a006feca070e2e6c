#include "text/difference_text.h"

#include <QRegularExpression>
#include <algorithm>
#include <cmath>

#include "text/number_text.h"

namespace ravnoves {

namespace {

QString withSign(double value, const QString& shown) {
    return value > 0.0 ? QLatin1Char('+') + shown : shown;
}

}  // namespace

std::optional<ShownNumber> readShownNumber(const QString& text) {
    static const QRegularExpression form(
        QStringLiteral("^\\s*([-+\u2212]?)(\\d+)(?:[.,](\\d+))?(?:[eE]([-+\u2212]?\\d+))?"
                       "(\u00A0?(?:%|°|[^\\d\\s%°×…/:-][^\\d]*))?\\s*$"));
    const QRegularExpressionMatch match = form.match(text);
    if (!match.hasMatch()) {
        return std::nullopt;
    }
    ShownNumber number;
    QString digits = match.captured(2);
    number.decimals = static_cast<int>(match.captured(3).size());
    if (number.decimals > 0) {
        digits += QLatin1Char('.') + match.captured(3);
    }
    if (!match.captured(4).isEmpty()) {
        number.isPlain = false;
        digits += QLatin1Char('e') + match.captured(4).replace(QChar(0x2212), QLatin1Char('-'));
    }
    number.value = digits.toDouble();
    if (!match.captured(1).isEmpty() && match.captured(1) != QLatin1String("+")) {
        number.value = -number.value;
    }
    number.unit = match.captured(5).trimmed();
    return number;
}

QString signedNumber(double value, int decimals) {
    const QString shown = fixedDecimals(value, decimals, QLocale());
    const double half = 0.5 * std::pow(10.0, -decimals);
    return std::abs(value) < half ? QStringLiteral("0") : withSign(value, shown);
}

QString signedPercent(double value, double reference) {
    if (reference == 0.0 || !std::isfinite(value / reference)) {
        return value == 0.0 ? QStringLiteral("0") : QStringLiteral("–");
    }
    const double percent = 100.0 * value / std::abs(reference);
    const QString shown = std::abs(percent) < 1000.0
                              ? fixedDecimals(percent, std::abs(percent) < 99.95 ? 1 : 0, QLocale())
                              : formNumber(percent, QLocale(), 3);
    return (std::abs(percent) < 0.05 ? QStringLiteral("0") : withSign(percent, shown)) +
           QStringLiteral("\u00A0%");
}

namespace {

/// Two numbers in one cell: "0.30 / 0.50", "120 × 80", "1.20 (0.5 %)".
struct Pair {
    QString first;
    QString sign;  ///< between them
    QString second;
    QString end;
};

std::optional<Pair> readPair(const QString& text) {
    static const QRegularExpression form(
        QStringLiteral("^(.*\\d)( [/×] | \\((?:÷ )?)([-+\u2212]?\\d[^()]*)(\\)?)$"));
    const QRegularExpressionMatch match = form.match(text);
    if (!match.hasMatch()) {
        return std::nullopt;
    }
    return Pair{match.captured(1), match.captured(2), match.captured(3), match.captured(4)};
}

/// Of both numbers, between which stands what stands there in the cell.
std::optional<ShownDifference> pairDifference(const QString& present, const QString& reference) {
    const auto now = readPair(present);
    const auto was = readPair(reference);
    if (!now || !was || now->sign != was->sign) {
        return std::nullopt;
    }
    const auto first = difference(now->first, was->first);
    const auto second = difference(now->second, was->second);
    if (!first || !second) {
        return std::nullopt;
    }
    if (now->sign.contains(QChar(0x00F7))) {
        return first;  // the other is a ratio of it
    }
    const auto read = readShownNumber(now->second);
    const bool isPercent = read->unit == QLatin1String("%");
    ShownDifference both{first->absolute + now->sign + second->absolute +
                             (isPercent ? QStringLiteral("\u00A0%") : QString()) + now->end,
                         first->percent};
    if (!second->percent.isEmpty()) {
        both.percent += now->sign + second->percent + now->end;
    }
    return both;
}

}  // namespace

std::optional<ShownDifference> difference(const QString& present, const QString& reference,
                                          bool isAngle) {
    const auto now = readShownNumber(present);
    const auto was = readShownNumber(reference);
    if (!now && !was) {
        return pairDifference(present, reference);
    }
    if (!now || !was || now->unit != was->unit) {
        return std::nullopt;
    }
    double value = now->value - was->value;
    isAngle = isAngle || now->unit == QStringLiteral("°");
    if (isAngle) {
        value = std::remainder(value, 360.0);
    }
    const QString absolute = now->isPlain && was->isPlain
                                 ? signedNumber(value, std::max(now->decimals, was->decimals))
                                 : withSign(value, trueMinus(formNumber(value, QLocale(), 3)));
    const bool isPercent = now->unit == QLatin1String("%");
    return ShownDifference{absolute,
                           isAngle || isPercent ? QString() : signedPercent(value, was->value)};
}

}  // namespace ravnoves
