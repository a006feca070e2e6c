#include "v8-plugs/scene.h"

#include <cmath>
#include <numeric>

#include "case-file/field_reader.h"
#include "case-file/field_writer.h"
#include "case-file/json.h"
#include "numerics/demand.h"
#include "v8-plugs/solver.h"

namespace ravnoves::v8_plugs {

namespace {

Json bob_weight_json(const BobWeight& weight) {
    Json lines = Json::array();
    for (const BobWeightLine& line : weight.lines) {
        lines.push_back({{"part", bob_weight_word(line.part).word},
                         {"factor", line.factor},
                         {"mass_g", line.mass / units::gram},
                         {"product_g", line.product() / units::gram}});
    }
    return {{"sum_g", weight.sum() / units::gram}, {"lines", std::move(lines)}};
}

std::string_view limit_name(Boring::Limit limit) {
    switch (limit) {
        case Boring::Limit::none:
            return "none";
        case Boring::Limit::wall:
            return "wall";
        case Boring::Limit::bottom:
            return "bottom";
    }
    return "";
}

Json shift_json(double plug_mass, double shift, double crank_radius) {
    return {{"shift_mm", shift / units::mm},
            {"coefficient", shift_coefficient(shift, crank_radius)},
            {"unbalance_g_mm", shift_unbalance(plug_mass, shift) / units::gram_mm}};
}

Json shift_effect_json(const ShiftEffect& effect, double tolerance) {
    Json json{{"from", effect.planned ? "bore" : "range"},
              {"shift_mm", {effect.least_shift / units::mm, effect.greatest_shift / units::mm}},
              {"unbalance_g_mm", {effect.least / units::gram_mm, effect.greatest / units::gram_mm}},
              {"residual_unbalance_g_mm", effect.residual_unbalance / units::gram_mm},
              {"beyond_tolerance", std::abs(effect.residual_unbalance) > tolerance},
              {"corrected_reduction_g",  // for the shifts in their order: the least asks for most
               {effect.greatest_reduction / units::gram, effect.least_reduction / units::gram}}};
    if (effect.depth) {
        json["corrected_depth_mm"] = *effect.depth / units::mm;
    }
    return json;
}

Json boring_json(const Boring& boring, const std::optional<ShiftEffect>& effect) {
    Json json{{"possible", boring.limit == Boring::Limit::none},
              {"limited_by", limit_name(boring.limit)},
              {"depth_mm", boring.depth / units::mm},
              {"deeper_by_mm", boring.deeper / units::mm},
              {"wall_mm", boring.wall / units::mm},
              {"bottom_mm", boring.bottom / units::mm},
              {"maximum_reduction_g", boring.max_reduction / units::gram}};
    if (boring.limit == Boring::Limit::none) {
        json["shift_mm"] = effect ? effect->greatest_shift / units::mm : 0.0;
        json["shift_unbalance_g_mm"] = effect ? effect->greatest / units::gram_mm : 0.0;
    }
    return json;
}

Json option_json(const Result& result, OptionId id, double crank_radius, double tolerance) {
    const auto& found = result.option(id);
    if (!found) {
        Json json = Json::object();
        for (const char* key :
             {"constant_g", "slope", "maximum_g", "required_reduction_g", "reduction_g"}) {
            json[key] = nullptr;
        }
        json["feasible"] = false;
        for (const char* key : {"residual_mass_g", "residual_unbalance_g_mm", "bobweight_g",
                                "bobweight_with_plugs_in_g"}) {
            json[key] = nullptr;
        }
        json["reason"] = Message(CORE_TEXT("v8-plugs", "the engine has no such plug")).english();
        return json;
    }
    const Option& option = *found;
    const OptionBobWeight& weights = result.bob_weights[index(id)].value();
    const double plug = option.plug_mass_unmachined - option.reduction;
    Json json{{"constant_g", option.constant / units::gram},
              {"slope", option.slope},
              {"maximum_g", option.maximum / units::gram},
              {"required_reduction_g", option.required_reduction / units::gram},
              {"reduction_g", option.reduction / units::gram},
              {"feasible", option.feasible},
              {"residual_mass_g", option.residual_mass / units::gram},
              {"residual_unbalance_g_mm", option.residual_unbalance / units::gram_mm},
              {"bobweight_g", weights.after.sum() / units::gram},
              {"bobweight_with_plugs_in_g", weights.after.with_plugs_in() / units::gram},
              {"nominal_bobweight_g", weights.nominal.sum() / units::gram},
              {"plug_mass_g", plug / units::gram}};
    if (!option.feasible) {
        json["reason"] = describe_failure(option, tolerance).english();
    }
    json["bobweight"] = bob_weight_json(weights.after);
    json["centre_of_mass_shift"] = Json::array({shift_json(plug, smallest_shift, crank_radius),
                                                shift_json(plug, largest_shift, crank_radius)});
    if (const auto& effect = result.shift[index(id)]) {
        json["shift_effect"] = shift_effect_json(*effect, tolerance);
    }
    if (const auto& boring = result.boring[index(id)]) {
        json["boring"] = boring_json(*boring, result.shift[index(id)]);
    }
    return json;
}

Json crankpin_json(const std::array<double, crankpin_count>& excess, double crank_radius) {
    const double mean = std::accumulate(excess.begin(), excess.end(), 0.0) / crankpin_count;
    Json grams = Json::array();
    Json unbalance = Json::array();
    for (const double mass : excess) {
        grams.push_back(mass / units::gram);
        unbalance.push_back((mass - mean) * crank_radius / units::gram_mm);
    }
    return {{"unbalanced_mass_g", std::move(grams)},
            {"spread_g", spread(excess) / units::gram},
            {"deviation_g_mm", std::move(unbalance)}};
}

Json weigh_in_json(const Input& input, const Result& result, double crank_radius) {
    Json json = Json::object();
    for (const Part part : all_parts) {
        const PartColumn& column = input.weigh_in.value()[part];
        if (const auto s = statistics(column)) {
            Json entry{{"mean_g", s->mean / units::gram},
                       {"spread_g", s->spread / units::gram},
                       {"heaviest_cylinder", s->heaviest + 1},
                       {"lightest_cylinder", s->lightest + 1},
                       {"within_permitted_spread", s->within_permitted},
                       {"take_off_g", shop::take_off_json(column.mass)}};
            if (column.nominal) {
                entry["mean_deviation_g"] = (s->mean - *column.nominal) / units::gram;
            }
            json[std::string(part_word(part).word)] = std::move(entry);
        }
    }
    if (result.assignment) {
        json["crankpins"] = crankpin_json(*result.crankpin_excess, crank_radius);
        const auto& speed = input.balancing ? input.balancing->service_speed : std::nullopt;
        json["assignment"] = shop::matched_json(*result.assignment, crank_radius, speed);
        json["assignment"]["crankpins"] = crankpin_json(*result.assigned_excess, crank_radius);
    }
    return json;
}

Json plug_mass_json(const PlugMass& mass) {
    return {{"geometry_mass_g", mass.geometry / units::gram},
            {"entered_mass_g", mass.typed / units::gram},
            {"fits", mass.fits}};
}

Json plane_json(const PlaneVerdict& plane) {
    Json json{{"permissible_g_mm", plane.permissible / units::gram_mm}};
    if (plane.reading) {
        json["reading_g_mm"] = *plane.reading / units::gram_mm;
        json["passes"] = plane.passes.value();
    }
    return json;
}

}  // namespace

Json write_result(const Input& input, const Result& result) {
    RAVNOVES_DEMAND(result.plugs && result.unbalanced_mass && result.advice,
                    "what is written is the result of a whole input");
    const PlugSet& plugs = *result.plugs;
    const double excess = *result.unbalanced_mass;
    const Coefficients coefficients = plugs.coefficients();
    const Advice& advice = *result.advice;

    Json json{{"unbalanced_mass_g", excess / units::gram},
              {"unbalance_g_mm", excess * plugs.crank_radius / units::gram_mm},
              {"k_p", coefficients.k_p},
              {"k_y", coefficients.k_y},
              {"k_y_new", coefficients.k_y_new ? Json(*coefficients.k_y_new) : Json()},
              {"slope_angle_deg", std::atan(coefficients.k_y) / units::degree}};
    Json changes = Json::object();
    for (const MassChangeField& field : mass_change_fields()) {
        changes[std::string(field.field.key)] = result.changes.*field.member / units::gram;
    }
    json["mass_changes_g"] = std::move(changes);
    json["not_counted"] = Json::array();
    for (const Message& message : not_counted(input)) {
        json["not_counted"].push_back(message.english());
    }
    Json options = Json::object();
    for (const OptionId id : all_options) {
        options[std::string(option_word(id).word)] =
            option_json(result, id, plugs.crank_radius, input.tolerance);
    }
    json["options"] = std::move(options);
    if (advice.kind == Advice::Kind::none_needed) {
        json["recommended"] = "none-needed";
    } else if (advice.kind == Advice::Kind::option) {
        json["recommended"] = option_word(advice.option.value().id).word;
    } else {
        json["recommended"] = nullptr;
    }
    std::string reason = describe(advice, excess, plugs.crank_radius, input.tolerance).english();
    if (advice.kind == Advice::Kind::option && input.plug) {
        const auto& boring = result.boring[index(advice.option.value().id)];
        if (boring && boring->cuts) {
            reason += ' ';
            reason += describe(*boring, input.plug->limits().value()).english();
        }
    }
    json["reason"] = std::move(reason);
    // Green, amber or red: works; works by the method's count only; does not.
    const ShiftEffect* shift = result.shift_that_matters();
    json["state"] = json["recommended"].is_null() ? "fails"
                    : shift != nullptr            ? "warning"
                                                  : "works";
    if (shift != nullptr) {
        json["warning"] = describe(*shift, input.tolerance).english();
    }
    if (result.nominal && result.before) {
        json["bobweight"] = {{"nominal", bob_weight_json(*result.nominal)},
                             {"before", bob_weight_json(*result.before)}};
    }
    if (input.weigh_in) {
        json["weigh_in"] = weigh_in_json(input, result, plugs.crank_radius);
    }
    if (result.steel_plug) {
        Json plug{{"steel", plug_mass_json(*result.steel_plug)}};
        if (result.aluminium_plug) {
            plug["aluminium"] = plug_mass_json(*result.aluminium_plug);
        }
        json["plug"] = std::move(plug);
    }
    const auto& [front, rear] = result.planes;
    if (result.balancing || front.reading || rear.reading) {
        json["balancing"] = {{"limit", result.balancing ? "iso-21940-11" : "tolerance"},
                             {"front", plane_json(front)},
                             {"rear", plane_json(rear)}};
        if (result.read_with) {
            json["balancing"]["read_with_bobweight_g"] = *result.read_with / units::gram;
        }
        if (result.read_on) {
            json["balancing"]["read_on"] = result.read_on->then;
        }
        if (result.balancing) {
            json["balancing"]["permissible_g_mm"] = result.balancing->permissible / units::gram_mm;
        }
    }
    return json;
}

Input read_input(const Json& json, Completeness completeness) {
    Input input = read_fields<Input>(json, completeness);
    if (completeness == Completeness::required) {
        check_input(input);
    } else {
        check_choices(input);
    }
    return input;
}

Json write_input(const Input& input) {
    return write_fields(input);
}

Json solve_scene(const Json& json, const CaseContext& /*context*/, const Wanted& /*wanted*/) {
    const Input input = read_input(json);
    return write_result(input, solve(input));
}

}  // namespace ravnoves::v8_plugs
