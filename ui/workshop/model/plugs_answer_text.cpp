// What the page shows of the solution: sentences and tables.

#include <cmath>

#include "shop/model/verdict.h"
#include "text/shown_units.h"
#include "workshop/model/workshop_model.h"
#include "workshop/plugs/model/v8_names.h"
#include "workshop/plugs/model/v8_text.h"

namespace ravnoves {

using namespace v8_plugs;

namespace {

using units::gram;
using units::gram_mm;

const QString dash = QStringLiteral("–");

}  // namespace

QString WorkshopModel::adviceText(const Words& words) const {
    if (plugs() == nullptr || withheld().bob_weight) {
        return {};
    }
    if (plugs()->advice) {
        return v8_text::advice(words, *plugsInput(), *plugs());
    }
    const QStringList names = v8_names::missing(words, *plugsInput(), false);
    return names.isEmpty() ? words.translate("V8", "The values are inconsistent.")
                           : words.translate("V8", "Missing for the plugs: %1.")
                                 .arg(names.join(QStringLiteral(", ")));
}

QString WorkshopModel::boringText(const Words& words) const {
    return plugs() != nullptr && plugs()->advice && plugs()->advice->kind == Advice::Kind::option
               ? v8_text::boring(words, *plugsInput(), *plugs(), plugs()->advice->option->id)
               : QString();
}

QString WorkshopModel::excessText() const {
    if (plugs() == nullptr || !plugs()->advice || !plugs()->unbalanced_mass ||
        !plugsInput()->engine.crank_radius) {
        return {};
    }
    return tr("Excess Δmᵤ: %1, %2")
        .arg(v8_text::grams(Words(), *plugs()->unbalanced_mass, 3),
             v8_text::gramMillimetres(
                 Words(), *plugs()->unbalanced_mass * *plugsInput()->engine.crank_radius));
}

QString WorkshopModel::shiftText() const {
    return plugs() != nullptr ? v8_text::shiftText(Words(), *plugsInput(), *plugs()) : QString();
}

QString WorkshopModel::checkText() const {
    if (plugs() == nullptr) {
        return {};
    }
    QStringList said{v8_text::bobWeightCheck(Words(), *plugsInput(), *plugs()),
                     v8_text::rodFactor(Words(), *plugsInput(), *plugs())};
    said.removeAll(QString());
    return said.join(QLatin1Char(' '));
}

QString WorkshopModel::toleranceText() const {
    if (!hasPlugs()) {
        return {};
    }
    const double tolerance = plugsInput()->tolerance;
    const bool isPapers = std::abs(tolerance - default_tolerance) < 1e-6 * default_tolerance;
    return (isPapers ? tr("Limit of this method: %1 in each plane, the residual of Nazarov's "
                          "experiments.")
            : isShopsTolerance() ? tr("Shop limit: %1 in each plane.")
                                 : tr("%1 in each plane, for this job only."))
        .arg(v8_text::gramMillimetres(Words(), tolerance));
}

QString WorkshopModel::plugWeightText() const {
    const auto& sheet = hasPlugs() ? input().plugs->plug : std::nullopt;
    if (!sheet || !sheet->geometry()) {
        return tr("Enter thread and height to see the mass of the plug.");
    }
    if (const auto fault = geometry_fault(*sheet->geometry())) {
        return Words().message(*fault);
    }
    const double volume = sheet->geometry()->volume();
    return tr("A plug of these dimensions weighs %1 in steel, %2 in aluminium.")
        .arg(v8_text::grams(Words(), volume * sheet->steel_density, 1),
             v8_text::grams(Words(), volume * sheet->aluminium_density, 1));
}

Results WorkshopModel::optionResults() const {
    Results results{{
        {tr("Option"), tr("Option; ✓ sufficient, ✗ not sufficient, ! only by the method")},
        {shownTitle(tr("fixed part, g")).text,
         tr("Mass compensated without boring, kₚ times the exchange of plugs")},
        {tr("gain"), tr("Mass compensated per gram taken off each plug")},
        {shownTitle(tr("maximum, g")).text, tr("Maximum mass that the option compensates")},
        {shownTitle(tr("take off each, g")).text,
         tr("Mass to take off each plug; negative or beyond the maximum if the option is not "
            "sufficient")},
        {shownTitle(tr("remains, g")).text, tr("Residual mass")},
        {shownTitle(tr("remains, g·mm")).text, tr("Residual unbalance, mass times crank radius")},
    }};
    ResultRows& rows = results.rows;
    if (plugs() == nullptr || withheld().bob_weight) {
        return results;
    }
    const v8_plugs::Result& solution = *plugs();
    for (const OptionId id : all_options) {
        const auto& option = solution.option(id);
        const QString name = v8_names::optionName(Words(), id);
        if (!option) {
            rows << ResultRow({name, dash, dash, dash, dash, dash, dash},
                              tr("The engine has no such plug, or its data are missing."));
            continue;
        }
        const bool works = option->feasible && solution.can_be_made(id);
        const QString mark = !works                               ? QStringLiteral("✗")
                             : v8_text::methodAlone(solution, id) ? QStringLiteral("!")
                                                                  : QStringLiteral("✓");
        rows << ResultRow(
            {// in brackets what the crankshaft that is fitted does not allow
             (isFitted(id) ? mark : QStringLiteral("(%1)").arg(mark)) + QLatin1Char(' ') + name,
             Words().cell(option->constant, gram, 3), Words().cell(option->slope, units::none, 3),
             Words().cell(option->maximum, gram, 3),
             Words().cell(option->required_reduction, gram, 3),
             Words().cell(option->residual_mass, gram, 3),
             Words().cell(option->residual_unbalance, gram_mm, 1)},
            optionTip(*option));
        rows.last().name = QString::fromUtf8(option_word(id).word);  // whatever its mark
    }
    return results;
}

bool WorkshopModel::isFitted(OptionId id) const {
    return needs_new_crankshaft(id) == (input().plugs->crankshaft == Crankshaft::new_plugs);
}

QString WorkshopModel::optionTip(const Option& option) const {
    const v8_plugs::Result& solution = *plugs();
    QStringList text;
    if (!isFitted(option.id)) {
        text << tr("For the other crankshaft.");
    }
    if (v8_text::methodAlone(solution, option.id)) {
        text << tr("By the method only; the neglected shift leaves up to %1.")
                    .arg(v8_text::gramMillimetres(
                        Words(), std::abs(solution.shift[index(option.id)]->residual_unbalance)));
    }
    text << QStringList{
        tr("%1: %2.").arg(v8_names::optionName(Words(), option.id),
                          Words().message(describe_verdict(option, plugsInput()->tolerance))),
        tr("Maximum off a plug: %1; slope kᵤ = %2, %3°.")
            .arg(v8_text::grams(Words(), option.max_reduction, 3), Words().number(option.slope, 3),
                 v8_text::slopeAngle(Words(), option.slope))};
    const QString boring = v8_text::boring(Words(), *plugsInput(), solution, option.id);
    if (!boring.isEmpty()) {
        text << boring;
    }
    text << v8_text::shiftText(Words(), *plugsInput(), solution, option);
    return text.join(QLatin1Char('\n'));
}

Results WorkshopModel::crankpinResults() const {
    if (plugs() == nullptr || !plugs()->weighed_excess || !plugs()->assigned_excess ||
        !weighAgain().isEmpty()) {
        return {};
    }
    const v8_plugs::Result& solution = *plugs();
    const auto row = [&](const QString& name, const std::array<double, crankpin_count>& excess,
                         const QString& tip) {
        ResultRow cells({shownTitle(name).text}, tip);
        for (const double mass : excess) {
            cells << Words().cell(mass, gram, 2);
        }
        cells << Words().cell(spread(excess), gram, 2);
        return cells;
    };
    return {{tr("Crankpin"),
             QStringLiteral("1"),
             QStringLiteral("2"),
             QStringLiteral("3"),
             QStringLiteral("4"),
             {tr("range"), tr("Maximum minus minimum excess of the four crankpins")}},
            {row(tr("as weighed, g"), *solution.weighed_excess,
                 tr("Excess on each crankpin over the mean, parts as weighed")),
             row(tr("after moving, g"), *solution.assigned_excess,
                 tr("Excess on each crankpin over the mean, parts moved"))}};
}

}  // namespace ravnoves
