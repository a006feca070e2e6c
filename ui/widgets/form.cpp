#include "widgets/form.h"

#include <QCheckBox>
#include <QLineEdit>
#include <QRegularExpression>
#include <QVBoxLayout>
#include <algorithm>

#include "case-file/decimal.h"
#include "case-file/field.h"
#include "text/message_text.h"
#include "theme/theme.h"

namespace ravnoves {

namespace {

/// A text of the input: every text is allowed that has room.
class TextField final : public ValueEntry<QString> {
  public:
    /// @param longest  characters; 0: any
    TextField(std::function<void(const QString&)> passOn, int longest, QWidget* parent)
        : ValueEntry(parent), passOn_(std::move(passOn)), longest_(longest) {
        if (longest > 0) {
            setMaxLength(longest);
        }
    }

  protected:
    Reading read(const QString& /*typed*/) const override { return {text(), {}}; }
    QString rule() const override {
        return longest_ == 0 ? QString() : Form::tr("At most %1 characters.").arg(longest_);
    }
    QString written() const override { return value(); }
    void passOn() override { passOn_(value()); }
    bool isReplaced() const override { return false; }

  private:
    std::function<void(const QString&)> passOn_;
    int longest_;
};

FieldValue numberValue(FieldKind kind, std::optional<double> value) {
    if (!value) {
        return {};
    }
    return kind == FieldKind::integer ? FieldValue(static_cast<int>(*value)) : FieldValue(*value);
}

std::optional<double> numberOf(const FieldValue& value) {
    if (const int* whole = std::get_if<int>(&value)) {
        return *whole;
    }
    const double* number = std::get_if<double>(&value);
    return number != nullptr ? std::optional(*number) : std::nullopt;
}

}  // namespace

Form::Form(SceneModel* model, QWidget* parent)
    : QWidget(parent), model_(model), column_(new QVBoxLayout(this)) {
    column_->setContentsMargins(Theme::margin, Theme::margin, Theme::margin, Theme::margin);
    column_->setSpacing(Theme::gap);
    connect(model_, &SceneModel::changed, this, &Form::showAll);
}

FormSection* Form::section(const QString& title) {
    current_ = new FormSection(title, this);
    column_->addWidget(current_);
    return current_;
}

/// As the scene describes it, which of a list describes the first element for all.
FieldEntry Form::entryOf(const std::string& pointer) const {
    static const QRegularExpression place(QStringLiteral("/[0-9]+(?=/)"));
    const QString first = QString::fromStdString(pointer).replace(place, QStringLiteral("/0"));
    FieldEntry entry = model_->describedField(first.toStdString());
    entry.pointer = pointer;
    return entry;
}

void Form::add(const std::string& pointer, QWidget* field, Show show) {
    const auto present = model_->fields(pointer);
    field->setEnabled(!present.empty());
    show(present.empty() ? FieldValue() : present.front().value);
    rows_.push_back({pointer, std::move(show), field});
}

NumberField* Form::number(const char* pointer) {
    NumberField* field = current_->addNumber(model_->describedField(pointer).field);
    bind(field, pointer);
    return field;
}

void Form::bind(NumberField* field, const std::string& pointer) {
    const FieldEntry entry = entryOf(pointer);
    field->setOptional(entry.may_be_empty);
    field->setWhole(entry.kind == FieldKind::integer);
    connect(field, &NumberField::valueEdited, this,
            [this, place = entry.pointer, kind = entry.kind,
             name = fieldName(entry.field)](std::optional<double> value) {
                model_->editField(place, numberValue(kind, value), name);
            });
    field->setModel(model_);
    add(pointer, field, [field, hint = field->placeholderText()](const FieldValue& value) {
        // What a case of this kind has no place for is not empty.
        field->setPlaceholderText(field->isEnabled() ? hint : QStringLiteral("–"));
        field->setValue(numberOf(value));
    });
}

NumberField* Form::number(const Field& description, Read read, Write write) {
    NumberField* field = current_->addNumber(description);
    bind(field, description, std::move(read), std::move(write));
    return field;
}

void Form::bind(NumberField* field, const Field& description, Read read, Write write) {
    bind(
        field,
        [description, read = std::move(read)] {
            const auto si = read();
            return si ? std::optional(from_si(description, *si)) : std::nullopt;
        },
        [unit = description.unit, write = std::move(write)](std::optional<double> value) {
            write(value ? std::optional(*value * unit) : std::nullopt);
        });
}

void Form::bind(NumberField* field, Read read, Write write) {
    connect(field, &NumberField::valueEdited, this, std::move(write));
    field->setModel(model_);
    follow([field, read = std::move(read)] { field->setValue(read()); });
}

QCheckBox* Form::box(const QString& name, const QString& label, const QString& hint,
                     std::function<bool()> read, std::function<void(bool)> write) {
    auto* box = new QCheckBox(label, current_);
    box->setObjectName(name);
    explain(box, hint);
    current_->addWide(box);
    const auto show = [box, read = std::move(read)] { box->setChecked(read()); };
    connect(box, &QCheckBox::clicked, this, [show, write = std::move(write)](bool on) {
        write(on);
        show();
    });
    follow(show);
    return box;
}

QComboBox* Form::choice(const QString& name, const QString& label, const QStringList& words,
                        const QString& hint, std::function<int()> read,
                        std::function<void(int)> write) {
    auto* box = new QComboBox(current_);
    box->setObjectName(name);
    box->addItems(words);
    current_->addWidget(label, box, {}, hint);
    bind(box, std::move(read), std::move(write));
    return box;
}

void Form::bind(QComboBox* box, std::function<int()> read, std::function<void(int)> write) {
    const auto show = [box, read] { box->setCurrentIndex(read()); };
    connect(box, &QComboBox::activated, this, [=, write = std::move(write)](int index) {
        if (index != read()) {
            write(index);
        }
        show();
    });
    follow(show);
}

void Form::bind(QComboBox* box, const std::string& pointer, TroubleLine* trouble, Choose write) {
    const FieldEntry entry = entryOf(pointer);
    if (!write) {
        write = [this, place = entry.pointer, name = fieldName(entry.field)](int value) {
            return model_->editField(place, value, name);
        };
    }
    connect(box, &QComboBox::activated, this,
            [this, box, trouble, write = std::move(write)](int index) {
                const QString why = write(box->itemData(index).toInt());
                if (!why.isEmpty()) {
                    showAll();  // the choice goes back
                }
                if (trouble != nullptr) {
                    trouble->say(why);
                }
            });
    add(pointer, box, [box, trouble](const FieldValue& value) {
        const int* present = std::get_if<int>(&value);
        box->setCurrentIndex(present != nullptr ? box->findData(*present) : -1);
        if (trouble != nullptr) {
            trouble->say({});
        }
    });
}

QComboBox* Form::choice(const char* pointer, Choose write) {
    const FieldEntry entry = model_->describedField(pointer);
    auto* box = new QComboBox(current_);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setObjectName(QString::fromStdString(std::string(entry.field.key)));
    const bool isWhole = entry.kind == FieldKind::integer;
    for (const Word& word : entry.field.words) {
        box->addItem(shownText(word.label), isWhole ? whole_number(word) : box->count());
    }
    current_->addWidget(shownText(entry.field.label), box, {}, fieldHint(entry.field));
    auto* trouble = new TroubleLine(current_);
    trouble->setObjectName(box->objectName() + QStringLiteral("Rejected"));
    current_->addWide(trouble);
    bind(box, pointer, trouble, std::move(write));
    return box;
}

QWidget* Form::flag(const char* pointer) {
    const FieldEntry entry = model_->describedField(pointer);
    auto* box = new QCheckBox(shownText(entry.field.label), current_);
    box->setObjectName(QString::fromStdString(std::string(entry.field.key)));
    explain(box, fieldHint(entry.field));
    box->setAccessibleName(fieldName(entry.field));
    current_->addWide(box);
    connect(box, &QCheckBox::clicked, this,
            [this, place = entry.pointer, name = fieldName(entry.field)](bool on) {
                if (!model_->editField(place, on, name).isEmpty()) {
                    showAll();
                }
            });
    add(pointer, box, [box](const FieldValue& value) {
        const bool* on = std::get_if<bool>(&value);
        box->setChecked(on != nullptr && *on);
    });
    return box;
}

EntryField* Form::text(const char* pointer, int longest) {
    const FieldEntry entry = model_->describedField(pointer);
    auto* field = new TextField(
        [this, place = entry.pointer, name = fieldName(entry.field)](const QString& typed) {
            model_->editField(place, typed.toStdString(), name);
        },
        longest, current_);
    field->setObjectName(QString::fromStdString(std::string(entry.field.key)));
    current_->addWidget(shownText(entry.field.label), field, {}, fieldHint(entry.field));
    field->setModel(model_);
    add(pointer, field, [field](const FieldValue& value) {
        const std::string* words = std::get_if<std::string>(&value);
        field->setValue(words != nullptr ? QString::fromStdString(*words) : QString());
    });
    return field;
}

void Form::follow(std::function<void()> show) {
    show();
    followers_.push_back(std::move(show));
}

void Form::showAll() {
    const auto entries = model_->fields();
    std::erase_if(rows_, [](const Row& row) { return !row.field; });
    for (const Row& row : rows_) {
        const auto present =
            std::find_if(entries.begin(), entries.end(),
                         [&](const FieldEntry& entry) { return entry.pointer == row.pointer; });
        row.field->setEnabled(present != entries.end());
        row.show(present != entries.end() ? present->value : FieldValue());
    }
    for (const auto& show : followers_) {
        show();
    }
}

std::string Form::placeOf(const EntryField* field) const {
    const auto row = std::ranges::find(rows_, field, [](const Row& each) { return each.field; });
    return row != rows_.end() ? row->pointer : std::string();
}

std::vector<std::string> Form::rejectedPlaces() const {
    std::vector<std::string> places;
    for (const auto* field : findChildren<NumberField*>()) {
        const std::string place = placeOf(field);
        if (!field->trouble().isEmpty() && field->isOptional() && !place.empty()) {
            places.push_back(place);
        }
    }
    return places;
}

bool Form::hasRejected() const {
    return std::ranges::any_of(findChildren<EntryField*>(),
                               [](const EntryField* field) { return !field->trouble().isEmpty(); });
}

void showAssumed(Form* form, NumberField* field, std::function<std::optional<double>()> value,
                 int digits) {
    form->follow([=, value = std::move(value), word = field->placeholderText()] {
        const std::optional<double> assumed = value();
        field->setPlaceholderText(assumed && std::isfinite(*assumed)
                                      ? word + QChar::Nbsp +
                                            field->textOf(rounded_to_digits(*assumed, digits))
                                      : word);
    });
}

}  // namespace ravnoves
