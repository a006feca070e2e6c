#include "v8-plugs/model/v8_text.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "v8-plugs/model/v8_names.h"

namespace ravnoves::v8_text {

using namespace v8_plugs;

namespace {

constexpr double gram = 1e-3;
constexpr double millimetre = 1e-3;
constexpr double gramMillimetre = 1e-6;
constexpr double worthSaying = 0.005 * gram;  // what two decimals show

QString withUnit(const QString& number, const QString& unit) {
    return number + QChar(0x00A0) + unit;
}

/// The action of an option in the imperative.
QString action(const Words& words, const Option& option) {
    const bool machined = option.reduction >= worthSaying;
    const QString each = grams(words, option.reduction);
    if (keeps_steel_plugs(option.id)) {
        return machined ? words.translate("V8", "Machine all 8 steel plugs by %1 each.").arg(each)
                        : words.translate("V8", "Fit today's 8 steel plugs as they are.");
    }
    return machined
               ? words
                     .translate("V8", "Replace all 8 plugs by aluminium ones lightened by %1 each.")
                     .arg(each)
               : words.translate("V8", "Replace all 8 plugs by aluminium ones as they are.");
}

QString overOrUnder(const Words& words, const Option& option) {
    return option.residual_mass > 0
               ? words.translate("V8", "leaves %1 too much on each crankpin")
                     .arg(grams(words, option.residual_mass))
               : words.translate("V8", "over-compensates by %1 on each crankpin")
                     .arg(grams(words, -option.residual_mass));
}

QString within(const Words& words, double unbalance, double tolerance) {
    return words.translate("V8", "%1, within the %2 allowed")
        .arg(gramMillimetres(words, std::abs(unbalance)), gramMillimetres(words, tolerance));
}

QString against(const Words& words, double unbalance, double tolerance) {
    return words.translate("V8", "%1 against the %2 allowed")
        .arg(gramMillimetres(words, std::abs(unbalance)), gramMillimetres(words, tolerance));
}

}  // namespace

QString grams(const Words& words, double kilograms, int decimals) {
    return withUnit(words.number(kilograms / gram, decimals), words.translate("V8", "g", "unit"));
}

QString gramMillimetres(const Words& words, double kilogramMetres, int decimals) {
    return withUnit(words.number(kilogramMetres / gramMillimetre, decimals),
                    words.translate("V8", "g·mm", "unit"));
}

QString millimetres(const Words& words, double metres, int decimals) {
    return withUnit(words.plain(metres / millimetre, decimals),
                    words.translate("V8", "mm", "unit"));
}

QString advice(const Words& words, const Input& input, const Result& solution) {
    if (!solution.advice || !solution.unbalanced_mass) {
        return {};
    }
    const Advice& advice = *solution.advice;
    const double excess = *solution.unbalanced_mass;
    const double unbalance = excess * input.engine.crank_radius.value_or(0.0);
    QString text;
    switch (advice.kind) {
        case Advice::Kind::none_needed:
            return words
                .translate("V8",
                           "Leave the plugs as they are: the excess of %1 per crankpin is %2.")
                .arg(grams(words, excess), within(words, unbalance, input.tolerance));
        case Advice::Kind::option: {
            const Option& option = *advice.option;
            text = action(words, option);
            if (option.residual_mass != 0.0) {
                text += QLatin1Char(' ') +
                        words.translate("V8", "This %1: %2.", "leaves …: … g·mm, within …")
                            .arg(overOrUnder(words, option),
                                 within(words, option.residual_unbalance, input.tolerance));
            }
            return text;
        }
        case Advice::Kind::no_new_plug_data:
            return words.translate("V8",
                                   "The crankshaft is made for plugs of the new design; their mass "
                                   "and radius are needed.");
        case Advice::Kind::too_light:
            text = words
                       .translate("V8",
                                  "The parts are %1 per crankpin lighter than nominal (%2), and "
                                  "plugs can only be lightened: heavier parts or heavier plugs are "
                                  "needed.")
                       .arg(grams(words, -excess), gramMillimetres(words, -unbalance));
            break;
        case Advice::Kind::none_sufficient:
        case Advice::Kind::none_light_enough: {
            const Option& closest = *advice.option;
            text =
                advice.kind == Advice::Kind::none_sufficient
                    ? words.translate("V8", "No plug of this crankshaft can be made light enough.")
                    : words.translate("V8",
                                      "No plug of this crankshaft has the mass that is needed.");
            text += QLatin1Char(' ') +
                    words
                        .translate("V8", "The nearest is “%1”, which %2: %3.",
                                   "option, leaves …, … g·mm against …")
                        .arg(optionName(words, closest.id), overOrUnder(words, closest),
                             against(words, closest.residual_unbalance, input.tolerance));
            break;
        }
    }
    if (advice.with_other_crankshaft) {
        const QString name = optionName(words, *advice.with_other_crankshaft);
        text += QLatin1Char(' ') +
                (needs_new_crankshaft(*advice.with_other_crankshaft)
                     ? words.translate("V8", "A crankshaft made for the new plugs would do: “%1”.")
                     : words.translate("V8", "A standard crankshaft would do: “%1”."))
                    .arg(name);
    }
    return text;
}

QString boring(const Words& words, const Input& input, const Result& solution, OptionId option) {
    const auto& plan = solution.boring[index(option)];
    if (!plan || !plan->cuts || !input.plug) {
        return {};
    }
    const BoreLimits limits = input.plug->limits().value();
    const QString cutter = millimetres(words, limits.cutter_diameter, 1);
    switch (plan->limit) {
        case Boring::Limit::wall:
            return words
                .translate("V8",
                           "It cannot be bored with a %1 cutter: a wall of %2 would be left under "
                           "the thread, and %3 must stay.")
                .arg(cutter, millimetres(words, plan->wall),
                     millimetres(words, limits.minimum_wall));
        case Boring::Limit::bottom:
            return words
                .translate("V8",
                           "It cannot be bored with a %1 cutter: a bore %2 deep is needed, and a "
                           "bottom of %3 must stay.")
                .arg(cutter, millimetres(words, plan->depth),
                     millimetres(words, limits.minimum_bottom));
        case Boring::Limit::none:
            break;
    }
    if (plan->deeper > 0.0 && input.plug->bore_depth.value_or(0.0) > 0.0) {
        return words.translate("V8", "Bore %1 deeper with a %2 cutter, to %3 from the face.")
            .arg(millimetres(words, plan->deeper), cutter, millimetres(words, plan->depth));
    }
    return words.translate("V8", "Bore with a %1 cutter to %2 from the face.")
        .arg(cutter, millimetres(words, plan->depth));
}

QString verdict(const Words& words, const Option& option, double tolerance) {
    if (option.feasible) {
        return option.residual_mass == 0.0
                   ? words.translate("V8", "works")
                   : words.translate("V8", "works: %1")
                         .arg(within(words, option.residual_unbalance, tolerance));
    }
    return overOrUnder(words, option) + QStringLiteral(": ") +
           against(words, option.residual_unbalance, tolerance);
}

QStringList massWarnings(const Words& words, const Input& input, const Result& solution) {
    QStringList warnings;
    const auto geometry = input.plug ? input.plug->geometry() : std::nullopt;
    const bool solid = geometry && geometry->bore_depth <= 0.0;
    const auto warn = [&](const std::optional<PlugMass>& mass, PlugMaterial material) {
        if (mass && !mass->fits) {
            warnings << (solid ? words.translate("V8",
                                                 "%1 plug: solid it weighs %2, but %3 was typed. "
                                                 "Give its bore or weigh it.")
                               : words.translate("V8",
                                                 "%1 plug: a plug of these dimensions weighs %2, "
                                                 "but %3 was typed. Weigh it."))
                            .arg(materialName(words, material), grams(words, mass->geometry, 1),
                                 grams(words, mass->typed, 2));
        }
    };
    warn(solution.steel_plug, PlugMaterial::steel);
    warn(solution.aluminium_plug, PlugMaterial::aluminium);
    return warnings;
}

QStringList weighInGaps(const Words& words, const Input& input) {
    QStringList gaps;
    if (!input.weigh_in) {
        return gaps;
    }
    for (const Part part : all_parts) {
        const PartColumn& column = (*input.weigh_in)[part];
        if (column.is_complete() || column.is_empty()) {
            continue;
        }
        const QString name = partName(words, part);
        gaps << (column.nominal
                     ? words.translate("V8", "%1: %2 of 8 weighed; nominal counts until all are.")
                           .arg(name)
                           .arg(statistics(column)->count)
                     : words.translate("V8", "%1: the weights do not count without a nominal mass.")
                           .arg(name));
    }
    return gaps;
}

namespace {

QStringList engineTroubles(const Words& words, const Engine& engine) {
    QStringList list;
    for (const EngineConflict& conflict : engine_conflicts(engine)) {
        const bool steel = conflict.key == "max_steel_reduction_g";
        const double mass = (steel ? engine.steel_plug_mass : engine.aluminium_plug_mass).value();
        list << words.translate("V8", "%1: must be less than the plug's mass, %2.")
                    .arg(fieldName(words, conflict.key), grams(words, mass, 3));
    }
    return list;
}

QStringList plugTroubles(const Words& words, const PlugSheet& plug) {
    QStringList list;
    const auto geometry = plug.geometry();
    if (geometry && geometry_fault(*geometry)) {
        list << (geometry->bore_depth >= geometry->height
                     ? words.translate(
                           "V8", "The bore is as deep as the plug is high: there is no bottom.")
                     : words
                           .translate("V8",
                                      "The bore is wider than the root of the thread, %1: there is "
                                      "no wall.")
                           .arg(millimetres(words, geometry->thread.root_diameter())));
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
        if (s && !s->within_permitted) {
            list << words
                        .translate(
                            "V8",
                            "%1: spread %2, permitted %3 (heaviest: cylinder %4, lightest: %5).")
                        .arg(partName(words, part), grams(words, s->spread),
                             grams(words, sheet[part].permitted_spread.value()))
                        .arg(s->heaviest + 1)
                        .arg(s->lightest + 1);
        }
    }
    return list;
}

}  // namespace

QStringList troubles(const Words& words, const Input& input, const Result& solution) {
    QStringList list = engineTroubles(words, input.engine);
    if (input.plug) {
        list << plugTroubles(words, *input.plug);
    }
    list << massWarnings(words, input, solution);
    if (input.changes_from_weigh_in) {
        list << weighInGaps(words, input);
    }
    if (input.weigh_in) {
        list << spreadTroubles(words, *input.weigh_in);
    }
    return list;
}

QString shiftText(const Words& words, const Input& input, const Result& solution,
                  const Option& option) {
    const double plug = option.plug_mass_unmachined - option.reduction;
    QString text =
        words
            .translate("V8",
                       "Neglected by the method: the plug's centre of mass moves by 0.8 to 1.2 mm "
                       "when it is bored, which is worth %1 to %2 beside the %3 allowed.")
            .arg(words.number(shift_unbalance(plug, smallest_shift) / gramMillimetre, 1),
                 gramMillimetres(words, shift_unbalance(plug, largest_shift)),
                 gramMillimetres(words, input.tolerance));
    const auto& boring = solution.boring[index(option.id)];
    if (boring && boring->cuts && boring->limit == Boring::Limit::none) {
        text += QLatin1Char(' ') +
                words.translate("V8", "Bored as planned here it moves by %1: %2.")
                    .arg(millimetres(words, boring->shift),
                         gramMillimetres(words, shift_unbalance(plug, boring->shift)));
    }
    return text;
}

std::optional<Option> chosenOption(const Result& solution) {
    return solution.advice ? solution.advice->option : std::nullopt;
}

bool works(const Result& solution) {
    return solution.advice && (solution.advice->kind == Advice::Kind::option ||
                               solution.advice->kind == Advice::Kind::none_needed);
}

QString hang(const Words& words, const Result& solution) {
    if (!solution.before) {
        return {};
    }
    const auto option = chosenOption(solution);
    const double weight =
        option ? solution.bob_weights[index(option->id)]->after.sum() : solution.before->sum();
    return (works(solution) ? words.translate("V8", "Hang %1 on each crankpin.")
                            : words.translate("V8", "Bob weight with the nearest option: %1."))
        .arg(grams(words, weight, 1));
}

QString bobWeightCheck(const Words& words, const Input& input, const Result& solution) {
    if (!solution.nominal || !solution.before) {
        return {};
    }
    const auto option = chosenOption(solution);
    const double after =
        option ? solution.bob_weights[index(option->id)]->after.sum() : solution.before->sum();
    const double difference = after - solution.nominal->sum();
    // Rounding of the sum, not a difference.
    if (std::abs(difference) < 1e-9 * solution.nominal->sum()) {
        return words.translate("V8", "After equals nominal: balanced.");
    }
    return words.translate("V8", "After less nominal: %1, which is %2.")
        .arg(grams(words, difference),
             gramMillimetres(words, difference * input.engine.crank_radius.value_or(0.0)));
}

QString assignmentText(const Words& words, const Result& solution) {
    if (!solution.assignment || !solution.crankpin_excess || !solution.assigned_excess) {
        return {};
    }
    const auto spread = [](const std::array<double, crankpin_count>& totals) {
        const auto [least, most] = std::minmax_element(totals.begin(), totals.end());
        return *most - *least;
    };
    const QString before = grams(words, spread(*solution.crankpin_excess));
    if (solution.assignment->moved == 0) {
        return words
            .translate("V8", "The parts are placed as well as can be: the crankpins differ by %1.")
            .arg(before);
    }
    return words
        .translate("V8", "Crankpins differ by %1 as weighed and by %2 after moving %3 sets.")
        .arg(before, grams(words, spread(*solution.assigned_excess)),
             QString::number(solution.assignment->moved));
}

}  // namespace ravnoves::v8_text
