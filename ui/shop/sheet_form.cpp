#include "shop/sheet_form.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "case-file/input_error.h"
#include "shop/checked_field.h"
#include "shop/job_header.h"
#include "shop/journal_dialog.h"
#include "text/capital.h"
#include "text/error_text.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "text/shown_units.h"
#include "text/typed_number.h"
#include "theme/theme.h"
#include "widgets/mnemonics.h"

namespace ravnoves {

namespace {

constexpr int numberWidth = 140;
constexpr int textWidth = 290;

}  // namespace

SheetForm::SheetForm(SceneModel* model, QWidget* parent) : Form(model, parent), model_(model) {}

QList<QWidget*> SheetForm::tabOrder() const {
    QList<QWidget*> order = order_;
    for (const auto& rows : grids_) {
        qsizetype at = order.indexOf(rows.constFirst().constFirst());
        for (const auto& row : rows) {
            for (QWidget* field : row) {
                order[at++] = field;
            }
        }
    }
    return order;
}

void SheetForm::addGrid(const QList<QList<QWidget*>>& rows) {
    grids_ << rows;
    for (const auto& row : rows) {
        for (QWidget* field : row) {
            field->installEventFilter(this);
        }
    }
}

bool SheetForm::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress) {
        for (const auto& rows : grids_) {
            if (goInGrid(rows, static_cast<QWidget*>(watched), *static_cast<QKeyEvent*>(event))) {
                return true;
            }
        }
    }
    return Form::eventFilter(watched, event);
}

