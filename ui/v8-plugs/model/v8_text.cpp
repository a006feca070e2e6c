#include "v8-plugs/model/v8_text.h"

#include <algorithm>
#include <cmath>

#include "shop/kilograms.h"
#include "text/capital.h"
#include "text/number_text.h"
#include "v8-plugs/model/v8_names.h"
#include "v8-plugs/presets.h"
#include "workshop/model/mass_doubts.h"
#include "workshop/model/verdict.h"
#include "workshop/model/weigh_again.h"

namespace ravnoves::v8_text {

using namespace v8_plugs;

QString grams(const Words& words, double mass, int decimals) {
    return words.number(mass, units::gram, decimals);
}

QString gramMillimetres(const Words& words, double unbalance, int decimals) {
    return words.number(unbalance, units::gram_mm, decimals);
}

QString thread(const Words& words, const Thread& thread) {
    return QStringLiteral("M%1×%2").arg(words.plain(thread.diameter / units::mm, 2),
                                        words.plain(thread.pitch / units::mm, 2));
}

QString slopeAngle(const Words& words, double slope) {
    return words.number(std::atan(slope) / units::degree, 1);
}

QString weighAgain(const Words& words, const Input& input) {
    return input.weigh_in ? weighAgainText(words, *input.weigh_in) : QString();
}

bool doubtsWeights(const Input& input) {
    return input.changes_from_weigh_in && !weighAgain(Words(), input).isEmpty();
}

QString advice(const Words& words, const Input& input, const Result& solution) {
    if (doubtsWeights(input)) {
        return weighAgain(words, input);
    }
    if (const ShiftEffect* effect = solution.shift_that_matters()) {
        // What can be done, not what the method alone would have.
        return words.message(describe_action(*solution.advice->option, effect->least_reduction,
                                             effect->greatest_reduction));
    }
    return solution.advice && solution.unbalanced_mass
               ? words.message(describe(*solution.advice, *solution.unbalanced_mass,
                                        input.engine.crank_radius.value_or(0.0), input.tolerance))
               : QString();
}

QString boring(const Words& words, const Input& input, const Result& solution, OptionId option) {
    const auto& plan = solution.boring[index(option)];
    const auto& effect = solution.shift[index(option)];
    if (!plan || !input.plug) {
        return {};
    }
    Boring bored = *plan;
    if (effect && effect->matters) {
        // One depth is said, that which is right.
        if (!effect->depth) {
            return {};
        }
        bored.deeper += bored.deeper > 0.0 ? *effect->depth - bored.depth : 0.0;
        bored.depth = *effect->depth;
    }
    return words.message(describe(bored, input.plug->limits().value()));
}

QStringList massWarnings(const Words& words, const Input& input, const Result& solution) {
    QStringList warnings;
    const auto geometry = input.plug ? input.plug->geometry() : std::nullopt;
    const bool solid = geometry && geometry->bore_depth <= 0.0;
    const auto warn = [&](const std::optional<PlugMass>& mass, PlugMaterial material,
                          std::optional<double> Engine::*member) {
        if (mass && !mass->fits && !is_printed(input, member)) {
            warnings << (solid ? words.translate("V8",
                                                 "%1 plug: solid it weighs %2, but sheet 2 says "
                                                 "%3. Give its bore or weigh it.")
                               : words.translate("V8",
                                                 "%1 plug: a plug of these dimensions weighs %2, "
                                                 "but sheet 2 says %3. Weigh it."))
                            .arg(v8_names::materialName(words, material),
                                 grams(words, mass->geometry, 1), grams(words, mass->typed, 2));
        }
    };
    warn(solution.steel_plug, PlugMaterial::steel, &Engine::steel_plug_mass);
    warn(solution.aluminium_plug, PlugMaterial::aluminium, &Engine::aluminium_plug_mass);
    return warnings;
}

QStringList notCounted(const Words& words, const Input& input) {
    QStringList list;
    for (const Message& message : v8_plugs::not_counted(input)) {
        list << words.message(message);
    }
    return list;
}

namespace {

QStringList engineTroubles(const Words& words, const Engine& engine) {
    QStringList list;
    for (const EngineConflict& conflict : engine_conflicts(engine)) {
        list << words.translate("V8", "%1: must be less than the plug's mass, %2.")
                    .arg(words.name(conflict.reduction->field),
                         grams(words, conflict.plug_mass, 3));
    }
    return list;
}

/// Masses of grams that were typed in kilograms.
QStringList kilogramTroubles(const Words& words, const Input& input) {
    QStringList list;
    const auto suspect = [&](const QString& name, double mass) {
        list << kilogramText(words, name, mass);
    };
    constexpr double leastGear = 20 * units::gram;  // the sums of parts that weigh 5 g and more
    for (const char* key : {"reciprocating_mass_g", "rotating_mass_g"}) {
        const EngineField& each = engine_field(key);
        const auto& mass = input.engine.*each.member;
        if (mass && *mass < leastGear) {
            suspect(words.name(each.field), *mass);
        }
    }
    for (const Part part : all_parts) {
        const auto mass =
            input.weigh_in ? mass_in_kilograms(part, (*input.weigh_in)[part]) : std::nullopt;
        if (mass) {
            suspect(v8_names::partName(words, part), *mass);
        }
    }
    return list;
}

/// Nominal masses of the gear that are not those of its nominal parts.
QStringList gearTroubles(const Words& words, const Input& input) {
    QStringList list;
    if (!input.weigh_in) {
        return list;
    }
    const auto check = [&](const char* key, const std::optional<double>& parts) {
        const EngineField& each = engine_field(key);
        const auto& typed = input.engine.*each.member;
        // Bob weights are hung to a tenth of a gram.
        if (typed && parts && std::abs(*typed - *parts) >= 0.1 * units::gram) {
            list << words.translate("V8", "%1: %2 typed, but the nominal parts give %3.")
                        .arg(words.name(each.field), grams(words, *typed), grams(words, *parts));
        }
    };
    check("reciprocating_mass_g", nominal_reciprocating(*input.weigh_in));
    check("rotating_mass_g", nominal_rotating(*input.weigh_in));
    return list;
}

QStringList plugTroubles(const Words& words, const PlugSheet& plug) {
    QStringList list;
    const auto geometry = plug.geometry();
    if (const auto fault = geometry ? geometry_fault(*geometry) : std::nullopt) {
        list << words.message(*fault);
    }
    if (plug.bore_diameter.has_value() != plug.bore_depth.has_value()) {
        list << words.translate("V8", "A bore needs both its diameter and its depth.");
    }
    return list;
}

QStringList spreadTroubles(const Words& words, const WeighIn& sheet) {
    QStringList list;
    for (const Part part : all_parts) {
        const auto s = statistics(sheet[part]);
        const bool isOdd = shop::odd_mass(sheet[part].nominal, sheet[part].mass).has_value();
        if (s && !s->within_permitted && !isOdd) {  // that is said by itself
            list << words
                        .translate(
                            "V8",
                            "%1: spread %2, permitted %3 (heaviest: cylinder %4, lightest: %5).")
                        .arg(v8_names::partName(words, part), grams(words, s->spread),
                             grams(words, sheet[part].permitted_spread.value()))
                        .arg(s->heaviest + 1)
                        .arg(s->lightest + 1);
        }
    }
    return list;
}

}  // namespace

QStringList massTroubles(const Words& words, const Input& input) {
    return kilogramTroubles(words, input) +
           (input.weigh_in ? oddMassTexts(words, *input.weigh_in) : QStringList()) +
           gearTroubles(words, input) +
           (input.balancing
                ? rotorTexts(words, input.balancing->rotor_mass, input.balancing->service_speed)
                : QStringList());
}

QStringList troubles(const Words& words, const Input& input, const Result& solution) {
    QStringList list = engineTroubles(words, input.engine);
    list << massTroubles(words, input);
    list << otherReadings(words, solution);
    list << shiftWarning(words, input, solution);
    list << unequalCrankpins(words, input, solution);
    list.removeAll(QString());
    if (input.plug) {
        list << plugTroubles(words, *input.plug);
    }
    list << massWarnings(words, input, solution);
    list << notCounted(words, input);
    if (input.weigh_in) {
        list << spreadTroubles(words, *input.weigh_in);
    }
    return list;
}

QString otherReadings(const Words& words, const Result& solution) {
    return otherText(words, solution, solution.hung().value_or(0.0));
}

bool hasUnequalCrankpins(const Input& input, const Result& solution) {
    return input.changes_from_weigh_in && solution.crankpin_excess &&
           0.5 * spread(*solution.crankpin_excess) * input.engine.crank_radius.value_or(0.0) >
               input.tolerance;
}

QString unequalCrankpins(const Words& words, const Input& input, const Result& solution) {
    if (!hasUnequalCrankpins(input, solution)) {
        return {};
    }
    const auto& now = *solution.crankpin_excess;
    const auto [least, most] = std::minmax_element(now.begin(), now.end());
    QString text =
        words
            .translate("V8",
                       "The crankpins are unequal: their excess is %1 to %2. The answer is for "
                       "their mean.")
            .arg(words.digits(*least, units::gram, 2), grams(words, *most, 2));
    const double moved = solution.assigned_excess ? spread(*solution.assigned_excess) : 0.0;
    constexpr double worthWhile = 0.9;
    if (solution.assigned_excess && !doubtsWeights(input) && moved < worthWhile * spread(now)) {
        text += QLatin1Char(' ') +
                words.translate("V8", "Sets moved as sheet 3 says leave a spread of %1.")
                    .arg(grams(words, moved, 2));
    }
    return text;
}

QString shiftWarning(const Words& words, const Input& input, const Result& solution) {
    const ShiftEffect* effect = solution.shift_that_matters();
    return effect != nullptr
               ? words.message(describe_method(*effect, *solution.advice->option, input.tolerance))
               : QString();
}

bool methodAlone(const Result& solution, OptionId option) {
    const auto& effect = solution.shift[index(option)];
    return effect && effect->matters;
}

QString shiftText(const Words& words, const Input& input, const Result& solution,
                  const Option& option) {
    const double plug = option.plug_mass_unmachined - option.reduction;
    QString text =
        words
            .translate(
                "V8",
                "Neglected by the method: the plug's centre of mass moves by %4 to %5 when it "
                "is bored, which is worth %1 to %2 beside the %3 allowed.")
            .arg(words.digits(shift_unbalance(plug, smallest_shift), units::gram_mm, 1),
                 gramMillimetres(words, shift_unbalance(plug, largest_shift)),
                 gramMillimetres(words, input.tolerance),
                 words.digits(smallest_shift, units::mm, 1),
                 words.number(largest_shift, units::mm, 1));
    const auto& effect = solution.shift[index(option.id)];
    if (effect && effect->planned) {
        text +=
            QLatin1Char(' ') + words.translate("V8", "Bored as planned here it moves by %1: %2.")
                                   .arg(words.plainWithUnit(effect->greatest_shift, units::mm, 2),
                                        gramMillimetres(words, effect->greatest));
    }
    return text;
}

QString shiftText(const Words& words, const Input& input, const Result& solution) {
    const auto chosen = chosenOption(solution);
    const auto option = chosen ? chosen : solution.option(OptionId::steel_machined);
    return option ? shiftText(words, input, solution, *option) : QString();
}

std::optional<Option> chosenOption(const Result& solution) {
    return solution.advice ? solution.advice->option : std::nullopt;
}

bool works(const Result& solution) {
    return solution.advice && (solution.advice->kind == Advice::Kind::option ||
                               solution.advice->kind == Advice::Kind::none_needed);
}

Severity adviceSeverity(const v8_plugs::Input& input, const v8_plugs::Result& solution) {
    if (solution.advice && (doubtsWeights(input) || hasUnequalCrankpins(input, solution) ||
                            solution.shift_that_matters() != nullptr)) {
        return Severity::warning;
    }
    return solution.advice && !works(solution) ? Severity::error : Severity::note;
}

const BobWeight* bobWeightAfter(const Result& solution) {
    const auto option = chosenOption(solution);
    const auto* weights = option ? &solution.bob_weights[index(option->id)] : nullptr;
    return weights != nullptr && *weights ? &(*weights)->after : nullptr;
}

ResultRow bobWeightCells(const Words& words, const Result& solution,
                         std::optional<BobWeightLine::Part> part, int decimals,
                         const QString& missing) {
    ResultRow cells;
    for (const BobWeight* weight :
         {&*solution.nominal, &*solution.before, bobWeightAfter(solution)}) {
        const auto mass = weight == nullptr ? std::nullopt
                          : part            ? weight->product(*part)
                                            : std::optional(weight->sum());
        cells << (mass ? words.cell(*mass, units::gram, decimals) : ResultCell(missing));
    }
    return cells;
}

QString hang(const Words& words, const Result& solution) {
    if (!solution.before) {
        return {};
    }
    return (works(solution) ? words.translate("V8", "Hang %1 on each crankpin.")
                            : words.translate("V8", "Bob weight with the nearest option: %1."))
        .arg(grams(words, solution.hung().value(), 1));
}

QString plugsWhileHung(const Words& words, const Result& solution) {
    if (!solution.before) {
        return {};
    }
    const BobWeight* after = bobWeightAfter(solution);
    return words
        .translate("V8", "The plugs are out of the shaft then; while they are in it hang %1.")
        .arg(grams(words, (after != nullptr ? *after : *solution.before).with_plugs_in(), 1));
}

QString rodFactor(const Words& words, const Input& input, const Result& solution) {
    const auto& k = input.engine.rod_coefficient;
    if (!solution.before || !k) {
        return {};
    }
    return words
        .translate("V8",
                   "Big end × %1: 2 for two rods as usual, kᵣ = %2 by the method, worth %3 here.")
        .arg(words.plain(2.0 + *k, 3), words.plain(*k, 3),
             grams(words, *k * solution.changes.rod_big_end));
}

bool isPapersTolerance(const Input& input) {
    return std::abs(input.tolerance - default_tolerance) < 1e-6 * default_tolerance;
}

QString toleranceOwner(const Words& words, const Input& input) {
    return isPapersTolerance(input)
               ? words
                     .translate("V8",
                                "%1 in each plane is what Nazarov's experiments left: the "
                                "limit of this method.")
                     .arg(gramMillimetres(words, input.tolerance))
               : words.translate("V8", "%1 in each plane is the shop's own limit.")
                     .arg(gramMillimetres(words, input.tolerance));
}

QString machineLimits(const Words& words, const Input& input, const Result& solution) {
    const QString owner = toleranceOwner(words, input);
    if (!solution.balancing) {
        return owner + QLatin1Char(' ') +
               words.translate("V8",
                               "Readings are judged by it while ISO 21940-11 lacks grade, "
                               "mass or speed.");
    }
    const double times = solution.planes[0].permissible / input.tolerance;
    return owner + QLatin1Char(' ') +
           words
               .translate("V8",
                          "It says how exactly the plugs compensate; ISO 21940-11 says what the "
                          "crankshaft may have in service, in front %1 times as much. Readings "
                          "are judged by ISO.")
               .arg(words.plain(times, times < 10.0 ? 1 : 0));
}

QString bobWeightCheck(const Words& words, const Input& input, const Result& solution) {
    if (!solution.nominal || !solution.before) {
        return {};
    }
    const double difference = solution.hung().value() - solution.nominal->sum();
    // Rounding of the sum, not a difference.
    if (std::abs(difference) < 1e-9 * solution.nominal->sum()) {
        if (!works(solution)) {
            return words.translate("V8", "After would equal nominal, but this cannot be made.");
        }
        return solution.shift_that_matters() != nullptr
                   ? words.translate("V8", "(!) After equals nominal by the method alone.")
                   : words.translate("V8", "After equals nominal: balanced.");
    }
    return words.translate("V8", "After less nominal: %1, which is %2.")
        .arg(grams(words, difference),
             gramMillimetres(words, difference * input.engine.crank_radius.value_or(0.0)));
}

std::optional<matching_text::Shown> matchingShown(const Input& input, const Result& solution) {
    if (!input.weigh_in || !solution.assignment || !solution.crankpin_excess ||
        !solution.assigned_excess || !weighAgain(Words(), input).isEmpty()) {
        return std::nullopt;
    }
    matching_text::Shown shown{*solution.assignment,
                               crank_of(*input.weigh_in),
                               input.engine.crank_radius,
                               input.balancing ? input.balancing->service_speed : std::nullopt,
                               input.weigh_in->piston_sets,
                               input.weigh_in->rod_sets};
    matching_text::takeAsWeighed(
        shown, matching_task(*input.weigh_in, input.engine.rod_coefficient.value_or(0.0)),
        *input.weigh_in);
    return shown;
}

}  // namespace ravnoves::v8_text
