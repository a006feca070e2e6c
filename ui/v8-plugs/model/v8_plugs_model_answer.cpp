// What the page shows of the solution: sentences and tables.

#include <cmath>

#include "text/shown_units.h"
#include "v8-plugs/model/v8_names.h"
#include "v8-plugs/model/v8_plugs_model.h"
#include "v8-plugs/model/v8_text.h"
#include "workshop/model/verdict.h"

namespace ravnoves {

using namespace v8_plugs;

namespace {

using units::gram;
using units::gram_mm;

const QString dash = QStringLiteral("–");

}  // namespace

QString V8PlugsModel::adviceText() const {
    if (solution().advice) {
        return v8_text::advice(words_, input(), solution());
    }
    const QString names = v8_names::missingNames(words_, input(), false);
    return names.isEmpty() ? tr("The values do not go together.")
                           : tr("Still needed: %1.").arg(names);
}

QString V8PlugsModel::boringText() const {
    return solution().advice && solution().advice->kind == Advice::Kind::option &&
                   !v8_text::doubtsWeights(input())
               ? v8_text::boring(words_, input(), solution(), solution().advice->option->id)
               : QString();
}

QString V8PlugsModel::excessText() const {
    if (!solution().unbalanced_mass || !input().engine.crank_radius) {
        return tr("Excess Δmᵤ: not known yet");
    }
    return (v8_text::hasUnequalCrankpins(input(), solution())
                ? tr("Excess Δmᵤ: %1, %2, the mean of unequal crankpins")
                : tr("Excess Δmᵤ: %1, %2"))
        .arg(v8_text::grams(words_, *solution().unbalanced_mass, 3),
             v8_text::gramMillimetres(words_,
                                      *solution().unbalanced_mass * *input().engine.crank_radius));
}

QStringList V8PlugsModel::troubles() const {
    return v8_text::troubles(words_, input(), solution());
}

QString V8PlugsModel::shiftText() const {
    return v8_text::shiftText(words_, input(), solution());
}

QString V8PlugsModel::checkText() const {
    return v8_text::bobWeightCheck(words_, input(), solution());
}

QString V8PlugsModel::plugsText() const {
    return v8_text::plugsWhileHung(words_, solution());
}

QString V8PlugsModel::rodFactorText() const {
    return v8_text::rodFactor(words_, input(), solution());
}

QString V8PlugsModel::toleranceText() const {
    const QString owner = v8_text::toleranceOwner(words_, input());
    return isShopsTolerance() || v8_text::isPapersTolerance(input())
               ? owner
               : tr("%1 in each plane is for this job alone.")
                     .arg(v8_text::gramMillimetres(words_, input().tolerance));
}

QString V8PlugsModel::hangText() const {
    return solution().before ? v8_text::hang(words_, solution()) : missingText();
}

QString V8PlugsModel::missingText() const {
    QStringList names = v8_names::missing(words_, input(), true);
    if (!solution().advice) {  // which names its own
        const QStringList said = v8_names::missing(words_, input(), false);
        names.removeIf([&](const QString& name) { return said.contains(name); });
    }
    return names.isEmpty()
               ? QString()
               : tr("The bob weight still needs: %1.").arg(names.join(QStringLiteral(", ")));
}

QString V8PlugsModel::isoText() const {
    if (!solution().balancing || !input().balancing) {
        return tr("ISO 21940-11 needs grade, mass and speed.");
    }
    return tr("ISO 21940-11: Uₚₑᵣ = 1000 m G / ω = %1 for the whole crankshaft.")
        .arg(v8_text::gramMillimetres(words_, solution().balancing->permissible));
}

QString V8PlugsModel::machineLimitsText() const {
    return v8_text::machineLimits(words_, input(), solution());
}

QString V8PlugsModel::plugWeightText() const {
    if (!input().plug || !input().plug->geometry()) {
        return tr("With thread and height the sheet says what the plug would weigh.");
    }
    if (const auto fault = geometry_fault(*input().plug->geometry())) {
        return words_.message(*fault);
    }
    const double volume = input().plug->geometry()->volume();
    return tr("A plug of these dimensions weighs %1 in steel, %2 in aluminium.")
        .arg(v8_text::grams(words_, volume * input().plug->steel_density, 1),
             v8_text::grams(words_, volume * input().plug->aluminium_density, 1));
}

QStringList V8PlugsModel::notCounted() const {
    return v8_text::notCounted(words_, input());
}

Results V8PlugsModel::optionResults() const {
    Results results{{
        {tr("Option"), tr("What is bored or replaced; ✓ it is enough, ✗ it is not, ! only by the "
                          "method")},
        {shownTitle(tr("const., g")).text,
         tr("Unbalanced mass that the option takes away with nothing bored, "
            "kₚ times the exchange of plugs")},
        {tr("slope"), tr("Unbalanced mass for each gram that is bored out of a plug")},
        {shownTitle(tr("reach, g")).text,
         tr("Largest unbalanced mass that the option compensates")},
        {shownTitle(tr("needed, g")).text,
         tr("To come off each plug; negative or beyond what is possible where the "
            "option cannot")},
        {shownTitle(tr("left, g")).text, tr("Unbalanced mass that stays")},
        {shownTitle(tr("left, g·mm")).text, tr("Unbalance that stays, mass times crank radius")},
    }};
    ResultRows& rows = results.rows;
    for (const OptionId id : all_options) {
        const auto& option = solution().option(id);
        const QString name =
            areNamesShort_ ? v8_names::shortOption(words_, id) : v8_names::optionName(words_, id);
        if (!option) {
            rows << ResultRow({name, dash, dash, dash, dash, dash, dash},
                              tr("The engine has no such plug, or its data are missing."));
            continue;
        }
        const bool works = option->feasible && solution().can_be_made(id);
        const QString mark = !works                                 ? QStringLiteral("✗")
                             : v8_text::methodAlone(solution(), id) ? QStringLiteral("!")
                                                                    : QStringLiteral("✓");
        rows << ResultRow(
            {// in brackets what the crankshaft that is fitted does not allow
             (isFitted(id) ? mark : QStringLiteral("(%1)").arg(mark)) + QLatin1Char(' ') + name,
             words_.cell(option->constant, gram, 3), words_.cell(option->slope, units::none, 3),
             words_.cell(option->maximum, gram, 3),
             words_.cell(option->required_reduction, gram, 3),
             words_.cell(option->residual_mass, gram, 3),
             words_.cell(option->residual_unbalance, gram_mm, 1)},
            optionTip(*option));
        rows.last().name = QString::fromUtf8(option_word(id).word);  // whatever its mark
    }
    return results;
}

void V8PlugsModel::setShortNames(bool areShort) {
    if (std::exchange(areNamesShort_, areShort) != areShort) {
        Q_EMIT viewChanged();
    }
}

bool V8PlugsModel::isFitted(OptionId id) const {
    return needs_new_crankshaft(id) == (input().crankshaft == Crankshaft::new_plugs);
}

QString V8PlugsModel::optionTip(const Option& option) const {
    QStringList text;
    if (!isFitted(option.id)) {
        text << tr("For the other crankshaft.");
    }
    if (v8_text::methodAlone(solution(), option.id)) {
        text << tr("By the method alone; the shift that it neglects leaves up to %1.")
                    .arg(v8_text::gramMillimetres(
                        words_, std::abs(solution().shift[index(option.id)]->residual_unbalance)));
    }
    text << QStringList{
        tr("%1: %2.").arg(v8_names::optionName(words_, option.id),
                          words_.message(describe_verdict(option, input().tolerance))),
        tr("At most %1 may come off a plug; slope kᵤ = %2, %3°.")
            .arg(v8_text::grams(words_, option.max_reduction, 3), words_.number(option.slope, 3),
                 v8_text::slopeAngle(words_, option.slope))};
    const QString boring = v8_text::boring(words_, input(), solution(), option.id);
    if (!boring.isEmpty()) {
        text << boring;
    }
    text << v8_text::shiftText(words_, input(), solution(), option);
    return text.join(QLatin1Char('\n'));
}

Results V8PlugsModel::bobWeightResults() const {
    Results results{{{shownTitle(tr("factor × mass, g")).text,
                      tr("Share of the part in the bob weight times its mass")},
                     {tr("nominal"), tr("By the nominal masses")},
                     {tr("before"), tr("With the parts as they are")},
                     {tr("after"), tr("After the compensation")}}};
    ResultRows& rows = results.rows;
    if (!solution().nominal || !solution().before) {
        return results;
    }
    for (const BobWeightLine& line : solution().before->lines) {
        rows << v8_text::bobWeightCells(words_, solution(), line.part, 2, dash);
        rows.last().prepend(v8_names::shortLine(words_, line));
    }
    rows << v8_text::bobWeightCells(words_, solution(), std::nullopt, 2, dash);
    rows.last().prepend(tr("Bob weight"));
    rows.last().tip = tr("Sum of the lines: what is hung on each crankpin");
    return results;
}

Results V8PlugsModel::planeResults() const {
    Results results{{
        {tr("Plane"), tr("Correction plane of the crankshaft")},
        {shownTitle(tr("allowed, g·mm")).text,
         tr("Permissible residual unbalance, share of U = G m / ω "
            "(ISO 21940-11)")},
        {shownTitle(tr("reading, g·mm")).text, tr("What the balancing machine reads")},
        {tr("verdict"), tr("Passes where the reading is not above what is allowed")},
    }};
    ResultRows& rows = results.rows;
    const auto add = [&](const QString& name, const PlaneVerdict& plane) {
        rows << ResultRow{
            name, words_.cell(plane.permissible, gram_mm, 1),
            plane.reading ? words_.cell(*plane.reading, gram_mm, 1) : ResultCell(dash),
            !plane.passes         ? dash
            : !solution().holds() ? verdictText(words_, otherWord(solution()))
            : *plane.passes       ? tr("✓ passes")
                                  : tr("✗ fails")};
    };
    add(tr("Front (pulley)"), solution().planes[0]);
    add(tr("Rear (flywheel)"), solution().planes[1]);
    return results;
}

QString V8PlugsModel::weighAgain() const {
    return v8_text::weighAgain(words_, input());
}

std::optional<matching_text::Shown> V8PlugsModel::matchingShown() const {
    return v8_text::matchingShown(input(), solution());
}

Results V8PlugsModel::takeOffResults() const {
    return input().weigh_in
               ? matching_text::takeOff(words_, cylinder_count, masses_of(*input().weigh_in))
               : Results();
}

Results V8PlugsModel::crankpinResults() const {
    if (!solution().weighed_excess || !solution().assigned_excess || !weighAgain().isEmpty()) {
        return {};
    }
    const auto row = [&](const QString& name, const std::array<double, crankpin_count>& excess,
                         const QString& tip) {
        ResultRow cells({shownTitle(name).text}, tip);
        for (const double mass : excess) {
            cells << words_.cell(mass, gram, 2);
        }
        cells << words_.cell(spread(excess), gram, 2);
        return cells;
    };
    return {{tr("Crankpin"),
             QStringLiteral("1"),
             QStringLiteral("2"),
             QStringLiteral("3"),
             QStringLiteral("4"),
             {tr("spread"), tr("Largest less smallest excess of the four crankpins")}},
            {row(tr("as weighed, g"), *solution().weighed_excess,
                 tr("Excess on each crankpin over the mean, parts where they were weighed")),
             row(tr("after moving, g"), *solution().assigned_excess,
                 tr("Excess on each crankpin over the mean, parts moved"))}};
}

WeighedColumn V8PlugsModel::columnNote(Part part) const {
    const PartColumn column = input().weigh_in.value_or(WeighIn{})[part];
    return weighedColumn(words_, part, statistics(column), column.nominal,
                         input().changes_from_weigh_in && column.is_complete());
}

}  // namespace ravnoves