bool SheetForm::goInGrid(const QList<QList<QWidget*>>& rows, QWidget* from, const QKeyEvent& key) {
    const int down = key.key() == Qt::Key_Down ? 1 : key.key() == Qt::Key_Up ? -1 : 0;
    const int right = key.key() == Qt::Key_Right ? 1 : key.key() == Qt::Key_Left ? -1 : 0;
    if ((down == 0 && right == 0) || (key.modifiers() & ~Qt::KeypadModifier) != 0) {
        return false;
    }
    const auto at = std::find_if(rows.begin(), rows.end(),
                                 [&](const QList<QWidget*>& row) { return row.contains(from); });
    if (at == rows.end()) {
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
    qsizetype row = at - rows.begin();
    qsizetype column = at->indexOf(from);
    do {
        row += down;
        column += right;
        if (row < 0 || row >= rows.size() || column < 0 || column >= rows[row].size()) {
            return down != 0;  // at the edge the sheet does not scroll away
        }
    } while (!rows[row][column]->isEnabled() || !rows[row][column]->isVisible());
    rows[row][column]->setFocus(Qt::TabFocusReason);
    return true;
}

void SheetForm::enlarge(QWidget* field) {
    field->setMinimumHeight(Theme::withText(fieldHeight));
    field->setFont(Theme::font(Theme::titleSize + 1));
}

QComboBox* SheetForm::wide(QComboBox* box, int width) {
    box->setMinimumWidth(Theme::withText(width));
    box->setFont(Theme::font(Theme::baseSize));
    // The list is as wide as its words.
    box->view()->setMinimumWidth(box->view()->sizeHintForColumn(0) + Theme::withText(24));
    return box;
}

NumberField* SheetForm::large(NumberField* field) {
    field->setMaximumWidth(Theme::withText(numberWidth));
    enlarge(field);
    return ordered(field);
}

QComboBox* SheetForm::choice(const char* pointer) {
    QComboBox* box = ordered(Form::choice(pointer));
    enlarge(box);
    return box;
}

void SheetForm::text(const char* pointer, int longest) {
    EntryField* field = ordered(Form::text(pointer, longest));
    field->setIsOfResult(false);
    field->setMinimumWidth(Theme::withText(textWidth));
    enlarge(field);
}

void SheetForm::checked(const Field& description, const CheckedText& text) {
    auto* field = ordered(new CheckedField(
        [text](const QString& typed) {
            return text.normal(typed).isEmpty() ? text.refusal(typed) : QString();
        },
        current()));
    field->setObjectName(QString::fromStdString(std::string(description.key)));
    const QString example = text.normal(shownText(description.placeholder));
    field->setPlaceholderText(text.shown && !example.isEmpty()
                                  ? text.shown(example)
                                  : shownText(description.placeholder));
    enlarge(field);
    field->setHint(fieldHint(description));
    field->setModel(model_);
    field->setIsOfResult(text.isOfResult);
    const QString unit = shownUnit(description).name;
    if (!unit.isEmpty()) {
        field->setMaximumWidth(Theme::withText(numberWidth));  // under the numbers
    }
    current()->addWidget(shownText(description.label), field, unit);
    connect(field, &CheckedField::valueEdited, this,
            [name = fieldName(description), text](const QString& typed) {
                text.write(name, text.normal(typed));
            });
    follow([field, text] {
        // What was typed in another form stays as it was typed.
        const QString value = text.read();
        if (text.normal(field->value()) != value) {
            field->setValue(text.shown ? text.shown(value) : value);
        }
    });
}

void SheetForm::addJob() {
    section(tr("Job"));
    text("/job/engine_number");
    text("/job/crankshaft_number");
    text("/job/customer");
    static const std::string date = "/job/date";
    checked(shop::field::date,
            {[](const QString& typed) { return readDay(typed).toString(Qt::ISODate); }, dayTrouble,
             [this] {
                 return QString::fromStdString(
                     std::get<std::string>(model_->fields(date).front().value));
             },
             [this](const QString& name, const QString& day) {
                 model_->editField(date, day.toStdString(), name);
             },
             [](const QString& day) { return Words().day(day); }, false});
    text("/job/technician");
}

void SheetForm::numberList(const Field& description, std::function<std::vector<double>()> read,
                           std::function<void(const QString&, const std::vector<double>&)> write) {
    const auto trouble = [&description](const QString& typed) {
        try {
            readNumberList(typed, description, {});
            return QString();
        } catch (const InputError& error) {
            return capitalised(errorText(error));  // the field's name stands before it
        }
    };
    const auto normal = [&description, trouble](const QString& typed) {
        return trouble(typed).isEmpty()
                   ? numberListText(readNumberList(typed, description), description)
                   : QString();
    };
    checked(description,
            {normal, trouble, [&description, read] { return numberListText(read(), description); },
             [&description, write = std::move(write)](const QString& name, const QString& typed) {
                 write(name, readNumberList(typed, description));
             }});
    // "12, 5" is two numbers and "10,12" one, and either may have been meant as the other.
    QLabel* understood = line(Theme::smallSize, [&description, read] {
        const std::vector<double> values = read();
        const QString read =
            numberListText(values, description) + QLatin1Char(' ') + shownUnit(description).name;
        return values.empty()       ? QString()
               : values.size() == 1 ? tr("Read as one: %1").arg(read)
                                    : tr("Read as %1: %2").arg(values.size()).arg(read);
    });
    understood->setObjectName(QString::fromStdString(std::string(description.key) + "_understood"));
    understood->setTextInteractionFlags(Qt::NoTextInteraction);  // of the form: no report has it
}

QLabel* SheetForm::line(int pixelSize, std::function<QString()> text) {
    QLabel* label = copyableLabel("", pixelSize, current());
    current()->addWide(label);
    follow([label, text = std::move(text)] { sayOrHide(label, text()); });
    return label;
}

void SheetForm::addHold(std::function<QString()> why, std::function<void()> hold,
                        const QList<NumberField*>& readings) {
    QLabel* said = line(Theme::baseSize, why);
    said->setObjectName(QStringLiteral("other_bob_weight"));
    colourText(said, &Theme::warning);
    auto* button = new QPushButton(tr("Readings &hold"), current());
    button->setObjectName(QStringLiteral("readings_hold"));
    button->setToolTip(tr("They are of this crankshaft, with the bob weight that there is now."));
    button->setMinimumHeight(Theme::withText(fieldHeight));
    current()->addWide(button);
    connect(button, &QPushButton::clicked, this, [button, readings, hold = std::move(hold)] {
        // The button goes with what it says: under the focus it would hand it on to what follows,
        // and the sheet would scroll there.
        const auto next = std::find_if(
            readings.begin(), readings.end(),
            [](const NumberField* reading) { return reading->isVisible() && !reading->value(); });
        (next == readings.end() ? readings.first() : *next)->setFocus(Qt::OtherFocusReason);
        hold();
        if (button->isVisible()) {
            button->setFocus(Qt::OtherFocusReason);  // there are others that do not hold
        }
    });
    isDoubted_ = [why = std::move(why)] { return !why().isEmpty(); };
    follow([this, button] { button->setVisible(isDoubted_()); });
}

void SheetForm::doubt(EntryField* field, std::function<bool()> isDoubtful) {
    follow([field, isDoubtful = std::move(isDoubtful)] { field->setDoubtful(isDoubtful()); });
}

void SheetForm::finish() {
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

}  // namespace ravnoves
