// What page, card and journal say of the plugs: sentences and tables.

#include <cmath>

#include "shop/model/verdict.h"
#include "text/capital.h"
#include "text/shown_units.h"
#include "v8-plugs/fields.h"
#include "v8-plugs/results.h"
#include "workshop/model/workshop_model.h"
#include "workshop/plugs/model/v8_text.h"

namespace ravnoves {

using namespace v8_plugs;
using v8_text::gramMillimetres;
using v8_text::grams;

namespace {

const QString dash = QStringLiteral("–");

}  // namespace

QStringList WorkshopModel::missingForPlugs(const Words& words, bool withBobWeight) const {
    QStringList names;
    for (const EngineField* each : missing_fields(plugsInput()->engine, withBobWeight)) {
        names << inSentence(words.name(each->field));
    }
    if (!plugsInput()->changes_known()) {
        names << words.translate("V8",
                                 "changes of mass (sheet 2) or masses of the parts (sheet 3)");
    }
    return names;
}

QStringList WorkshopModel::plugTroubles(const Words& words) const {
    if (plugs() == nullptr) {
        return {};
    }
    QStringList list;
    for (const EngineConflict& conflict : engine_conflicts(plugsInput()->engine)) {
        list << words.translate("V8", "%1: must be less than the plug's mass, %2.")
                    .arg(words.name(conflict.reduction->field),
                         grams(words, conflict.plug_mass, 3));
    }
    const PlugSheet plug = plugsInput()->plug.value_or(PlugSheet{});
    const auto geometry = plug.geometry();
    if (const auto fault = geometry ? geometry_fault(*geometry) : std::nullopt) {
        list << words.message(*fault);
    }
    if (plug.bore_diameter.has_value() != plug.bore_depth.has_value()) {
        list << words.translate("V8", "Enter both diameter and depth of the bore.");
    }
    return list;
}

QString WorkshopModel::adviceText(const Words& words) const {
    if (plugs() == nullptr || withheld().bob_weight) {
        return {};
    }
    if (!plugs()->advice) {
        const QStringList names = missingForPlugs(words, false);
        return names.isEmpty() ? words.translate("V8", "The values are inconsistent.")
                               : words.translate("V8", "Missing for the plugs: %1.")
                                     .arg(names.join(QStringLiteral(", ")));
    }
    const QString said = words.message(plug_work(*plugsInput(), *plugs()));
    return isProvisional() && !said.isEmpty() ? provisional(words, said) : said;
}

QString WorkshopModel::boringText(const Words& words) const {
    const bool isOption = plugs() != nullptr && plugs()->advice &&
                          plugs()->advice->kind == Advice::Kind::option;
    const auto bored = isOption ? plugs()->chosen()->right_boring() : std::nullopt;
    return bored && plugsInput()->plug
               ? words.message(describe(*bored, plugsInput()->plug->limits().value()))
               : QString();
}

QString WorkshopModel::excessText() const {
    if (plugs() == nullptr || !plugs()->advice || !plugs()->unbalanced_mass ||
        !plugsInput()->engine.crank_radius) {
        return {};
    }
    return tr("Excess Δmᵤ: %1, %2")
        .arg(grams(Words(), *plugs()->unbalanced_mass, 3),
             gramMillimetres(Words(),
                             *plugs()->unbalanced_mass * *plugsInput()->engine.crank_radius));
}

QString WorkshopModel::shiftText(const Words& words) const {
    const SolvedOption* option = plugs() != nullptr ? plugs()->chosen() : nullptr;
    if (plugs() != nullptr && option == nullptr) {
        const auto& usual = plugs()->option(OptionId::steel_machined);
        option = usual ? &*usual : nullptr;
    }
    if (option == nullptr) {
        return {};
    }
    const double plug = option->plug_mass_unmachined - option->reduction;
    QString text = words
                       .translate("V8",
                                  "The method neglects the shift of the plug's centre of mass by "
                                  "boring, %4 to %5. Effect: %1 to %2; permissible: %3.")
                       .arg(words.digits(shift_unbalance(plug, smallest_shift), units::gram_mm, 1),
                            gramMillimetres(words, shift_unbalance(plug, largest_shift)),
                            gramMillimetres(words, plugsInput()->tolerance),
                            words.digits(smallest_shift, units::mm, 1),
                            words.number(largest_shift, units::mm, 1));
    const auto& effect = option->shift;
    if (effect && effect->planned) {
        text +=
            QLatin1Char(' ') + words.translate("V8", "With the planned bore it moves by %1: %2.")
                                   .arg(words.plainWithUnit(effect->max_shift, units::mm, 2),
                                        gramMillimetres(words, effect->maximum));
    }
    return text;
}

QString WorkshopModel::plugsWhileHung(const Words& words) const {
    const BobWeight* hung =
        plugs() != nullptr && plugs()->before ? plugs()->hung_weight() : nullptr;
    return hung != nullptr
               ? words.translate("V8", "Without plugs; with the planned plugs use %1.")
                     .arg(grams(words, hung->with_plugs_in(), 1))
               : QString();
}

QString WorkshopModel::checkText() const {
    if (plugs() == nullptr) {
        return {};
    }
    const Words words;
    const v8_plugs::Result& solution = *plugs();
    QStringList said;
    if (solution.before && solution.nominal) {
        const double difference = solution.hung_weight()->sum() - solution.nominal->sum();
        const ShiftEffect* shift = solution.shift_that_matters();
        // Rounding of the sum, not a difference.
        const bool isNone = std::abs(difference) < 1e-9 * solution.nominal->sum();
        said << (isNone && !v8_text::works(solution)
                     ? words.translate("V8", "Would match nominal, but cannot be made.")
                 : isNone && shift != nullptr && !shift->planned
                     ? words.translate("V8", "Matches nominal within %1.")
                           .arg(gramMillimetres(words, shift->uncertainty))
                 : isNone ? words.translate("V8", "Matches nominal: balanced.")
                          : words.translate("V8", "Difference from nominal: %1 (%2).")
                                .arg(grams(words, difference),
                                     gramMillimetres(words,
                                                     difference * *solution.engine->crank_radius)));
    }
    said << words.message(rod_note(*plugsInput(), solution));
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
        .arg(gramMillimetres(Words(), tolerance));
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
        .arg(grams(Words(), volume * sheet->steel_density, 1),
             grams(Words(), volume * sheet->aluminium_density, 1));
}

Results WorkshopModel::optionResults() const {
    Results results{{
        {tr("Option"), tr("Option; ✓ sufficient, ✗ not sufficient, ! shift included")},
        {shownTitle(tr("fixed part, g")).text,
         tr("Mass compensated without boring, kₚ times the mass difference of the plugs")},
        {tr("gain"), tr("Mass compensated per gram taken off each plug")},
        {shownTitle(tr("maximum, g")).text, tr("Maximum mass that the option compensates")},
        {shownTitle(tr("take off each, g")).text,
         tr("Mass to take off each plug, as far as the plug allows it")},
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
        const QString name = v8_text::optionName(Words(), id);
        if (!option) {
            rows << ResultRow({name, dash, dash, dash, dash, dash, dash},
                              tr("The engine has no such plug, or its data are missing."));
            continue;
        }
        const QString mark = !option->works()            ? QStringLiteral("✗")
                             : option->by_method_alone() ? QStringLiteral("!")
                                                         : QStringLiteral("✓");
        rows << ResultRow(
            {// in brackets what the crankshaft that is fitted does not allow
             (isFitted(id) ? mark : QStringLiteral("(%1)").arg(mark)) + QLatin1Char(' ') + name,
             Words().cell(option->constant, units::gram, 3),
             Words().cell(option->slope, units::none, 3),
             Words().cell(option->maximum, units::gram, 3),
             Words().cell(option->take_off(), units::gram, 3),
             Words().cell(option->residual_mass, units::gram, 3),
             Words().cell(option->residual_unbalance, units::gram_mm, 1)},
            optionTip(*option));
        rows.last().name = QString::fromUtf8(option_word(id).word);  // whatever its mark
    }
    return results;
}

bool WorkshopModel::isFitted(OptionId id) const {
    return needs_new_crankshaft(id) == (input().plugs->crankshaft == Crankshaft::new_plugs);
}

QString WorkshopModel::optionTip(const SolvedOption& option) const {
    QStringList text;
    if (!isFitted(option.id)) {
        text << tr("For the other crankshaft.");
    }
    if (option.by_method_alone()) {
        text << tr("The take-off includes the shift; the method alone would leave up to %1.")
                    .arg(gramMillimetres(Words(), std::abs(option.shift->residual_unbalance)));
    }
    text << tr("%1: %2.").arg(
        v8_text::optionName(Words(), option.id),
        Words().message(describe_verdict(option, plugsInput()->tolerance)));
    return text.join(QLatin1Char('\n'));
}

}  // namespace ravnoves
