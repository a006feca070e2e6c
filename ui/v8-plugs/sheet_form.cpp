#include "v8-plugs/sheet_form.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

#include "theme/theme.h"
#include "v8-plugs/checked_field.h"
#include "v8-plugs/model/v8_plugs_model.h"
#include "v8-plugs/model/v8_text.h"
#include "widgets/form_section.h"
#include "widgets/number_field.h"
#include "v8-plugs/model/v8_names.h"

namespace ravnoves {

using namespace v8_plugs;

namespace {

constexpr int numberWidth = 140;
constexpr int textWidth = 290;

/// The name of the step in the history: the label without its mnemonic.
QString stepName(QString label) {
    return label.remove(QLatin1Char('&'));
}

}  // namespace

SheetForm::SheetForm(V8PlugsModel* model, QWidget* parent)
    : QWidget(parent), model_(model), column_(new QVBoxLayout(this)) {
    column_->setContentsMargins(Theme::margin, Theme::margin, Theme::margin, Theme::margin);
    column_->setSpacing(Theme::gap);
    connect(model_, &SceneModel::changed, this, [this] {
        for (const auto& show : followers_) {
            show();
        }
    });
}

void SheetForm::enlarge(QWidget* field) {
    field->setMinimumHeight(fieldHeight);
    field->setFont(Theme::font(Theme::titleSize + 1));
}

QLabel* SheetForm::wrapped(QWidget* parent, int pixelSize, bool bold) {
    auto* label = new QLabel(parent);
    label->setWordWrap(true);
    label->setFont(Theme::font(pixelSize, bold));
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

void SheetForm::follow(std::function<void()> show) {
    show();
    followers_.push_back(std::move(show));
}

NumberField* SheetForm::number(FormSection* section, const QString& label, const FieldSpec& spec,
                               const QString& hint, std::function<std::optional<double>()> read,
                               std::function<void(Input&, std::optional<double>)> write) {
    NumberField* field =
        section->addNumber(label, spec, hint, v8_text::unitName(Words(), spec.unit));
    field->setOptional(true);
    field->setMaximumWidth(numberWidth);
    enlarge(field);
    connect(field, &NumberField::valueEdited, this,
            [this, step = stepName(label), write = std::move(write)](std::optional<double> value) {
                model_->edit(step, [&](Input& input) { write(input, value); });
            });
    follow([field, read = std::move(read)] { field->setValue(read()); });
    order_ << field;
    return field;
}

QLineEdit* SheetForm::text(FormSection* section, const QString& label, const QString& name,
                           std::string JobHeader::*member, const QString& hint, int longest) {
    auto* field = new QLineEdit(section);
    field->setObjectName(name);
    field->setMaxLength(longest);
    field->setMinimumWidth(textWidth);
    enlarge(field);
    section->addWidget(label, field, {}, hint);
    connect(field, &QLineEdit::textEdited, this,
            [this, step = stepName(label), member](const QString& typed) {
                model_->edit(step,
                             [&](Input& input) { input.job.*member = typed.toStdString(); });
            });
    follow([this, field, member] {
        const QString value = QString::fromStdString(model_->input().job.*member);
        if (field->text() != value) {
            field->setText(value);
        }
    });
    order_ << field;
    return field;
}

CheckedField* SheetForm::checked(FormSection* section, const QString& label, const QString& name,
                                 const QString& hint, CheckedText text) {
    auto* field = new CheckedField(
        [text](const QString& typed) {
            return text.normal(typed).isEmpty() ? text.refusal(typed) : QString();
        },
        section);
    field->setObjectName(name);
    enlarge(field);
    section->addWidget(label, field, {}, hint);
    auto* trouble = wrapped(section, Theme::smallSize);
    trouble->hide();
    section->addWide(trouble);
    connect(field, &CheckedField::troubleChanged, trouble, [trouble](const QString& words) {
        trouble->setText(words);
        trouble->setVisible(!words.isEmpty());
        colourText(trouble, Theme::instance().error());
    });
    connect(field, &CheckedField::valueEdited, this,
            [this, step = stepName(label), text](const QString& typed) {
                model_->edit(step,
                             [&](Input& input) { text.write(input, text.normal(typed)); });
            });
    follow([field, text] {
        // What was typed in another form stays as it was typed.
        const QString value = text.read();
        if (text.normal(field->value()) != value) {
            field->setValue(value);
        }
    });
    order_ << field;
    return field;
}

QComboBox* SheetForm::choice(FormSection* section, const QString& label, const QString& name,
                             const QStringList& items, const QString& hint,
                             std::function<void(int)> choose) {
    auto* box = new QComboBox(section);
    box->setObjectName(name);
    box->addItems(items);
    enlarge(box);
    section->addWidget(label, box, {}, hint);
    connect(box, &QComboBox::activated, this, std::move(choose));
    order_ << box;
    return box;
}

QStringList SheetForm::refused() const {
    QStringList list;
    for (const QWidget* each : order_) {
        const auto* field = qobject_cast<const EntryField*>(each);
        if (field != nullptr && !field->trouble().isEmpty()) {
            list << field->accessibleName() + QStringLiteral(": ") + field->trouble();
        }
    }
    return list;
}

}  // namespace ravnoves
