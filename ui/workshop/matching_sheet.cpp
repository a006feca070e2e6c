#include "workshop/matching_sheet.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QVBoxLayout>

#include "text/message_text.h"
#include "text/number_text.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/result_table.h"
#include "workshop/model/matching_text.h"

namespace ravnoves {

using namespace workshop;

namespace {

constexpr int moveHeight = 30;
constexpr int moveWidth = 44;  // that of a weight

QVBoxLayout* columnOfSheet(QWidget* sheet) {
    return static_cast<QVBoxLayout*>(sheet->layout());
}

/// Nothing where a word is no angle.
std::optional<std::vector<double>> readAngles(const QString& typed) {
    static const QRegularExpression between(QStringLiteral("\\s*;\\s*|,\\s+|°?\\s+"));
    std::vector<double> angles;
    for (QString word : typed.split(between, Qt::SkipEmptyParts)) {
        const auto value = readFormNumber(word.remove(QChar(0xB0)));
        if (!value || !field::crankpin_angles.range.contains(*value)) {
            return std::nullopt;
        }
        angles.push_back(*value);
    }
    return angles;
}

QString anglesText(const std::vector<double>& angles) {
    QStringList list;
    for (const double angle : angles) {
        list << formNumber(angle, QLocale());
    }
    return list.join(QStringLiteral("; "));
}

}  // namespace

MatchingSheet::MatchingSheet(
    SceneModel* model, std::function<Rules()> rules,
    std::function<void(const QString&, const std::function<void(Rules&)>&)> edit,
    std::function<bool()> isMoved, QWidget* parent)
    : SheetForm(model, parent),
      rules_(std::move(rules)),
      edit_(std::move(edit)),
      isMoved_(std::move(isMoved)) {}

void MatchingSheet::addMoves(QGridLayout* grid, int row) {
    auto* title = new QLabel(tr("may go"), grid->parentWidget());
    title->setFont(Theme::font(Theme::smallSize));
    title->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    grid->addWidget(title, row, 0);
    const auto add = [&](Part part, const Field& field, auto Rules::*member) {
        using Moves = std::decay_t<decltype(Rules().*member)>;
        auto* box = ordered(new QComboBox(this));
        box->setObjectName(
            QStringLiteral("moves_") +
            QString::fromUtf8(field.key.data(), static_cast<qsizetype>(field.key.size())));
        makeCell(box);
        box->setAccessibleName(fieldName(field));
        box->setToolTip(shownText(field.hint));
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumWidth(Theme::withText(moveWidth));
        box->setMinimumHeight(Theme::withText(moveHeight));
        box->setFont(Theme::font(Theme::smallSize));
        for (const Word& word : field.words) {
            box->addItem(shownText(word.label));
        }
        connect(box, &QComboBox::activated, this, [this, member, name = fieldName(field)](int at) {
            edit_(name, [&](Rules& rules) { rules.*member = static_cast<Moves>(at); });
        });
        const bool isSet = part == Part::piston || part == Part::rod_big_end;
        follow([this, box, member, isSet, hint = shownText(field.hint)] {
            box->setCurrentIndex(static_cast<int>(rules_().*member));
            // By another rule the parts would not go back to where they were weighed.
            const bool isFixed = !isSet && isMoved_();
            box->setEnabled(!isFixed);
            box->setToolTip(isFixed ? tr("Parts have been moved by this rule: press “As weighed” "
                                         "to change it.")
                                    : hint);
        });
        grid->addWidget(box, row, static_cast<int>(part) + 1);
    };
    add(Part::piston, field::piston_moves, &Rules::pistons);
    add(Part::pin, field::pin_moves, &Rules::pins);
    add(Part::rings, field::ring_moves, &Rules::rings);
    add(Part::rod_big_end, field::rod_moves, &Rules::rods);
    auto* withRod = new QLabel(tr("with it"), grid->parentWidget());
    withRod->setFont(Theme::font(Theme::smallSize));
    withRod->setAlignment(Qt::AlignCenter);
    withRod->setToolTip(tr("The small end goes with the big end: they are one rod."));
    grid->addWidget(withRod, row, static_cast<int>(Part::rod_small_end) + 1);
    add(Part::shells, field::shell_moves, &Rules::shells);
    QLabel* words = captionLabel(
        tr("Where matching may put a part – free: in any cylinder, bank: within its bank, goes: "
           "with its piston or rod, stays: where it is."),
        grid->parentWidget());
    words->setObjectName(QStringLiteral("moves_words"));
    QSizePolicy policy = words->sizePolicy();
    policy.setHorizontalPolicy(QSizePolicy::Ignored);  // the columns are those of the cells
    words->setSizePolicy(policy);
    grid->addWidget(words, row + 1, 0, 1, -1);
}

void MatchingSheet::addGoal(bool asksRadius) {
    section({});
    wide(choice("/weigh_in/matching/goal"), 200);
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
    checked(field::crankpin_angles,
            {[](const QString& typed) {
                 return anglesText(readAngles(typed).value_or(std::vector<double>{}));
             },
             [](const QString& typed) {
                 return readAngles(typed)
                            ? QString()
                            : tr("Angles in degrees, one after the other: 0; 90; 270; 180");
             },
             [this] { return anglesText(rules_().crankpin_angles_deg); },
             [this](const QString& name, const QString& normal) {
                 edit_(name, [&](Rules& rules) {
                     rules.crankpin_angles_deg = readAngles(normal).value_or(std::vector<double>{});
                 });
             }});
}

ResultTable* MatchingSheet::addTable(const QString& name) {
    auto* table = new ResultTable(this);
    table->setAccessibleName(name);
    table->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    columnOfSheet(this)->addWidget(table);
    return table;
}

void MatchingSheet::addFindings(std::function<Findings()> findings, std::function<void()> move,
                                std::function<void()> moveBack) {
    auto* summary = new QLabel(this);
    summary->setObjectName(QStringLiteral("weigh_in_summary"));
    summary->setWordWrap(true);
    summary->setFont(Theme::font(Theme::baseSize, true));
    auto* button = new QPushButton(tr("&Move them here"), this);
    button->setObjectName(QStringLiteral("move_parts"));
    button->setToolTip(tr("The weights change places on this sheet as the parts do."));
    button->setMinimumHeight(Theme::withText(moveHeight));
    connect(button, &QPushButton::clicked, this, std::move(move));
    auto* found = new QHBoxLayout;
    found->addWidget(summary, 1);
    found->addWidget(button, 0, Qt::AlignTop);
    auto* back = new QPushButton(tr("As &weighed"), this);
    back->setObjectName(QStringLiteral("move_back"));
    back->setToolTip(tr("The weights go back to the cylinders that they were weighed in."));
    back->setMinimumHeight(Theme::withText(moveHeight));
    connect(back, &QPushButton::clicked, this, std::move(moveBack));
    found->addWidget(back, 0, Qt::AlignTop);
    columnOfSheet(this)->addLayout(found);
    ResultTable* effects = addTable(tr("What the placing makes of the differences"));
    ResultTable* assignment = addTable(tr("Which set goes to which cylinder"));
    ResultTable* takeOff = addTable(tr("What to take off each part to reach the lightest"));
    const auto show = [=, this, findings = std::move(findings)] {
        const Findings now = findings();
        const Theme& theme = Theme::instance();
        back->setVisible(isMoved_());
        button->setEnabled(!now.isSearching);
        for (ResultTable* table : {effects, assignment, takeOff}) {
            table->setEnabled(!now.isSearching);
        }
        if (now.isSearching) {
            // What was found before stays, in grey, until the new comes: nothing jumps.
            summary->setText(tr("Looking for the best placing…"));
            colourText(summary, theme.mutedText());
            return;
        }
        summary->setText(now.summary);
        colourText(summary, now.isAmber ? theme.warning() : theme.text());
        button->setVisible(now.canMove);
        const Words own;
        const auto fill = [](ResultTable* table, const ResultColumns& columns,
                             const ResultRows& rows) {
            if (!rows.isEmpty() && table->property("columns") != columns.size()) {
                table->setProperty("columns", columns.size());
                table->setColumns(columns);
            }
            table->setRows(rows);
            table->setVisible(!rows.isEmpty());
        };
        fill(effects, matching_text::effectColumns(own), now.effects);
        fill(assignment, matching_text::assignmentColumns(own, now.cylinders), now.assignment);
        fill(takeOff, matching_text::takeOffColumns(own, now.cylinders), now.takeOff);
    };
    connect(&Theme::instance(), &Theme::changed, this, show);
    follow(show);
}

}  // namespace ravnoves
