#pragma once

#include <QRegularExpression>
#include <QString>
#include <optional>

#include "text/result_row.h"

namespace ravnoves::test {

/// A number as a person reads it in a table, with what stands behind it.
struct ShownNumber {
    double value = 0.0;
    int decimals = 0;
    bool isPlain = true;  ///< without an exponent
    QString unit;         ///< "%" and the like, where it stands behind the number
};

/// Nothing where the cell is no number: "0.6580", "−10.4 %", "63.86°", "1.2E-5".
inline std::optional<ShownNumber> readShownNumber(const QString& text) {
    static const QRegularExpression form(
        QStringLiteral("^\\s*([-+\u2212]?)(\\d+)(?:[.,](\\d+))?(?:[eE]([-+\u2212]?\\d+))?"
                       "(\u00A0?(?:%|°|[^\\d\\s%°×…/:-][^\\d]*))?\\s*$"));
    const QRegularExpressionMatch match = form.match(text);
    if (!match.hasMatch()) {
        return std::nullopt;
    }
    const auto plain = [](QString part) { return part.replace(QChar(0x2212), QLatin1Char('-')); };
    const QString power = match.captured(4);
    const QString digits = plain(match.captured(1)) + match.captured(2) + QLatin1Char('.') +
                           match.captured(3) + QLatin1Char('e') +
                           (power.isEmpty() ? QStringLiteral("0") : plain(power));
    return ShownNumber{digits.toDouble(), static_cast<int>(match.captured(3).size()),
                       power.isEmpty(), match.captured(5).trimmed()};
}

inline QVector<QStringList> textsOf(const ResultRows& rows) {
    QVector<QStringList> texts;
    for (const ResultRow& row : rows) {
        texts << row.texts();
    }
    return texts;
}

}  // namespace ravnoves::test
