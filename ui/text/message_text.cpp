#include "text/message_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>

#include "case-file/range.h"
#include "text/number_text.h"
#include "text/shown_units.h"

namespace ravnoves {

namespace {

/// "1.2e+20" as "1.2·10²⁰".
QString withPower(const QString& number) {
    const qsizetype at = number.indexOf(QLatin1Char('e'));
    bool isPower = false;
    const int power = number.mid(at + 1).toInt(&isPower);
    if (at < 0 || !isPower) {
        return number;
    }
    const QString mantissa = number.left(at);
    return (mantissa == QLatin1String("1")    ? QString()
            : mantissa == QLatin1String("-1") ? QStringLiteral("-")
                                              : mantissa + QStringLiteral("·")) +
           powerOfTen(power);
}

using Words = std::function<QString(const std::string&)>;

struct Shown {
    const Words& words;

    QString operator()(const std::string& word) const { return words(word); }
    QString operator()(const Message& message) const { return messageText(message, words); }
    QString operator()(const Number& number) const {
        const ShownUnit unit = shownUnit(number.unit);
        const QString name = number.unit_follows ? QString() : unit.name;
        if (number.digits < 0) {
            return withUnit(fixedNumber(unit.factor * number.value,
                                        std::max(0, unit.decimals - number.digits), QLocale()),
                            name);
        }
        Number own{number.value, units::none, number.digits};
        if (unit.factor != 1.0) {
            constexpr int converted = 6;
            own = {rounded_to(unit.factor * number.value,
                              number.digits > 0 ? number.digits : converted),
                   units::none, 0};
        }
        const Message plain(own);
        QString digits = withPower(QString::fromStdString(plain.english()));
        return withUnit(trueMinus(digits.replace(QLatin1Char('.'), QLocale().decimalPoint())),
                        name);
    }
};

}  // namespace

QString shownText(const Text& text) {
    return text.empty() ? QString() : QCoreApplication::translate(text.context, text.english);
}

QString messageText(const Message& message) {
    static const Words asTheyAre = [](const std::string& word) {
        return QString::fromStdString(word);
    };
    return messageText(message, asTheyAre);
}

QString messageText(const Message& message, const Words& word) {
    const Text& pattern = message.pattern();
    if (pattern.empty()) {
        return word(message.verbatim());
    }
    std::vector<std::string> values;
    for (const Argument& argument : message.arguments()) {
        values.push_back(std::visit(Shown{word}, argument).toStdString());
    }
    return QString::fromStdString(fill_pattern(shownText(pattern).toStdString(), values));
}

QString fieldName(const Field& field) {
    return shownText(field.label).remove(QLatin1Char('&'));
}

}  // namespace ravnoves
