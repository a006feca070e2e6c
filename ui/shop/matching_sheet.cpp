#include "shop/matching_sheet.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "page/part_views.h"
#include "shop/model/matching_text.h"
#include "text/message_text.h"
#include "text/shown_units.h"
#include "theme/theme.h"
#include "widgets/form_section.h"

namespace ravnoves {

using namespace shop;

namespace {

constexpr int cellHeight = 30;  // all of the sheet has to be seen on 800 lines
constexpr int cellWidth = 44;
constexpr int titleColumn = 73;  // the longest word of its titles, in Russian

}  // namespace

void MatchingSheet::addWeights(WeighInTable* table, int mostRows, const Note& note) {
    table_ = table;
    rows_ = table->firstCylinder() + mostRows;
    grid_ = new QGridLayout;
    column()->addLayout(grid_);
    grid_->setHorizontalSpacing(Theme::gap / 2);  // "1568.52" is seen whole
    grid_->setVerticalSpacing(2);
    grid_->setColumnMinimumWidth(0, Theme::withText(50));
    for (int row = 0; row < rows_; ++row) {
        QLabel* title =
            put(row + 1, 0, table_->headerData(row, Qt::Vertical, Qt::DisplayRole).toString(),
                row < table_->firstCylinder() ? Theme::smallSize : Theme::titleSize);
        follow([this, title, row] { title->setVisible(row < table_->rowCount()); });
    }
    int row = rows_ + 1;
    put(row++, 0, shownTitle(tr("mean, g")).text, Theme::smallSize);
    if (table_->firstCylinder() > 0) {
        put(row++, 0, shownTitle(tr("to nominal, g")).text, Theme::smallSize);
    }
    put(row++, 0, shownTitle(tr("spread, g")).text, Theme::smallSize);
    trouble_ = new TroubleLine(this);
    trouble_->setObjectName(QStringLiteral("weigh_in_trouble"));
    for (int column = 0; column < table_->columnCount(); ++column) {
        addColumn(column, note);
    }
    QList<QList<QWidget*>> rows(rows_);
    for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
        rows[static_cast<int>(cell) % rows_] << cells_[cell];
    }
    addGrid(rows);
    addMoves(row);
    column()->addWidget(trouble_);
}

/// A label of the grid; those above and to the left of the cells wrap.
QLabel* MatchingSheet::put(int row, int column, const QString& text, int size, bool bold) {
    // A unit stays with the word before it.
    const QString whole = QString(text).replace(QStringLiteral(", "), QStringLiteral(",\u00A0"));
    auto* label = new QLabel(column == 0 ? whole : text, this);
    label->setFont(Theme::font(size, bold));
    label->setWordWrap(column == 0 || row == 0);
    if (column == 0) {
        label->setMaximumWidth(Theme::withText(titleColumn));  // the numbers need the room
    }
    label->setAlignment(row == 0 ? Qt::AlignCenter : Qt::AlignRight | Qt::AlignVCenter);
    grid_->addWidget(label, row, column);
    return label;
}

void MatchingSheet::addColumn(int column, const Note& note) {
    const int place = column + 1;
    put(0, place, table_->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString(),
        Theme::smallSize, true);
    grid_->setColumnStretch(place, 1);
    for (int row = 0; row < rows_; ++row) {
        grid_->addWidget(addCell(row, column), row + 1, place);
    }
    int row = rows_ + 1;
    QLabel* mean = put(row++, place, {}, Theme::baseSize);
    QLabel* deviation =
        table_->firstCylinder() > 0 ? put(row++, place, {}, Theme::baseSize) : nullptr;
    QLabel* spread = put(row++, place, {}, Theme::baseSize);
    const auto show = [=, part = all_parts[static_cast<std::size_t>(column)]] {
        const WeighedColumn weighed = note(part);
        const auto say = [&](QLabel* label, const QString& text, Ink ink) {
            if (label != nullptr) {
                label->setText(text);
                label->setToolTip(weighed.toolTip);
                colourText(label, ink);
            }
        };
        say(mean, weighed.mean, weighed.counts ? &Theme::text : &Theme::warning);
        say(deviation, weighed.deviation, weighed.counts ? &Theme::text : &Theme::warning);
        say(spread, weighed.tooWide ? weighed.spread + QStringLiteral(" !") : weighed.spread,
            weighed.tooWide ? &Theme::error : &Theme::text);
    };
    follow(show);
}

