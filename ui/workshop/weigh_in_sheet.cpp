#include <QCheckBox>
#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <tuple>

#include "bob-weights/fields.h"
#include "model/editable_table.h"
#include "page/part_views.h"
#include "shop/scale_input.h"
#include "text/message_text.h"
#include "text/shown_units.h"
#include "theme/theme.h"
#include "v8-plugs/fields.h"
#include "widgets/form_section.h"
#include "workshop/sheets.h"

namespace ravnoves {

namespace {

constexpr int cellHeight = 30;  // all of the sheet has to be seen on 800 lines
constexpr int cellWidth = 44;
constexpr int titleColumn = 73;  // the longest word of its titles, in Russian
constexpr int maxRows = 16;      // further cylinders come by pasting a column

}  // namespace

WeighInSheet::WeighInSheet(WorkshopModel* model, QWidget* parent) : WorkshopSheet(model, parent) {
    column()->setSpacing(Theme::space);
    addSource();
    addWeights();
    addMoves();
    section({});
    line(Theme::baseSize, [model] { return model->weighInText(); });
    addGoal();
    addFindings();
    finish();
}

/// What the weights are for, and which cylinders share a crankpin.
void WeighInSheet::addSource() {
    section({});
    QCheckBox* source = box(
        QStringLiteral("changes_from_weigh_in"), tr("Use the mass changes o&f this sheet"),
        fieldHint(v8_plugs::field::changes_source),
        [this] { return model_->hasPlugs() && model_->input().plugs->changes_from_weigh_in; },
        [this](bool on) {
            model_->editPlugs(fieldName(v8_plugs::field::changes_source),
                              [on](v8_plugs::Input& plugs) { plugs.changes_from_weigh_in = on; });
        });
    showWhile(source, [this] { return model_->hasPlugs(); });
    QComboBox* pairs = wide(choice("/weigh_in/cylinder_numbering"), 250);
    const auto noPairs = [this] {
        return model_->input().engine.type == bob_weights::EngineType::in_line
                   ? tr("In line each cylinder has a crankpin of its own.")
                   : QString();
    };
    follow([pairs, noPairs, hint = pairs->toolTip()] {
        const QString why = noPairs();
        pairs->setEnabled(why.isEmpty());
        pairs->setToolTip(why.isEmpty() ? hint : why);
    });
    line(Theme::smallSize, noPairs);
    line(Theme::smallSize, [this] {
        const int cylinders = model_->input().engine.cylinders;
        return cylinders > maxRows
                   ? tr("The sheet shows %1 of %2 cylinders. Paste a column of a spreadsheet for "
                        "all, or type the means on sheet 2.")
                         .arg(maxRows)
                         .arg(cylinders)
                   : QString();
    });
}

/// The grid of weights, with what is below its columns.
void WeighInSheet::addWeights() {
    QStringList headings{QString()};
    for (const shop::Part part : shop::all_parts) {
        headings << fieldName(
            std::ranges::find(bob_weights::part_fields(), part, &bob_weights::PartField::column)
                ->field);
    }
    std::tie(grid_, trouble_) = grid(headings);
    trouble_->setObjectName(QStringLiteral("weigh_in_trouble"));
    grid_->setHorizontalSpacing(Theme::gap / 2);  // "1568.52" is seen whole
    grid_->setVerticalSpacing(2);
    grid_->setColumnMinimumWidth(0, Theme::withText(50));
    QStringList titles{tr("nominal, g"), tr("permitted range, g")};
    for (int cylinder = 1; cylinder <= maxRows; ++cylinder) {
        titles << QString::number(cylinder);
    }
    const auto rows = static_cast<int>(titles.size());
    titles << tr("mean, g") << tr("vs. nominal, g") << tr("range, g");
    constexpr auto columns = static_cast<int>(shop::all_parts.size());
    for (int row = 0; row < titles.size(); ++row) {
        const bool isCylinder = row >= WorkshopModel::firstCylinder && row < rows;
        QLabel* title = put(row + 1, 0, isCylinder ? Theme::titleSize : Theme::smallSize);
        // A unit stays with the word before it.
        title->setText(
            shownTitle(titles[row]).text.replace(QStringLiteral(", "), QStringLiteral(",\u00A0")));
        title->setWordWrap(true);
        title->setMaximumWidth(Theme::withText(titleColumn));  // the numbers need the room
        showWhile(title, [this, row, rows] { return row >= rows || row < model_->weightRows(); });
        for (int column = 0; row < rows && column < columns; ++column) {
            grid_->addWidget(addCell(row, column), row + 1, column + 1);
        }
    }
    for (int column = 0; column < columns; ++column) {
        for (int row = 0; row < rows; ++row) {
            ordered(grid_->itemAtPosition(row + 1, column + 1)->widget());
        }
        std::array<QLabel*, 3> notes{};
        for (int i = 0; i < 3; ++i) {
            notes.at(i) = put(rows + i + 1, column + 1, Theme::baseSize);
        }
        follow([this, notes, column] {
            const WeighedColumn weighed = model_->columnNote(shop::all_parts.at(column));
            for (std::size_t i = 0; i < notes.size(); ++i) {
                const bool isTooWide = i == 2 && weighed.tooWide;
                notes[i]->setText(isTooWide ? weighed.texts[i] + QStringLiteral(" !")
                                            : weighed.texts[i]);
                notes[i]->setToolTip(weighed.toolTip);
                colourText(notes[i], isTooWide                  ? &Theme::error
                                     : weighed.counts || i == 2 ? &Theme::text
                                                                : &Theme::mutedText);
            }
        });
    }
    followArrows(grid_);
}

/// A label of the grid beside or below the cells.
QLabel* WeighInSheet::put(int row, int column, int size) {
    auto* label = new QLabel(this);
    label->setFont(Theme::font(size));
    label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    grid_->addWidget(label, row, column);
    return label;
}

NumberField* WeighInSheet::addCell(int row, int column) {
    const Field& description = WorkshopModel::weightField(row);
    const Word& word = shop::part_word(shop::all_parts[static_cast<std::size_t>(column)]);
    const QString key = QString::fromStdString(std::string(word.word));
    // A text with %1 for the part and %2 for the cylinder; the first two are of the rows above.
    const auto of = [row](const QString& whose, const QString& nominal, const QString& spread,
                          const QString& cylinder) {
        return row == 0   ? nominal.arg(whose)
               : row == 1 ? spread.arg(whose)
                          : cylinder.arg(whose).arg(row - WorkshopModel::firstCylinder + 1);
    };
    const auto name = [of, label = word.label](const Words& words) {
        return of(words.text(label), words.translate("ravnoves::WeighInSheet", "%1, nominal mass"),
                  words.translate("ravnoves::WeighInSheet", "%1, permitted range"),
                  words.translate("ravnoves::WeighInSheet", "%1 of cylinder %2"));
    };
    NumberField* field =
        cell(description,
             of(key, QStringLiteral("nominal_%1"), QStringLiteral("spread_%1"),
                QStringLiteral("mass_%1_%2")),
             name, [row, &word] {
                 const std::string part = "/weigh_in/" + std::string(word.word) + '/' +
                                          std::string(WorkshopModel::weightField(row).key);
                 const int cylinder = row - WorkshopModel::firstCylinder;
                 return cylinder < 0 ? part : part + '/' + std::to_string(cylinder);
             });
    field->setHint(of(shownText(word.label), tr("%1: mass by the drawing."),
                      tr("%1: permitted heaviest minus lightest, by the works manual. Blank means "
                         "no limit."),
                      tr("%1 of cylinder %2 by the scale.")));
    if (row < WorkshopModel::firstCylinder) {
        setTypedAlone(field);
    }
    field->setMinimumWidth(Theme::withText(cellWidth));
    field->setMinimumHeight(Theme::withText(cellHeight));
    field->setFont(Theme::font(Theme::baseSize));
    field->setTextMargins(-1, 0, -1, 0);  // "1568.52" is seen whole
    if (const ShownUnit shown = shownUnit(description.unit); shown.factor != 1.0) {
        field->setPlaces(2 + shown.decimals);  // the points are below each other
    }
    bind(
        field, description, [this, row, column] { return model_->weight(row, column); },
        [this, row, column, name](std::optional<double> mass) {
            model_->setWeight(name({}), row, column, mass);
        });
    trouble_->watch(field);
    showWhile(field, [this, row] { return row < model_->weightRows(); });
    return field;
}

bool WeighInSheet::eventFilter(QObject* watched, QEvent* event) {
    const bool isPaste = event->type() == QEvent::KeyPress &&
                         static_cast<QKeyEvent*>(event)->matches(QKeySequence::Paste);
    const auto cell = isPaste ? placeIn(*grid_, static_cast<QWidget*>(watched)) : std::nullopt;
    const QString text = cell ? QGuiApplication::clipboard()->text() : QString();
    if (text.contains(QLatin1Char('\n')) || text.contains(QLatin1Char('\t'))) {
        trouble_->say(model_->pasteWeights(cell->first - 1, cell->second - 1,
                                           readTextTable(text, EmptyLine::gap)));
        return true;
    }
    return WorkshopSheet::eventFilter(watched, event);
}

/// Which parts may change places.
void WeighInSheet::addMoves() {
    section({});
    for (const char* parts : {"pistons", "pins", "rings", "rods", "shells"}) {
        QComboBox* box = wide(choice((std::string("/weigh_in/matching/") + parts).c_str()), 150);
        box->setObjectName(QStringLiteral("moves_") + QLatin1String(parts));
        const std::string_view part = parts;
        if (part == "pistons" || part == "rods") {
            continue;
        }
        follow([this, box, hint = box->toolTip()] {
            // By another rule the parts would not go back to where they were weighed.
            const bool isFixed = model_->canMoveBack();
            box->setEnabled(!isFixed);
            box->setToolTip(
                isFixed
                    ? tr("Parts were moved by this rule: press “As weighed” to change the rule.")
                    : hint);
        });
    }
}

shop::MatchingRules WeighInSheet::rules() const {
    const auto& sheet = model_->input().weigh_in;
    return sheet ? sheet->matching : shop::MatchingRules();
}

/// What the parts are placed for, with what that needs.
void WeighInSheet::addGoal() {
    section({});
    goal_ = wide(choice("/weigh_in/matching/goal"), 200);
    QWidget* moves = section({});
    number("/weigh_in/matching/permitted_spread_g")
        ->setObjectName(QStringLiteral("permitted_crankpin_spread"));
    QWidget* shaking = section({});
    numberList(
        shop::field::crankpin_angles, [this] { return rules().crankpin_angles_deg; },
        [this](const QString& name, const std::vector<double>& angles) {
            model_->editWeights(
                name, [&](shop::WeighIn& sheet) { sheet.matching.crankpin_angles_deg = angles; });
        });
    number("/weigh_in/matching/cylinder_spacing_mm");
    number("/weigh_in/matching/bank_offset_mm");
    number("/weigh_in/matching/crank_radius_mm")
        ->setObjectName(QStringLiteral("matching_crank_radius"));
    follow([this, moves, shaking] {
        const shop::MatchingGoal goal = rules().goal;
        const auto ask = [](QWidget* section, bool asked) {
            section->setVisible(asked);
            for (EntryField* each : section->findChildren<EntryField*>()) {
                each->setEnabled(asked);
            }
        };
        ask(moves, goal == shop::MatchingGoal::fewest_moves);
        ask(shaking, goal == shop::MatchingGoal::min_shaking);
    });
}

/// A table with its title, there while it has rows.
void WeighInSheet::addTable(std::string_view part, const QString& name) {
    QLabel* title = headingLabel(name, this);
    title->setWordWrap(true);
    column()->addWidget(title);
    auto* table = new PartTable(model(), part, name, this);
    table->hideWhereEmpty();
    const auto show = [title, table] { title->setVisible(table->rowCount() > 0); };
    connect(table->model(), &QAbstractItemModel::rowsInserted, title, show);
    connect(table->model(), &QAbstractItemModel::rowsRemoved, title, show);
    show();
    table->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    column()->addWidget(table);
}

/// What comes out, and the buttons that move the weights on the sheet and back.
void WeighInSheet::addFindings() {
    auto* summary = new QLabel(this);
    summary->setObjectName(QStringLiteral("weigh_in_summary"));
    summary->setWordWrap(true);
    summary->setFont(Theme::font(Theme::baseSize, true));
    QPushButton* button = largeButton("move_parts", tr("&Move them here"), this, cellHeight);
    button->setToolTip(tr("Moves the masses on this sheet with the parts."));
    auto* found = new QHBoxLayout;
    found->addWidget(summary, 1);
    found->addWidget(button, 0, Qt::AlignTop);
    QPushButton* back = largeButton("move_back", tr("As &weighed"), this, cellHeight);
    back->setToolTip(tr("Returns the masses to the cylinders where they were weighed."));
    // The button goes with what it does: under the focus it would hand it on to what follows, and
    // the sheet would scroll there.
    const auto handOn = [this](QPushButton* pressed, QPushButton* other,
                               void (WorkshopModel::*act)()) {
        connect(pressed, &QPushButton::clicked, this, [model = model_, other, act] {
            other->setVisible(true);
            other->setFocus(Qt::OtherFocusReason);  // a field's end may make the sheet again
            (model->*act)();
        });
    };
    handOn(button, back, &WorkshopModel::moveParts);
    handOn(back, button, &WorkshopModel::moveBack);
    found->addWidget(back, 0, Qt::AlignTop);
    column()->addLayout(found);
    addTable("effects", tr("Effect of the matching"));
    addTable("assignment", tr("Sets by cylinder"));
    addTable("take-off", tr("Mass to take off each part to match the lightest"));
    follow([=, this] {
        const shop::Matched* placing = model_->placing();
        const bool isWarning =
            placing != nullptr ? !placing->remark.empty() : !model_->weighAgain().isEmpty();
        const bool canMove = placing != nullptr && placing->moved > 0;
        back->setVisible(model_->canMoveBack());
        const QStringList gaps = model_->hasPlugs() ? model_->notCounted() : QStringList();
        QStringList said =
            gaps + QStringList(model_->assignmentText()) + model_->assignmentRemarks();
        said.removeAll(QString());
        summary->setText(said.join(QLatin1Char('\n')));
        colourText(summary, isWarning || !gaps.isEmpty() ? &Theme::warning : &Theme::text);
        if (button->hasFocus() && !canMove) {
            goal_->setFocus(Qt::OtherFocusReason);
        }
        button->setVisible(canMove);
    });
}

}  // namespace ravnoves
