#include "v8-plugs/weigh_in_sheet.h"

#include <QCheckBox>
#include <QClipboard>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "text/message_text.h"
#include "text/number_text.h"
#include "theme/theme.h"
#include "v8-plugs/fields.h"
#include "v8-plugs/model/v8_names.h"
#include "widgets/result_table.h"

namespace ravnoves {

using namespace v8_plugs;

namespace {

constexpr int cellHeight = 30;  // all of the sheet has to be seen on 800 lines

QVBoxLayout* columnOf(QWidget* sheet) {
    return static_cast<QVBoxLayout*>(sheet->layout());
}

const Field& fieldOf(int row) {
    return row == 0 ? field::nominal : row == 1 ? field::permitted_spread : field::part_mass;
}

template <typename Column>
auto& valueOf(Column& column, int row) {
    return row == 0   ? column.nominal
           : row == 1 ? column.permitted_spread
                      : column.mass[static_cast<std::size_t>(row - 2)];
}

WeighIn& weighIn(Input& input) {
    return input.weigh_in ? *input.weigh_in : input.weigh_in.emplace();
}

/// The rows of a block, each with its cells; without a first row that has no number in it.
QList<QStringList> cellsOf(const QString& text) {
    QList<QStringList> rows;
    for (QString line : text.split(QLatin1Char('\n'))) {
        line.remove(QLatin1Char('\r'));
        const QStringList cells = line.split(QLatin1Char('\t'));
        const bool heading = rows.isEmpty() && !line.trimmed().isEmpty() &&
                             std::none_of(cells.cbegin(), cells.cend(), [](const QString& cell) {
                                 return readFormNumber(cell).has_value();
                             });
        if (!heading) {
            rows << cells;
        }
    }
    while (!rows.isEmpty() && rows.constLast().join(QString()).trimmed().isEmpty()) {
        rows.removeLast();
    }
    return rows;
}

}  // namespace

WeighInSheet::WeighInSheet(V8PlugsModel* model, QWidget* parent) : SheetForm(model, parent) {
    columnOf(this)->setSpacing(Theme::space);
    section({});
    use_ = ordered(new QCheckBox(tr("Take the mass changes &from this sheet"), this));
    use_->setObjectName(QStringLiteral("changes_from_weigh_in"));
    use_->setToolTip(shownText(field::changes_source.hint));
    current()->addWide(use_);
    connect(use_, &QCheckBox::toggled, this, [this](bool on) {
        model_->edit(fieldName(field::changes_source), [&](Input& input) {
            weighIn(input);
            input.changes_from_weigh_in = on;
        });
    });
    QComboBox* numbering = choice("/weigh_in/cylinder_numbering");
    numbering->setMinimumHeight(cellHeight);
    numbering->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    numbering->setMinimumContentsLength(10);  // the grid below says how wide the sheet is
    buildGrid();
    buildFindings();
    connect(&Theme::instance(), &Theme::changed, this, &WeighInSheet::showInput);
    follow([this] { showInput(); });
    finish();
}

void WeighInSheet::buildGrid() {
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(Theme::gap);
    grid->setVerticalSpacing(2);
    grid->setColumnMinimumWidth(0, 58);
    constexpr int meanRow = 1 + rowCount;
    const auto put = [&](int row, int column, const QString& text, int size, bool bold = false) {
        auto* label = new QLabel(text, this);
        label->setFont(Theme::font(size, bold));
        label->setWordWrap(column == 0 || row == 0);
        label->setAlignment(row == 0 ? Qt::AlignCenter : Qt::AlignRight | Qt::AlignVCenter);
        grid->addWidget(label, row, column);
        return label;
    };
    put(1, 0, tr("nominal, g"), Theme::smallSize);
    put(2, 0, tr("permitted spread, g"), Theme::smallSize);
    for (int cylinder = 1; cylinder <= cylinder_count; ++cylinder) {
        put(firstCylinder + cylinder, 0, QString::number(cylinder), Theme::titleSize);
    }
    put(meanRow, 0, tr("mean, g"), Theme::smallSize);
    put(meanRow + 1, 0, tr("to nominal, g"), Theme::smallSize);
    put(meanRow + 2, 0, tr("spread, g"), Theme::smallSize);
    trouble_ = new TroubleLine(this);
    int place = 1;
    for (const Part part : all_parts) {
        put(0, place, v8_text::partName(Words(), part), Theme::smallSize, true);
        grid->setColumnStretch(place, 1);
        Column column{};
        for (int row = 0; row < rowCount; ++row) {
            column.cells[static_cast<std::size_t>(row)] = addCell(part, row);
            grid->addWidget(column.cells[static_cast<std::size_t>(row)], row + 1, place);
        }
        column.mean = put(meanRow, place, {}, Theme::baseSize);
        column.deviation = put(meanRow + 1, place, {}, Theme::baseSize);
        column.spread = put(meanRow + 2, place, {}, Theme::baseSize);
        columns_.push_back(column);
        ++place;
    }
    columnOf(this)->addLayout(grid);
    columnOf(this)->addWidget(trouble_);
}

NumberField* WeighInSheet::addCell(Part part, int row) {
    const std::string_view word = part_word(part).word;
    const QString key = QString::fromUtf8(word.data(), static_cast<qsizetype>(word.size()));
    const QString name = v8_text::partName(Words(), part);
    auto* field = ordered(new NumberField(fieldOf(row), this));
    QString step;
    if (row == 0) {
        field->setObjectName(QStringLiteral("nominal_") + key);
        field->setAccessibleName(tr("%1, nominal mass, g").arg(name));
        field->setHint(tr("%1: mass by the drawing.").arg(name));
        step = tr("%1, nominal").arg(name);
    } else if (row == 1) {
        field->setObjectName(QStringLiteral("spread_") + key);
        field->setAccessibleName(tr("%1, permitted spread, g").arg(name));
        field->setHint(tr("%1: heaviest less lightest that the works manual permits. "
                          "Empty: no limit.")
                           .arg(name));
        step = tr("%1, spread").arg(name);
    } else {
        const int cylinder = row - firstCylinder + 1;
        field->setObjectName(QStringLiteral("mass_%1_%2").arg(key).arg(cylinder));
        field->setAccessibleName(tr("%1 of cylinder %2, g").arg(name).arg(cylinder));
        field->setHint(tr("%1 of cylinder %2 as the scale says.").arg(name).arg(cylinder));
        step = tr("%1 %2").arg(name).arg(cylinder);
    }
    field->setOptional(true);
    field->setMinimumWidth(44);
    field->setMinimumHeight(cellHeight);
    field->setFont(Theme::font(Theme::titleSize));
    field->installEventFilter(this);
    connect(field, &NumberField::valueEdited, this,
            [this, part, row, step](std::optional<double> value) {
                model_->edit(step, [&](Input& input) {
                    valueOf(weighIn(input)[part], row) =
                        value ? std::optional(*value * units::gram) : std::nullopt;
                });
            });
    field->setModel(model_);
    makeCell(field);
    trouble_->watch(field);
    return field;
}

void WeighInSheet::buildFindings() {
    summary_ = new QLabel(this);
    summary_->setWordWrap(true);
    summary_->setFont(Theme::font(Theme::baseSize, true));
    move_ = new QPushButton(tr("&Move them here"), this);
    move_->setObjectName(QStringLiteral("move_parts"));
    move_->setToolTip(tr("The weights change places on this sheet as the parts do."));
    move_->setMinimumHeight(cellHeight);
    connect(move_, &QPushButton::clicked, this, [this] {
        if (const auto assignment = model_->solution().assignment) {
            model_->edit(tr("Move parts"), [&](Input& input) {
                input.weigh_in = reassigned(input.weigh_in.value(), *assignment);
            });
        }
    });
    auto* found = new QHBoxLayout;
    found->addWidget(summary_, 1);
    found->addWidget(move_, 0, Qt::AlignTop);
    columnOf(this)->addLayout(found);
    const auto table = [this](const QString& name, const QStringList& columns) {
        auto* made = new ResultTable(this);
        made->setAccessibleName(name);
        made->setColumns(columns);
        made->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        columnOf(this)->addWidget(made);
        return made;
    };
    crankpins_ = table(tr("Excess on each crankpin, as weighed and after moving"),
                       model_->crankpinColumns());
    assignment_ = table(tr("Which set goes to which cylinder"), model_->assignmentColumns());
}

bool WeighInSheet::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress) {
        for (std::size_t column = 0; column < columns_.size(); ++column) {
            const auto& cells = columns_[column].cells;
            const auto cell = std::find(cells.begin(), cells.end(), watched);
            if (cell != cells.end()) {
                return useKey(*static_cast<QKeyEvent*>(event), column,
                              static_cast<std::size_t>(cell - cells.begin()));
            }
        }
    }
    return SheetForm::eventFilter(watched, event);
}

