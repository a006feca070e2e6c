#include "methods/model/method_words.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>

#include "case-file/decimal.h"
#include "plot/model/ticks.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "text/shown_units.h"

namespace ravnoves {

namespace {

QString inLocale(QString number) {
    return number.contains(QLatin1Char('e'))
               ? powerText(number.toDouble(), QLocale())
               : number.replace(QLatin1Char('.'), QLocale().decimalPoint());
}

/// Words of no language, but with numbers: "0.1°", "1e-6".
QString verbatimText(const std::string& word) {
    // No digit of a name: P_j1, M₁₂, 10⁻⁹.
    static const QRegularExpression number(
        QStringLiteral("(?<![\\w.])[0-9]+(?:\\.[0-9]+)?(?:e[-+]?[0-9]+)?(?!\\w)"),
        QRegularExpression::UseUnicodePropertiesOption);
    const QString text = QString::fromStdString(word);
    QString shown;
    qsizetype from = 0;
    for (auto found = number.globalMatch(text); found.hasNext();) {
        const auto match = found.next();
        shown += text.mid(from, match.capturedStart() - from) + inLocale(match.captured());
        from = match.capturedEnd();
    }
    return shown + text.mid(from);
}

}  // namespace

QString methodText(const Message& message) {
    return messageText(message, {.word = verbatimText});
}

QString sweepTitle(const methods::SweepInfo& sweep) {
    return titleWithUnit(shownText(sweep.title), unitText(sweep.unit.name));
}

QString timeText(double nanoseconds) {
    struct Unit {
        double size;
        const char* name;
    };
    static constexpr Unit units[] = {{1e9, QT_TRANSLATE_NOOP("ravnoves::MethodWords", "s")},
                                     {1e6, QT_TRANSLATE_NOOP("ravnoves::MethodWords", "ms")},
                                     {1e3, QT_TRANSLATE_NOOP("ravnoves::MethodWords", "µs")},
                                     {1.0, QT_TRANSLATE_NOOP("ravnoves::MethodWords", "ns")}};
    constexpr double rounding = 0.9995;  // 999.9 ns is 1 µs
    const auto* unit = std::find_if(std::begin(units), std::end(units), [&](const Unit& u) {
        return nanoseconds >= rounding * u.size;
    });
    unit = unit == std::end(units) ? std::end(units) - 1 : unit;
    return formNumber(nanoseconds / unit->size, QLocale(), 3) + QChar(0x00A0) +
           QCoreApplication::translate("ravnoves::MethodWords", unit->name);
}

QString nanosecondsText(double nanoseconds) {
    if (!(nanoseconds > 0.0)) {
        return QStringLiteral("–");
    }
    const int decimals =
        std::clamp(2 - static_cast<int>(std::floor(std::log10(nanoseconds))), 0, 3);
    return QLocale().toString(rounded_to_digits(nanoseconds, 3), 'f', decimals);
}

QString errorNumber(double error) {
    return powerText(error, QLocale(), 2);
}

QString resultText(const methods::Result& result) {
    return result.rejected() ? QCoreApplication::translate("ravnoves::MethodWords", "rejected")
                             : errorNumber(result.error);
}

}  // namespace ravnoves
