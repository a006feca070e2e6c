#include "widgets/number_field.h"

#include <QKeyEvent>
#include <algorithm>
#include <cmath>

#include "text/message_text.h"
#include "text/number_text.h"

namespace ravnoves {

NumberField::NumberField(QWidget* parent) : ValueEntry(parent) {
    setAlignment(Qt::AlignRight | Qt::AlignVCenter);
}

NumberField::NumberField(const Field& field, QWidget* parent) : NumberField(parent) {
    setRange(field.range, unitText(field.unit.name));
    setHint(shownText(field.hint));
    setPlaceholderText(shownText(field.placeholder));
    setAccessibleName(unit_.isEmpty() ? fieldName(field)
                                      : fieldName(field) + QStringLiteral(", ") + unit_);
    setObjectName(QString::fromStdString(std::string(field.key)));
}

void NumberField::setRange(const Range& range, const QString& unit) {
    range_ = range;
    unit_ = unit;
    describe();
}

void NumberField::setDigits(int digits) {
    digits_ = digits;
    setValue(value());
}

void NumberField::keyPressEvent(QKeyEvent* event) {
    const int step = event->key() == Qt::Key_Up ? 1 : event->key() == Qt::Key_Down ? -1 : 0;
    if (step == 0 || !whole_ || !value() || isReadOnly()) {
        ValueEntry::keyPressEvent(event);
    } else if (const double next = *value() + step; range_.contains(next)) {
        setText(formNumber(next, locale(), digits_));
        Q_EMIT textEdited(text());
    }
}

NumberField::Reading NumberField::read(const QString& typed) const {
    if (typed.isEmpty()) {
        return {{},
                optional_ ? QString()
                          : tr("A value is needed: %1.").arg(rangeText(range_, unit_, locale()))};
    }
    const auto number = readFormNumber(typed);
    if (!number) {
        return {{}, tr("“%1” is not a number.").arg(typed)};
    }
    if (whole_ && std::floor(*number) != *number) {
        return {{}, tr("The value must be a whole number.")};
    }
    if (!range_.contains(*number)) {
        return {{}, tr("The value %1.").arg(rangeText(range_, unit_, locale()))};
    }
    return {number, {}};
}

QString NumberField::written() const {
    return value() ? formNumber(*value(), locale(), digits_) : QString();
}

QString NumberField::rule() const {
    return tr("Value %1.").arg(rangeText(range_, unit_, locale()));
}

bool NumberField::same(const std::optional<double>& a, const std::optional<double>& b) const {
    constexpr double rounding = 1e-15;
    return a == b ||
           (a && b && std::abs(*a - *b) <= rounding * std::max(std::abs(*a), std::abs(*b)));
}

}  // namespace ravnoves