NumberField* MatchingSheet::addCell(int row, int column) {
    // Rows that are not there yet have names, too.
    const QModelIndex named = table_->createdIndex(row, column);
    auto* field = ordered(new NumberField(table_->fieldOf(row), this));
    field->setObjectName(table_->data(named, WeighInTable::KeyRole).toString());
    field->setAccessibleName(table_->data(named, Qt::AccessibleTextRole).toString());
    field->setHint(table_->data(named, Qt::ToolTipRole).toString());
    field->setOptional(true);
    field->setMinimumWidth(Theme::withText(cellWidth));
    field->setMinimumHeight(Theme::withText(cellHeight));
    field->setFont(Theme::font(Theme::baseSize));
    field->setTextMargins(-1, 0, -1, 0);  // "1568.52" is seen whole
    field->setDecimals(2 + shownUnit(table_->fieldOf(row).unit).decimals);
    bind(
        field,
        [this, row, column]() -> std::optional<double> {
            const QVariant mass = table_->index(row, column).data(Qt::EditRole);
            return mass.isValid() ? std::optional(mass.toDouble()) : std::nullopt;
        },
        [this, row, column](std::optional<double> value) {
            table_->setData(table_->index(row, column), value ? QVariant(*value) : QVariant());
        });
    makeCell(field);
    trouble_->watch(field);
    cells_.push_back(field);
    if (row >= table_->firstCylinder()) {
        follow([this, field, row] { field->setVisible(row < table_->rowCount()); });
    }
    return field;
}

bool MatchingSheet::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress &&
        static_cast<QKeyEvent*>(event)->matches(QKeySequence::Paste)) {
        const auto found = std::find(cells_.begin(), cells_.end(), watched);
        if (found != cells_.end()) {
            const auto place = static_cast<int>(found - cells_.begin());
            if (pasteBlock(place % rows_, place / rows_)) {
                return true;
            }
        }
    }
    return SheetForm::eventFilter(watched, event);
}

bool MatchingSheet::pasteBlock(int row, int column) {
    const QString text = QGuiApplication::clipboard()->text();
    const bool isBlock = text.contains(QLatin1Char('\n')) || text.contains(QLatin1Char('\t'));
    if (isBlock) {
        trouble_->say(table_->paste(row, column, readTextTable(text, EmptyLine::gap)));
    }
    return isBlock;
}

void MatchingSheet::addMoves(int row) {
    auto* title = new QLabel(tr("may go"), this);
    title->setFont(Theme::font(Theme::smallSize));
    title->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    grid_->addWidget(title, row, 0);
    const auto add = [&](Part part, const Field& field, auto Rules::*member) {
        using Moves = std::decay_t<decltype(Rules().*member)>;
        auto* box = ordered(new QComboBox(this));
        box->setObjectName(
            QStringLiteral("moves_") +
            QString::fromUtf8(field.key.data(), static_cast<qsizetype>(field.key.size())));
        makeCell(box);
        box->setAccessibleName(fieldName(field));
        box->setToolTip(fieldHint(field));
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumWidth(Theme::withText(cellWidth));
        box->setMinimumHeight(Theme::withText(cellHeight));
        box->setFont(Theme::font(Theme::smallSize));
        for (const Word& word : field.words) {
            box->addItem(shownText(word.label));
        }
        connect(box, &QComboBox::activated, this, [this, member, name = fieldName(field)](int at) {
            edit_(name, [&](Rules& rules) { rules.*member = static_cast<Moves>(at); });
        });
        const bool isSet = part == Part::piston || part == Part::rod_big_end;
        follow([this, box, member, isSet, hint = fieldHint(field)] {
            box->setCurrentIndex(static_cast<int>(rules_().*member));
            // By another rule the parts would not go back to where they were weighed.
            const bool isFixed = !isSet && isMoved_();
            box->setEnabled(!isFixed);
            box->setToolTip(isFixed ? tr("Parts have been moved by this rule: press “As weighed” "
                                         "to change it.")
                                    : hint);
        });
        grid_->addWidget(box, row, static_cast<int>(part) + 1);
    };
    add(Part::piston, field::piston_moves, &Rules::pistons);
    add(Part::pin, field::pin_moves, &Rules::pins);
    add(Part::rings, field::ring_moves, &Rules::rings);
    add(Part::rod_big_end, field::rod_moves, &Rules::rods);
    auto* withRod = new QLabel(tr("with it"), this);
    withRod->setFont(Theme::font(Theme::smallSize));
    withRod->setAlignment(Qt::AlignCenter);
    withRod->setToolTip(tr("The small end goes with the big end: they are one rod."));
    grid_->addWidget(withRod, row, static_cast<int>(Part::rod_small_end) + 1);
    add(Part::shells, field::shell_moves, &Rules::shells);
    QLabel* words = captionLabel(
        tr("Where matching may put a part – free: in any cylinder, bank: within its bank, goes: "
           "with its piston or rod, stays: where it is."),
        this);
    words->setObjectName(QStringLiteral("moves_words"));
    QSizePolicy policy = words->sizePolicy();
    policy.setHorizontalPolicy(QSizePolicy::Ignored);  // the columns are those of the cells
    words->setSizePolicy(policy);
    grid_->addWidget(words, row + 1, 0, 1, -1);
}

