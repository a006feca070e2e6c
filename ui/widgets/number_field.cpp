#include "widgets/number_field.h"

#include <QKeyEvent>
#include <QPainter>
#include <QWheelEvent>

#include "text/number_text.h"
#include "theme/theme.h"

namespace ravnoves {

NumberField::NumberField(QWidget* parent) : QLineEdit(parent) {
    setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    connect(this, &QLineEdit::textEdited, this, &NumberField::readText);
    connect(this, &QLineEdit::editingFinished, this, [this] {
        if (trouble_.isEmpty()) {
            showValue();
        }
    });
}

NumberField::NumberField(const FieldSpec& spec, QWidget* parent) : NumberField(parent) {
    setRange(spec.range, unitText(spec.unit));
}

void NumberField::setRange(const Range& range, const QString& unit) {
    range_ = range;
    unit_ = unit;
    updateToolTip();
}

void NumberField::setOptional(bool optional) {
    optional_ = optional;
}

void NumberField::setHint(const QString& hint) {
    hint_ = hint;
    updateToolTip();
}

void NumberField::setValue(std::optional<double> value) {
    if (!trouble_.isEmpty() && hasFocus() && value == value_) {
        return;  // the user is mending the text
    }
    const bool changed = value != value_;
    value_ = value;
    setTrouble({});
    if (changed || !hasFocus() || !isModified()) {
        // Text that already means the value stays as typed ("46,0").
        if (readFormNumber(text()) != value || (!value && !text().isEmpty())) {
            showValue();
        }
    }
}

void NumberField::showValue() {
    setText(value_ ? formNumber(*value_, locale(), digits_) : QString());
    setCursorPosition(0);
}

void NumberField::readText() {
    const QString typed = text().trimmed();
    if (typed.isEmpty()) {
        if (optional_) {
            setTrouble({});
            if (value_) {
                value_.reset();
                Q_EMIT valueEdited(value_);
            }
        } else {
            setTrouble(tr("A value is needed: %1.").arg(rangeText(range_, unit_, locale())));
        }
        return;
    }
    const auto number = readFormNumber(typed);
    if (!number) {
        setTrouble(tr("“%1” is not a number.").arg(typed));
        return;
    }
    if (!range_.contains(*number)) {
        setTrouble(tr("The value %1.").arg(rangeText(range_, unit_, locale())));
        return;
    }
    setTrouble({});
    if (value_ != number) {
        value_ = number;
        Q_EMIT valueEdited(value_);
    }
}

void NumberField::setTrouble(const QString& trouble) {
    if (trouble == trouble_) {
        return;
    }
    trouble_ = trouble;
    updateToolTip();
    setAccessibleDescription(trouble_.isEmpty() ? hint_ : trouble_);
    Q_EMIT troubleChanged(trouble_);
    update();
}

void NumberField::updateToolTip() {
    QString tip = hint_;
    const QString rule = rangeText(range_, unit_, locale());
    if (!tip.isEmpty()) {
        tip += QLatin1String("\n");
    }
    tip += tr("Value %1.").arg(rule);
    if (!trouble_.isEmpty()) {
        tip = trouble_ + QLatin1String("\n") + tip;
    }
    setToolTip(tip);
    if (trouble_.isEmpty()) {
        setAccessibleDescription(hint_);
    }
}

void NumberField::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && (!trouble_.isEmpty() || isModified())) {
        setTrouble({});
        showValue();
        setModified(false);
        return;
    }
    QLineEdit::keyPressEvent(event);
}

void NumberField::wheelEvent(QWheelEvent* event) {
    event->ignore();
}  // the form scrolls

void NumberField::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LocaleChange && trouble_.isEmpty()) {
        showValue();
        updateToolTip();
    }
    QLineEdit::changeEvent(event);
}

void NumberField::paintEvent(QPaintEvent* event) {
    QLineEdit::paintEvent(event);
    if (!trouble_.isEmpty()) {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(Theme::instance().error(), 2.0));
        painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 2, 2);
    }
}

}  // namespace ravnoves
