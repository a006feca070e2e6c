#include "v8-plugs/plugs_card_painter.h"

#include <algorithm>
#include <cmath>

#include "text/shown_units.h"
#include "v8-plugs/fields.h"
#include "v8-plugs/model/v8_names.h"
#include "v8-plugs/model/v8_text.h"
#include "v8-plugs/plug_drawing.h"
#include "workshop/card_blocks.h"

namespace ravnoves {

using namespace v8_plugs;

namespace {

using units::gram;

const QColor cutColour(0xB0, 0x30, 0x10);

constexpr double inputRow = 3.6;  // mm
constexpr double signaturesTop = 276.5;
constexpr double remarkPoints = 8.0;

}  // namespace

void PlugsCardPainter::paint() {
    // A card with a warning has much to say.
    const double gap = v8_text::shiftWarning(words_, input_, solution_).isEmpty() ? 2.2 : 1.0;
    using Section = double (PlugsCardPainter::*)(double);
    const auto section = [this](Section paint) {
        return [this, paint](double y) { return (this->*paint)(y); };
    };
    const double machineTop =
        signaturesTop - 0.3 - sheet_.heightOf(section(&PlugsCardPainter::machine));
    sheet_.setFoot(machineTop - gap, [this, machineTop] { foot(machineTop); });
    double y = CardPage::top - gap;
    for (const Section paint :
         {&PlugsCardPainter::head, &PlugsCardPainter::answer, &PlugsCardPainter::inputs,
          &PlugsCardPainter::options, &PlugsCardPainter::bobWeights}) {
        y = sheet_.place(y + gap, section(paint));
    }
    const QString notes = QString::fromStdString(input_.job.notes).simplified();
    const auto weights = section(&PlugsCardPainter::weighIn);
    const double weightsHeight = sheet_.heightOf(weights);
    const double room = sheet_.end() - y - 3 * gap - weightsHeight - cardNotesHeight(sheet_, notes);
    // Smaller where that keeps all on one sheet; else what is doubtful stays on the first.
    double points = remarkPoints;
    while (points > CardPage::smallestType && heightOfRemarks(points) > room) {
        points -= 0.25;
    }
    const bool isOneSheet = heightOfRemarks(points) <= room;
    if (isOneSheet) {
        y = sheet_.place(y + gap, weights);
    }
    y = remarks(y + gap, isOneSheet ? points : remarkPoints);
    y = cardNotes(sheet_, words_, notes, y + gap);
    if (!isOneSheet) {
        y = sheet_.place(y + gap, weights);
    }
    sheet_.finishSheet();
}

void PlugsCardPainter::foot(double machineTop) {
    machine(machineTop);
    cardSignatures(
        sheet_, words_,
        words_.translate("JobCard", "Ravnoves %1 · method: A. D. Nazarov, equations (3)–(24)")
            .arg(QStringLiteral(RAVNOVES_VERSION)),
        signaturesTop);
}

QString PlugsCardPainter::grams(double mass, int decimals) const {
    return words_.digits(mass, gram, decimals);
}

double PlugsCardPainter::head(double y) {
    return cardHead(sheet_, words_,
                    {words_.translate("JobCard", "Job card: crankpin plugs and bob weights"),
                     words_.translate("JobCard", "V-8 engine: %1")
                         .arg(v8_names::engineName(words_, input_.engine.name)),
                     input_.job, words_.translate("JobCard", "Work · crankshaft"),
                     words_.text(process_words[static_cast<int>(input_.process)].label) +
                         QStringLiteral(" · ") +
                         words_.text(crankshaft_words[static_cast<int>(input_.crankshaft)].label)},
                    y);
}

double PlugsCardPainter::answer(double y) {
    QString fact;
    QString action;
    QStringList more;
    const bool isDoubted = solution_.advice && v8_text::doubtsWeights(input_);
    const QString warning =
        isDoubted ? QString() : v8_text::shiftWarning(words_, input_, solution_);
    if (solution_.advice) {
        const double excess = *solution_.unbalanced_mass;
        fact = words_.translate("JobCard", "Excess on each crankpin Δmᵤ = %1 (%2)")
                   .arg(v8_text::grams(words_, excess, 3),
                        v8_text::gramMillimetres(
                            words_, excess * input_.engine.crank_radius.value_or(0.0)));
        action = v8_text::advice(words_, input_, solution_);
        const QString boring =
            solution_.advice->kind == Advice::Kind::option && !isDoubted
                ? v8_text::boring(words_, input_, solution_, solution_.advice->option->id)
                : QString();
        if (isDoubted) {
            // What the weights would give is not to be done.
        } else if (warning.isEmpty()) {
            more << boring << v8_text::bobWeightCheck(words_, input_, solution_);
        } else {  // what is to be done stands above what the method says
            action = (action + QLatin1Char(' ') + boring).trimmed();
        }
        more.removeAll(QString());
    } else {
        action = words_.translate("JobCard", "The data are not complete; nothing can be advised.");
        fact = words_.translate("JobCard", "Not known without: %1.")
                   .arg(v8_names::missingNames(words_, input_, false));
    }
    QStringList wrong{refused_, warning, v8_text::unequalCrankpins(words_, input_, solution_),
                      v8_text::otherReadings(words_, solution_)};
    if (isDoubted) {
        wrong << v8_text::massTroubles(words_, input_);
    }
    wrong.removeAll(QString());
    return cardAnswer(
        sheet_, {fact, action, more.join(QLatin1Char(' ')), {}, wrong.join(QLatin1Char(' '))}, y);
}

double PlugsCardPainter::inputs(double y) {
    constexpr double gap = 4.0;
    constexpr double engineWidth = 117.0;
    const double height = engineTable(y, engineWidth);
    changesTable(left + engineWidth + gap, y, full - engineWidth - gap);
    return y + height;
}

double PlugsCardPainter::engineTable(double y, double width) {
    sheet_.heading(left, y, width, words_.translate("JobCard", "Engine"));
    CardTable engine({{34, Qt::AlignLeft},
                      {13},
                      {7.5, Qt::AlignLeft},
                      {42, Qt::AlignLeft},
                      {13},
                      {7.5, Qt::AlignLeft}},
                     7.5, inputRow);
    const auto fields = engine_fields();
    const std::size_t half = (fields.size() + 1) / 2;
    const auto cells = [&](std::size_t i) -> QStringList {
        if (i >= fields.size()) {
            return {QString(), QString(), QString()};
        }
        const auto& [field, member, group] = fields[i];
        const auto& value = input_.engine.*member;
        // As typed; what is converted with digits that mean something.
        const int decimals = shownAs(field.unit) == field.unit ? 4 : 3;
        return {words_.name(field), value ? words_.plain(*value, field.unit, decimals) : missing,
                words_.unit(field.unit)};
    };
    for (std::size_t i = 0; i < half; ++i) {
        engine.add({cells(i) + cells(i + half)});
    }
    return 5.2 + engine.draw(sheet_, left, y + 5.2);
}

void PlugsCardPainter::changesTable(double x, double y, double width) {
    sheet_.heading(x, y, width, words_.translate("JobCard", "Heavier than nominal by"));
    CardTable changes({{width - 23, Qt::AlignLeft}, {13}, {10, Qt::AlignLeft}}, 7.5, inputRow);
    for (const MassChangeField& field : mass_change_fields()) {
        if (field.repair_only && input_.process == Process::manufacture &&
            solution_.changes.*field.member == 0.0) {
            continue;
        }
        changes.add(
            {{words_.name(field.field),
              input_.changes_known() ? words_.plain(solution_.changes.*field.member, gram, 3)
                                     : missing,
              unitGram()}});
    }
    changes.add(
        {{words_.translate("JobCard", "Excess Δmᵤ"),
          solution_.unbalanced_mass ? grams(*solution_.unbalanced_mass, 3) : missing, unitGram()},
         true,
         true});
    changes.add({{words_.name(field::tolerance), words_.plain(input_.tolerance, units::gram_mm, 2),
                  unitUnbalance()}});
    changes.draw(sheet_, x, y + 5.2);
}

double PlugsCardPainter::options(double y) {
    sheet_.heading(left, y, full, words_.translate("JobCard", "Options, in the order of cost"));
    CardTable table({{50, Qt::AlignLeft}, {16}, {16}, {19}, {19}, {20}, {42, Qt::AlignRight}}, 7.5,
                    3.8);
    const QString g = unitGram();
    table.head({QString(), words_.translate("JobCard", "constant, %1").arg(g),
                words_.translate("JobCard", "reach, %1").arg(g),
                words_.translate("JobCard", "needed, %1").arg(g),
                words_.translate("JobCard", "limit, %1").arg(g),
                words_.translate("JobCard", "left, %1").arg(unitUnbalance()),
                words_.translate("JobCard", "verdict")});
    const auto chosen = v8_text::chosenOption(solution_);
    const bool recommended = solution_.advice && solution_.advice->kind == Advice::Kind::option;
    for (const OptionId id : all_options) {
        const auto& option = solution_.option(id);
        if (!option) {
            table.add(
                {{v8_names::optionName(words_, id), missing, missing, missing, missing, missing,
                  solution_.plugs && solution_.unbalanced_mass
                      ? words_.translate("JobCard", "no such plug")
                      : missing}});
            continue;
        }
        const bool fitted =
            needs_new_crankshaft(id) == (input_.crankshaft == Crankshaft::new_plugs);
        const bool best = recommended && chosen && chosen->id == id;
        table.add(
            {{v8_names::optionName(words_, id), grams(option->constant, 3),
              grams(option->maximum, 3), grams(option->required_reduction, 3),
              grams(option->max_reduction, 3),
              words_.digits(option->residual_unbalance, units::gram_mm, 1),
              !fitted ? words_.translate("JobCard", "other crankshaft") + QStringLiteral(": ") +
                            (option->feasible && solution_.can_be_made(id)
                                 ? words_.translate("JobCard", "works")
                                 : words_.translate("JobCard", "does not work"))
              : !solution_.can_be_made(id) ? words_.translate("JobCard", "cannot be made")
              : best && v8_text::methodAlone(solution_, id)
                  ? words_.translate("JobCard", "check: see above")
              : v8_text::methodAlone(solution_, id)
                  ? words_.translate("JobCard", "by the method alone")
              : option->feasible ? words_.translate("JobCard", "works")
                                 : words_.translate("JobCard", "does not work")},
             best,
             best});
    }
    double height = 5.0 + table.draw(sheet_, left, y + 5.0);
    height +=
        0.4 + sheet_.paragraph(
                  left, y + height + 0.4, full,
                  words_
                      .translate("JobCard",
                                 "Each compensates constant + kᵤ × lightening of one plug, kᵤ = %1 "
                                 "(slope %2°); needed: lightening of one plug.")
                      .arg(solution_.plugs ? words_.number(solution_.plugs->coefficients().k_y, 3)
                                           : missing,
                           solution_.plugs
                               ? v8_text::slopeAngle(words_, solution_.plugs->coefficients().k_y)
                               : missing),
                  6.8, false, CardPage::grey);
    return y + height;
}

double PlugsCardPainter::bobWeights(double y) {
    const double tableWidth = 112.0;
    sheet_.heading(left, y, tableWidth,
                   words_.translate("JobCard", "Bob weight on each crankpin, %1").arg(unitGram()));
    double height = 0.0;
    if (solution_.nominal && solution_.before) {
        height = bobWeightTable(y + 5.0);
    } else {
        height = sheet_.paragraph(left, y + 5.4, tableWidth,
                                  words_.translate("JobCard", "Not known without: %1.")
                                      .arg(v8_names::missingNames(words_, input_, true)),
                                  8);
    }
    const double x = left + tableWidth + 4.0;
    const double width = full - tableWidth - 4.0;
    sheet_.heading(x, y, width, words_.translate("JobCard", "Plug"));
    const double drawingHeight = std::max(height + 1.0, 44.0);
    plug(x, y + 5.4, width, drawingHeight - 1.0);
    return y + 5.0 + std::max(height, drawingHeight);
}

double PlugsCardPainter::bobWeightTable(double y) {
    const auto chosen = v8_text::chosenOption(solution_);
    CardTable table({{44, Qt::AlignLeft}, {14}, {18}, {18}, {18}}, 7.5, 3.5);
    table.head({words_.translate("JobCard", "factor × mass"), words_.translate("JobCard", "factor"),
                words_.translate("JobCard", "nominal"), words_.translate("JobCard", "before"),
                words_.translate("JobCard", "after")});
    const auto weights = [&](std::optional<BobWeightLine::Part> part) {
        return v8_text::bobWeightCells(words_, solution_, part, 3, missing).texts();
    };
    for (const BobWeightLine& line : solution_.before->lines) {
        QString name = words_.text(bob_weight_word(line.part).label);
        if (line.part == BobWeightLine::Part::plugs) {
            const double mass =
                chosen ? chosen->plug_mass_unmachined - chosen->reduction : line.mass;
            name = (chosen && v8_text::methodAlone(solution_, chosen->id)
                        ? words_.translate("JobCard", "Plug (after, by the method: %1)")
                        : words_.translate("JobCard", "Plug (after: %1)"))
                       .arg(v8_text::grams(words_, mass, 3));
        }
        table.add({QStringList{name, words_.plain(line.factor, 4)} + weights(line.part)});
    }
    table.add({QStringList{words_.translate("JobCard", "Sum: bob weight"), QString()} +
                   weights(std::nullopt),
               true, true});
    double height = table.draw(sheet_, left, y);
    const double width = table.tableWidth();
    const auto say = [&](const QString& text, double points, bool bold, const QColor& colour) {
        height += sheet_.paragraph(left, y + height, width, text, points, bold, colour);
    };
    height += 0.6;
    say(v8_text::hang(words_, solution_), 10, true,
        v8_text::doubtsWeights(input_) ? CardPage::amber : CardPage::ink);
    say(v8_text::plugsWhileHung(words_, solution_), 6.8, false, CardPage::ink);
    if (solution_.changes.rod_big_end != 0.0) {
        say(v8_text::rodFactor(words_, input_, solution_), 6.8, false, CardPage::grey);
    }
    return height;
}

void PlugsCardPainter::plug(double x, double y, double w, double h) {
    if (sheet_.isMeasuring()) {
        return;
    }
    const DrawingStyle style{CardPage::ink, CardPage::hair,   CardPage::ink,
                             cutColour,     sheet_.font(7.5), 0.35 * sheet_.unit()};
    const QRectF target = sheet_.rect(x, y, w, h);
    drawPlug(sheet_.painter(), target, plannedPlug(input_, solution_), style, words_);
}

}  // namespace ravnoves
