#include "v8-plugs/solver.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "case-file/json.h"
#include "numerics/constants.h"

namespace ravnoves::v8_plugs {

namespace {

constexpr double gram = 1e-3;
constexpr double millimetre = 1e-3;
constexpr double gram_millimetre = 1e-6;

std::size_t index(OptionId id) {
    return static_cast<std::size_t>(id);
}

PlugMaterial material_of(OptionId id) {
    return keeps_steel_plugs(id) ? PlugMaterial::steel : PlugMaterial::aluminium;
}

PlugMass plug_mass(double typed, const PlugGeometry& geometry, double density) {
    const double weighs = geometry.volume() * density;
    return {weighs, typed, mass_fits(typed, weighs)};
}

void solve_weigh_in(const CaseInput& input, Solution& solution) {
    if (!input.weigh_in || !input.engine.rod_coefficient) {
        return;
    }
    const double k = *input.engine.rod_coefficient;
    solution.assignment = best_assignment(*input.weigh_in, input.process, k);
    if (solution.assignment) {
        solution.crankpin_excess = crankpin_excess(*input.weigh_in, input.process, k);
        solution.assigned_excess =
            crankpin_excess(reassigned(*input.weigh_in, *solution.assignment), input.process, k);
    }
}

void solve_plug(const CaseInput& input, Solution& solution) {
    if (!input.plug) {
        return;
    }
    const auto geometry = input.plug->geometry();
    if (!geometry || geometry_fault(*geometry)) {
        return;
    }
    if (input.engine.steel_plug_mass) {
        solution.steel_plug =
            plug_mass(*input.engine.steel_plug_mass, *geometry, input.plug->steel_density);
    }
    if (input.engine.aluminium_plug_mass) {
        solution.aluminium_plug =
            plug_mass(*input.engine.aluminium_plug_mass, *geometry, input.plug->aluminium_density);
    }
    const auto limits = input.plug->limits();
    if (!limits) {
        return;
    }
    for (const OptionId id : all_options) {
        if (const auto& option = solution.option(id)) {
            solution.boring[index(id)] = plan_boring(*geometry, *limits, option->reduction,
                                                     input.plug->density(material_of(id)));
        }
    }
}

void solve_bob_weights(const CaseInput& input, Solution& solution) {
    const auto gear = gear_masses(input.engine);
    if (!gear || !solution.plugs) {
        return;
    }
    const PlugSet& plugs = *solution.plugs;
    solution.nominal = nominal_bob_weight(plugs, *gear, input.crankshaft);
    if (solution.nominal) {
        const bool new_plugs = input.crankshaft == Crankshaft::new_plugs;
        solution.before = bob_weight(plugs, *gear, input.process, solution.changes,
                                     new_plugs ? plugs.new_design->mass : plugs.steel_mass,
                                     new_plugs ? plugs.new_design->radius : plugs.plug_radius);
    }
    for (const OptionId id : all_options) {
        const auto& option = solution.option(id);
        const auto nominal = nominal_bob_weight(
            plugs, *gear, needs_new_crankshaft(id) ? Crankshaft::new_plugs : Crankshaft::standard);
        if (option && nominal) {
            solution.bob_weights[index(id)] = OptionBobWeight{
                option_bob_weight(plugs, *gear, input.process, solution.changes, *option),
                *nominal};
        }
    }
}

Json bob_weight_json(const BobWeight& weight) {
    Json lines = Json::array();
    for (const BobWeightLine& line : weight.lines) {
        lines.push_back({{"part", part_name(line.part)},
                         {"factor", line.factor},
                         {"mass_g", line.mass / gram},
                         {"product_g", line.product() / gram}});
    }
    return {{"sum_g", weight.sum() / gram}, {"lines", std::move(lines)}};
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
    return {{"shift_mm", shift / millimetre},
            {"coefficient", shift_coefficient(shift, crank_radius)},
            {"unbalance_g_mm", shift_unbalance(plug_mass, shift) / gram_millimetre}};
}

Json boring_json(const Boring& boring, double plug_mass) {
    Json json{{"possible", boring.limit == Boring::Limit::none},
              {"limited_by", limit_name(boring.limit)},
              {"depth_mm", boring.depth / millimetre},
              {"deeper_by_mm", boring.deeper / millimetre},
              {"wall_mm", boring.wall / millimetre},
              {"bottom_mm", boring.bottom / millimetre},
              {"maximum_reduction_g", boring.max_reduction / gram}};
    if (boring.limit == Boring::Limit::none) {
        json["shift_mm"] = boring.shift / millimetre;
        json["shift_unbalance_g_mm"] = shift_unbalance(plug_mass, boring.shift) / gram_millimetre;
    }
    return json;
}

Json option_json(const Solution& solution, OptionId id, double crank_radius, double tolerance) {
    const auto& found = solution.option(id);
    if (!found) {
        Json json = Json::object();
        for (const char* key :
             {"constant_g", "slope", "maximum_g", "required_reduction_g", "reduction_g"}) {
            json[key] = nullptr;
        }
        json["feasible"] = false;
        for (const char* key : {"residual_mass_g", "residual_unbalance_g_mm", "bobweight_g"}) {
            json[key] = nullptr;
        }
        json["reason"] = "the engine has no such plug";
        return json;
    }
    const Option& option = *found;
    const OptionBobWeight& weights = solution.bob_weights[index(id)].value();
    const double plug = option.plug_mass_unmachined - option.reduction;
    Json json{{"constant_g", option.constant / gram},
              {"slope", option.slope},
              {"maximum_g", option.maximum / gram},
              {"required_reduction_g", option.required_reduction / gram},
              {"reduction_g", option.reduction / gram},
              {"feasible", option.feasible},
              {"residual_mass_g", option.residual_mass / gram},
              {"residual_unbalance_g_mm", option.residual_unbalance / gram_millimetre},
              {"bobweight_g", weights.after.sum() / gram},
              {"nominal_bobweight_g", weights.nominal.sum() / gram},
              {"plug_mass_g", plug / gram}};
    if (!option.feasible) {
        json["reason"] = describe_failure(option, tolerance);
    }
    json["bobweight"] = bob_weight_json(weights.after);
    json["centre_of_mass_shift"] = Json::array({shift_json(plug, smallest_shift, crank_radius),
                                                shift_json(plug, largest_shift, crank_radius)});
    if (const auto& boring = solution.boring[index(id)]) {
        json["boring"] = boring_json(*boring, plug);
    }
    return json;
}

Json crankpin_json(const std::array<double, crankpin_count>& excess, double crank_radius) {
    const double mean = std::accumulate(excess.begin(), excess.end(), 0.0) / crankpin_count;
    Json grams = Json::array();
    Json unbalance = Json::array();
    for (const double mass : excess) {
        grams.push_back(mass / gram);
        unbalance.push_back((mass - mean) * crank_radius / gram_millimetre);
    }
    const auto [least, most] = std::minmax_element(excess.begin(), excess.end());
    return {{"unbalanced_mass_g", std::move(grams)},
            {"spread_g", (*most - *least) / gram},
            {"deviation_g_mm", std::move(unbalance)}};
}

Json weigh_in_json(const CaseInput& input, const Solution& solution, double crank_radius) {
    Json json = Json::object();
    for (const Part part : all_parts) {
        const PartColumn& column = input.weigh_in.value()[part];
        if (const auto s = statistics(column)) {
            Json entry{{"mean_g", s->mean / gram},
                       {"spread_g", s->spread / gram},
                       {"heaviest_cylinder", s->heaviest + 1},
                       {"lightest_cylinder", s->lightest + 1},
                       {"within_permitted_spread", s->within_permitted}};
            if (column.nominal) {
                entry["mean_deviation_g"] = (s->mean - *column.nominal) / gram;
            }
            json[std::string(part_key(part))] = std::move(entry);
        }
    }
    if (solution.assignment) {
        const auto cylinders = [](const std::vector<int>& from) {
            Json list = Json::array();
            for (const int cylinder : from) {
                list.push_back(cylinder + 1);
            }
            return list;
        };
        json["crankpins"] = crankpin_json(*solution.crankpin_excess, crank_radius);
        json["assignment"] = {
            {"pistons_from_cylinder", cylinders(solution.assignment->pistons)},
            {"rods_from_cylinder", cylinders(solution.assignment->rods)},
            {"sets_moved", solution.assignment->moved},
            {"crankpins", crankpin_json(*solution.assigned_excess, crank_radius)}};
    }
    return json;
}

Json plug_mass_json(const PlugMass& mass) {
    return {{"geometry_mass_g", mass.geometry / gram},
            {"entered_mass_g", mass.typed / gram},
            {"fits", mass.fits}};
}

Json plane_json(const PlaneVerdict& plane) {
    Json json{{"permissible_g_mm", plane.permissible / gram_millimetre}};
    if (plane.reading) {
        json["reading_g_mm"] = *plane.reading / gram_millimetre;
        json["passes"] = plane.passes.value();
    }
    return json;
}

}  // namespace

Solution solve(const CaseInput& input) {
    Solution solution;
    solution.changes = input.changes();
    if (input.engine.rod_coefficient) {
        solution.unbalanced_mass =
            unbalanced_mass(input.process, solution.changes, *input.engine.rod_coefficient);
    }
    solution.plugs = plug_set(input.engine);
    if (solution.plugs && solution.unbalanced_mass) {
        for (const OptionId id : all_options) {
            solution.options[index(id)] =
                evaluate_option(id, *solution.plugs, *solution.unbalanced_mass, input.tolerance);
        }
        solution.advice =
            advise(*solution.plugs, input.crankshaft, *solution.unbalanced_mass, input.tolerance);
    }
    solve_bob_weights(input, solution);
    solve_weigh_in(input, solution);
    solve_plug(input, solution);
    if (input.balancing) {
        if (const auto check = input.balancing->check()) {
            solution.balancing = judge(*check);
        }
    }
    return solution;
}

Json solve_case_input(const Json& json, const CaseContext& /*context*/) {
    const CaseInput input = read_input(json);
    const Solution solution = solve(input);
    const PlugSet& plugs = solution.plugs.value();
    const double excess = solution.unbalanced_mass.value();
    const Coefficients coefficients = plugs.coefficients();
    const Advice& advice = solution.advice.value();

    Json result{{"unbalanced_mass_g", excess / gram},
                {"unbalance_g_mm", excess * plugs.crank_radius / gram_millimetre},
                {"k_p", coefficients.k_p},
                {"k_y", coefficients.k_y},
                {"k_y_new", coefficients.k_y_new ? Json(*coefficients.k_y_new) : Json()},
                {"slope_angle_deg", std::atan(coefficients.k_y) / degree}};
    Json changes = Json::object();
    for (const MassChangeField& field : mass_change_fields()) {
        if (!field.repair_only || input.process == Process::repair) {
            changes[std::string(field.spec.key)] = solution.changes.*field.member / gram;
        }
    }
    result["mass_changes_g"] = std::move(changes);
    Json options = Json::object();
    for (const OptionId id : all_options) {
        options[std::string(option_name(id))] =
            option_json(solution, id, plugs.crank_radius, input.tolerance);
    }
    result["options"] = std::move(options);
    if (advice.kind == Advice::Kind::none_needed) {
        result["recommended"] = "none-needed";
    } else if (advice.kind == Advice::Kind::option) {
        result["recommended"] = option_name(advice.option.value().id);
    } else {
        result["recommended"] = nullptr;
    }
    std::string reason = describe(advice, excess, plugs.crank_radius, input.tolerance);
    if (advice.kind == Advice::Kind::option && input.plug) {
        const auto& boring = solution.boring[index(advice.option.value().id)];
        if (boring && boring->cuts) {
            reason += ' ';
            reason += describe(*boring, input.plug->limits().value());
        }
    }
    result["reason"] = std::move(reason);
    if (solution.nominal && solution.before) {
        result["bobweight"] = {{"nominal", bob_weight_json(*solution.nominal)},
                               {"before", bob_weight_json(*solution.before)}};
    }
    if (input.weigh_in) {
        result["weigh_in"] = weigh_in_json(input, solution, plugs.crank_radius);
    }
    if (solution.steel_plug) {
        Json plug{{"steel", plug_mass_json(*solution.steel_plug)}};
        if (solution.aluminium_plug) {
            plug["aluminium"] = plug_mass_json(*solution.aluminium_plug);
        }
        result["plug"] = std::move(plug);
    }
    if (solution.balancing) {
        result["balancing"] = {
            {"permissible_g_mm", solution.balancing->permissible / gram_millimetre},
            {"front", plane_json(solution.balancing->front)},
            {"rear", plane_json(solution.balancing->rear)}};
    }
    return result;
}

}  // namespace ravnoves::v8_plugs
