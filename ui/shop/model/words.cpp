#include "shop/model/words.h"

#include <QCoreApplication>
#include <QTranslator>
#include <algorithm>

#include "text/message_text.h"
#include "text/number_text.h"
#include "text/shown_units.h"

namespace ravnoves {

Words::Words(const QString& code) : own_(true), locale_(code) {
    locale_.setNumberOptions(QLocale::OmitGroupSeparator);
    auto translator = std::make_shared<QTranslator>();
    if (translator->load(QStringLiteral(":/i18n/ravnoves_%1.qm").arg(code))) {
        translator_ = std::move(translator);
    }
}

QString Words::translate(const char* context, const char* text, const char* comment) const {
    if (!own_) {
        return QCoreApplication::translate(context, text, comment);
    }
    const QString found = translator_ ? translator_->translate(context, text, comment) : QString();
    return found.isEmpty() ? QString::fromUtf8(text) : found;
}

QString Words::unit(Unit unit) const {
    const Unit shown = shownAs(unit);
    return shown.name.empty() ? QString() : translate(core_texts, std::string(shown.name).c_str());
}

QString Words::message(const Message& message) const {
    const auto numberOf = [this](const Number& number) {
        const ShownUnit shown = shownUnit(number.unit);
        const double value = shown.factor * number.value;
        const int decimals = std::max(0, shown.decimals - number.digits);
        const int digits = number.digits > 0 ? number.digits : shown.factor == 1.0 ? 10 : 6;
        return withUnit(number.trimmed      ? plain(value, decimals)
                        : number.digits < 0 ? this->number(value, decimals)
                                            : shownFormNumber(value, locale(), digits),
                        number.unit_follows ? QString() : unit(number.unit));
    };
    return messageText(
        message, {.text = [this](const Text& each) { return text(each); }, .number = numberOf});
}

QString Words::number(double si, Unit unit, int decimals) const {
    return withUnit(digits(si, unit, decimals), this->unit(unit));
}

QString Words::digits(double si, Unit unit, int decimals) const {
    return number(shownValue(si, unit), std::max(0, decimals + shownUnit(unit).decimals));
}

ResultCell Words::cell(double si, Unit unit, int decimals) const {
    return {shownValue(si, unit), digits(si, unit, decimals)};
}

ResultCell Words::cellWithUnit(double si, Unit unit, int decimals) const {
    return {shownValue(si, unit), number(si, unit, decimals), ResultCell::Kind::Plain,
            this->unit(unit)};
}

QString Words::number(double value, int decimals) const {
    return fixedDecimals(value, decimals, locale());
}

QString Words::day(const QString& iso) const {
    const QDate day = QDate::fromString(iso, Qt::ISODate);
    return day.isValid() && locale().language() == QLocale::Russian
               ? day.toString(QStringLiteral("dd.MM.yyyy"))
               : iso;
}

QString Words::plain(double value, int decimals) const {
    QString text = number(value, decimals);
    const QString point = locale().decimalPoint();
    if (text.contains(point)) {
        while (text.endsWith(QLatin1Char('0'))) {
            text.chop(1);
        }
        if (text.endsWith(point)) {
            text.chop(point.size());
        }
    }
    return text;
}

QString Words::plain(double si, Unit unit, int decimals) const {
    return plain(shownValue(si, unit), std::max(0, decimals + shownUnit(unit).decimals));
}

QString Words::plainWithUnit(double si, const Field& field, int decimals) const {
    const ShownUnit shown = shownUnit(field);
    return withUnit(plain(si / field.unit * shown.factor, std::max(0, decimals + shown.decimals)),
                    translate(core_texts, std::string(shownAs(field).name).c_str()));
}

QString Words::plainWithUnit(double si, Unit unit, int decimals) const {
    return withUnit(plain(si, unit, decimals), this->unit(unit));
}

QDate readDay(const QString& text) {
    for (const char* format : {"yyyy-MM-dd", "dd.MM.yyyy", "d.M.yyyy", "d.M.yy", "dd/MM/yyyy"}) {
        const QDate day = QDate::fromString(text.trimmed(), QLatin1String(format));
        if (day.isValid()) {
            return day.year() < 2000 && qstrcmp(format, "d.M.yy") == 0 ? day.addYears(100) : day;
        }
    }
    return {};
}

}  // namespace ravnoves
