#include <cmath>
#include <filesystem>

#include "balance-shaft/balance_shaft.h"
#include "case-file/input_error.h"
#include "case-file/object_reader.h"

namespace ravnoves::balance_shaft {

namespace {

constexpr const char* root = "/input";
constexpr const char* masses_key = "reciprocating_masses_kg";

std::string pointer(const FieldSpec& field, const char* parent = root) {
    return std::string(parent) + "/" + std::string(field.key);
}

void check(const FieldSpec& field, double si, const char* parent = root) {
    const double value = from_si(field, si);
    if (!field.range.contains(value)) {
        throw InputError(pointer(field, parent), field.range.describe(), format_number(value));
    }
}

void check(const FieldSpec& field, const std::optional<double>& si, const char* parent = root) {
    if (si) {
        check(field, *si, parent);
    }
}

std::vector<NamedMass> read_masses(ObjectReader& reader) {
    if (!reader.has(masses_key)) {
        return {{"", reader.si(field::reciprocating_mass)}};
    }
    if (reader.has(field::reciprocating_mass.key)) {
        throw InputError(reader.pointer_to(field::reciprocating_mass.key),
                         std::string("must be left out where ") + masses_key + " is given");
    }
    ObjectReader masses = reader.object(masses_key);
    std::vector<NamedMass> parts;
    for (const std::string& name : masses.keys()) {
        parts.push_back({name, masses.number(name, field::reciprocating_mass_part.range)});
    }
    return parts;
}

TorqueSource read_torque(ObjectReader reader, const CaseContext& context) {
    TorqueSource source;
    if (reader.has("csv")) {
        source.kind = TorqueSource::Kind::csv;
        source.csv = reader.text("csv");
        reader.finish();
        const std::string place = reader.pointer_to("csv");
        if (source.csv.find('\0') != std::string::npos || source.csv.empty()) {
            throw InputError(place, "must be a file name", show(Json(source.csv)));
        }
        try {
            source.table = parse_torque_table(read_text_file(context.directory / source.csv)).table;
        } catch (const InputError& error) {
            std::string rule = source.csv + ": ";
            rule += error.where().empty() ? "" : error.where() + ": ";
            throw InputError(place, rule + error.allowed(), error.found());
        }
        return source;
    }
    if (!reader.has("crank_angle_deg") && !reader.has("torque_Nm")) {
        reader.finish();  // a misspelt key is named first
        throw InputError(reader.pointer(), "must hold crank_angle_deg and torque_Nm, or csv", "{}");
    }
    source.table.crank_angle_deg = reader.numbers("crank_angle_deg", Range{});
    source.table.torque = reader.numbers("torque_Nm", Range{});
    reader.finish();
    return source;
}

EnvelopeSizes read_envelope(ObjectReader reader) {
    EnvelopeSizes sizes;
    sizes.cylinder_bore = reader.optional_si(field::cylinder_bore);
    sizes.cylinder_top = reader.optional_si(field::cylinder_top);
    sizes.crank_swing_radius = reader.optional_si(field::crank_swing_radius);
    sizes.shaft_swing_radius = reader.optional_si(field::shaft_swing_radius);
    sizes.gear_tip_radius = reader.optional_si(field::gear_tip_radius);
    sizes.wall = reader.si(field::wall, 0.0);
    reader.finish();
    return sizes;
}

void put(Json& object, const FieldSpec& field, double si) {
    object[std::string(field.key)] = from_si(field, si);
}

void put(Json& object, const FieldSpec& field, const std::optional<double>& si) {
    if (si) {
        put(object, field, *si);
    }
}

}  // namespace

double Input::reciprocating_mass() const {
    double sum = 0.0;
    for (const NamedMass& part : reciprocating_masses) {
        sum += part.mass;
    }
    return sum;
}

double Input::effective_rod_length() const {
    return rod_length.value_or(crank_radius / default_lambda);
}

Input read_input(const Json& json, const CaseContext& context) {
    ObjectReader reader(json, root);
    Input input;
    input.speed_in_rpm = reader.has(field::speed.key);
    if (input.speed_in_rpm && reader.has(field::angular_speed.key)) {
        throw InputError(reader.pointer_to(field::angular_speed.key),
                         "must be left out where " + std::string(field::speed.key) + " is given");
    }
    if (!input.speed_in_rpm && !reader.has(field::angular_speed.key)) {
        throw InputError(
            reader.pointer_to(field::speed.key),
            "is required and missing (or " + std::string(field::angular_speed.key) + ")");
    }
    input.angular_speed = reader.si(input.speed_in_rpm ? field::speed : field::angular_speed);
    input.crank_radius = reader.si(field::crank_radius);
    input.reciprocating_masses = read_masses(reader);
    input.counterweight_radius = reader.si(field::counterweight_radius);
    input.counterweight_mass = reader.optional_si(field::counterweight_mass);
    input.centre_distance = reader.si(field::centre_distance);
    input.shaft_angle = reader.si(field::shaft_angle);
    const std::string interpolation =
        reader.choice("interpolation", {"linear", "periodic-cubic"}, "linear");
    input.interpolation =
        interpolation == "linear" ? Interpolation::linear : Interpolation::periodic_cubic;
    input.step_deg = reader.number(field::step.key, field::step.range, input.step_deg);
    input.rod_length = reader.optional_si(field::rod_length);
    input.rod_mass = reader.optional_si(field::rod_mass);
    if (reader.has("envelope")) {
        input.envelope = read_envelope(reader.object("envelope"));
    }
    input.torque = read_torque(reader.object("torque"), context);
    reader.finish();
    check_input(input);
    return input;
}

Json write_input(const Input& input) {
    Json json = Json::object();
    put(json, input.speed_in_rpm ? field::speed : field::angular_speed, input.angular_speed);
    put(json, field::crank_radius, input.crank_radius);
    if (input.reciprocating_masses.size() == 1 && input.reciprocating_masses[0].name.empty()) {
        put(json, field::reciprocating_mass, input.reciprocating_masses[0].mass);
    } else {
        Json masses = Json::object();
        for (const NamedMass& part : input.reciprocating_masses) {
            masses[part.name] = part.mass;
        }
        json[masses_key] = std::move(masses);
    }
    put(json, field::counterweight_radius, input.counterweight_radius);
    put(json, field::counterweight_mass, input.counterweight_mass);
    put(json, field::centre_distance, input.centre_distance);
    put(json, field::shaft_angle, input.shaft_angle);
    if (input.torque.kind == TorqueSource::Kind::csv) {
        json["torque"] = {{"csv", input.torque.csv}};
    } else {
        json["torque"] = {{"crank_angle_deg", input.torque.table.crank_angle_deg},
                          {"torque_Nm", input.torque.table.torque}};
    }
    json["interpolation"] =
        input.interpolation == Interpolation::linear ? "linear" : "periodic-cubic";
    json[std::string(field::step.key)] = input.step_deg;
    put(json, field::rod_length, input.rod_length);
    put(json, field::rod_mass, input.rod_mass);
    if (input.envelope != EnvelopeSizes{}) {
        Json envelope = Json::object();
        put(envelope, field::cylinder_bore, input.envelope.cylinder_bore);
        put(envelope, field::cylinder_top, input.envelope.cylinder_top);
        put(envelope, field::crank_swing_radius, input.envelope.crank_swing_radius);
        put(envelope, field::shaft_swing_radius, input.envelope.shaft_swing_radius);
        put(envelope, field::gear_tip_radius, input.envelope.gear_tip_radius);
        put(envelope, field::wall, input.envelope.wall);
        json["envelope"] = std::move(envelope);
    }
    return json;
}

void check_input(const Input& input) {
    check(input.speed_in_rpm ? field::speed : field::angular_speed, input.angular_speed);
    check(field::crank_radius, input.crank_radius);
    const std::string masses = std::string(root) + "/" + masses_key;
    if (input.reciprocating_masses.size() == 1 && input.reciprocating_masses[0].name.empty()) {
        check(field::reciprocating_mass, input.reciprocating_masses[0].mass);
    } else {
        for (const NamedMass& part : input.reciprocating_masses) {
            if (!field::reciprocating_mass_part.range.contains(part.mass)) {
                throw InputError(masses + "/" + part.name,
                                 field::reciprocating_mass_part.range.describe(),
                                 format_number(part.mass));
            }
        }
        const double sum = input.reciprocating_mass();
        if (!(sum > 0.0) || !std::isfinite(sum)) {
            throw InputError(masses, "must add up to more than 0 and to a finite mass",
                             format_number(sum));
        }
    }
    check(field::counterweight_radius, input.counterweight_radius);
    check(field::counterweight_mass, input.counterweight_mass);
    check(field::centre_distance, input.centre_distance);
    check(field::shaft_angle, input.shaft_angle);
    check_torque_table(input.torque.table, std::string(root) + "/torque");
    if (!field::step.range.contains(input.step_deg)) {
        throw InputError(pointer(field::step), field::step.range.describe(),
                         format_number(input.step_deg));
    }
    check(field::rod_length, input.rod_length);
    check(field::rod_mass, input.rod_mass);
    for (const NamedMass& part : input.reciprocating_masses) {
        if (part.name == "rod_small_end" && input.rod_mass && part.mass > *input.rod_mass) {
            throw InputError("/input/reciprocating_masses_kg/rod_small_end",
                             "must be at most rod_mass_kg, " + format_number(*input.rod_mass),
                             format_number(part.mass));
        }
    }
    if (input.rod_length && !(*input.rod_length > input.crank_radius)) {
        throw InputError(pointer(field::rod_length),
                         "must be greater than the crank radius, " +
                             format_number(from_si(field::crank_radius, input.crank_radius)),
                         format_number(from_si(field::rod_length, *input.rod_length)));
    }
    const std::string envelope_pointer = std::string(root) + "/envelope";
    const char* envelope = envelope_pointer.c_str();
    check(field::cylinder_bore, input.envelope.cylinder_bore, envelope);
    check(field::cylinder_top, input.envelope.cylinder_top, envelope);
    check(field::crank_swing_radius, input.envelope.crank_swing_radius, envelope);
    check(field::shaft_swing_radius, input.envelope.shaft_swing_radius, envelope);
    check(field::gear_tip_radius, input.envelope.gear_tip_radius, envelope);
    check(field::wall, input.envelope.wall, envelope);

    // Each number alone may be fine and their products not.
    constexpr double largest = 1e100;
    const auto check_together = [&](double value, const char* what, const FieldSpec& field) {
        if (!(std::abs(value) <= largest)) {
            throw InputError(pointer(field), std::string("makes ") + what +
                                                 " larger than this program can work with (1e100)"
                                                 " together with the other inputs");
        }
    };
    const double speed = input.angular_speed;
    const double reciprocating = input.reciprocating_mass();
    const double counterweight = input.counterweight_mass.value_or(
        reciprocating * input.crank_radius / (2.0 * input.counterweight_radius));
    check_together(speed * speed, "the square of the speed",
                   input.speed_in_rpm ? field::speed : field::angular_speed);
    check_together(input.crank_radius, "the mechanism", field::crank_radius);
    check_together(reciprocating * input.crank_radius * speed * speed, "the inertia force",
                   field::crank_radius);
    check_together(counterweight, "the counterweight's mass", field::counterweight_radius);
    const double force = counterweight * input.counterweight_radius * speed * speed;
    check_together(input.counterweight_radius, "the mechanism", field::counterweight_radius);
    check_together(force, "the counterweight's force", field::counterweight_radius);
    check_together(input.centre_distance, "the mechanism", field::centre_distance);
    check_together(force * input.centre_distance, "the shaft's moment", field::centre_distance);
    check_together(input.effective_rod_length(), "the mechanism", field::rod_length);
    check_together(input.envelope.cylinder_bore.value_or(0.0), "the envelope",
                   field::cylinder_bore);
    check_together(input.envelope.cylinder_top.value_or(0.0), "the envelope", field::cylinder_top);
    check_together(input.envelope.crank_swing_radius.value_or(0.0), "the envelope",
                   field::crank_swing_radius);
    check_together(input.envelope.shaft_swing_radius.value_or(0.0), "the envelope",
                   field::shaft_swing_radius);
    check_together(input.envelope.gear_tip_radius.value_or(0.0), "the envelope",
                   field::gear_tip_radius);
    check_together(input.envelope.wall, "the envelope", field::wall);
}

}  // namespace ravnoves::balance_shaft
