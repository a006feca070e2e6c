#include "elastic-hinge/number_list_field.h"

#include <QRegularExpression>

#include "text/number_text.h"

namespace ravnoves {

NumberListField::NumberListField(const Range& range, int longest, QWidget* parent)
    : ValueEntry(parent), range_(range), longest_(longest) {
    describe();
}

NumberListField::Reading NumberListField::read(const QString& typed) const {
    static const QRegularExpression separators(QStringLiteral("[;\\s]+"));
    std::vector<double> values;
    for (const QString& part : typed.split(separators, Qt::SkipEmptyParts)) {
        const auto value = readFormNumber(part);
        if (!value) {
            return {{}, tr("“%1” is not a number.").arg(part)};
        }
        if (!range_.contains(*value)) {
            return {{}, tr("The value %1.").arg(rangeText(range_, {}, locale()))};
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
        parts << formNumber(each, locale(), 6);
    }
    return parts.join(QStringLiteral("; "));
}

QString NumberListField::rule() const {
    return tr("Each value %1.").arg(rangeText(range_, {}, locale()));
}

}  // namespace ravnoves
