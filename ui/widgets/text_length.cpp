#include "widgets/text_length.h"

#include <QCoreApplication>
#include <QInputDialog>
#include <QLineEdit>
#include <QToolTip>
#include <algorithm>

namespace ravnoves {

QString cutText(int longest) {
    return QCoreApplication::translate("ravnoves::EntryField", "Cut: at most %1 characters.")
        .arg(longest);
}

void limitLength(QLineEdit* field, int longest) {
    field->setMaxLength(std::max(longest, static_cast<int>(field->text().size())));
    QObject::connect(field, &QLineEdit::inputRejected, field, [field] {
        QToolTip::showText(field->mapToGlobal(QPoint(0, field->height())),
                           cutText(field->maxLength()), field);
    });
}

std::optional<QString> askName(QWidget* parent, const QString& title, const QString& label,
                               const QString& name) {
    QInputDialog dialog(parent);
    dialog.setWindowTitle(title);
    dialog.setLabelText(label);
    dialog.setTextValue(name);
    constexpr int longest = 200;
    if (auto* field = dialog.findChild<QLineEdit*>()) {
        limitLength(field, longest);
    }
    return dialog.exec() == QDialog::Accepted ? std::optional(dialog.textValue()) : std::nullopt;
}

}  // namespace ravnoves
