#include "bob-weights/scene.h"

#include "bob-weights/fields.h"
#include "bob-weights/solver.h"
#include "case-file/field_reader.h"
#include "case-file/field_writer.h"
#include "case-file/json.h"
#include "numerics/demand.h"

namespace ravnoves::bob_weights {

namespace {

Json holes_json(const std::vector<Hole>& holes, bool added) {
    Json list = Json::array();
    for (const Hole& hole : holes) {
        const double mass = hole.mass / units::gram;
        const double unbalance = hole.unbalance / units::gram_mm;
        // A slug takes off less than nothing: so every line counts in the same sense.
        Json line{{"diameter_mm", hole.diameter / units::mm},
                  {"depth_mm", hole.depth / units::mm},
                  {"angle_deg", hole.angle / units::degree},
                  {"removed_g", added ? -mass : mass},
                  {"removed_g_mm", added ? -unbalance : unbalance}};
        if (added) {
            line["added_g"] = mass;
            line["added_g_mm"] = unbalance;
            if (hole.slug > 0.0) {
                line["slug_g"] = hole.slug / units::gram;
            }
        }
        list.push_back(std::move(line));
    }
    return list;
}

Json known(const std::optional<bool>& yes) {
    return yes ? Json(*yes) : Json();
}

Json plane_json(const PlaneResult& plane) {
    Json json{{"unbalance_g_mm", plane.unbalance / units::gram_mm},
              {"angle_deg", plane.angle / units::degree},
              {"grams_at_radius", plane.grams_at_radius / units::gram},
              {"holes", holes_json(plane.holes, false)},
              {"slugs", holes_json(plane.slugs, true)},
              {"remaining_g_mm", plane.remaining / units::gram_mm},
              {"remaining_angle_deg", plane.remaining_angle / units::degree},
              {"within_tolerance_as_measured", known(plane.measured_within)},
              {"within_tolerance", known(plane.within_tolerance)},
              {"feasible", plane.reason.empty()}};
    if (plane.beyond_sector > 0.0) {
        json["edge_beyond_sector_mm"] = plane.beyond_sector / units::mm;
    }
    if (!plane.reason.empty()) {
        json["reason"] = plane.reason.english();
    }
    return json;
}

Json runs_json(const std::vector<RunResult>& runs) {
    Json list = Json::array();
    for (const RunResult& run : runs) {
        Json planes = Json::array();
        for (std::size_t i = 0; i < 2; ++i) {
            const RunResult::InPlane& plane = run.planes.value()[i];
            planes.push_back({{"unbalance_g_mm", plane.unbalance / units::gram_mm},
                              {"angle_deg", plane.angle / units::degree},
                              {"within_tolerance", known(plane.within_tolerance)}});
            if (const auto& other = run.other_effect[i]) {
                planes.back()["expected"] = {{"unbalance_g_mm", other->expected / units::gram_mm},
                                             {"angle_deg", other->expected_angle / units::degree},
                                             {"drilling_acted_opposite", other->is_opposite}};
            }
            if (&run != &runs.back()) {
                planes.back()["drilled_holes"] = holes_json(run.drilled[i].holes, false);
                planes.back()["drilled_slugs"] = holes_json(run.drilled[i].slugs, true);
            }
        }
        list.push_back({{"planes", std::move(planes)}, {"within_tolerance", known(run.passes())}});
        if (run.read_with) {
            list.back()["read_with_bobweight_g"] = *run.read_with / units::gram;
        }
        if (run.read_on) {
            list.back()["read_on"] = run.read_on->then;
        }
    }
    return list;
}

Json weigh_in_json(const Input& input, const Result& result) {
    Json json = Json::object();
    for (const Matching& each : result.matching) {
        const auto& masses = (*input.weigh_in)[*each.part->column].mass;
        json[std::string(shop::part_word(*each.part->column).word)] = {
            {"mean_g", each.statistics.mean / units::gram},
            {"spread_g", each.statistics.spread / units::gram},
            {"heaviest_cylinder", each.statistics.heaviest + 1},
            {"lightest_cylinder", each.statistics.lightest + 1},
            {"within_permitted_spread", each.statistics.within_permitted},
            {"take_off_g", shop::take_off_json(masses)}};
    }
    Json pins = Json::array();
    for (const double mass : result.crankpins) {
        pins.push_back(mass / units::gram);
    }
    json["crankpins_g"] = std::move(pins);
    if (result.placing) {
        json["assignment"] = shop::matched_json(
            *result.placing, input.weigh_in->matching.crank_radius, service_speed(input));
        Json placed = Json::array();
        for (const double mass : result.placed_crankpins) {
            placed.push_back(mass / units::gram);
        }
        json["assignment"]["crankpins_g"] = std::move(placed);
    }
    return json;
}

}  // namespace

Json write_result(const Input& input, const Result& result) {
    RAVNOVES_DEMAND(
        result.first_order && result.reciprocating && result.rotating && result.bob_weight,
        "what is written is the result of a whole input");
    const double factor = result.factor + input.factor.overbalance;
    const FirstOrder& left = *result.first_order;
    Json lines = Json::array();
    for (const Line& line : result.lines) {
        lines.push_back({{"part", line.part->field.key},
                         {"factor", line.factor},
                         {"mass_g", line.mass / units::gram},
                         {"product_g", line.product() / units::gram}});
    }
    Json json{{"reciprocating_g", *result.reciprocating / units::gram},
              {"rotating_g", *result.rotating / units::gram},
              {"reciprocating_percent", result.factor / units::percent},
              {"bobweight_g", *result.bob_weight / units::gram},
              {"bobweights", input.engine.crankpins()},
              {"lines", std::move(lines)},
              {"theory",
               {{"reciprocating_percent", result.theory_factor / units::percent},
                {"reason", factor_reason(input.engine).english()},
                {"effect", factor_effect(input.engine, factor).english()},
                {"cylinders", is_pair(input.engine) ? 2 : 1},
                {"forward_g", left.forward / units::gram},
                {"backward_g", left.backward / units::gram},
                {"upright_g", left.upright() / units::gram},
                {"across_g", left.across() / units::gram}}}};
    json["not_given"] = Json::array();
    for (const PartField* part : result.not_given) {
        json["not_given"].push_back(part->field.key);
    }
    json["not_counted"] = Json::array();
    for (const Message& message : not_counted(input)) {
        json["not_counted"].push_back(message.english());
    }
    json["looks_like_kilograms"] = Json::array();
    for (const auto& [part, mass] : result.in_kilograms) {
        json["looks_like_kilograms"].push_back(part->field.key);
    }
    if (input.weigh_in) {
        json["weigh_in"] = weigh_in_json(input, result);
    }
    if (result.permissible) {
        json["permissible_g_mm"] = {(*result.permissible)[0] / units::gram_mm,
                                    (*result.permissible)[1] / units::gram_mm};
    }
    if (result.permissible_whole) {
        json["permissible_rotor_g_mm"] = *result.permissible_whole / units::gram_mm;
    }
    if (result.correction) {
        json["correction"] = {
            {"planes", {plane_json((*result.correction)[0]), plane_json((*result.correction)[1])}},
            {"runs", runs_json(result.runs)},
            {"amplification", result.amplification.value()}};
        const RunResult& newest = result.runs.back();
        if (newest.read_with) {
            json["correction"]["read_with_bobweight_g"] = *newest.read_with / units::gram;
        }
        if (newest.read_on) {
            json["correction"]["read_on"] = newest.read_on->then;
        }
    }
    return json;
}

Input read_input(const Json& json, Completeness completeness) {
    Input input = read_fields<Input>(json, completeness);
    if (completeness == Completeness::required) {
        check_input(input);
    } else {
        fit_weigh_in(input);
    }
    return input;
}

Json write_input(const Input& input) {
    return write_fields(fitted(input));
}

Json solve_scene(const Json& json, const CaseContext& /*context*/, const Wanted& /*wanted*/) {
    const Input input = read_input(json);
    return write_result(input, solve(input));
}

}  // namespace ravnoves::bob_weights
