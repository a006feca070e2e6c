#include "elastic-hinge/number_list_field.h"

#include "case-file/input_error.h"
#include "text/capital.h"
#include "text/error_text.h"
#include "text/message_text.h"
#include "text/shown_units.h"
#include "theme/theme.h"

namespace ravnoves {

NumberListField::NumberListField(const Field& field, int longest, QWidget* parent)
    : ValueEntry(parent), field_(field), longest_(longest) {
    describe();
}

QSize NumberListField::sizeHint() const {
    const QString numbers = QStringLiteral("0.35; ").repeated(longest_);
    return {fontMetrics().horizontalAdvance(numbers) + 2 * Theme::gap,
            ValueEntry::sizeHint().height()};
}

NumberListField::Reading NumberListField::read(const QString& typed) const {
    try {
        std::vector<double> values = readNumberList(typed, field_, {});
        if (values.size() > static_cast<std::size_t>(longest_)) {
            return {{}, tr("At most %n value(s).", nullptr, longest_)};
        }
        return {std::move(values), {}};
    } catch (const InputError& error) {
        return {{}, capitalised(errorText(error))};  // the field's name stands before it
    }
}

QString NumberListField::rule() const {
    // A pure number where there is no other unit to be told from.
    const Unit& unit = field_.unit;
    return tr("Each value %1.")
        .arg(messageText(field_.range.message(shownAs(unit) == unit ? units::none : unit)));
}

}  // namespace ravnoves
