#include "workshop/workshop_sheet.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "case-file/input_error.h"
#include "text/capital.h"
#include "text/error_text.h"
#include "text/message_text.h"
#include "text/shown_units.h"
#include "theme/theme.h"
#include "v8-plugs/fields.h"
#include "widgets/mnemonics.h"

namespace ravnoves {

namespace {

constexpr int numberWidth = 140;
constexpr int textFieldWidth = 290;

/// A field for text that must have a form (a date, a thread); it may be empty.
class CheckedField final : public ValueEntry<QString> {
  public:
    using Check = std::function<QString(const QString& text)>;
    /// @param check  the fault of a text; empty without one
    CheckedField(Check check, std::function<void(const QString& text)> passOn, QWidget* parent)
        : ValueEntry(parent), check_(std::move(check)), passOn_(std::move(passOn)) {}

  protected:
    Reading read(const QString& typed) const override {
        return {typed, typed.isEmpty() ? QString() : check_(typed)};
    }
    QString written() const override { return value(); }
    void passOn() override { passOn_(value()); }

  private:
    Check check_;
    std::function<void(const QString& text)> passOn_;
};

}  // namespace

WorkshopSheet::WorkshopSheet(WorkshopModel* model, QWidget* parent)
    : Form(model, parent), model_(model) {}

std::optional<std::pair<int, int>> WorkshopSheet::placeIn(const QGridLayout& grid,
                                                          QWidget* widget) {
    int row = 0;
    int column = 0;
    int rows = 0;
    int columns = 0;
    const int at = grid.indexOf(widget);
    grid.getItemPosition(at, &row, &column, &rows, &columns);
    return at < 0 ? std::nullopt : std::optional(std::pair(row, column));
}

void WorkshopSheet::followArrows(QGridLayout* grid) {
    grids_ << grid;
    for (int i = 0; i < grid->count(); ++i) {
        grid->itemAt(i)->widget()->installEventFilter(this);
    }
}

bool WorkshopSheet::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress) {
        for (const QGridLayout* grid : grids_) {
            if (goInGrid(*grid, static_cast<QWidget*>(watched), *static_cast<QKeyEvent*>(event))) {
                return true;
            }
        }
    }
    return Form::eventFilter(watched, event);
}

bool WorkshopSheet::goInGrid(const QGridLayout& grid, QWidget* from, const QKeyEvent& key) {
    const int down = key.key() == Qt::Key_Down ? 1 : key.key() == Qt::Key_Up ? -1 : 0;
    const int right = key.key() == Qt::Key_Right ? 1 : key.key() == Qt::Key_Left ? -1 : 0;
    const auto at = placeIn(grid, from);
    if (!at || (down == 0 && right == 0) || (key.modifiers() & ~Qt::KeypadModifier) != 0) {
        return false;
    }
    if (const auto* entry = qobject_cast<const EntryField*>(from); right != 0 && entry != nullptr) {
        // Within what is typed the cursor moves.
        const bool isWhole = !entry->isEditing() && entry->selectedText() == entry->text();
        const qsizetype end = right < 0 ? 0 : entry->text().size();
        if (!isWhole && (entry->hasSelectedText() || entry->cursorPosition() != end)) {
            return false;
        }
    }
    auto [row, column] = *at;
    QWidget* next = nullptr;
    do {
        row += down;
        column += right;
        const QLayoutItem* item = grid.itemAtPosition(row, column);
        next = item != nullptr ? item->widget() : nullptr;
        if (qobject_cast<QLabel*>(next) != nullptr) {
            next = nullptr;
        }
    } while (next != nullptr && (!next->isEnabled() || !next->isVisible()));
    if (next == nullptr) {
        return down != 0;  // at the edge the sheet does not scroll away
    }
    next->setFocus(Qt::TabFocusReason);
    return true;
}

void WorkshopSheet::enlarge(QWidget* field) {
    field->setMinimumHeight(Theme::withText(fieldHeight));
    field->setFont(Theme::font(Theme::titleSize + 1));
}

QComboBox* WorkshopSheet::wide(QComboBox* box, int width) {
    box->setMinimumWidth(Theme::withText(width));
    box->setFont(Theme::font(Theme::baseSize));
    // The list is as wide as its words.
    box->view()->setMinimumWidth(box->view()->sizeHintForColumn(0) + Theme::withText(24));
    return box;
}

