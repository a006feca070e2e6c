#include "shell/case_properties.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "model/scene_model.h"
#include "theme/theme.h"
#include "widgets/entry_field.h"
#include "widgets/layouts.h"

namespace ravnoves {

CaseProperties::CaseProperties(SceneModel* model, QWidget* parent) : QDialog(parent) {
    setWindowTitle(tr("Title and notes"));
    auto* column = new QVBoxLayout(this);
    column->setSpacing(Theme::gap);
    const auto add = [&](const QString& name, const QString& hint, auto* field) {
        auto* label = new QLabel(name, this);
        label->setBuddy(field);
        field->setToolTip(hint);
        field->setAccessibleDescription(hint);
        column->addWidget(label);
        column->addWidget(field);
        return field;
    };
    auto* title = add(tr("&Title"), tr("Title of the case, in its file and in the window"),
                      new QLineEdit(model->titleShown(), this));
    title->setObjectName(QStringLiteral("case_title"));
    limitLength(title, 200);
    auto* notes =
        add(tr("&Notes"),
            tr("Your notes on the case: sources, assumptions, open tasks. They are saved with "
               "the case."),
            new QPlainTextEdit(model->notes(), this));
    notes->setObjectName(QStringLiteral("case_notes"));
    notes->setTabChangesFocus(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    buttons->button(QDialogButtonBox::Close)->setDefault(true);  // Return in the title
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(this, &QDialog::finished, model, [=] {
        const QString typed = title->text().trimmed();
        model->editText(typed == model->titleShown().trimmed() ? model->title() : typed,
                        notes->toPlainText());
    });
    resizeWithText(this, 480, 320);
}

}  // namespace ravnoves
