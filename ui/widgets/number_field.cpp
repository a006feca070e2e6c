#include "widgets/number_field.h"

#include <QKeyEvent>
#include <algorithm>
#include <cmath>

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
    const ShownUnit unit = shownUnit(field);
    factor_ = unit.factor;
    setRange(field.range, unit.name);
    setHint(fieldHint(field));
    setPlaceholderText(shownText(field.placeholder));
    setAccessibleName(unit_.isEmpty() ? fieldName(field)
                                      : fieldName(field) + QStringLiteral(", ") + unit_);
    setObjectName(QString::fromStdString(std::string(field.key)));
}

void NumberField::setRange(const Range& range, const QString& unit) {
    own_ = range;
    range_ = range;
    range_.min = shown(range.min);
    range_.max = shown(range.max);
    unit_ = unit;
    describe();
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

void NumberField::setDecimals(int decimals) {
    decimals_ = decimals;
    showValue();
}

void NumberField::keyPressEvent(QKeyEvent* event) {
    const int step = event->key() == Qt::Key_Up ? 1 : event->key() == Qt::Key_Down ? -1 : 0;
    if (step == 0 || !whole_ || !value() || isReadOnly()) {
        ValueEntry::keyPressEvent(event);
    } else if (const double next = shown(*value()) + step; range_.contains(next)) {
        setText(formNumber(next, locale(), digits_));
        Q_EMIT textEdited(text());
    }
}

NumberField::Reading NumberField::read(const QString& typed) const {
    if (typed.isEmpty()) {
        return {{},
                optional_ ? QString() : tr("A value is needed: %1.").arg(rangeText(range_, unit_))};
    }
    const auto [number, trouble] = readTypedNumber(typed, unit_);
    if (!number) {
        return {{}, trouble.isEmpty() ? notANumberText(typed) : trouble};
    }
    if (whole_ && std::floor(*number) != *number) {
        return {{}, tr("The value must be a whole number.")};
    }
    const auto thousands = readWithThousands(typed, unit_);
    if (thousands && range_.contains(*thousands)) {
        return {{}, eitherNumberText(typed, *thousands, *number)};
    }
    if (!range_.contains(*number)) {
        return {{}, tr("The value %1.").arg(rangeText(range_, unit_))};
    }
    constexpr int digits = 15;  // 2 in are 50.8 mm, not 50.799999999999997
    // What the text's rule allows, the value's allows: its ends are rounded for the text.
    return {factor_ == 1.0
                ? *number
                : std::clamp(rounded_to_digits(*number / factor_, digits), own_.min, own_.max),
            {}};
}

QString NumberField::written() const {
    // In a column of converted numbers the points stand below each other.
    if (value() && factor_ != 1.0 && decimals_) {
        return QString::number(*value() * factor_, 'f', *decimals_)
            .replace(QLatin1Char('.'), locale().decimalPoint());
    }
    return value() ? writtenOut(shown(*value()), locale(), digits_) : QString();
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
