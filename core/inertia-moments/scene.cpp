#include "inertia-moments/scene.h"

#include <cmath>
#include <string>
#include <string_view>

#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/object_reader.h"
#include "inertia-moments/solver.h"

namespace ravnoves::inertia_moments {

namespace {

// ---------------------------------------------------------------------------------------- input

Cylinder read_cylinder(const Json& value, const std::string& pointer) {
    ObjectReader reader(value, pointer);
    Cylinder cylinder;
    cylinder.axial_position = reader.si(field::axial_position);
    cylinder.bank_angle = reader.si(field::bank_angle);
    cylinder.offset = reader.si(field::offset);
    cylinder.crankpin_angle = reader.si(field::crankpin_angle);
    reader.finish();
    return cylinder;
}

/// The entries of an array of objects.
template <typename Item, typename Read>
std::vector<Item> read_list(ObjectReader& reader, std::string_view key, Read&& read) {
    const Json& list = reader.raw(key);
    if (!list.is_array()) {
        throw InputError(reader.pointer_to(key), "must be a list", show(list));
    }
    std::vector<Item> items;
    for (const Json& item : list) {
        items.push_back(read(item, reader.pointer_to(key) + "/" + std::to_string(items.size())));
    }
    return items;
}

Layout read_layout(ObjectReader reader, double crank_radius) {
    Layout layout;
    if (reader.choice("type", {"vr", "library"}) == "vr") {
        layout.name = "vr";
        layout.cylinders = reader.integer("cylinders", 1, most_cylinders);
        layout.bank_angle = reader.si(field::included_angle);
        layout.offset = reader.si(field::offset);
        layout.spacing = reader.si(field::spacing);
        layout.firing_order = reader.integers("firing_order", 1, layout.cylinders);
        layout.first_position = reader.si(field::first_position);
    } else {
        const std::string name = reader.text("name");
        const LayoutSpec* spec = find_layout(name);
        if (spec == nullptr) {
            std::vector<std::string> names;
            for (const LayoutSpec& known : layout_library()) {
                names.emplace_back(known.name);
            }
            std::string allowed = "must be a layout of the library";
            if (const auto near = nearest_word(name, names)) {
                allowed += " (the nearest is \"" + *near + "\")";
            }
            throw InputError(reader.pointer_to("name"), allowed, show(Json(name)));
        }
        const Layout usual = usual_layout(*spec, crank_radius);
        layout = usual;
        layout.bank_angle = reader.si(field::included_angle, usual.bank_angle);
        layout.offset = reader.si(field::offset, usual.offset);
        layout.spacing = reader.si(field::spacing, usual.spacing);
        layout.stagger = reader.si(field::stagger, usual.stagger);
        layout.first_position = reader.si(field::first_position, usual.first_position);
        if (reader.has("firing_order")) {
            layout.firing_order = reader.integers("firing_order", 1, spec->cylinders);
        }
    }
    reader.finish();
    return layout;
}

Shaft read_shaft(const Json& value, const std::string& pointer) {
    ObjectReader reader(value, pointer);
    Shaft shaft;
    shaft.order = reader.integer("order", 1, highest_order);
    shaft.direction = reader.choice("direction", {"forward", "backward"}) == "forward"
                          ? Direction::forward
                          : Direction::backward;
    if (reader.choice("balances", {"moment", "force"}, "moment") == "moment") {
        shaft.balances = Balances::moment;
        shaft.weight_distance = reader.si(field::weight_distance);
    } else {
        shaft.balances = Balances::force;
        shaft.axial_position = reader.optional_si(field::shaft_position);
    }
    shaft.weight_radius = reader.optional_si(field::weight_radius);
    shaft.phase_error = reader.si(field::phase_error, 0.0);
    shaft.enabled = reader.boolean("enabled", true);
    reader.finish();
    return shaft;
}

EndWebs read_end_webs(ObjectReader reader) {
    EndWebs webs;
    webs.front_position = reader.si(field::front_position);
    webs.rear_position = reader.si(field::rear_position);
    webs.front_radius = reader.si(field::front_radius);
    webs.rear_radius = reader.si(field::rear_radius);
    webs.first_order_share = reader.si(field::first_order_share, 0.0);
    webs.enabled = reader.boolean("enabled", true);
    reader.finish();
    return webs;
}

void put(Json& object, const FieldSpec& field, double si) {
    object[std::string(field.key)] = from_si(field, si);
}

void put(Json& object, const FieldSpec& field, const std::optional<double>& si) {
    if (si) {
        put(object, field, *si);
    }
}

Json write_layout(const Layout& layout) {
    Json object;
    if (layout.name == "vr") {
        object["type"] = "vr";
        object["cylinders"] = layout.cylinders;
    } else {
        object["type"] = "library";
        object["name"] = layout.name;
    }
    put(object, field::included_angle, layout.bank_angle);
    put(object, field::offset, layout.offset);
    put(object, field::spacing, layout.spacing);
    if (layout.name != "vr") {
        put(object, field::stagger, layout.stagger);
    }
    object["firing_order"] = layout.firing_order;
    put(object, field::first_position, layout.first_position);
    return object;
}

// --------------------------------------------------------------------------------------- result

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

std::string_view word(Direction direction) {
    return direction == Direction::forward ? "forward" : "backward";
}

std::string_view word(Balances balances) {
    return balances == Balances::force ? "force" : "moment";
}

Json write_shaft(const ShaftDesign& design) {
    const bool force = design.shaft.balances == Balances::force;
    Json object = {{"order", design.shaft.order},
                   {"direction", word(design.shaft.direction)},
                   {"balances", word(design.shaft.balances)},
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

std::string_view word(Quantity quantity) {
    switch (quantity) {
        case Quantity::force:
            return "force";
        case Quantity::moment:
            return "moment";
        case Quantity::roll:
            return "roll_moment";
    }
    return "";
}

Json write_differences(const Result& result) {
    Json object;
    Json warnings = Json::array();
    for (const Difference& difference : result.differences) {
        Json& order = object["order_" + std::to_string(difference.order)];
        const Json percent = difference.relative ? Json(100.0 * *difference.relative) : Json();
        const std::string quantity(word(difference.quantity));
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
            warnings.push_back(describe(difference));
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
    return {{"crank_angle_deg", std::move(angle)},
            {"force_x_N", curves.force_x},
            {"force_y_N", curves.force_y},
            {"moment_x_Nm", curves.moment_x},
            {"moment_y_Nm", curves.moment_y},
            {"inertia_roll_Nm", curves.inertia_roll},
            {"reaction_torque_Nm", curves.reaction_torque},
            {"roll_moment_Nm", curves.roll}};
}

}  // namespace

Input read_input(const Json& json) {
    ObjectReader reader(json, "/input");
    Input input;
    input.crank_radius = reader.si(field::crank_radius);
    input.lambda = reader.si(field::lambda);
    input.angular_speed = reader.si(field::speed);
    input.reciprocating_mass = reader.si(field::reciprocating_mass);
    input.rotating_mass = reader.si(field::rotating_mass, 0.0);
    input.reference_position = reader.si(field::reference_position, 0.0);
    const bool table = reader.has("cylinders");
    const bool layout = reader.has("layout");
    if (table == layout) {
        throw InputError("/input/cylinders",
                         table ? "must not stand beside \"layout\": one of the two"
                               : "is required and missing (or \"layout\" instead)");
    }
    if (table) {
        input.cylinders = read_list<Cylinder>(reader, "cylinders", read_cylinder);
        if (reader.has("firing_order")) {
            input.firing_order = reader.integers("firing_order", 1, most_cylinders);
        }
    } else {
        input.layout = read_layout(reader.object("layout"), input.crank_radius);
    }
    if (reader.has("rod")) {
        ObjectReader rod = reader.object("rod");
        input.rod = RigidRod{rod.si(field::rod_mass), rod.si(field::rod_centre),
                             rod.si(field::rod_inertia)};
        rod.finish();
    }
    if (reader.has("balance_shafts")) {
        input.shafts = read_list<Shaft>(reader, "balance_shafts", read_shaft);
    }
    if (reader.choice("balance_shaft_basis", {"exact", "two-term"}, "exact") == "two-term") {
        input.shaft_basis = DesignBasis::two_term;
    }
    if (reader.has("counterweights")) {
        input.end_webs = read_end_webs(reader.object("counterweights"));
    }
    input.step = reader.optional_si(field::step);
    reader.finish();
    check_input(input);
    return input;
}

Json write_input(const Input& input) {
    Json json;
    put(json, field::crank_radius, input.crank_radius);
    put(json, field::lambda, input.lambda);
    put(json, field::speed, input.angular_speed);
    put(json, field::reciprocating_mass, input.reciprocating_mass);
    put(json, field::rotating_mass, input.rotating_mass);
    put(json, field::reference_position, input.reference_position);
    if (input.layout) {
        json["layout"] = write_layout(*input.layout);
    } else {
        Json list = Json::array();
        for (const Cylinder& cylinder : input.cylinders) {
            Json item;
            put(item, field::axial_position, cylinder.axial_position);
            put(item, field::bank_angle, cylinder.bank_angle);
            put(item, field::offset, cylinder.offset);
            put(item, field::crankpin_angle, cylinder.crankpin_angle);
            list.push_back(std::move(item));
        }
        json["cylinders"] = std::move(list);
        if (!input.firing_order.empty()) {
            json["firing_order"] = input.firing_order;
        }
    }
    if (input.rod) {
        Json rod;
        put(rod, field::rod_mass, input.rod->mass);
        put(rod, field::rod_centre, input.rod->centre_from_big_end);
        put(rod, field::rod_inertia, input.rod->inertia);
        json["rod"] = std::move(rod);
    }
    if (!input.shafts.empty()) {
        Json list = Json::array();
        for (const Shaft& shaft : input.shafts) {
            Json item = {{"order", shaft.order},
                         {"direction", word(shaft.direction)},
                         {"balances", word(shaft.balances)}};
            if (shaft.balances == Balances::moment) {
                put(item, field::weight_distance, shaft.weight_distance);
            } else {
                put(item, field::shaft_position, shaft.axial_position);
            }
            put(item, field::weight_radius, shaft.weight_radius);
            put(item, field::phase_error, shaft.phase_error);
            item["enabled"] = shaft.enabled;
            list.push_back(std::move(item));
        }
        json["balance_shafts"] = std::move(list);
    }
    if (input.shaft_basis == DesignBasis::two_term) {
        json["balance_shaft_basis"] = "two-term";
    }
    if (input.end_webs) {
        Json webs;
        put(webs, field::front_position, input.end_webs->front_position);
        put(webs, field::rear_position, input.end_webs->rear_position);
        put(webs, field::front_radius, input.end_webs->front_radius);
        put(webs, field::rear_radius, input.end_webs->rear_radius);
        put(webs, field::first_order_share, input.end_webs->first_order_share);
        webs["enabled"] = input.end_webs->enabled;
        json["counterweights"] = std::move(webs);
    }
    put(json, field::step, input.step);
    return json;
}

Json write_result(const Input& input, const Result& result) {
    Json json;
    Json pins = Json::array();
    Json tops = Json::array();
    for (const Cylinder& cylinder : result.engine.cylinders) {
        pins.push_back(turn_degrees(cylinder.crankpin_angle));
        tops.push_back(result.engine.mechanism(cylinder).top_dead_centre() / degree);
    }
    json["crankpin_angle_deg"] = std::move(pins);
    if (result.tdc_angle) {
        json["tdc_angle_deg"] = *result.tdc_angle / degree;
    }
    json["cylinder_tdc_angle_deg"] = std::move(tops);
    json["two_term"] = write_orders(result.two_term);
    json["exact"] = write_orders(result.exact);
    json["rotating"] = write_rotating(result.rotating);
    json["difference"] = write_differences(result);
    if (!result.exact.accurate) {
        json["difference"]["warnings"].push_back(
            "a mechanism is so near locking that the exact orders are less accurate than usual");
    }
    if (!result.firing.empty()) {
        Json firing = Json::array();
        for (const FiringEvent& event : result.firing) {
            firing.push_back({{"cylinder", event.cylinder},
                              {"crank_angle_deg", event.crank_angle / degree},
                              {"interval_deg", event.interval / degree}});
        }
        json["firing"] = std::move(firing);
    }
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
    json["remaining"] = write_orders(result.remaining);
    if (input.step) {
        json["curves"] = write_curves(result.curves);
        json["remaining_curves"] = write_curves(result.remaining_curves);
    }
    return json;
}

Json solve_scene(const Json& input, const CaseContext& /*context*/) {
    const Input checked = read_input(input);
    return write_result(checked, solve(checked));
}

}  // namespace ravnoves::inertia_moments
