#include "v8-plugs/results.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "numerics/demand.h"
#include "shop/results.h"
#include "shop/sentences.h"
#include "v8-plugs/presets.h"
#include "v8-plugs/solver.h"

namespace ravnoves::v8_plugs {

namespace {

using ravnoves::result_field::feasible;
using ravnoves::result_field::reason;
using shop::in_gram_millimetres;
using shop::in_grams;
using shop::two_sentences;
namespace key {
constexpr ResultField unbalanced_mass{"unbalanced_mass_g", Text::tr("Excess on a crankpin Δmᵤ"), 3,
                                      Text::tr("Excess mass of the parts on the crankpin axis.")};
constexpr ResultField unbalance{"unbalance_g_mm", Text::tr("Unbalance of a crankpin"), 1};
constexpr ResultField not_counted{"not_counted"};
constexpr ResultField recommended{"recommended"};
constexpr ResultField state{"state"};
constexpr ResultField warning{"warning"};
constexpr ResultField required_reduction{"required_reduction_g",
                                         Text::tr("Required off each plug")};
constexpr ResultField reduction{"reduction_g", Text::tr("Off each plug, paper's method")};
constexpr ResultField take_off{
    "take_off_g", Text::tr("Take off each plug"), 3,
    Text::tr("With the shift of the plug's centre of mass, where the shift matters.")};
constexpr ResultField residual_mass{"residual_mass_g", Text::tr("Remains")};
constexpr ResultField residual_unbalance{"residual_unbalance_g_mm", Text::tr("Residual unbalance"),
                                         1};
constexpr ResultField bob_weight_sum{"bobweight_g", Text::tr("Bob weight"), 1};
constexpr ResultField with_plugs_in{"bobweight_with_plugs_in_g", Text::tr("Bob weight, plugs in"),
                                    1};
constexpr ResultField shift{"shift_mm", Text::tr("Shift"), 2};
constexpr ResultField bob_weight{"bobweight", Text::tr("Bob weight")};
}  // namespace key

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

constexpr std::array<std::string_view, 3> limit_words{"none", "wall", "bottom"};

void visit_bob_weight(ResultVisitor& visitor, const ResultField& field, const BobWeight& weight) {
    visitor.object(field, [&] {
        visitor.number({"sum_g", Text::tr("Sum"), 1}, weight.sum());
        shop::visit_lines(visitor, weight.lines);
    });
}

void visit_shift_effect(ResultVisitor& visitor, const ShiftEffect& effect, double tolerance) {
    visitor.word({"from"}, effect.planned ? "bore" : "range");
    visitor.numbers(key::shift, {effect.min_shift, effect.max_shift});
    visitor.numbers(key::unbalance, {effect.minimum, effect.maximum});
    visitor.number(key::residual_unbalance, effect.residual_unbalance);
    visitor.flag({"beyond_tolerance", Text::tr("Beyond tolerance")},
                 std::abs(effect.residual_unbalance) > tolerance);
    // For the shifts in their order: the smallest asks for most.
    visitor.numbers({"corrected_reduction_g"}, {effect.max_reduction, effect.min_reduction});
    if (effect.depth) {
        visitor.number({"corrected_depth_mm", Text::tr("Corrected depth"), 2}, effect.depth);
    }
}

void visit_boring(ResultVisitor& visitor, const Boring& boring,
                  const std::optional<ShiftEffect>& effect) {
    const bool possible = boring.limit == Boring::Limit::none;
    visitor.flag({"possible", Text::tr("Possible")}, possible);
    visitor.word({"limited_by"}, limit_words.at(static_cast<std::size_t>(boring.limit)));
    visitor.number({"depth_mm", Text::tr("Depth"), 2}, boring.depth);
    visitor.number({"deeper_by_mm", Text::tr("Deeper by"), 2}, boring.deeper);
    visitor.number({"wall_mm", Text::tr("Wall"), 2}, boring.wall);
    visitor.number({"bottom_mm", Text::tr("Bottom"), 2}, boring.bottom);
    visitor.number({"maximum_reduction_g", Text::tr("Maximum by the walls")}, boring.max_reduction);
    if (possible) {
        visitor.number(key::shift, effect ? effect->max_shift : 0.0);
        visitor.number({"shift_unbalance_g_mm", Text::tr("Effect of the shift"), 2},
                       effect ? effect->maximum : 0.0);
    }
}

void visit_option(ResultVisitor& visitor, const Result& result, OptionId id, double crank_radius,
                  double tolerance) {
    const auto& solved = result.option(id);
    // What its plugs are worth is known whatever they have to compensate.
    const auto option =
        solved ? std::optional<Option>(*solved)
               : evaluate_option(id, *result.engine, *result.unbalanced_mass, tolerance);
    const auto weight = solved ? solved->bob_weight : std::nullopt;
    const auto number = [&](const ResultField& field, double Option::*member) {
        visitor.number(field, option ? std::optional((*option).*member) : std::nullopt);
    };
    number({"constant_g", Text::tr("Fixed part"), 3, Text::tr("Compensated without machining.")},
           &Option::constant);
    number({"slope", Text::tr("Gain"), 3, Text::tr("Compensated by a gram off each plug.")},
           &Option::slope);
    number({"maximum_g", Text::tr("Maximum")}, &Option::maximum);
    const auto answer = [&](const ResultField& field, double Option::*member) {
        visitor.number(field, solved ? std::optional((*solved).*member) : std::nullopt);
    };
    answer(key::required_reduction, &Option::required_reduction);
    answer(key::reduction, &Option::reduction);
    visitor.number(key::take_off, solved ? std::optional(solved->take_off()) : std::nullopt);
    visitor.flag(feasible, solved   ? std::optional(solved->feasible)
                           : option ? std::nullopt
                                    : std::optional(false));
    answer(key::residual_mass, &Option::residual_mass);
    answer(key::residual_unbalance, &Option::residual_unbalance);
    const auto grams = [&](const ResultField& field, const std::optional<BobWeight>& of,
                           double (BobWeight::*sum)() const) {
        visitor.number(field, of ? std::optional(((*of).*sum)()) : std::nullopt);
    };
    grams(key::bob_weight_sum, weight, &BobWeight::sum);
    grams(key::with_plugs_in, weight, &BobWeight::with_plugs_in);
    if (!option) {
        visitor.text(reason, Text::tr("the engine has no such plug"));
    }
    if (!solved) {
        return;
    }
    const auto crankshaft = needs_new_crankshaft(id) ? Crankshaft::new_plugs : Crankshaft::standard;
    grams({"nominal_bobweight_g", Text::tr("Bob weight, nominal"), 1},
          weight ? bob_weight(*result.engine, {}, crankshaft) : std::nullopt, &BobWeight::sum);
    visitor.number({"plug_mass_g", Text::tr("Mass of a plug")}, solved->fitted_mass());
    if (!option->feasible) {
        visitor.text(reason, describe_failure(*option, tolerance));
    }
    if (weight) {
        visit_bob_weight(visitor, key::bob_weight, *weight);
    }
    const double plug = option->plug_mass_unmachined - option->reduction;
    visitor.list({"centre_of_mass_shift", Text::tr("Shift")}, 2, [&](std::size_t i) {
        const double shift = i == 0 ? smallest_shift : largest_shift;
        visitor.number(key::shift, shift);
        visitor.number({"coefficient", Text::tr("Coefficient"), 4},
                       shift_coefficient(shift, crank_radius));
        visitor.number(key::unbalance, shift_unbalance(plug, shift));
    });
    if (const auto& effect = solved->shift) {
        visitor.object({"shift_effect", Text::tr("Effect of the shift")},
                       [&] { visit_shift_effect(visitor, *effect, tolerance); });
    }
    if (const auto& boring = solved->boring) {
        visitor.object({"boring", Text::tr("Boring")},
                       [&] { visit_boring(visitor, *boring, solved->shift); });
    }
}

void visit_crankpins(ResultVisitor& visitor, const shop::Placed& placed, double mean,
                     double crank_radius) {
    visitor.object({"crankpins", Text::tr("Crankpins")}, [&] {
        std::vector<double> excess;
        std::vector<double> deviation;
        for (const double mass : placed.crankpins) {
            excess.push_back(mean + mass);
            deviation.push_back(mass * crank_radius);
        }
        visitor.numbers(key::unbalanced_mass, excess);
        visitor.number(shop::result_field::spread, placed.spread);
        visitor.numbers({"deviation_g_mm", {}, 1}, deviation);
    });
}

void visit_weigh_in(ResultVisitor& visitor, const Input& input, const Result& result,
                    const std::optional<shop::Matched>& placing, double crank_radius,
                    const std::optional<double>& speed) {
    shop::visit_columns(visitor, *input.weigh_in);
    if (placing) {
        const double mean = result.weighed_excess.value();
        visit_crankpins(visitor, placing->before, mean, crank_radius);
        visitor.object(shop::result_field::assignment, [&] {
            shop::visit_matched(visitor, *placing, crank_radius, speed);
            visit_crankpins(visitor, placing->after, mean, crank_radius);
        });
    }
}

struct Material {
    ResultField field;
    Text plug;
    std::optional<double> Engine::*mass;
    double PlugSheet::*density;
};
constexpr Material materials[] = {{{"steel", Text::tr("Steel")},
                                   Text::tr("Steel plug"),
                                   &Engine::steel_plug_mass,
                                   &PlugSheet::steel_density},
                                  {{"aluminium", Text::tr("Aluminium")},
                                   Text::tr("Aluminium plug"),
                                   &Engine::aluminium_plug_mass,
                                   &PlugSheet::aluminium_density}};

/// What a plug of the sheet's sizes weighs, kg, where its mass is known too.
std::optional<double> mass_by_sizes(const Input& input, const Material& material) {
    const auto geometry = input.plug ? input.plug->geometry() : std::nullopt;
    return geometry && !geometry_fault(*geometry) && input.engine.*material.mass
               ? std::optional(geometry->volume() * *input.plug.*material.density)
               : std::nullopt;
}

/// What is to be done, with the bore where there is one.
Message advice_text(const Input& input, const Result& result) {
    const Advice& advice = *result.advice;
    Message text = plug_work(input, result);
    if (advice.kind == Advice::Kind::option && input.plug) {
        if (const auto boring = result.chosen()->right_boring(); boring && boring->cuts) {
            return two_sentences(std::move(text), describe(*boring, input.plug->limits().value()));
        }
    }
    return text;
}

std::string_view recommended_word(const Advice& advice) {
    return advice.kind == Advice::Kind::none_needed ? "none-needed"
           : advice.kind == Advice::Kind::option    ? option_word(advice.option.value()).word
                                                    : "";
}

void visit_advice(ResultVisitor& visitor, const Input& input, const Result& result) {
    const std::string_view recommended = recommended_word(*result.advice);
    visitor.word(key::recommended, recommended);
    if (visitor.wants(reason.key)) {
        visitor.text(reason, advice_text(input, result));
    }
    // Green, amber or red: works; works by the method's count only; does not.
    const ShiftEffect* shift = result.shift_that_matters();
    visitor.word(key::state, recommended.empty() ? "fails"
                             : shift != nullptr  ? "warning"
                                                 : "works");
    if (shift != nullptr) {
        visitor.text(key::warning, describe(*shift, input.tolerance));
    }
}

}  // namespace

void visit_plugs(ResultVisitor& visitor, const Input& input, const Result& result,
                 const std::optional<shop::Matched>& placing, const std::optional<double>& speed) {
    RAVNOVES_DEMAND(result.engine && result.unbalanced_mass,
                    "what is written is the result of a whole input");
    const double crank_radius = result.engine->crank_radius.value();
    const double excess = *result.unbalanced_mass;
    const Coefficients k = coefficients(*result.engine);
    visitor.number(key::unbalanced_mass, excess);
    visitor.number(key::unbalance, excess * crank_radius);
    visitor.number({"k_p", Text::tr("Coefficient kₚ")}, k.k_p);
    visitor.number({"k_y", Text::tr("Coefficient kᵤ")}, k.k_y);
    visitor.number({"k_y_new", Text::tr("Coefficient kᵤₙ")}, k.k_y_new);
    visitor.number({"slope_angle_deg", Text::tr("Slope angle"), 1}, std::atan(k.k_y));
    visitor.object({"mass_changes_g", Text::tr("Mass changes"), 3, {}, units::none}, [&] {
        for (const auto& [field, member, repair_only] : mass_change_fields()) {
            visitor.number({field.key, field.label, 3, {}, field.unit}, result.changes.*member);
        }
    });
    if (visitor.wants(key::not_counted.key)) {
        visitor.texts(key::not_counted, shop::both(replaced(input), not_counted(input)));
    }
    visitor.texts({"notes"}, [&] { return std::vector{rod_note(input, result)}; });
    visitor.object({"options", Text::tr("Options")}, [&] {
        for (const OptionId id : all_options) {
            visitor.object({option_word(id).word, option_word(id).label, 0, {}, units::none}, [&] {
                visit_option(visitor, result, id, crank_radius, input.tolerance);
            });
        }
    });
    if (result.advice) {
        visit_advice(visitor, input, result);
    } else {
        for (const ResultField* field : {&key::recommended, &reason, &key::state, &key::warning}) {
            visitor.nothing(*field);
        }
    }
    if (result.nominal && result.before) {
        visitor.object(key::bob_weight, [&] {
            visit_bob_weight(visitor, {"nominal", Text::tr("Nominal")}, *result.nominal);
            visit_bob_weight(visitor, {"before", Text::tr("Before")}, *result.before);
        });
    }
    if (input.weigh_in) {
        visitor.object(shop::result_field::weigh_in, [&] {
            visit_weigh_in(visitor, input, result, placing, crank_radius, speed);
        });
    }
    if (mass_by_sizes(input, materials[0])) {
        visitor.object({"plug", Text::tr("Plug")}, [&] {
            for (const Material& each : materials) {
                const auto mass = mass_by_sizes(input, each);
                if (!mass) {
                    continue;
                }
                const double entered = (input.engine.*each.mass).value();
                visitor.object(each.field, [&] {
                    visitor.number({"geometry_mass_g", Text::tr("Mass by the sizes"), 2}, *mass);
                    visitor.number({"entered_mass_g", Text::tr("Mass as entered")}, entered);
                    visitor.flag({"fits", Text::tr("Masses agree")}, mass_fits(entered, *mass));
                });
            }
        });
    }
}

Message describe_action(const Option& option, double reduction) {
    const bool machined = option.machined();
    const Number off = in_grams(reduction);
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

Message plug_work(const Input& input, const Result& result) {
    const Advice& advice = *result.advice;
    const double tolerance = input.tolerance;
    const double unbalanced_mass = *result.unbalanced_mass;
    const double unbalance = unbalanced_mass * result.engine->crank_radius.value();
    Message text;
    switch (advice.kind) {
        case Advice::Kind::none_needed:
            return {Text::tr("Leave the plugs unchanged: the excess of %1 per crankpin is %2."),
                    in_grams(unbalanced_mass), within(unbalance, tolerance)};
        case Advice::Kind::option: {
            const SolvedOption& option = *result.chosen();
            const Message action = describe_action(option, option.take_off());
            return option.residual_mass == 0.0 || option.by_method_alone()
                       ? action
                       : two_sentences(action, {Text::tr("This %1: %2."), over_or_under(option),
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
            const SolvedOption& option = *result.chosen();
            text = two_sentences(
                option.machined()
                    ? Message(Text::tr("“%1” would be suitable with %2 off each plug, but such a "
                                       "plug cannot be made."),
                              option_word(option.id).label, in_grams(option.reduction))
                    : Message(Text::tr("“%1” would be suitable, but such a plug cannot be made."),
                              option_word(option.id).label),
                option.hindrance);
            break;
        }
        case Advice::Kind::none_sufficient:
        case Advice::Kind::none_light_enough: {
            const SolvedOption& closest = *result.chosen();
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

Verdict verdict_of_plugs(const Input& input, const Result& result) {
    const bool works = !recommended_word(*result.advice).empty();
    return {works ? Severity::good : Severity::error, advice_text(input, result)};
}

PlugDoubt plug_doubt(const Input& input, const Result& result) {
    const auto geometry = input.plug ? input.plug->geometry() : std::nullopt;
    const bool solid = geometry && geometry->bore_depth <= 0.0;
    const auto& advice = result.advice;
    const bool takes_aluminium = advice && advice->option && !has_steel_plugs(*advice->option);
    PlugDoubt doubt;
    for (const Material& each : materials) {
        const auto mass = mass_by_sizes(input, each);
        const double entered = (input.engine.*each.mass).value_or(0.0);
        if (!mass || mass_fits(entered, *mass)) {
            continue;
        }
        PlugDoubt found;
        if (is_printed(input, each.mass)) {
            found = {Text::tr("The plug mass is from the paper: weigh the plugs."),
                     advice && (each.mass == &Engine::steel_plug_mass || takes_aluminium)};
        } else {
            found = {{solid ? Text::tr("%1: %2 entered, but a solid plug of these dimensions "
                                       "weighs %3. Enter its bore or weigh the plug.")
                            : Text::tr("%1: %2 entered, but a plug of these dimensions weighs "
                                       "%3. Weigh the plug."),
                      each.plug, in_grams(entered), Number{*mass / units::gram, units::gram, -1}},
                     !solid || entered > *mass};
        }
        if (doubt.text.empty() || (found.is_certain && !doubt.is_certain)) {
            doubt = std::move(found);
        }
    }
    return doubt;
}

Message rod_note(const Input& input, const Result& result) {
    const auto k = input.rod_coefficient();
    if (!k || !result.unbalanced_mass || !input.engine.crank_radius) {
        return {};
    }
    if (k != input.engine.rod_coefficient) {
        return Text::tr("Big end × 2: the small ends are weighed, kᵣ is not used.");
    }
    const double effect = *k * result.changes.rod_big_end;
    return {Text::tr("Big end × %1: 2 for two rods, kᵣ = %2 by the method for the small ends, "
                     "which are not weighed; effect here: %3, %4."),
            Number{2.0 + *k, units::none, -3, false, true},
            Number{*k, units::none, -3, false, true}, in_grams(effect),
            in_gram_millimetres(effect * *input.engine.crank_radius)};
}

std::vector<Message> paper_limits(const Input& input, const Result& result) {
    std::vector<Message> list;
    const Engine* preset = find_preset(input.preset);
    const auto check = [&](std::optional<double> Engine::*limit,
                           std::optional<double> Engine::*mass, OptionId id) {
        const bool is_own =
            input.plug ? !is_printed(input, mass) : input.engine.*mass != preset->*mass;
        if (!is_own || !(preset->*limit) || input.engine.*limit != preset->*limit) {
            return;
        }
        const auto field = std::ranges::find(engine_fields(), limit, &EngineField::member);
        const Number grams = in_grams(*(preset->*limit));
        const auto& option = result.option(id);
        if (option && option->boring) {
            list.emplace_back(Text::tr("%1: %2 is the paper's limit for its plug; the walls of "
                                       "this plug allow %3. Enter the limit of this plug."),
                              field->field.label, grams, in_grams(option->boring->max_reduction));
        } else {
            list.emplace_back(Text::tr("%1: %2 is the paper's limit for its plug. Enter the limit "
                                       "of this plug."),
                              field->field.label, grams);
        }
    };
    if (preset != nullptr) {
        check(&Engine::max_steel_reduction, &Engine::steel_plug_mass, OptionId::steel_machined);
        check(&Engine::max_aluminium_reduction, &Engine::aluminium_plug_mass,
              OptionId::steel_to_aluminium);
    }
    return list;
}

}  // namespace ravnoves::v8_plugs
