#include "text/number_text.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cmath>

#include "case-file/decimal.h"
#include "text/message_text.h"

namespace ravnoves {

namespace {

QLocale plain(QLocale locale) {
    locale.setNumberOptions(QLocale::OmitGroupSeparator | QLocale::RejectGroupSeparator);
    return locale;
}

/// Units that a language may write with letters of its own; the rest ("°") stays.
constexpr std::array unitNames{
    QT_TRANSLATE_NOOP("ravnoves::Unit", "mm"),    QT_TRANSLATE_NOOP("ravnoves::Unit", "kg"),
    QT_TRANSLATE_NOOP("ravnoves::Unit", "g"),     QT_TRANSLATE_NOOP("ravnoves::Unit", "g·mm"),
    QT_TRANSLATE_NOOP("ravnoves::Unit", "N"),     QT_TRANSLATE_NOOP("ravnoves::Unit", "N/m"),
    QT_TRANSLATE_NOOP("ravnoves::Unit", "N·m"),   QT_TRANSLATE_NOOP("ravnoves::Unit", "kN/m"),
    QT_TRANSLATE_NOOP("ravnoves::Unit", "J"),     QT_TRANSLATE_NOOP("ravnoves::Unit", "bar"),
    QT_TRANSLATE_NOOP("ravnoves::Unit", "kPa"),   QT_TRANSLATE_NOOP("ravnoves::Unit", "MPa"),
    QT_TRANSLATE_NOOP("ravnoves::Unit", "GPa"),   QT_TRANSLATE_NOOP("ravnoves::Unit", "Pa"),
    QT_TRANSLATE_NOOP("ravnoves::Unit", "kg/m³"), QT_TRANSLATE_NOOP("ravnoves::Unit", "kg·m²"),
    QT_TRANSLATE_NOOP("ravnoves::Unit", "m/s²"),  QT_TRANSLATE_NOOP("ravnoves::Unit", "mm/s"),
    QT_TRANSLATE_NOOP("ravnoves::Unit", "min⁻¹"), QT_TRANSLATE_NOOP("ravnoves::Unit", "rad/s"),
    QT_TRANSLATE_NOOP("ravnoves::Unit", "rad"),   QT_TRANSLATE_NOOP("ravnoves::Unit", "µm"),
    QT_TRANSLATE_NOOP("ravnoves::Unit", "s"),     QT_TRANSLATE_NOOP("ravnoves::Unit", "cm³"),
};

}  // namespace

QString unitText(std::string_view unit) {
    const auto* const known = std::find(unitNames.begin(), unitNames.end(), unit);
    if (known != unitNames.end()) {
        return QCoreApplication::translate("ravnoves::Unit", *known);
    }
    return QString::fromUtf8(unit.data(), static_cast<qsizetype>(unit.size()));
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

std::optional<double> readFormNumber(const QString& text) {
    return parse_decimal(text.trimmed().toStdString());
}

QString fixedNumber(double value, int decimals, const QLocale& locale) {
    if (!std::isfinite(value)) {
        return QStringLiteral("–");
    }
    // −0.00 is no number that a person wants to see.
    const double scale = std::pow(10.0, decimals);
    const double shown = std::round(value * scale) == 0.0 ? 0.0 : value;
    return plain(locale).toString(shown, 'f', decimals).replace(QLatin1Char('-'), QChar(0x2212));
}

QString rangeText(const Range& range, const QString& unit, const QLocale& /*locale*/) {
    const std::string name = unit.toStdString();
    return messageText(range.message({name, 1.0}));
}

}  // namespace ravnoves
