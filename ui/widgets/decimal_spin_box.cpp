#include "widgets/decimal_spin_box.h"

#include <QKeyEvent>

#include "text/number_text.h"

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
    const QString number = bare(text);
    if (const auto value = readFormNumber(number)) {
        return *value >= minimum() && *value <= maximum() ? QValidator::Acceptable
                                                          : QValidator::Intermediate;
    }
    for (const QChar c : number) {
        if (!c.isDigit() && !QStringLiteral("+-,.−").contains(c)) {
            return QValidator::Invalid;
        }
    }
    return QValidator::Intermediate;
}

void DecimalSpinBox::fixup(QString& text) const {
    if (const QString number = bare(text); !number.isEmpty()) {
        Q_EMIT refused(number);
    }
}

double DecimalSpinBox::valueFromText(const QString& text) const {
    return readFormNumber(bare(text)).value_or(value());
}

}  // namespace ravnoves
