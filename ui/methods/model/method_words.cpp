#include "methods/model/method_words.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <QSet>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "methods/model/method_texts.h"
#include "plot/model/ticks.h"
#include "text/number_text.h"

namespace ravnoves {

namespace {

constexpr const char* contexts[] = {"ravnoves::MethodTexts", "ravnoves::ValidationTexts"};

QString plainText(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

/// A text with its numbers taken out: "64 points" is "%1 points" and 64.
struct Pattern {
    QString text;
    QStringList numbers;
};

Pattern patternOf(const QString& text) {
    // No digit of a name: P_j1, M₁₂, 10⁻⁹.
    static const QRegularExpression number(
        QStringLiteral("(?<![\\w.])[0-9]+(?:\\.[0-9]+)?(?:e[-+]?[0-9]+)?(?!\\w)"),
        QRegularExpression::UseUnicodePropertiesOption);
    Pattern pattern;
    qsizetype from = 0;
    auto found = number.globalMatch(text);
    while (found.hasNext()) {
        const auto match = found.next();
        pattern.numbers << match.captured();
        pattern.text += text.mid(from, match.capturedStart() - from) + QLatin1Char('%') +
                        QString::number(pattern.numbers.size());
        from = match.capturedEnd();
    }
    pattern.text += text.mid(from);
    return pattern;
}

QString inLocale(QString number) {
    return number.contains(QLatin1Char('e'))
               ? powerText(number.toDouble(), QLocale())
               : number.replace(QLatin1Char('.'), QLocale().decimalPoint());
}

QString filled(QString text, const QStringList& numbers) {
    // From the last, so that %1 is not found in %10.
    for (qsizetype i = numbers.size(); i-- > 0;) {
        text.replace(QLatin1Char('%') + QString::number(i + 1), inLocale(numbers[i]));
    }
    return text;
}

/// Nothing where no context knows it (or where it says the same in both languages).
QString translated(const QByteArray& english) {
    for (const char* context : contexts) {
        QString text = QCoreApplication::translate(context, english.constData());
        if (text != QString::fromUtf8(english)) {
            return text;
        }
    }
    return {};
}

const QSet<QString>& knownTexts() {
    static const QSet<QString> known = [] {
        QSet<QString> texts;
        for (const auto& list : {methodTexts(), validationTexts()}) {
            for (const char* text : list) {
                texts.insert(QString::fromUtf8(text));
            }
        }
        return texts;
    }();
    return known;
}

QString unitText(const QString& unit) {
    return unit == QStringLiteral("°") || unit.isEmpty() ? unit : QChar(0x00A0) + unit;
}

/// Nothing where neither the text nor its pattern is known.
QString whole(const QString& text) {
    if (QString same = translated(text.toUtf8()); !same.isEmpty()) {
        return same;
    }
    const Pattern pattern = patternOf(text);
    const QString other = translated(pattern.text.toUtf8());
    return other.isEmpty() ? QString() : filled(other, pattern.numbers);
}

/// Where a text that is not known as a whole is made of two: "k_p, 4.25 l".
qsizetype seamOf(const QString& text) {
    return std::max(text.lastIndexOf(QStringLiteral(", ")), text.lastIndexOf(QStringLiteral(": ")));
}

QString textInParts(const QString& text) {
    if (QString known = whole(text); !known.isEmpty()) {
        return known;
    }
    if (const qsizetype seam = seamOf(text); seam > 0) {
        return textInParts(text.left(seam)) + text.mid(seam, 2) + textInParts(text.mid(seam + 2));
    }
    const Pattern pattern = patternOf(text);
    return filled(pattern.text, pattern.numbers);
}

bool isKnown(const QString& text) {
    static const QRegularExpression word(QStringLiteral("[A-Za-z]{2}"));
    if (knownTexts().contains(text) || knownTexts().contains(patternOf(text).text)) {
        return true;
    }
    if (const qsizetype seam = seamOf(text); seam > 0) {
        return isKnown(text.left(seam)) && isKnown(text.mid(seam + 2));
    }
    // Formulas read the same in every language.
    QString rest = text;
    for (const char* name : {"M_ups", "M_up", "M_sm", "sin", "cos", "P_c"}) {
        rest.remove(QLatin1String(name));
    }
    static const QRegularExpression subscript(QStringLiteral("_[A-Za-z0-9]+"));
    return !rest.remove(subscript).contains(word);
}

}  // namespace

QString methodText(std::string_view english) {
    return textInParts(plainText(english));
}

bool isKnownMethodText(std::string_view english) {
    return isKnown(plainText(english));
}

QString sweepTitle(const methods::SweepInfo& sweep) {
    const QString title = methodText(sweep.title);
    return sweep.unit.empty() ? title : title + QStringLiteral(", ") + methodText(sweep.unit);
}

QString sweepNumber(const methods::SweepInfo& sweep, double value) {
    const double span = sweep.to - sweep.from;
    const double gap = std::min(std::abs(sweep.to - value), std::abs(value - sweep.from)) / span;
    int digits = 3;
    if (sweep.crowded() && gap > 0.0) {
        digits += std::clamp(static_cast<int>(std::ceil(-std::log10(gap))) - 1, 0, 12);
    }
    const QString number =
        sweep.logarithmic() ? powerText(value, QLocale()) : formNumber(value, QLocale(), digits);
    return number + unitText(methodText(sweep.unit));
}

QString failingText(const methods::SweepInfo& sweep, std::string_view english) {
    const QString unit = plainText(sweep.unit);
    QStringList parts = plainText(english).split(QStringLiteral(", "));
    for (QString& part : parts) {
        const bool more = part.endsWith(QStringLiteral(" …"));
        part.chop(more ? 2 : 0);
        const bool hasUnit = !unit.isEmpty() && part.endsWith(unit);
        part = (hasUnit ? part.chopped(unit.size()) : part).trimmed();
        part = methodText(part.toStdString()) +
               (hasUnit ? unitText(methodText(sweep.unit)) : QString()) +
               (more ? QStringLiteral(" …") : QString());
    }
    return parts.join(QStringLiteral(", "));
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

QString errorNumber(double error) {
    return powerText(error, QLocale(), 2);
}

QString resultText(const methods::Result& result) {
    return result.refused() ? QCoreApplication::translate("ravnoves::MethodWords", "refused")
                            : errorNumber(result.error);
}

}  // namespace ravnoves