NumberField* WorkshopSheet::large(NumberField* field) {
    field->setMaximumWidth(Theme::withText(numberWidth));
    enlarge(field);
    field->setSaysHowRead(true);
    return ordered(field);
}

void WorkshopSheet::showWhile(QWidget* widget, std::function<bool()> isShown) {
    follow([widget, isShown = std::move(isShown)] { widget->setVisible(isShown()); });
}

void WorkshopSheet::enableWhile(QWidget* widget, std::function<bool()> isEnabled) {
    follow([widget, isEnabled = std::move(isEnabled)] { widget->setEnabled(isEnabled()); });
}

void WorkshopSheet::text(const char* pointer, int longest) {
    EntryField* field = ordered(Form::text(pointer, longest));
    field->setIsOfResult(false);
    field->setMinimumWidth(Theme::withText(textFieldWidth));
    enlarge(field);
}

EntryField* WorkshopSheet::checked(const Field& description, const CheckedText& text) {
    auto* field = ordered(new CheckedField(
        [text](const QString& typed) {
            return text.normal(typed).isEmpty() ? text.rejection(typed) : QString();
        },
        [name = fieldName(description), text](const QString& typed) {
            text.write(name, text.normal(typed));
        },
        current()));
    field->setObjectName(QString::fromStdString(std::string(description.key)));
    const QString example = text.normal(shownText(description.placeholder));
    field->setPlaceholderText(text.shown && !example.isEmpty()
                                  ? text.shown(example)
                                  : shownText(description.placeholder));
    enlarge(field);
    field->setLabel(description.label);
    field->setHint(fieldHint(description));
    field->setModel(model_);
    field->setIsOfResult(text.isOfResult);
    const QString unit = shownUnit(description).name;
    if (!unit.isEmpty()) {
        field->setMaximumWidth(Theme::withText(numberWidth));  // under the numbers
    }
    current()->addWidget(shownText(description.label), field, unit);
    follow([field, text] {
        // What was typed in another form stays as it was typed.
        const QString value = text.read();
        if (text.normal(field->value()) != value) {
            field->setValue(text.shown ? text.shown(value) : value);
        }
    });
    return field;
}

void WorkshopSheet::numberList(
    const Field& description, const std::function<std::vector<double>()>& read,
    std::function<void(const QString&, const std::vector<double>&)> write,
    bool (*isUsual)(double si)) {
    const auto numbers = [&description, isUsual](const QString& typed) {
        return readNumberList(typed, description, {}, isUsual);
    };
    const auto trouble = [numbers](const QString& typed) {
        try {
            numbers(typed);
            return QString();
        } catch (const InputError& error) {
            return capitalised(errorText(error));  // the field's name stands before it
        }
    };
    EntryField* field =
        checked(description,
                {[&description, numbers, trouble](const QString& typed) {
                     return trouble(typed).isEmpty() ? numberListText(numbers(typed), description)
                                                     : QString();
                 },
                 trouble, [&description, read] { return numberListText(read(), description); },
                 [numbers, write = std::move(write)](const QString& name, const QString& typed) {
                     write(name, numbers(typed));
                 }});
    // "12, 5" is two numbers and "10,12" one, and either may have been meant as the other.
    QLabel* understood = line(Theme::smallSize, [&description, read, field] {
        const auto values = field->trouble().isEmpty() ? read() : std::vector<double>();
        const QString read =
            numberListText(values, description) + QLatin1Char(' ') + shownUnit(description).name;
        return values.empty()       ? QString()
               : values.size() == 1 ? tr("Read as one value: %1").arg(read)
                                    : tr("Read as %1: %2").arg(values.size()).arg(read);
    });
    understood->setObjectName(QString::fromStdString(std::string(description.key) + "_understood"));
    connect(field, &EntryField::troubleChanged, this, &WorkshopSheet::showAll);
}

QLabel* WorkshopSheet::line(int pixelSize, std::function<QString()> text) {
    QLabel* label = copyableLabel("", pixelSize, current());
    current()->addWide(label);
    follow([label, text = std::move(text)] { showOrHide(label, text()); });
    return label;
}

