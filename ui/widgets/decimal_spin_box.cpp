#include "widgets/decimal_spin_box.h"

#include <QKeyEvent>
#include <cmath>

#include "text/number_text.h"
#include "text/typed_number.h"

namespace ravnoves {

QString DecimalSpinBox::bare(const QString& text) const {
    QString number = text;
    if (!suffix().isEmpty() && number.endsWith(suffix())) {
        number.chop(suffix().size());
    }
    return number.trimmed();
}

bool DecimalSpinBox::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if ((key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) &&
            cleanText() == textFromValue(value())) {
            event->ignore();
            return true;
        }
    }
    return QDoubleSpinBox::event(event);
}

QValidator::State DecimalSpinBox::validate(QString& text, int& /*position*/) const {
    // No key is refused: what is wrong is said of the whole text.
    const QString typed = bare(text);
    const QString unit = suffix().trimmed();
    // The ends of a range are rounded, what was converted to them is not.
    const double rounding = readFormNumber(typed) ? 0.0 : 0.5 * std::pow(10.0, -decimals());
    const auto isAllowed = [&](const std::optional<double>& value) {
        return value && *value >= minimum() - rounding && *value <= maximum() + rounding;
    };
    return isAllowed(readTypedNumber(typed, unit).value) &&
                   !isAllowed(readWithThousands(typed, unit))
               ? QValidator::Acceptable
               : QValidator::Intermediate;
}

void DecimalSpinBox::fixup(QString& text) const {
    if (const QString number = bare(text); !number.isEmpty()) {
        Q_EMIT refused(number);
    }
}

double DecimalSpinBox::valueFromText(const QString& text) const {
    return readTypedNumber(bare(text), suffix().trimmed()).value.value_or(value());
}

}  // namespace ravnoves