bool WeighInSheet::useKey(const QKeyEvent& key, std::size_t column, std::size_t row) {
    const auto& cells = columns_[column].cells;
    if (key.matches(QKeySequence::Paste)) {
        const QString text = QGuiApplication::clipboard()->text();
        const bool isBlock = text.contains(QLatin1Char('\n')) || text.contains(QLatin1Char('\t'));
        if (isBlock) {
            pasteBlock(text, static_cast<int>(column), static_cast<int>(row));
        }
        return isBlock;
    }
    const bool down = key.key() == Qt::Key_Down;
    if (!down && key.key() != Qt::Key_Up) {
        return false;
    }
    if (down ? row + 1 < cells.size() : row > 0) {
        cells[down ? row + 1 : row - 1]->setFocus(Qt::TabFocusReason);
    }
    return true;
}

void WeighInSheet::pasteBlock(const QString& text, int column, int row) {
    WeighIn sheet = model_->input().weigh_in.value_or(WeighIn{});
    const QList<QStringList> rows = cellsOf(text);
    if (rows.isEmpty()) {
        trouble_->say(tr("Nothing is pasted: “%1” is no mass in grams.").arg(text.simplified()));
        return;
    }
    for (qsizetype i = 0; i < rows.size(); ++i) {
        for (qsizetype j = 0; j < rows.at(i).size(); ++j) {
            const QString typed = rows.at(i).at(j).trimmed();
            const auto value = readFormNumber(typed);
            const auto to = static_cast<std::size_t>(column + j);
            const int at = row + static_cast<int>(i);
            if (typed.isEmpty()) {
                continue;  // a gap leaves what is there
            }
            if (to >= all_parts.size() || at >= rowCount) {
                trouble_->say(
                    tr("Nothing is pasted: the block does not fit on the sheet from here."));
                return;
            }
            if (!value || !fieldOf(at).range.contains(*value)) {
                trouble_->say(tr("Nothing is pasted: “%1” is no mass in grams.").arg(typed));
                return;
            }
            valueOf(sheet[all_parts[to]], at) = *value * units::gram;
        }
    }
    trouble_->say({});
    model_->edit(tr("Paste weights"), [&](Input& input) { input.weigh_in = sheet; });
}

