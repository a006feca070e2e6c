#include "inertia-moments/scene.h"

#include <array>
#include <cmath>
#include <span>
#include <string>
#include <string_view>

#include "case-file/field_reader.h"
#include "case-file/field_writer.h"
#include "inertia-moments/fields.h"
#include "inertia-moments/solver.h"

namespace ravnoves::inertia_moments {

namespace {

/// Degrees in 0…360 of an angle in rad.
double turn_degrees(double angle) {
    return wrap_turn(angle) / degree;
}

/// The direction in degrees, or null where the amplitude is nothing beside its scale.
Json direction(Complex vector, double scale) {
    if (!(std::abs(vector) > zero_share * scale)) {
        return nullptr;
    }
    return turn_degrees(std::arg(vector));
}

Json write_harmonic(const Harmonic<double>& h) {
    return {{"cos", h.cos + 0.0}, {"sin", h.sin + 0.0}};
}

Json write_rotating_part(Complex vector, double scale) {
    return {{"amplitude", std::abs(vector)}, {"angle_deg", direction(vector, scale)}};
}

Json write_pair(const RotatingPair& pair, double scale) {
    return {{"horizontal", write_harmonic(pair.horizontal())},
            {"vertical", write_harmonic(pair.vertical())},
            {"forward", write_rotating_part(pair.forward, scale)},
            {"backward", write_rotating_part(pair.backward, scale)}};
}

Json write_orders(const EngineOrders& orders) {
    Json object;
    for (const EngineOrder& order : orders.orders) {
        object["order_" + std::to_string(order.order)] = {
            {"force_N", write_pair(order.force, order.force_scale)},
            {"moment_Nm", write_pair(order.moment, order.moment_scale)},
            {"roll_moment_Nm",
             {{"inertia", write_harmonic(order.inertia_roll)},
              {"reaction_torque", write_harmonic(order.reaction_torque)},
              {"total", write_harmonic(order.roll())}}}};
    }
    return object;
}

Json write_throws(const Engine& engine) {
    Json throws = Json::array();
    for (const Throw& pin : engine.throws) {
        Json cylinders = Json::array();
        for (const std::size_t i : pin.cylinders) {
            cylinders.push_back(i + 1);
        }
        throws.push_back({{"cylinders", std::move(cylinders)},
                          {"axial_position_mm", pin.position / units::mm},
                          {"crankpin_angle_deg", turn_degrees(pin.crankpin_angle)},
                          {"rotating_mass_kg", engine.mass_on(pin)}});
    }
    return throws;
}

/// The articulated rods with what their input leaves out filled in.
Json write_articulated(const Engine& engine) {
    Json rods = Json::array();
    for (std::size_t i = 0; i < engine.knuckles.size(); ++i) {
        if (const auto& rod = engine.knuckles[i]) {
            rods.push_back({{"cylinder", i + 1},
                            {"master", rod->master + 1},
                            {"knuckle_radius_mm", rod->knuckle_radius / units::mm},
                            {"knuckle_angle_deg", rod->knuckle_angle / degree},
                            {"rod_length_mm", rod->rod_length / units::mm}});
        }
    }
    return rods;
}

Json write_rotating(const RotatingMasses& rotating) {
    // A counterweight lies opposite; its lag is measured against the rotation.
    const auto lag = [](Complex vector, double scale) -> Json {
        const Json angle = direction(-vector, scale);
        return angle.is_null() ? angle : Json(turn_degrees(-angle.get<double>() * degree));
    };
    return {{"force_factor", std::abs(rotating.force_factor)},
            {"force_angle_deg", direction(rotating.force_factor, rotating.force_scale)},
            {"moment_factor_m", std::abs(rotating.moment_factor)},
            {"moment_angle_deg", direction(rotating.moment_factor, rotating.moment_scale)},
            {"force_N", std::abs(rotating.force())},
            {"moment_Nm", std::abs(rotating.moment())},
            {"counterweight_force_lag_deg", lag(rotating.force_factor, rotating.force_scale)},
            {"counterweight_moment_lag_deg", lag(rotating.moment_factor, rotating.moment_scale)}};
}

template <typename Enum>
std::string_view word(std::span<const Word> words, Enum value) {
    return words[static_cast<std::size_t>(value)].word;
}

Json write_shaft(const ShaftDesign& design) {
    const bool force = design.shaft.balances == Balances::force;
    Json object = {{"order", design.shaft.order},
                   {"direction", word(field::directions, design.shaft.direction)},
                   {"balances", word(field::tasks, design.shaft.balances)},
                   {"unbalance_kg_m", design.unbalance},
                   {"mass_kg", design.mass ? Json(*design.mass) : Json()},
                   {"phase_deg", design.phase ? Json(turn_degrees(*design.phase)) : Json()}};
    object[force ? "cancels_N" : "cancels_Nm"] = std::abs(design.target);
    object[force ? "order_max_before_N" : "order_max_before_Nm"] = design.before;
    object[force ? "order_max_remaining_N" : "order_max_remaining_Nm"] = design.remaining;
    return object;
}

Json write_counterweight(const Counterweight& weight, double scale) {
    const Json angle = direction(weight.unbalance, scale);
    return {
        {"unbalance_kg_m", std::abs(weight.unbalance)},
        {"mass_kg", weight.mass()},
        {"angle_deg", angle},
        {"lag_deg", angle.is_null() ? Json() : Json(turn_degrees(-angle.get<double>() * degree))}};
}

Json write_counterweights(const CounterweightDesign& design) {
    const double scale = std::abs(design.against_force) + std::abs(design.against_moment) +
                         std::abs(design.front.unbalance) + std::abs(design.rear.unbalance);
    return {{"front", write_counterweight(design.front, scale)},
            {"rear", write_counterweight(design.rear, scale)},
            {"force_unbalance_kg_m", std::abs(design.against_force)},
            {"moment_unbalance_kg_m", std::abs(design.against_moment)}};
}

Json write_differences(const Result& result) {
    Json object;
    Json warnings = Json::array();
    for (const Difference& difference : result.differences) {
        Json& order = object["order_" + std::to_string(difference.order)];
        const Json percent = difference.relative ? Json(100.0 * *difference.relative) : Json();
        constexpr std::array quantities{"force", "moment", "roll_moment"};
        const std::string quantity = quantities.at(static_cast<std::size_t>(difference.quantity));
        switch (difference.plane) {
            case Plane::horizontal:
                order[quantity]["horizontal_percent"] = percent;
                break;
            case Plane::vertical:
                order[quantity]["vertical_percent"] = percent;
                break;
            case Plane::none:
                order[quantity + "_percent"] = percent;
                break;
        }
        if (difference.warning) {
            warnings.push_back(describe(difference).english());
        }
    }
    object["warnings"] = std::move(warnings);
    return object;
}

Json write_curves(const WrenchCurves& curves) {
    Json angle = Json::array();
    for (const double phi : curves.crank_angle) {
        angle.push_back(phi / degree);
    }
    return object_of({{"crank_angle_deg", std::move(angle)},
                      {"force_x_N", curves.force_x},
                      {"force_y_N", curves.force_y},
                      {"moment_x_Nm", curves.moment_x},
                      {"moment_y_Nm", curves.moment_y},
                      {"inertia_roll_Nm", curves.inertia_roll},
                      {"reaction_torque_Nm", curves.reaction_torque},
                      {"roll_moment_Nm", curves.roll}});
}

}  // namespace

Input read_input(const Json& json) {
    Input input = read_fields<Input>(json);
    check_input(input);
    return input;
}

Json write_input(const Input& input) {
    return write_fields(input);
}

namespace {

Json write_wanted(const Input& input, const Result& result, const Wanted& wanted) {
    Json json = object_with_room(32);
    const auto put_orders = [&](const char* key, const EngineOrders& orders) {
        if (wanted.wants(std::string("/") + key)) {
            json[key] = write_orders(orders);
        }
    };
    Json pins = Json::array();
    Json tops = Json::array();
    Json strokes = Json::array();
    for (std::size_t i = 0; i < result.engine.cylinders.size(); ++i) {
        pins.push_back(turn_degrees(result.engine.cylinders[i].crankpin_angle));
        tops.push_back(result.engine.top_dead_centre(i) / degree);
        strokes.push_back(result.engine.stroke(i) / units::mm);
    }
    json["crankpin_angle_deg"] = std::move(pins);
    if (result.tdc_angle) {
        json["tdc_angle_deg"] = *result.tdc_angle / degree;
    }
    json["cylinder_tdc_angle_deg"] = std::move(tops);
    json["cylinder_stroke_mm"] = std::move(strokes);
    if (Json rods = write_articulated(result.engine); !rods.empty()) {
        json["articulated_rods"] = std::move(rods);
    }
    put_orders("two_term", result.two_term);
    put_orders("exact", result.exact);
    json["rotating"] = write_rotating(result.rotating);
    json["throws"] = write_throws(result.engine);
    if (wanted.wants("/difference")) {
        json["difference"] = write_differences(result);
    }
    if (!result.firing.empty()) {
        Json firing = Json::array();
        for (const FiringEvent& event : result.firing) {
            firing.push_back({{"cylinder", event.cylinder},
                              {"crank_angle_deg", event.crank_angle / degree},
                              {"interval_deg", event.interval / degree}});
        }
        json["firing"] = std::move(firing);
        json["firing_cycle_deg"] = input.cycle() / degree;
        json["fires_evenly"] = fires_evenly(result.firing);
    } else if (!result.firing_trouble.empty()) {
        json["firing_reason"] = result.firing_trouble.english();
    }
    json["notes"] = english(result.notes);
    if (!result.shafts.empty()) {
        Json shafts = Json::array();
        for (const ShaftDesign& design : result.shafts) {
            shafts.push_back(write_shaft(design));
        }
        json["balance_shafts"] = std::move(shafts);
    }
    if (result.counterweights) {
        json["counterweights"] = write_counterweights(*result.counterweights);
    }
    put_orders("unbalanced", result.unbalanced);
    put_orders("remaining", result.remaining);
    if (input.step && wanted.wants("/curves")) {
        json["curves"] = write_curves(result.curves);
    }
    if (input.step && wanted.wants("/unbalanced_curves")) {
        json["unbalanced_curves"] = write_curves(result.unbalanced_curves);
    }
    if (input.step && wanted.wants("/remaining_curves")) {
        json["remaining_curves"] = write_curves(result.remaining_curves);
    }
    return json;
}

}  // namespace

Json write_result(const Input& input, const Result& result) {
    return write_wanted(input, result, {});
}

Json solve_scene(const Json& input, const CaseContext& /*context*/, const Wanted& wanted) {
    const Input checked = read_input(input);
    return write_wanted(checked, solve(checked), wanted);
}

}  // namespace ravnoves::inertia_moments