void MatchingSheet::addGoal(bool asksRadius) {
    section({});
    goal_ = wide(choice("/weigh_in/matching/goal"), 200);
    QWidget* moves = section({});
    number("/weigh_in/matching/permitted_spread_g")
        ->setObjectName(QStringLiteral("permitted_crankpin_spread"));
    QWidget* shaking = section({});
    addAngles();
    number("/weigh_in/matching/cylinder_spacing_mm");
    number("/weigh_in/matching/bank_offset_mm");
    if (asksRadius) {
        number("/weigh_in/matching/crank_radius_mm")
            ->setObjectName(QStringLiteral("matching_crank_radius"));
    }
    follow([this, moves, shaking] {
        const MatchingGoal goal = rules_().goal;
        const auto ask = [](QWidget* section, bool asked) {
            section->setVisible(asked);
            for (EntryField* each : section->findChildren<EntryField*>()) {
                each->setEnabled(asked);
            }
        };
        ask(moves, goal == MatchingGoal::fewest_moves);
        ask(shaking, goal == MatchingGoal::least_shaking);
    });
}

void MatchingSheet::addAngles() {
    numberList(
        field::crankpin_angles, [this] { return rules_().crankpin_angles_deg; },
        [this](const QString& name, const std::vector<double>& angles) {
            edit_(name, [&](Rules& rules) { rules.crankpin_angles_deg = angles; });
        });
}

void MatchingSheet::addTable(std::string_view part, const QString& name) {
    auto* table = new PartTable(model(), part, name, this);
    table->hideWhereEmpty();
    table->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    column()->addWidget(table);
}

void MatchingSheet::addFindings(std::function<QStringList()> notCounted) {
    auto* summary = new QLabel(this);
    summary->setObjectName(QStringLiteral("weigh_in_summary"));
    summary->setWordWrap(true);
    summary->setFont(Theme::font(Theme::baseSize, true));
    auto* button = new QPushButton(tr("&Move them here"), this);
    button->setObjectName(QStringLiteral("move_parts"));
    button->setToolTip(tr("The weights change places on this sheet as the parts do."));
    button->setMinimumHeight(Theme::withText(cellHeight));
    auto* found = new QHBoxLayout;
    found->addWidget(summary, 1);
    found->addWidget(button, 0, Qt::AlignTop);
    auto* back = new QPushButton(tr("As &weighed"), this);
    back->setObjectName(QStringLiteral("move_back"));
    back->setToolTip(tr("The weights go back to the cylinders that they were weighed in."));
    back->setMinimumHeight(Theme::withText(cellHeight));
    // The button goes with what it does: under the focus it would hand it on to what follows, and
    // the sheet would scroll there.
    const auto handOn = [this](QPushButton* pressed, QPushButton* other,
                               const std::function<void()>& act) {
        connect(pressed, &QPushButton::clicked, this, [other, act] {
            other->setVisible(true);
            other->setFocus(Qt::OtherFocusReason);
            act();
        });
    };
    handOn(button, back, move_);
    handOn(back, button, moveBack_);
    found->addWidget(back, 0, Qt::AlignTop);
    column()->addLayout(found);
    addTable("effects", tr("What the placing makes of the differences"));
    addTable("assignment", tr("Which set goes to which cylinder"));
    addTable("take-off", tr("What to take off each part to reach the lightest"));
    const auto show = [=, this, notCounted = std::move(notCounted)] {
        const Findings now = find_();
        back->setVisible(isMoved_());
        const QStringList gaps = notCounted ? notCounted() : QStringList();
        QStringList said = gaps + now.summary;
        said.removeAll(QString());
        summary->setText(said.join(QLatin1Char('\n')));
        colourText(summary, now.isAmber || !gaps.isEmpty() ? &Theme::warning : &Theme::text);
        if (button->hasFocus() && !now.canMove) {
            goal_->setFocus(Qt::OtherFocusReason);
        }
        button->setVisible(now.canMove);
    };
    follow(show);
}

}  // namespace ravnoves
