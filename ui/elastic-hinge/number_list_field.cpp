#include "elastic-hinge/number_list_field.h"

#include <QPainter>
#include <QRegularExpression>

#include "text/number_text.h"
#include "theme/theme.h"

namespace ravnoves {

NumberListField::NumberListField(const Range& range, int longest, QWidget* parent)
    : QLineEdit(parent), range_(range), longest_(longest) {
    connect(this, &QLineEdit::textEdited, this, &NumberListField::readText);
    setHint({});
}

void NumberListField::setValues(const std::vector<double>& values) {
    if (values == values_ && !text().isEmpty()) {
        return;
    }
    values_ = values;
    QStringList parts;
    for (const double value : values) {
        parts << formNumber(value, locale(), 6);
    }
    setText(parts.join(QStringLiteral("; ")));
    setTrouble({});
}

void NumberListField::setHint(const QString& hint) {
    hint_ = hint;
    setTrouble(trouble_);
}

void NumberListField::readText() {
    static const QRegularExpression separators(QStringLiteral("[;\\s]+"));
    std::vector<double> values;
    for (const QString& part : text().split(separators, Qt::SkipEmptyParts)) {
        const auto value = readFormNumber(part);
        if (!value) {
            setTrouble(tr("“%1” is not a number.").arg(part));
            return;
        }
        if (!range_.contains(*value)) {
            setTrouble(tr("The value %1.").arg(rangeText(range_, {}, locale())));
            return;
        }
        values.push_back(*value);
    }
    if (values.size() > static_cast<std::size_t>(longest_)) {
        setTrouble(tr("At most %n value(s).", nullptr, longest_));
        return;
    }
    setTrouble({});
    if (values != values_) {
        values_ = values;
        Q_EMIT valuesEdited(values_);
    }
}

void NumberListField::setTrouble(const QString& trouble) {
    trouble_ = trouble;
    QString tip = trouble_.isEmpty() ? hint_ : trouble_ + QLatin1Char('\n') + hint_;
    if (!tip.isEmpty()) {
        tip += QLatin1Char('\n');
    }
    setToolTip(tip + tr("Each value %1.").arg(rangeText(range_, {}, locale())));
    setAccessibleDescription(trouble_.isEmpty() ? hint_ : trouble_);
    update();
}

void NumberListField::paintEvent(QPaintEvent* event) {
    QLineEdit::paintEvent(event);
    if (!trouble_.isEmpty()) {
        QPainter painter(this);
        painter.setPen(QPen(Theme::instance().error(), 2.0));
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

}  // namespace ravnoves
