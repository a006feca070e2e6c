#include "shop/scale_input.h"

#include <QApplication>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QPointer>

#include "text/number_text.h"
#include "text/typed_number.h"
#include "widgets/number_field.h"

namespace ravnoves {

namespace {

constexpr const char* typedAlone = "typedAlone";

/// The texts of this file.
struct ScaleInput {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::ScaleInput)
};

void press(QWidget* widget, Qt::Key key) {
    for (const QEvent::Type type : {QEvent::KeyPress, QEvent::KeyRelease}) {
        QKeyEvent event(type, key, Qt::NoModifier,
                        key == Qt::Key_Return ? QStringLiteral("\r") : QString());
        QApplication::sendEvent(widget, &event);
    }
}

NumberField* focusedNumber() {
    return qobject_cast<NumberField*>(QApplication::focusWidget());
}

QString enterInto(NumberField* field, const QString& weight) {
    const QPointer<NumberField> entered = field;
    field->setText(weight);
    Q_EMIT field->textEdited(weight);
    if (const QString trouble = field->trouble(); !trouble.isEmpty()) {
        press(field, Qt::Key_Escape);  // nobody typed it: what was there stays
        QApplication::beep();
        return ScaleInput::tr("%1 from the scale is not accepted. %2").arg(weight, trouble);
    }
    const QString name = field->accessibleName();
    if (isTypedAlone(field)) {
        Q_EMIT field->editingFinished();  // the next weight is of nothing that follows
        field->selectAll();
        return ScaleInput::tr("%1 from the scale: %2").arg(weight, name);
    }
    press(field, Qt::Key_Return);
    if (entered != nullptr && entered->hasFocus()) {
        press(entered, Qt::Key_Tab);
    }
    NumberField* at = focusedNumber();
    while (at != nullptr && isTypedAlone(at)) {
        press(at, Qt::Key_Return);
        at = at->hasFocus() ? nullptr : focusedNumber();
    }
    return ScaleInput::tr("%1 from the scale: %2").arg(weight, name);
}

}  // namespace

void setTypedAlone(QWidget* field) {
    field->setProperty(typedAlone, true);
}

bool isTypedAlone(const QWidget* field) {
    return field->property(typedAlone).toBool();
}

QString scaleText(const shop::ScaleLine& line) {
    return withUnit(fixedDecimals(line.number, line.decimals, QLocale()), unitText(line.unit.name));
}

QString meaningOf(const shop::ScaleLine& line) {
    switch (line.kind) {
        case shop::ScaleLine::Kind::stable:
            return ScaleInput::tr("%1, stable").arg(scaleText(line));
        case shop::ScaleLine::Kind::moving:
            return ScaleInput::tr("%1, not settled").arg(scaleText(line));
        case shop::ScaleLine::Kind::overload:
            return ScaleInput::tr("too much on the pan");
        case shop::ScaleLine::Kind::underload:
            return ScaleInput::tr("too little on the pan");
        case shop::ScaleLine::Kind::garbled:
            return ScaleInput::tr("not understood");
        case shop::ScaleLine::Kind::other:
            break;
    }
    return ScaleInput::tr("no weight");
}

QString enterWeight(const shop::ScaleLine& line) {
    const QString weight = scaleText(line);
    NumberField* field = focusedNumber();
    if (field != nullptr && field->isEnabled() && !field->isReadOnly() &&
        isMassUnit(field->unit())) {
        return enterInto(field, weight);
    }
    QApplication::beep();
    return ScaleInput::tr("%1 from the scale was not entered: click a mass field first.")
        .arg(weight);
}

}  // namespace ravnoves
