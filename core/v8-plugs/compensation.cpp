#include "v8-plugs/compensation.h"

#include <algorithm>
#include <cmath>

namespace ravnoves::v8_plugs {

namespace {

using shop::in_gram_millimetres;
using shop::in_grams;

/// The action of an option in the imperative.
Message action(const Option& option, const Message& off) {
    const bool machined = option.machined();
    if (has_new_plugs(option.id)) {
        return machined ? Message(Text::tr("Take %1 off each of the 8 new steel plugs."), off)
                        : Text::tr("Leave the 8 new steel plugs unchanged.");
    }
    if (has_steel_plugs(option.id)) {
        return machined ? Message(Text::tr("Take %1 off each of the 8 steel plugs."), off)
                        : Text::tr("Fit the 8 present steel plugs unchanged.");
    }
    return machined
               ? Message(Text::tr("Replace all 8 plugs by aluminium plugs, lightened by %1 each."),
                         off)
               : Text::tr("Replace all 8 plugs by aluminium plugs, unchanged.");
}

Message action(const Option& option) {
    return action(option, in_grams(option.reduction));
}

Message over_or_under(const Option& option) {
    return {option.residual_mass > 0 ? Text::tr("leaves an excess of %1 on each crankpin")
                                     : Text::tr("over-compensates by %1 on each crankpin"),
            in_grams(std::abs(option.residual_mass))};
}

Message within(double unbalance, double tolerance) {
    return {Text::tr("%1, within the %2 allowed"), in_gram_millimetres(std::abs(unbalance)),
            in_gram_millimetres(tolerance)};
}

Message against(double unbalance, double tolerance) {
    return {Text::tr("%1 against the %2 allowed"), in_gram_millimetres(std::abs(unbalance)),
            in_gram_millimetres(tolerance)};
}

}  // namespace

double unbalanced_mass(const MassChanges& changes, double rod_coefficient) {
    return changes.piston + (2.0 + rod_coefficient) * changes.rod_big_end +
           changes.repair_piston_and_rings + changes.repair_bearing;
}

Coefficients coefficients(const Engine& engine) {
    const double crank_radius = engine.crank_radius.value();
    const double k_p = engine.plug_radius.value() / crank_radius;
    return {k_p, 2.0 * k_p,
            engine.has_new_plug ? std::optional(2.0 * engine.new_plug_radius.value() / crank_radius)
                                : std::nullopt};
}

bool has_steel_plugs(OptionId option) {
    return option != OptionId::steel_to_aluminium && option != OptionId::new_steel_to_aluminium;
}

bool has_new_plugs(OptionId option) {
    return option == OptionId::new_steel_machined;
}

bool needs_new_crankshaft(OptionId option) {
    return option == OptionId::new_steel_to_steel || option == OptionId::new_steel_machined ||
           option == OptionId::new_steel_to_aluminium;
}

std::optional<Option> evaluate_option(OptionId id, const Engine& engine, double unbalanced_mass,
                                      double tolerance) {
    const bool steel = has_steel_plugs(id);
    const bool new_crankshaft = needs_new_crankshaft(id);
    if ((!steel && !engine.has_aluminium_plug) || (new_crankshaft && !engine.has_new_plug)) {
        return std::nullopt;
    }
    Option option{};
    option.id = id;
    const double crank_radius = engine.crank_radius.value();
    const double steel_mass = engine.steel_plug_mass.value();
    option.plug_radius = engine.plug_radius.value();
    option.plug_mass_unmachined = steel ? steel_mass : engine.aluminium_plug_mass.value();
    option.max_reduction =
        (steel ? engine.max_steel_reduction : engine.max_aluminium_reduction).value();
    if (has_new_plugs(id)) {
        option.plug_radius = engine.new_plug_radius.value();
        option.plug_mass_unmachined = engine.new_steel_plug_mass.value();
        option.max_reduction *= std::min(1.0, option.plug_mass_unmachined / steel_mass);
    }
    const double k_y = 2.0 * option.plug_radius / crank_radius;
    option.slope = k_y;
    if (has_new_plugs(id)) {
        option.constant = 0.0;  // the counterweights expect these plugs
    } else if (new_crankshaft) {
        // (13), (14): the counterweights expect the new plugs, today's are fitted.
        option.constant = *coefficients(engine).k_y_new * engine.new_steel_plug_mass.value() -
                          k_y * option.plug_mass_unmachined;
    } else {
        option.constant = k_y * (steel_mass - option.plug_mass_unmachined);  // (12), or 0
    }
    option.maximum = option.constant + k_y * option.max_reduction;
    option.required_reduction = (unbalanced_mass - option.constant) / k_y;
    option.reduction = std::clamp(option.required_reduction, 0.0, option.max_reduction);
    // What the limits leave; exactly nothing where they do not bind.
    if (option.required_reduction < 0.0) {
        option.residual_mass = unbalanced_mass - option.constant;
    } else if (option.required_reduction > option.max_reduction) {
        option.residual_mass = unbalanced_mass - option.maximum;
    } else {
        option.residual_mass = 0.0;
    }
    option.residual_unbalance = option.residual_mass * crank_radius;
    option.feasible = std::abs(option.residual_unbalance) <= tolerance;
    return option;
}

Advice advise(const Engine& engine, Crankshaft crankshaft, double unbalanced_mass, double tolerance,
              const Hindrance& hindrance) {
    const bool new_crankshaft = crankshaft == Crankshaft::new_plugs;
    Advice advice{Advice::Kind::none_sufficient, std::nullopt, std::nullopt, {}};
    if (std::abs(unbalanced_mass * engine.crank_radius.value()) <= tolerance) {
        advice.kind = Advice::Kind::none_needed;
        return advice;
    }
    bool any_over = false;
    bool any_evaluated = false;
    std::optional<Option> not_made;          // the first that would do
    for (const OptionId id : all_options) {  // in the order of cost
        const auto option = evaluate_option(id, engine, unbalanced_mass, tolerance);
        if (!option) {
            continue;
        }
        const Message why =
            option->feasible && hindrance != nullptr ? hindrance(*option) : Message();
        if (needs_new_crankshaft(id) != new_crankshaft) {
            if (option->feasible && why.empty() && !advice.with_other_crankshaft) {
                advice.with_other_crankshaft = id;
            }
            continue;
        }
        any_evaluated = true;
        if (!why.empty()) {
            if (!not_made) {
                not_made = option;
                advice.hindrance = why;
            }
            continue;
        }
        if (option->feasible) {
            advice.kind = Advice::Kind::option;
            advice.option = option;
            advice.with_other_crankshaft.reset();
            advice.hindrance = {};
            return advice;
        }
        any_over = any_over || option->residual_mass < 0;
        if (!advice.option ||
            std::abs(option->residual_mass) < std::abs(advice.option->residual_mass)) {
            advice.option = option;
        }
    }
    if (!any_evaluated) {
        advice.kind = Advice::Kind::no_new_plug_data;
    } else if (not_made) {
        advice.kind = Advice::Kind::cannot_be_made;
        advice.option = not_made;
    } else if (unbalanced_mass < 0) {
        advice.kind = Advice::Kind::too_light;
    } else {
        advice.kind = any_over ? Advice::Kind::none_light_enough : Advice::Kind::none_sufficient;
    }
    return advice;
}

Message describe_action(const Option& option, double minimum, double maximum) {
    Number from = in_grams(minimum);
    const Number to = in_grams(maximum);
    if (Message(from) == Message(to)) {
        return action(option, to);
    }
    from.unit_follows = true;
    return action(option, {Text{"%1…%2"}, from, to});
}

Message describe_failure(const Option& option, double tolerance) {
    return option.feasible ? Message()
                           : Message(Text{"%1: %2"}, over_or_under(option),
                                     against(option.residual_unbalance, tolerance));
}

Message describe_verdict(const Option& option, double tolerance) {
    if (!option.feasible) {
        return describe_failure(option, tolerance);
    }
    return option.residual_mass == 0.0
               ? Message(Text::tr("works"))
               : Message(Text::tr("works: %1"), within(option.residual_unbalance, tolerance));
}

Message describe(const Advice& advice, double unbalanced_mass, double crank_radius,
                 double tolerance) {
    const double unbalance = unbalanced_mass * crank_radius;
    Message text;
    switch (advice.kind) {
        case Advice::Kind::none_needed:
            return {Text::tr("Leave the plugs unchanged: the excess of %1 per crankpin is %2."),
                    in_grams(unbalanced_mass), within(unbalance, tolerance)};
        case Advice::Kind::option: {
            const Option& option = advice.option.value();
            return option.residual_mass == 0.0
                       ? action(option)
                       : two_sentences(action(option),
                                       {Text::tr("This %1: %2."), over_or_under(option),
                                        within(option.residual_unbalance, tolerance)});
        }
        case Advice::Kind::no_new_plug_data:
            return Text::tr(
                "The crankshaft is made for plugs of the new design: enter their mass and radius.");
        case Advice::Kind::too_light:
            text = {Text::tr("The parts are %1 per crankpin lighter than nominal (%2). Plugs can "
                             "only be lightened: use heavier parts or heavier plugs."),
                    in_grams(-unbalanced_mass), in_gram_millimetres(-unbalance)};
            break;
        case Advice::Kind::cannot_be_made: {
            const Option& option = advice.option.value();
            text = two_sentences(
                option.machined()
                    ? Message(Text::tr("“%1” would be suitable with %2 off each plug, but such a "
                                       "plug cannot be made."),
                              option_word(option.id).label, in_grams(option.reduction))
                    : Message(Text::tr("“%1” would be suitable, but such a plug cannot be made."),
                              option_word(option.id).label),
                advice.hindrance);
            break;
        }
        case Advice::Kind::none_sufficient:
        case Advice::Kind::none_light_enough: {
            const Option& closest = advice.option.value();
            text =
                two_sentences(advice.kind == Advice::Kind::none_sufficient
                                  ? Text::tr("No plug of this crankshaft can be made light enough.")
                                  : Text::tr("No plug of this crankshaft has the required mass."),
                              {Text::tr("The nearest option is “%1”, which %2: %3."),
                               option_word(closest.id).label, over_or_under(closest),
                               against(closest.residual_unbalance, tolerance)});
            if (closest.residual_mass > 0.0) {
                // Each piston counts once in the excess of its crankpin.
                text = two_sentences(std::move(text), {Text::tr("Also take %1 off each piston."),
                                                       in_grams(closest.residual_mass)});
            }
            break;
        }
    }
    if (const auto other = advice.with_other_crankshaft) {
        return two_sentences(
            std::move(text),
            {needs_new_crankshaft(*other)
                 ? Text::tr("A crankshaft for the new plugs would be suitable: “%1”.")
                 : Text::tr("A standard crankshaft would be suitable: “%1”."),
             option_word(*other).label});
    }
    return text;
}

double BobWeight::sum() const {
    double total = 0.0;
    for (const shop::WeightLine& line : lines) {
        total += line.product();
    }
    return total;
}

namespace {

BobWeight bob_weight(const Engine& engine, const MassChanges& changes, double plug_mass,
                     double plug_radius) {
    const shop::WeightLine plugs{
        {"plugs", Text::tr("Plug")}, 2.0 * plug_radius / engine.crank_radius.value(), plug_mass};
    const shop::WeightLine oil{
        {"oil", Text::tr("Oil mₘ")}, engine.oil_coefficient.value(), engine.oil_mass.value()};
    return {{{{"reciprocating_mass", Text::tr("Reciprocating mass mⱼ")},
              1.0,
              engine.reciprocating_mass.value(),
              true},
             {{"rotating_mass", Text::tr("Rotating mass")}, 2.0, engine.rotating_mass.value()},
             plugs,
             oil,
             {{"piston", Text::tr("Improved piston Δmₚᵢ")}, 1.0, changes.piston, true},
             {{"rod_big_end", Text::tr("Rod big end")},
              2.0 + engine.rod_coefficient.value(),
              changes.rod_big_end},
             {{"repair_piston_and_rings", Text::tr("Repair piston and rings Δmᵣₚ")},
              1.0,
              changes.repair_piston_and_rings,
              true},
             {{"repair_bearing", Text::tr("Repair shells Δmₛₕ")}, 1.0, changes.repair_bearing}},
            plugs.product(),
            oil.product()};
}

}  // namespace

std::optional<BobWeight> bob_weight(const Engine& engine, const MassChanges& changes,
                                    Crankshaft crankshaft) {
    if (crankshaft == Crankshaft::standard) {
        return bob_weight(engine, changes, engine.steel_plug_mass.value(),
                          engine.plug_radius.value());
    }
    return engine.has_new_plug
               ? std::optional(bob_weight(engine, changes, engine.new_steel_plug_mass.value(),
                                          engine.new_plug_radius.value()))
               : std::nullopt;
}

BobWeight bob_weight(const Engine& engine, const MassChanges& changes, const Option& option) {
    return bob_weight(engine, changes, option.plug_mass_unmachined - option.reduction,
                      option.plug_radius);
}

double shift_coefficient(double shift, double crank_radius) {
    return shift / crank_radius;
}

double shift_unbalance(double plug_mass, double shift) {
    return 2.0 * plug_mass * shift;
}

}  // namespace ravnoves::v8_plugs
