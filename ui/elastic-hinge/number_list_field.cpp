#include "elastic-hinge/number_list_field.h"

#include <QRegularExpression>

#include "case-file/decimal.h"
#include "case-file/range.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "text/shown_units.h"
#include "theme/theme.h"

namespace ravnoves {

NumberListField::NumberListField(const Range& range, const Unit& unit, int longest, QWidget* parent)
    : ValueEntry(parent), range_(range), unit_(unit), longest_(longest) {
    describe();
}

QSize NumberListField::sizeHint() const {
    const QString numbers = QStringLiteral("0.35; ").repeated(longest_);
    return {fontMetrics().horizontalAdvance(numbers) + 2 * Theme::gap,
            ValueEntry::sizeHint().height()};
}

NumberListField::Reading NumberListField::read(const QString& typed) const {
    static const QRegularExpression separators(QStringLiteral("[;\\s]+"));
    std::vector<double> values;
    for (const QString& part : typed.split(separators, Qt::SkipEmptyParts)) {
        auto value = readFormNumber(part);
        if (!value) {
            return {{}, tr("“%1” is not a number.").arg(part)};
        }
        if (const double factor = shownUnit(unit_).factor; factor != 1.0) {
            constexpr int exact = 9;  // what is shown and read again is the same
            value = rounded_to_digits(*value / factor, exact);
        }
        if (!range_.contains(*value)) {
            return {{}, tr("The value %1.").arg(rangeText())};
        }
        values.push_back(*value);
    }
    if (values.size() > static_cast<std::size_t>(longest_)) {
        return {{}, tr("At most %n value(s).", nullptr, longest_)};
    }
    return {std::move(values), {}};
}

QString NumberListField::written() const {
    QStringList parts;
    for (const double each : value()) {
        parts << formNumber(shownUnit(unit_).factor * each, locale(), 6);
    }
    return parts.join(QStringLiteral("; "));
}

QString NumberListField::rangeText() const {
    // A pure number where there is no other unit to be told from.
    return messageText(range_.message(shownAs(unit_) == unit_ ? units::none : unit_));
}

QString NumberListField::rule() const {
    return tr("Each value %1.").arg(rangeText());
}

}  // namespace ravnoves
