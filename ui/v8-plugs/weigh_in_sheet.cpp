#include "v8-plugs/weigh_in_sheet.h"

#include <QCheckBox>
#include <QClipboard>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

#include "text/message_text.h"
#include "text/shown_units.h"
#include "theme/theme.h"
#include "v8-plugs/fields.h"
#include "widgets/result_table.h"

namespace ravnoves {

using namespace v8_plugs;

namespace {

constexpr int cellHeight = 30;  // all of the sheet has to be seen on 800 lines
constexpr int rows = WeighInTable::rows;
constexpr int titleColumn = 73;  // the longest word of its titles, in Russian

QVBoxLayout* columnOf(QWidget* sheet) {
    return static_cast<QVBoxLayout*>(sheet->layout());
}

/// A label of the grid; those above and to the left of the cells wrap.
QLabel* put(QGridLayout* grid, int row, int column, const QString& text, int size,
            bool bold = false) {
    // A unit stays with the word before it.
    const QString whole = QString(text).replace(QStringLiteral(", "), QStringLiteral(",\u00A0"));
    auto* label = new QLabel(column == 0 ? whole : text);
    label->setFont(Theme::font(size, bold));
    label->setWordWrap(column == 0 || row == 0);
    if (column == 0) {
        label->setMaximumWidth(Theme::withText(titleColumn));  // the numbers need the room
    }
    label->setAlignment(row == 0 ? Qt::AlignCenter : Qt::AlignRight | Qt::AlignVCenter);
    grid->addWidget(label, row, column);
    return label;
}

}  // namespace

WeighInSheet::WeighInSheet(V8PlugsModel* model, QWidget* parent)
    : MatchingSheet(
          model,
          [model] {
              const auto& sheet = model->input().weigh_in;
              return sheet ? sheet->matching : Rules();
          },
          [model](const QString& name, const std::function<void(Rules&)>& change) {
              model->editWeights(name, [&](WeighIn& sheet) { change(sheet.matching); });
          },
          [model] {
              const auto& sheet = model->input().weigh_in;
              return sheet && sheet->is_moved();
          },
          parent),
      model_(model),
      table_(new WeighInTable(model, this)) {
    columnOf(this)->setSpacing(Theme::space);
    section({});
    ordered(box(
        QStringLiteral("changes_from_weigh_in"), tr("Take the mass changes &from this sheet"),
        shownText(field::changes_source.hint),
        [this] { return model_->input().changes_from_weigh_in; },
        [this](bool on) {
            model_->edit(fieldName(field::changes_source), [&](Input& input) {
                input.changes_from_weigh_in = on;
                if (!input.weigh_in) {
                    input.weigh_in.emplace();
                }
            });
        }));
    QComboBox* numbering = choice("/weigh_in/cylinder_numbering");
    numbering->setMinimumHeight(Theme::withText(cellHeight));
    numbering->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    buildGrid();
    addGoal(false);
    buildFindings();
    finish();
}

void WeighInSheet::buildGrid() {
    auto* grid = new QGridLayout;
    columnOf(this)->addLayout(grid);
    grid->setHorizontalSpacing(Theme::gap / 2);  // "1568.52" is seen whole
    grid->setVerticalSpacing(2);
    grid->setColumnMinimumWidth(0, Theme::withText(50));
    for (int row = 0; row < rows; ++row) {
        put(grid, row + 1, 0, table_->headerData(row, Qt::Vertical, Qt::DisplayRole).toString(),
            row < WeighInTable::firstCylinder ? Theme::smallSize : Theme::titleSize);
    }
    put(grid, rows + 1, 0, shownTitle(tr("mean, g")).text, Theme::smallSize);
    put(grid, rows + 2, 0, shownTitle(tr("to nominal, g")).text, Theme::smallSize);
    put(grid, rows + 3, 0, shownTitle(tr("spread, g")).text, Theme::smallSize);
    trouble_ = new TroubleLine(this);
    for (int column = 0; column < table_->columnCount(); ++column) {
        addColumn(grid, column);
    }
    addMoves(grid, rows + 4);
    columnOf(this)->addWidget(trouble_);
}

void WeighInSheet::addColumn(QGridLayout* grid, int column) {
    const int place = column + 1;
    put(grid, 0, place, table_->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString(),
        Theme::smallSize, true);
    grid->setColumnStretch(place, 1);
    for (int row = 0; row < rows; ++row) {
        grid->addWidget(addCell(row, column), row + 1, place);
    }
    QLabel* mean = put(grid, rows + 1, place, {}, Theme::baseSize);
    QLabel* deviation = put(grid, rows + 2, place, {}, Theme::baseSize);
    QLabel* spread = put(grid, rows + 3, place, {}, Theme::baseSize);
    const auto show = [=, this, part = all_parts[static_cast<std::size_t>(column)]] {
        const auto note = model_->columnNote(part);
        const Theme& theme = Theme::instance();
        mean->setText(note.mean);
        deviation->setText(note.deviation);
        spread->setText(note.tooWide ? note.spread + QStringLiteral(" !") : note.spread);
        colourText(mean, note.counts ? theme.text() : theme.warning());
        colourText(deviation, note.counts ? theme.text() : theme.warning());
        colourText(spread, note.tooWide ? theme.error() : theme.text());
        for (QLabel* label : {mean, deviation, spread}) {
            label->setToolTip(note.toolTip);
        }
    };
    connect(&Theme::instance(), &Theme::changed, this, show);
    follow(show);
}

NumberField* WeighInSheet::addCell(int row, int column) {
    const QPersistentModelIndex cell = table_->index(row, column);
    auto* field = ordered(new NumberField(WeighInTable::fieldOf(row), this));
    field->setObjectName(cell.data(WeighInTable::KeyRole).toString());
    field->setAccessibleName(cell.data(Qt::AccessibleTextRole).toString());
    field->setHint(cell.data(Qt::ToolTipRole).toString());
    field->setOptional(true);
    field->setMinimumWidth(Theme::withText(44));
    field->setMinimumHeight(Theme::withText(cellHeight));
    field->setFont(Theme::font(Theme::baseSize));
    field->setTextMargins(-1, 0, -1, 0);  // "1568.52" is seen whole
    field->setProperty("decimals", 2 + shownUnit(WeighInTable::fieldOf(row).unit).decimals);
    field->installEventFilter(this);
    bind(
        field,
        [cell] {
            const QVariant mass = cell.data(Qt::EditRole);
            return mass.isValid() ? std::optional(mass.toDouble()) : std::nullopt;
        },
        [this, cell](std::optional<double> value) {
            table_->setData(cell, value ? QVariant(*value) : QVariant());
        });
    makeCell(field);
    trouble_->watch(field);
    cells_.push_back(field);
    return field;
}

void WeighInSheet::buildFindings() {
    addFindings([this] { return findings(); }, [this] { model_->moveParts(); },
                [this] { model_->moveBack(); });
    crankpins_ = new ResultTable(this);
    crankpins_->setAccessibleName(tr("Excess on each crankpin, as weighed and after moving"));
    crankpins_->setColumns(model_->crankpinColumns());
    crankpins_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    columnOf(this)->addWidget(crankpins_);
    follow([this] {
        crankpins_->setEnabled(!model_->isSearching());
        if (model_->isSearching()) {
            return;
        }
        const auto rows = model_->crankpinRows();
        crankpins_->setRows(rows);
        crankpins_->setVisible(!rows.isEmpty());
    });
}

MatchingSheet::Findings WeighInSheet::findings() const {
    const QStringList gaps = model_->notCounted();
    QStringList summary = gaps;
    summary << model_->assignmentText() << model_->assignmentRemarks();
    summary.removeAll(QString());
    const auto& assignment = model_->solution().assignment;
    return {summary.join(QLatin1Char('\n')),
            !gaps.isEmpty() || (assignment && !assignment->remark.empty()),
            assignment && assignment->moved > 0,
            model_->isSearching(),
            model_->effectRows(),
            model_->assignmentRows(),
            model_->takeOffRows(),
            cylinder_count};
}

bool WeighInSheet::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress) {
        const auto found = std::find(cells_.begin(), cells_.end(), watched);
        if (found != cells_.end()) {
            const auto place = static_cast<int>(found - cells_.begin());
            return useKey(*static_cast<QKeyEvent*>(event),
                          table_->index(place % rows, place / rows));
        }
    }
    return SheetForm::eventFilter(watched, event);
}

bool WeighInSheet::useKey(const QKeyEvent& key, const QModelIndex& cell) {
    if (key.matches(QKeySequence::Paste)) {
        const QString text = QGuiApplication::clipboard()->text();
        const bool isBlock = text.contains(QLatin1Char('\n')) || text.contains(QLatin1Char('\t'));
        if (isBlock) {
            trouble_->say(
                table_->pasteBlock(cell.row(), cell.column(), readTextTable(text, EmptyLine::gap)));
        }
        return isBlock;
    }
    const int step = key.key() == Qt::Key_Down ? 1 : key.key() == Qt::Key_Up ? -1 : 0;
    const QModelIndex next = cell.siblingAtRow(cell.row() + step);
    if (step != 0 && next.isValid()) {
        cells_[static_cast<std::size_t>(next.column() * rows + next.row())]->setFocus(
            Qt::TabFocusReason);
    }
    return step != 0;
}

}  // namespace ravnoves
