#include "text/message_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>

#include "case-file/decimal.h"
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

}  // namespace

QString numberText(const Number& number) {
    const ShownUnit unit = shownUnit(number.unit);
    const QString name = number.unit_follows ? QString() : unit.name;
    const int decimals = std::max(0, unit.decimals - number.digits);
    if (number.digits < 0 && !number.trimmed) {
        return withUnit(fixedNumber(unit.factor * number.value, decimals, QLocale()), name);
    }
    Number own{number.value, units::none, number.digits};
    if (number.trimmed) {
        own = {rounded_to_decimals(unit.factor * number.value, decimals), units::none, 0};
    } else if (unit.factor != 1.0) {
        constexpr int converted = 6;
        own = {rounded_to_digits(unit.factor * number.value,
                                 number.digits > 0 ? number.digits : converted),
               units::none, 0};
    }
    QString digits = withPower(QString::fromStdString(Message(own).english()));
    return withUnit(trueMinus(digits.replace(QLatin1Char('.'), QLocale().decimalPoint())), name);
}

QString shownText(const Text& text) {
    return text.empty() ? QString() : QCoreApplication::translate(core_texts, text.english);
}

QString messageText(const Message& message, const MessageWords& words) {
    if (message.pattern().empty()) {
        return words.word(message.verbatim());
    }
    struct Said {
        const MessageWords& words;
        QString operator()(const Message& inner) const { return messageText(inner, words); }
        QString operator()(const Number& number) const { return words.number(number); }
    };
    std::vector<std::string> values;
    for (const Argument& argument : message.arguments()) {
        values.push_back(std::visit(Said{words}, argument).toStdString());
    }
    return QString::fromStdString(
        fill_pattern(words.text(message.pattern()).toStdString(), values));
}

QString messageLines(const std::vector<Message>& messages) {
    QStringList lines;
    for (const Message& message : messages) {
        lines << messageText(message);
    }
    return lines.join(QLatin1Char('\n'));
}

QString presetTitle(const Message& title) {
    return title.pattern().empty()
               ? QCoreApplication::translate("ravnoves::Presets", title.verbatim().c_str())
               : messageText(title);
}

QString fieldName(const Field& field) {
    return shownText(field.label).remove(QLatin1Char('&'));
}

QString choiceText(const Field& field, std::string_view word) {
    for (const Word& each : field.words) {
        if (each.word == word) {
            return shownText(each.label).remove(QLatin1Char('&'));
        }
    }
    return {};
}

QString fieldHint(const Field& field) {
    QStringList sentences{shownText(field.hint)};
    if (!field.if_empty.empty()) {
        sentences << QCoreApplication::translate("ravnoves::Fields", "Empty: %1.")
                         .arg(shownText(field.if_empty));
    }
    sentences.removeAll(QString());
    return sentences.join(QLatin1Char(' '));
}

}  // namespace ravnoves
