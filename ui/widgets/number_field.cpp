#include "widgets/number_field.h"

#include <QKeyEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "case-file/decimal.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "text/shown_units.h"
#include "text/typed_number.h"

namespace ravnoves {

NumberField::NumberField(QWidget* parent) : ValueEntry(parent) {
    setAlignment(Qt::AlignRight | Qt::AlignVCenter);
}

NumberField::NumberField(const Field& field, QWidget* parent) : NumberField(parent) {
    setShownUnit(shownUnit(field));
    setRange(field.range, unit_);
    setLabel(field.label);
    setHint(fieldHint(field));
    setPlaceholderText(shownText(field.placeholder));
    setAccessibleName(unit_.isEmpty() ? fieldName(field)
                                      : fieldName(field) + QStringLiteral(", ") + unit_);
    setObjectName(QString::fromStdString(std::string(field.key)));
}

void NumberField::setShownUnit(const ShownUnit& unit) {
    factor_ = unit.factor;
    unit_ = unit.name;
}

void NumberField::setRange(const Range& range, const QString& unit) {
    own_ = range;
    range_ = range;
    range_.min = shown(range.min);
    range_.max = shown(range.max);
    unit_ = unit;
    describe();
}

void NumberField::setOptional(bool optional) {
    const bool isNew = std::exchange(optional_, optional) != optional;
    if (isNew && optional && !trouble().isEmpty() && text().trimmed().isEmpty()) {
        readLater();
    }
}

double NumberField::shown(double value) const {
    constexpr int digits = 6;  // nobody reads more of a number that was converted
    return factor_ == 1.0 || !std::isfinite(value) ? value
                                                   : rounded_to_digits(value * factor_, digits);
}

void NumberField::setDigits(int digits) {
    digits_ = digits;
    showValue();
}

void NumberField::keyPressEvent(QKeyEvent* event) {
    const int way = event->key() == Qt::Key_Up ? 1 : event->key() == Qt::Key_Down ? -1 : 0;
    if (way == 0 || step_ == 0.0 || !value() || isReadOnly()) {
        ValueEntry::keyPressEvent(event);
    } else if (const double next = shown(*value()) + way * step_; range_.contains(next)) {
        setText(formNumber(next, locale(), digits_));
        Q_EMIT textEdited(text());
    }
}

NumberField::Reading NumberField::read(const QString& typed) const {
    if (typed.isEmpty()) {
        return {{}, optional_ ? QString() : tr("Enter a value: %1.").arg(rangeText(range_, unit_))};
    }
    auto [number, trouble] = readTypedFormula(typed, unit_);
    QString howRead;
    if (const auto mass = !number && lever_
                              ? readTypedFormula(typed, unitText(units::gram.name)).value
                              : std::nullopt) {
        const auto lever = lever_();
        if (!lever) {
            return {{},
                    tr("Grams need the drilling radius of the plane: enter it first. If two planes "
                       "have different radii, enter %1.")
                        .arg(unit_)};
        }
        const double unbalance = *mass * units::gram * *lever;
        number = shown(unbalance / units::gram_mm);
        howRead = tr("“%1” at a radius of %2: %3.")
                      .arg(typed, shownNumber(*lever, units::mm, 1),
                           shownNumber(unbalance, units::gram_mm, 1));
    }
    if (!number) {
        return {{}, trouble.isEmpty() ? notANumberText(typed) : trouble};
    }
    if (whole_ && std::floor(*number) != *number) {
        return {{}, tr("The value must be a whole number.")};
    }
    if (!range_.contains(*number)) {
        return {{}, tr("The value %1.").arg(rangeText(range_, unit_))};
    }
    constexpr double maxThousands = 100'000.0;  // of any quantity that is typed so
    const double thousand = 1000.0 * *number;
    const bool isEither =
        saysHowRead_ && !unit_.isEmpty() && thousand <= maxThousands && range_.contains(thousand) &&
        typed.back().isDigit() &&
        may_have_thousands(
            QString(typed).replace(QLatin1Char('.'), QLatin1Char(',')).toStdString());
    constexpr int digits = 15;  // 2 in are 50.8 mm, not 50.799999999999997
    // What the text's rule allows, the value's allows: its ends are rounded for the text.
    return {factor_ == 1.0
                ? *number
                : std::clamp(rounded_to_digits(*number / factor_, digits), own_.min, own_.max),
            {},
            !howRead.isEmpty() ? howRead
            : isEither         ? tr("“%1” was read as %2. Type %3 if that is meant.")
                             .arg(typed, shownFormNumber(*number, locale(), digits),
                                  shownFormNumber(thousand, locale(), digits))
                       : QString()};
}

QString NumberField::written() const {
    return value() ? textOf(*value()) : QString();
}

QString NumberField::textOf(double value) const {
    if (!places_) {
        return writtenOut(shown(value), locale(), digits_);
    }
    const auto fixed = [this](double number, int decimals) {
        return QString::number(number, 'f', decimals)
            .replace(QLatin1Char('.'), locale().decimalPoint());
    };
    constexpr int more = 5;
    const double number = value * factor_;
    // Values have 12 digits.
    const double rounding = 6e-12 * std::max(std::abs(number), 1e-3);
    double parts = std::pow(10.0, *places_);
    for (int places = *places_; places <= *places_ + more; ++places, parts *= 10.0) {
        if (std::abs(std::round(number * parts) / parts - number) <= rounding) {
            return fixed(number, places);
        }
    }
    return fixed(number, *places_);  // what was computed has no end
}

QString NumberField::wholeText() const {
    // Of a converted number nobody reads more.
    return isAtRest() && value() && factor_ == 1.0 ? wholeNumber(*value(), text()) : QString();
}

QString NumberField::rule() const {
    return tr("Value %1.").arg(rangeText(range_, unit_));
}

bool NumberField::same(const std::optional<double>& a, const std::optional<double>& b) const {
    constexpr double rounding = 1e-15;
    return a == b ||
           (a && b && std::abs(*a - *b) <= rounding * std::max(std::abs(*a), std::abs(*b)));
}

}  // namespace ravnoves
