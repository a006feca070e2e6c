#include "text/message_text.h"

#include <QCoreApplication>
#include <QLocale>

#include "text/number_text.h"

namespace ravnoves {

namespace {

struct Shown {
    QString operator()(const std::string& word) const { return QString::fromStdString(word); }
    QString operator()(const Message& message) const { return messageText(message); }
    QString operator()(const Number& number) const {
        if (number.digits < 0) {
            return withUnit(fixedNumber(number.value, -number.digits, QLocale()),
                            unitText(number.unit.name));
        }
        const Message plain(Number{number.value, units::none, number.digits});
        QString digits = QString::fromStdString(plain.english());
        return withUnit(digits.replace(QLatin1Char('.'), QLocale().decimalPoint()),
                        unitText(number.unit.name));
    }
};

}  // namespace

QString shownText(const Text& text) {
    return text.empty() ? QString() : QCoreApplication::translate(text.context, text.english);
}

QString messageText(const Message& message) {
    const Text& pattern = message.pattern();
    if (pattern.empty()) {
        return QString::fromStdString(message.verbatim());
    }
    std::vector<std::string> values;
    for (const Argument& argument : message.arguments()) {
        values.push_back(std::visit(Shown{}, argument).toStdString());
    }
    return QString::fromStdString(fill_pattern(shownText(pattern).toStdString(), values));
}

QString fieldName(const Field& field) {
    return shownText(field.label).remove(QLatin1Char('&'));
}

}  // namespace ravnoves