void WorkshopSheet::doubt(EntryField* field, std::function<bool()> isDoubtful) {
    follow([field, isDoubtful = std::move(isDoubtful)] { field->setDoubtful(isDoubtful()); });
}

void WorkshopSheet::doubt(EntryField* field, std::string_view word) {
    doubt(field, [this, word] {
        const auto& doubts = model_->doubts();
        return std::any_of(doubts.begin(), doubts.end(),
                           [&](const workshop::Doubt& each) { return each.rule->word == word; });
    });
}

void WorkshopSheet::plugsSection(bool there, const QString& title) {
    showWhile(section(title), [this, there] { return model_->hasPlugs() == there; });
}

void WorkshopSheet::engineValues(v8_plugs::EngineGroup group) {
    for (const v8_plugs::EngineField& each : v8_plugs::engine_fields()) {
        if (each.group == group) {
            number(("/plugs/engine/" + std::string(each.field.key)).c_str());
        }
    }
}

QPushButton* WorkshopSheet::button(const char* name, const QString& label, const QString& tip,
                                   std::function<void()> press) {
    QPushButton* made = largeButton(name, label, current());
    made->setToolTip(tip);
    current()->addWide(made);
    connect(made, &QPushButton::clicked, this, std::move(press));
    return made;
}

std::pair<QGridLayout*, TroubleLine*> WorkshopSheet::grid(const QStringList& headings) {
    auto* holder = new QWidget(current());
    auto* made = new QGridLayout(holder);
    made->setContentsMargins(0, 0, 0, 0);
    made->setHorizontalSpacing(Theme::gap);
    made->setVerticalSpacing(Theme::gap);
    current()->addWide(holder);
    auto* trouble = new TroubleLine(current());
    current()->addWide(trouble);
    for (int column = 0; column < headings.size(); ++column) {
        auto* heading = new QLabel(headings.at(column), holder);
        heading->setFont(Theme::font(Theme::smallSize, true));
        heading->setAlignment(Qt::AlignCenter);
        heading->setWordWrap(true);
        made->addWidget(heading, 0, column);
        made->setColumnStretch(column, column == 0 ? 0 : 1);
    }
    return {made, trouble};
}

NumberField* WorkshopSheet::cell(const Field& field, const QString& key, const Name& name,
                                 const Place& place) {
    auto* made = new NumberField(field, current());
    made->setObjectName(key);
    made->setOptional(true);
    made->setSaysHowRead(true);
    enlarge(made);
    makeCell(made);
    named_[made] = {name, place};
    follow([made, name] {
        const QString spoken = titleWithUnit(name({}), made->unit());
        if (made->accessibleName() != spoken) {
            made->setAccessibleName(spoken);
        }
    });
    return made;
}

QString WorkshopSheet::nameIn(const Words& words, const EntryField& field) const {
    const auto cell = named_.find(&field);
    return cell != named_.end() ? cell->second.first(words)
                                : words.text(field.label()).remove(QLatin1Char('&'));
}

std::string WorkshopSheet::placeOf(const EntryField* field) const {
    const auto cell = named_.find(field);
    return cell == named_.end()  ? Form::placeOf(field)
           : cell->second.second ? cell->second.second()
                                 : std::string();
}

void WorkshopSheet::finish() {
    column()->addStretch();
    QString used;
    const auto take = [&used](const QString& text) {
        const qsizetype at = text.indexOf(QLatin1Char('&'));
        used += at < 0 ? QString() : text.mid(at + 1, 1).toLower();
    };
    for (const QAbstractButton* button : findChildren<QAbstractButton*>()) {
        take(button->text());
    }
    QList<QLabel*> without;
    for (QLabel* label : findChildren<QLabel*>()) {
        if (label->buddy() != nullptr) {
            take(label->text());
            if (!label->text().contains(QLatin1Char('&'))) {
                without << label;
            }
        }
    }
    for (QLabel* label : without) {
        label->setText(withMnemonic(label->text(), used));
    }
}

QPushButton* largeButton(const char* name, const QString& text, QWidget* parent, int height) {
    auto* made = new QPushButton(text, parent);
    made->setObjectName(QLatin1String(name));
    made->setMinimumHeight(Theme::withText(height));
    return made;
}

}  // namespace ravnoves
