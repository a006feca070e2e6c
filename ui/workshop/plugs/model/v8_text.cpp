#include "workshop/plugs/model/v8_text.h"

#include <algorithm>
#include <cmath>

#include "shop/model/verdict.h"
#include "shop/model/weigh_again.h"
#include "text/capital.h"
#include "text/number_text.h"
#include "v8-plugs/presets.h"
#include "workshop/plugs/model/v8_names.h"

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

QString advice(const Words& words, const Input& input, const Result& solution) {
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

QStringList plugTroubles(const Words& words, const PlugSheet& plug) {
    QStringList list;
    const auto geometry = plug.geometry();
    if (const auto fault = geometry ? geometry_fault(*geometry) : std::nullopt) {
        list << words.message(*fault);
    }
    if (plug.bore_diameter.has_value() != plug.bore_depth.has_value()) {
        list << words.translate("V8", "Enter both diameter and depth of the bore.");
    }
    return list;
}

}  // namespace

QStringList troubles(const Words& words, const Input& input) {
    QStringList list = engineTroubles(words, input.engine);
    if (input.plug) {
        list << plugTroubles(words, *input.plug);
    }
    return list;
}

bool methodAlone(const Result& solution, OptionId option) {
    const auto& effect = solution.shift[index(option)];
    return effect && effect->matters;
}

QString shiftText(const Words& words, const Input& input, const Result& solution,
                  const Option& option) {
    const double plug = option.plug_mass_unmachined - option.reduction;
    QString text = words
                       .translate("V8",
                                  "The method neglects the shift of the plug's centre of mass by "
                                  "boring, %4 to %5. Effect: %1 to %2; permissible: %3.")
                       .arg(words.digits(shift_unbalance(plug, smallest_shift), units::gram_mm, 1),
                            gramMillimetres(words, shift_unbalance(plug, largest_shift)),
                            gramMillimetres(words, input.tolerance),
                            words.digits(smallest_shift, units::mm, 1),
                            words.number(largest_shift, units::mm, 1));
    const auto& effect = solution.shift[index(option.id)];
    if (effect && effect->planned) {
        text +=
            QLatin1Char(' ') + words.translate("V8", "With the planned bore it moves by %1: %2.")
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

const BobWeight* bobWeightAfter(const Result& solution) {
    const auto option = chosenOption(solution);
    const auto* weights = option ? &solution.bob_weights[index(option->id)] : nullptr;
    return weights != nullptr && *weights ? &(*weights)->after : nullptr;
}

QString plugsWhileHung(const Words& words, const Result& solution) {
    if (!solution.before) {
        return {};
    }
    const BobWeight* after = bobWeightAfter(solution);
    return words.translate("V8", "With the plugs removed. With the plugs fitted use %1.")
        .arg(grams(words, (after != nullptr ? *after : *solution.before).with_plugs_in(), 1));
}

QString rodFactor(const Words& words, const Input& input, const Result& solution) {
    const auto& k = input.engine.rod_coefficient;
    if (!solution.before || !k) {
        return {};
    }
    return words
        .translate("V8", "Big end × %1: 2 for two rods, kᵣ = %2 by the method; effect here: %3.")
        .arg(words.plain(2.0 + *k, 3), words.plain(*k, 3),
             grams(words, *k * solution.changes.rod_big_end));
}

QString bobWeightCheck(const Words& words, const Input& input, const Result& solution) {
    if (!solution.nominal || !solution.before) {
        return {};
    }
    const double difference = solution.hung().value() - solution.nominal->sum();
    // Rounding of the sum, not a difference.
    if (std::abs(difference) < 1e-9 * solution.nominal->sum()) {
        if (!works(solution)) {
            return words.translate("V8", "Would match nominal, but cannot be made.");
        }
        return solution.shift_that_matters() != nullptr
                   ? words.translate("V8", "(!) Matches nominal by the method only.")
                   : words.translate("V8", "Matches nominal: balanced.");
    }
    return words.translate("V8", "After minus nominal: %1 (%2).")
        .arg(grams(words, difference),
             gramMillimetres(words, difference * input.engine.crank_radius.value_or(0.0)));
}

std::optional<matching_text::Shown> matchingShown(const Input& input, const Result& solution) {
    if (!input.weigh_in || !solution.assignment || !solution.crankpin_excess ||
        !solution.assigned_excess || !weighAgainText(Words(), *input.weigh_in).isEmpty()) {
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
