#include "v8-plugs/checked_field.h"

#include <QPainter>

#include "theme/theme.h"

namespace ravnoves {

CheckedField::CheckedField(Check check, QWidget* parent)
    : QLineEdit(parent), check_(std::move(check)) {
    connect(this, &QLineEdit::textEdited, this, &CheckedField::readText);
}

void CheckedField::setValue(const QString& value) {
    if (!trouble_.isEmpty() && hasFocus()) {
        return;  // the user is mending the text
    }
    setTrouble({});
    if (text() != value && !(hasFocus() && isModified())) {
        setText(value);
    }
}

void CheckedField::readText() {
    const QString typed = text().trimmed();
    setTrouble(typed.isEmpty() ? QString() : check_(typed));
    if (trouble_.isEmpty()) {
        Q_EMIT valueEdited(typed);
    }
}

void CheckedField::setTrouble(const QString& trouble) {
    if (trouble == trouble_) {
        return;
    }
    trouble_ = trouble;
    setAccessibleDescription(trouble_);
    Q_EMIT troubleChanged(trouble_);
    update();
}

void CheckedField::paintEvent(QPaintEvent* event) {
    QLineEdit::paintEvent(event);
    if (!trouble_.isEmpty()) {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(Theme::instance().error(), 2.0));
        painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 2, 2);
    }
}

}  // namespace ravnoves
