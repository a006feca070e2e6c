#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStandardItemModel>
#include <algorithm>
#include <type_traits>

#include "bob-weights/drilled.h"
#include "bob-weights/drilling.h"
#include "bob-weights/fields.h"
#include "bob-weights/solver.h"
#include "shop/model/verdict.h"
#include "text/message_text.h"
#include "text/typed_number.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "workshop/sheets.h"

namespace ravnoves {

using namespace bob_weights;

CorrectionSheet::CorrectionSheet(WorkshopModel* model, QWidget* parent)
    : WorkshopSheet(model, parent) {
    section(tr("Available drills"));
    numberList(
        field::diameters,
        [this] {
            const auto& correction = model_->input().correction;
            return correction ? correction->drill.diameters_mm : std::vector<double>();
        },
        [this](const QString& name, const std::vector<double>& diameters) {
            model_->editCorrection(
                name, [&](Correction& correction) { correction.drill.diameters_mm = diameters; });
        },
        is_usual_drill);
    // How several are written.
    findChild<QLineEdit*>(QString::fromStdString(std::string(field::diameters.key)))
        ->setPlaceholderText(numberListText({8, 10}, field::diameters) + QStringLiteral("; …"));
    number("/correction/drill/maximum_depth_mm");
    number("/correction/smallest_depth_mm");
    wide(choice("/correction/aim"), 250);
    number("/correction/drill/point_angle_deg");
    number("/correction/drill/density_kg_m3");
    number("/correction/drill/depth_step_mm");
    section(tr("Several holes"));
    number("/correction/drill/maximum_holes");
    number("/correction/drill/minimum_wall_mm");
    number("/correction/drill/maximum_angle_deg");
    buildDrilled();
    buildWhatIf();
    section(tr("Heavy metal"));
    number("/correction/slug/diameter_mm")->setObjectName(QStringLiteral("slug_diameter_mm"));
    NumberField* density = number("/correction/slug/density_kg_m3");
    density->setObjectName(QStringLiteral("slug_density_kg_m3"));
    const auto hasSlugs = [this] {
        const auto& correction = model_->input().correction;
        return correction && correction->slug && correction->slug->diameter;
    };
    follow([hasSlugs, density, needed = density->placeholderText()] {
        density->setPlaceholderText(hasSlugs() ? needed : QStringLiteral("–"));
    });
    QComboBox* direction = choice("/correction/slug/direction");
    direction->setObjectName(QStringLiteral("slug_direction"));
    enableWhile(direction, hasSlugs);
    finish();
}

// ---------------------------------------------------------------------------------- what if

void CorrectionSheet::buildWhatIf() {
    section(tr("Try a hole"));
    followPlanes(choice(
        QStringLiteral("what_if_plane"), shownText(field::drilled_plane.label),
        QStringList(2, QString()), fieldHint(field::drilled_plane),
        [this] { return whatIf_.plane; },
        [this](int chosen) {
            whatIf_.plane = chosen;
            showWhatIf();
        }));
    const auto add = [this](const Field& field, std::optional<double> WhatIf::*member,
                            const char* name) {
        NumberField* made = number(
            field, [this, member] { return whatIf_.*member; },
            [this, member](std::optional<double> value) {
                whatIf_.*member = value;
                showWhatIf();
            });
        made->setObjectName(QLatin1String(name));
        made->setIsOfResult(false);
        connect(made, &EntryField::troubleChanged, this, &CorrectionSheet::showWhatIf);
        whatIfFields_ << made;
    };
    add(field::drilled_diameter, &WhatIf::diameter, "what_if_diameter");
    add(field::drilled_depth, &WhatIf::depth, "what_if_depth");
    add(field::drilled_angle, &WhatIf::angle, "what_if_angle");
    whatIfLine_ = copyableLabel("what_if", Theme::titleSize, current());
    current()->addWide(whatIfLine_);
    addHole_ = button("add_hole", tr("Drilled before the first reading: &add"),
                      tr("Only for a hole that the first readings contain. New holes keep clear of "
                         "this hole; it may be deepened."),
                      [this] { addHole(true); });
    addLateHole_ = button("add_late_hole", tr("Drilled before the &last reading: add"),
                          tr("For a hole that was not planned: the last reading contains its "
                             "effect, the one before does not."),
                          [this] { addHole(false); });
    follow([this] { showWhatIf(); });
    connect(model_, &SceneModel::shownChanged, this, &CorrectionSheet::showWhatIf);
    connect(model_, &SceneModel::restarted, this, [this] {
        whatIf_ = {};
        showAll();
    });
}

/// The planes by the machine's names, short: they stand beside the word.
void CorrectionSheet::followPlanes(QComboBox* box) {
    follow([this, box] {
        for (std::size_t i = 0; i < 2; ++i) {
            const std::string& own = model_->input().machine.planes[i];
            box->setItemText(static_cast<int>(i),
                             own.empty() ? shownText(plane_words[i].label) : model_->planeName(i));
        }
    });
}

std::optional<Remaining> CorrectionSheet::tried() const {
    return what_if(model_->input(), model_->solution(), static_cast<PlaneName>(whatIf_.plane),
                   *whatIf_.diameter, *whatIf_.depth, *whatIf_.angle);
}

void CorrectionSheet::showWhatIf() {
    const bool isWhole = std::ranges::all_of(whatIfFields_, [](const NumberField* each) {
        return each->trouble().isEmpty() && each->value();
    });
    addHole_->setEnabled(isWhole);
    const auto& correction = model_->input().correction;
    const bool isAgain = correction && correction->earlier_runs.size() > first_run(correction) &&
                         correction->earlier_runs.back().drilled;
    addLateHole_->setVisible(isAgain);
    addLateHole_->setEnabled(isWhole);
    const auto at = static_cast<std::size_t>(whatIf_.plane);
    // Which may be the reason for a stop.
    if (isWhole && correction && at < correction->planes.size() &&
        correction->planes[at].has_half_sector()) {
        showOrHide(whatIfLine_, tr("Enter both ends of the drilling sector."));
        return;
    }
    const auto left = isWhole && !model_->shown().withheld().holes ? tried() : std::nullopt;
    if (!left) {
        showOrHide(whatIfLine_, {});
        return;
    }
    const Words words;
    const TriedRoom& room = left->room;
    if (room.missing != NoRoom::none) {
        showOrHide(whatIfLine_, words.message(describe(room.missing, room.maximum_depth)));
    } else {
        const QString verdict = verdictText(words, verdictWord(left->within_tolerance, {}));
        const QString said =
            tr("%1: residual %2 at %3.")
                .arg(model_->planeName(at), words.number(left->unbalance, units::gram_mm, 1),
                     words.number(left->angle, units::degree, 1));
        showOrHide(whatIfLine_, verdict.isEmpty() ? said : said + QLatin1Char(' ') + verdict);
    }
}

// ----------------------------------------------------------------------------- already drilled

void CorrectionSheet::buildDrilled() {
    section(tr("Already drilled: correct holes that differ from the plan"));
    const Words words;
    const auto made = grid({tr("Hole"), shownText(field::drilled_plane.label),
                            words.translate("BobWeights", "Depth, %1").arg(words.unit(units::mm)),
                            tr("Angle, °"), tr("Actual drilling")});
    holes_ = made.first;
    trouble_ = made.second;
    line(Theme::smallSize, [this] {
        return recorded_holes(model_->input().correction).empty()
                   ? tr("None yet. The plan appears here after the next run.")
                   : QString();
    });
    connect(model_, &SceneModel::changed, this, &CorrectionSheet::growRows);
    growRows();
}

void CorrectionSheet::growRows() {
    while (rows_.size() < std::ssize(recorded_holes(model_->input().correction))) {
        addHoleRow();
    }
}

void CorrectionSheet::addHoleRow() {
    const auto row = static_cast<std::size_t>(rows_.size());
    const int at = holes_->rowCount();
    auto* name = new QLabel(this);
    name->setFont(Theme::font(Theme::smallSize));
    name->setWordWrap(true);
    name->setMaximumWidth(Theme::withText(90));
    const auto place = [this, row] {
        const auto holes = recorded_holes(model_->input().correction);
        return row < holes.size() ? holes[row] : decltype(holes)::value_type{};
    };
    const auto present = [place] { return place().second; };
    const auto change = [this, row, present](const QString& step,
                                             const std::function<void(DrilledHole&)>& mutate) {
        if (present() != nullptr) {
            model_->editCorrection(step, [&](Correction& correction) {
                auto* of = &correction;
                mutate(*recorded_holes(of)[row].second);
            });
        }
    };
    // What differs from the plan was found on the crankshaft.
    const auto measure = [change](const QString& step,
                                  const std::function<void(DrilledHole&)>& mutate) {
        change(step, [&](DrilledHole& hole) {
            mutate(hole);
            hole.state = hole.state == HoleState::wrong_side ? hole.state : HoleState::measured;
            if (hole.slug || !hole.is_slug()) {
                hole.mass.reset();  // they were the plan's
                hole.unbalance.reset();
            }
        });
    };
    const auto choiceOf = [&](const Field& field, auto DrilledHole::*member, const char* key,
                              const QStringList& words, int width, const auto& set) {
        auto* made = new QComboBox(this);
        made->setObjectName(QStringLiteral("%1_%2").arg(QLatin1String(key)).arg(row + 1));
        made->setAccessibleName(fieldName(field));
        made->setToolTip(fieldHint(field));
        made->addItems(words);
        made->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        enlarge(made);
        made->setFont(Theme::font(Theme::smallSize));
        made->setMinimumWidth(Theme::withText(width));  // its words are read whole
        bind(
            made,
            [present, member] {
                const DrilledHole* hole = present();
                return hole != nullptr ? static_cast<int>(hole->*member) : -1;
            },
            [set, member, step = fieldName(field)](int place) {
                set(step, [&](DrilledHole& hole) {
                    hole.*member = static_cast<std::remove_cvref_t<decltype(hole.*member)>>(place);
                });
            });
        return made;
    };
    const auto numberOf = [&](const Field& field, double DrilledHole::*member, const char* key) {
        NumberField* made = cell(
            field, QStringLiteral("%1_%2").arg(QLatin1String(key)).arg(row + 1),
            [this, place, &field](const Words& words) {
                const auto [at, hole] = place();
                return (hole != nullptr
                            ? model_->drilledName(words, at.run) + QStringLiteral(", ") +
                                  model_->planeName(static_cast<std::size_t>(hole->plane), words) +
                                  QStringLiteral(": ")
                            : QString()) +
                       words.name(field);
            });
        made->setMinimumWidth(Theme::withText(50));
        constexpr int seen = 5;  // of an angle that was planned
        made->setDigits(seen);
        // Where it is, as the other tables have it; the record keeps where it was planned.
        const auto turned = [isAngle = member == &DrilledHole::angle](const DrilledHole& hole,
                                                                      double value) {
            return isAngle ? hole.turned(value) : value;
        };
        bind(
            made, field,
            [present, member, turned]() -> std::optional<double> {
                const DrilledHole* hole = present();
                return hole != nullptr ? std::optional(turned(*hole, hole->*member)) : std::nullopt;
            },
            [measure, member, turned, step = fieldName(field)](std::optional<double> value) {
                if (value) {
                    measure(step, [&](DrilledHole& hole) { hole.*member = turned(hole, *value); });
                }
            });
        made->setOptional(false);  // no depth is none, not that before
        trouble_->watch(made);
        return made;
    };
    QComboBox* plane = choiceOf(field::drilled_plane, &DrilledHole::plane, "drilled_plane",
                                {QString(), QString()}, 64, measure);
    NumberField* depth = numberOf(field::drilled_depth, &DrilledHole::depth, "drilled_depth");
    doubt(depth, [this, place] {
        return std::ranges::any_of(model_->doubts(), [&](const workshop::Doubt& each) {
            return each.rule->word == "shallower-hole" && each.hole == place().first;
        });
    });
    NumberField* angle = numberOf(field::drilled_angle, &DrilledHole::angle, "drilled_angle");
    QStringList states;
    for (const Word& word : state_words) {
        states << shownText(word.label);
    }
    QComboBox* state =
        choiceOf(field::drilled_state, &DrilledHole::state, "drilled_state", states, 0, change);
    state->setMinimumWidth(widthFor(state));
    const QList<QWidget*> widgets{name, ordered(plane), ordered(depth), ordered(angle),
                                  ordered(state)};
    for (int column = 0; column < widgets.size(); ++column) {
        holes_->addWidget(widgets[column], at, column);
    }
    followPlanes(plane);
    follow([this, place, name, state, widgets, hint = state->toolTip()] {
        const auto [at, hole] = place();
        for (QWidget* each : widgets) {
            each->setVisible(hole != nullptr);
        }
        if (hole != nullptr) {
            // What was measured is in the plan's place; where a slug's own mass is not recorded,
            // any other state may have it.
            const bool isPlanned = hole->state == HoleState::as_planned ||
                                   (hole->mass && hole->state != HoleState::measured &&
                                    (hole->slug || !hole->is_slug()));
            QStandardItem* asPlanned = qobject_cast<QStandardItemModel*>(state->model())
                                           ->item(static_cast<int>(HoleState::as_planned));
            asPlanned->setEnabled(isPlanned);
            asPlanned->setToolTip(
                isPlanned ? QString()
                          : tr("The planned values were replaced; Undo restores them."));
            state->setToolTip(isPlanned ? hint : hint + QLatin1Char('\n') + asPlanned->toolTip());
            name->setText(model_->drilledName(at.run, *hole));
        }
    });
    rows_ << widgets;
}

QWidget* CorrectionSheet::drilled(const std::optional<Hole::Place>& hole) const {
    const auto holes = recorded_holes(model_->input().correction);
    const auto found =
        std::ranges::find_if(holes, [&](const auto& each) { return each.first == hole; });
    return found == holes.end() ? nullptr : rows_.at(found - holes.begin()).last();
}

void CorrectionSheet::addHole(bool isBefore) {
    DrilledHole hole;
    hole.plane = static_cast<PlaneName>(whatIf_.plane);
    hole.diameter = whatIf_.diameter.value();
    hole.depth = whatIf_.depth.value();
    hole.angle = whatIf_.angle.value();
    hole.state = HoleState::measured;
    if (const auto left = isBefore ? std::nullopt : tried()) {
        hole.from_depth = left->room.from_depth;
        hole.angle = left->room.angle;
    }
    whatIf_ = {whatIf_.plane, {}, {}, {}};
    whatIfFields_.first()->setFocus(Qt::OtherFocusReason);  // the button goes grey
    model_->editCorrection(tr("Existing hole"), [&](Correction& correction) {
        if (!isBefore) {
            correction.earlier_runs.back().drilled->push_back(hole);
            return;
        }
        if (first_run(correction) == 0) {
            EarlierRun before;
            before.readings.clear();  // it was not read
            before.drilled.emplace();
            correction.earlier_runs.insert(correction.earlier_runs.begin(), std::move(before));
        }
        correction.earlier_runs.front().drilled->push_back(hole);
    });
}

}  // namespace ravnoves