void WeighInSheet::showInput() {
    const Input& input = model_->input();
    const QSignalBlocker block(use_);
    use_->setChecked(input.changes_from_weigh_in);
    const WeighIn sheet = input.weigh_in.value_or(WeighIn{});
    const Theme& theme = Theme::instance();
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        const PartColumn& column = sheet[all_parts[i]];
        const Column& shown = columns_[i];
        for (int row = 0; row < rowCount; ++row) {
            const auto& mass = valueOf(column, row);
            shown.cells[static_cast<std::size_t>(row)]->setValue(
                mass ? std::optional(from_si(fieldOf(row), *mass)) : std::nullopt);
        }
        const auto note = model_->columnNote(all_parts[i]);
        shown.mean->setText(note.mean);
        shown.deviation->setText(note.deviation);
        shown.spread->setText(note.tooWide ? note.spread + QStringLiteral(" !") : note.spread);
        colourText(shown.spread, note.tooWide ? theme.error() : theme.text());
        for (QLabel* label : {shown.mean, shown.deviation, shown.spread}) {
            label->setToolTip(note.toolTip);
        }
    }
    QStringList summary = model_->weighInGaps();
    summary << model_->assignmentText();
    summary.removeAll(QString());
    summary_->setText(summary.join(QLatin1Char('\n')));
    move_->setVisible(model_->solution().assignment && model_->solution().assignment->moved > 0);
    const auto assignment = model_->assignmentRows();
    assignment_->setRows(assignment);
    assignment_->setVisible(!assignment.isEmpty());
    crankpins_->setRows(model_->crankpinRows());
    crankpins_->setVisible(!assignment.isEmpty());
}

}  // namespace ravnoves
