#include <cmath>
#include <filesystem>

#include "balance-shaft/balance_shaft.h"
#include "balance-shaft/engine_torque.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/object_reader.h"
#include "case-file/text_file.h"

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

/// Reads and parses a file that the case names.
template <typename Parse>
auto read_beside(const std::string& name, const std::string& place, const CaseContext& context,
                 Parse parse) {
    if (name.find('\0') != std::string::npos || name.empty()) {
        throw InputError(place, "must be a file name", show(Json(name)));
    }
    try {
        return parse(read_text_file(context.directory / name));
    } catch (const InputError& error) {
        std::string rule = name + ": ";
        rule += error.where().empty() ? "" : error.where() + ": ";
        throw InputError(place, rule + error.allowed(), error.found());
    }
}

/// What "pressure" and "cycle" share.
void read_cylinder(ObjectReader& reader, Input& input) {
    CylinderSizes& sizes = input.torque.cylinder;
    sizes.bore = reader.si(field::bore);
    input.rod_length = reader.si(field::rod_length);
    sizes.offset = reader.si(field::offset, sizes.offset);
    sizes.crankcase_pressure = reader.si(field::crankcase_pressure, sizes.crankcase_pressure);
}

void read_cycle(ObjectReader reader, Input& input) {
    read_cylinder(reader, input);
    GasCycle& cycle = input.torque.cycle;
    cycle.compression_ratio = reader.si(field::compression_ratio);
    cycle.intake_pressure = reader.si(field::intake_pressure, cycle.intake_pressure);
    cycle.exhaust_pressure = reader.si(field::exhaust_pressure, cycle.exhaust_pressure);
    cycle.polytropic_compression =
        reader.si(field::polytropic_compression, cycle.polytropic_compression);
    cycle.polytropic_expansion = reader.si(field::polytropic_expansion, cycle.polytropic_expansion);
    cycle.heat = reader.optional_si(field::heat);
    cycle.imep = reader.optional_si(field::imep);
    if (cycle.heat.has_value() == cycle.imep.has_value()) {
        throw InputError(reader.pointer(),
                         "must hold either heat_J or indicated_mean_effective_pressure_bar",
                         cycle.heat ? "both" : "neither");
    }
    cycle.combustion_start = reader.si(field::combustion_start);
    cycle.combustion_duration = reader.si(field::combustion_duration);
    cycle.wiebe_m = reader.si(field::wiebe_m, cycle.wiebe_m);
    reader.finish();
}

void read_torque(ObjectReader reader, const CaseContext& context, Input& input) {
    TorqueSource& source = input.torque;
    const bool pressure = reader.has("pressure");
    const bool cycle = reader.has("cycle");
    const bool csv = reader.has("csv");
    const bool table = reader.has("crank_angle_deg") || reader.has("torque_Nm");
    if (pressure + cycle + csv + table != 1) {
        reader.finish();  // a misspelt key is named first
        throw InputError(
            reader.pointer(),
            "must hold one of: crank_angle_deg with torque_Nm, csv, pressure, cycle",
            pressure + cycle + csv + table == 0 ? "none of them" : "more than one of them");
    }
    if (pressure) {
        source.kind = TorqueSource::Kind::pressure;
        ObjectReader inner = reader.object("pressure");
        read_cylinder(inner, input);
        source.csv = inner.text("csv");
        inner.finish();
        reader.finish();
        source.trace =
            read_beside(source.csv, inner.pointer_to("csv"), context,
                        [](const std::string& text) { return parse_pressure_trace(text).trace; });
    } else if (cycle) {
        source.kind = TorqueSource::Kind::cycle;
        read_cycle(reader.object("cycle"), input);
        reader.finish();
    } else if (csv) {
        source.kind = TorqueSource::Kind::csv;
        source.csv = reader.text("csv");
        reader.finish();
        source.table =
            read_beside(source.csv, reader.pointer_to("csv"), context,
                        [](const std::string& text) { return parse_torque_table(text).table; });
    } else {
        source.table.crank_angle_deg = reader.numbers("crank_angle_deg", Range{});
        source.table.torque = reader.numbers("torque_Nm", Range{});
        reader.finish();
    }
}

RelievedShaftSizes read_relieved_shaft(ObjectReader reader) {
    RelievedShaftSizes sizes;
    sizes.diameter = reader.optional_si(field::bar_diameter);
    sizes.depth = reader.optional_si(field::relief_depth);
    sizes.length = reader.optional_si(field::relief_length);
    sizes.density = reader.si(field::density, sizes.density);
    sizes.elastic_modulus = reader.si(field::elastic_modulus, sizes.elastic_modulus);
    reader.finish();
    return sizes;
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

GearPair read_gears(ObjectReader reader) {
    GearPair gears;
    gears.teeth = reader.integer("teeth", 6, field::most_teeth, gears.teeth);
    gears.shifted_teeth =
        reader.integer("shifted_teeth", 1 - gears.teeth, gears.teeth - 1, gears.shifted_teeth);
    gears.backlash = reader.si(field::backlash, gears.backlash);
    reader.finish();
    return gears;
}

void put(Json& object, const FieldSpec& field, double si) {
    object[std::string(field.key)] = from_si(field, si);
}

void put(Json& object, const FieldSpec& field, const std::optional<double>& si) {
    if (si) {
        put(object, field, *si);
    }
}

Json write_torque(const Input& input) {
    const TorqueSource& source = input.torque;
    if (source.kind == TorqueSource::Kind::table) {
        return {{"crank_angle_deg", source.table.crank_angle_deg},
                {"torque_Nm", source.table.torque}};
    }
    if (source.kind == TorqueSource::Kind::csv) {
        return {{"csv", source.csv}};
    }
    Json inner = Json::object();
    if (source.kind == TorqueSource::Kind::pressure) {
        inner["csv"] = source.csv;
    }
    put(inner, field::bore, source.cylinder.bore);
    put(inner, field::rod_length, input.rod_length);
    put(inner, field::offset, source.cylinder.offset);
    put(inner, field::crankcase_pressure, source.cylinder.crankcase_pressure);
    if (source.kind == TorqueSource::Kind::pressure) {
        return {{"pressure", inner}};
    }
    const GasCycle& cycle = source.cycle;
    put(inner, field::compression_ratio, cycle.compression_ratio);
    put(inner, field::intake_pressure, cycle.intake_pressure);
    put(inner, field::exhaust_pressure, cycle.exhaust_pressure);
    put(inner, field::polytropic_compression, cycle.polytropic_compression);
    put(inner, field::polytropic_expansion, cycle.polytropic_expansion);
    put(inner, field::heat, cycle.heat);
    put(inner, field::imep, cycle.imep);
    put(inner, field::combustion_start, cycle.combustion_start);
    put(inner, field::combustion_duration, cycle.combustion_duration);
    put(inner, field::wiebe_m, cycle.wiebe_m);
    return {{"cycle", inner}};
}

void check_torque(const Input& input) {
    const std::string root_of_torque = std::string(root) + "/torque";
    const TorqueSource& source = input.torque;
    if (!source.is_computed()) {
        check_torque_table(source.table, root_of_torque);
        return;
    }
    const bool traced = source.kind == TorqueSource::Kind::pressure;
    const std::string parent = root_of_torque + (traced ? "/pressure" : "/cycle");
    const auto check_inner = [&](const FieldSpec& field, const auto& value) {
        check(field, value, parent.c_str());
    };
    check_inner(field::bore, source.cylinder.bore);
    check_inner(field::offset, source.cylinder.offset);
    check_inner(field::crankcase_pressure, source.cylinder.crankcase_pressure);
    if (!input.rod_length) {
        throw InputError(pointer(field::rod_length, parent.c_str()), "is required and missing");
    }
    check_inner(field::rod_length, input.rod_length);
    const double offset = std::abs(source.cylinder.offset);
    const SliderCrank<double> crank = slider_crank(input);
    if (!(*input.rod_length > (input.crank_radius + 2.0 * offset) * (1.0 + 1e-9))) {
        throw InputError(
            pointer(field::rod_length, parent.c_str()),
            "must be greater than the crank radius and twice the offset together, " +
                format_number(from_si(field::crank_radius, input.crank_radius + 2.0 * offset)),
            format_number(from_si(field::rod_length, *input.rod_length)));
    }
    // Beyond these no cylinder exists, and pressures and powers of volumes leave double's range.
    constexpr Range displacement_range = Range::between(1e-12, 1e3);
    const double displacement =
        pi / 4.0 * source.cylinder.bore * source.cylinder.bore * crank.stroke();
    if (!displacement_range.contains(displacement)) {
        throw InputError(pointer(field::bore, parent.c_str()),
                         "must make a displacement from 1e-6 cm³ to 1e9 cm³",
                         format_number(displacement * 1e6, 6) + " cm³");
    }
    if (traced) {
        check_pressure_trace(source.trace, parent + "/csv");
        return;
    }
    const GasCycle& cycle = source.cycle;
    check_inner(field::compression_ratio, cycle.compression_ratio);
    check_inner(field::intake_pressure, cycle.intake_pressure);
    check_inner(field::exhaust_pressure, cycle.exhaust_pressure);
    check_inner(field::polytropic_compression, cycle.polytropic_compression);
    check_inner(field::polytropic_expansion, cycle.polytropic_expansion);
    check_inner(field::heat, cycle.heat);
    check_inner(field::imep, cycle.imep);
    if (cycle.heat.has_value() == cycle.imep.has_value()) {
        throw InputError(parent, "must hold either heat_J or indicated_mean_effective_pressure_bar",
                         cycle.heat ? "both" : "neither");
    }
    check_inner(field::combustion_start, cycle.combustion_start);
    check_inner(field::combustion_duration, cycle.combustion_duration);
    check_inner(field::wiebe_m, cycle.wiebe_m);
    const double end = cycle.combustion_start + cycle.combustion_duration;
    const double bottom = two_pi + crank.bottom_dead_centre() - crank.top_dead_centre();
    if (end > bottom) {
        throw InputError(pointer(field::combustion_duration, parent.c_str()),
                         "must end the combustion before the bottom dead centre at " +
                             format_number(bottom / degree, 6) + "°",
                         format_number(end / degree, 6) + "°");
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
    input.crank_share = reader.si(field::crank_share, input.crank_share);
    if (reader.has("gears")) {
        input.gears = read_gears(reader.object("gears"));
    }
    if (reader.has("envelope")) {
        input.envelope = read_envelope(reader.object("envelope"));
    }
    if (reader.has("speed_band")) {
        ObjectReader inner = reader.object("speed_band");
        SpeedBand band;
        band.from = inner.si(field::band_from);
        band.to = inner.si(field::band_to);
        band.speeds = inner.integer("speeds", 2, field::most_speeds, band.speeds);
        band.map = inner.boolean("map", band.map);
        inner.finish();
        input.speed_band = band;
    }
    if (reader.has("relieved_shaft")) {
        input.relieved_shaft = read_relieved_shaft(reader.object("relieved_shaft"));
    }
    read_torque(reader.object("torque"), context, input);
    if (input.torque.is_computed() && reader.has(field::rod_length.key)) {
        throw InputError(reader.pointer_to(field::rod_length.key),
                         "must be left out where the torque's own object gives it");
    }
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
    json["torque"] = write_torque(input);
    json["interpolation"] =
        input.interpolation == Interpolation::linear ? "linear" : "periodic-cubic";
    json[std::string(field::step.key)] = input.step_deg;
    if (!input.torque.is_computed()) {
        put(json, field::rod_length, input.rod_length);
    }
    put(json, field::rod_mass, input.rod_mass);
    const Input standard;
    if (input.crank_share != standard.crank_share) {
        put(json, field::crank_share, input.crank_share);
    }
    if (input.gears != standard.gears) {
        json["gears"] = {{"teeth", input.gears.teeth},
                         {"shifted_teeth", input.gears.shifted_teeth},
                         {"backlash_mm", from_si(field::backlash, input.gears.backlash)}};
    }
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
    if (input.relieved_shaft) {
        Json shaft = Json::object();
        put(shaft, field::bar_diameter, input.relieved_shaft->diameter);
        put(shaft, field::relief_depth, input.relieved_shaft->depth);
        put(shaft, field::relief_length, input.relieved_shaft->length);
        put(shaft, field::density, input.relieved_shaft->density);
        put(shaft, field::elastic_modulus, input.relieved_shaft->elastic_modulus);
        json["relieved_shaft"] = std::move(shaft);
    }
    if (input.speed_band) {
        Json band = Json::object();
        put(band, field::band_from, input.speed_band->from);
        put(band, field::band_to, input.speed_band->to);
        band["speeds"] = input.speed_band->speeds;
        band["map"] = input.speed_band->map;
        json["speed_band"] = std::move(band);
    }
    return json;
}

void check_speed_band(const SpeedBand& band) {
    const std::string parent = "/input/speed_band";
    check(field::band_from, band.from, parent.c_str());
    check(field::band_to, band.to, parent.c_str());
    if (band.to < band.from) {
        throw InputError(
            pointer(field::band_to, parent.c_str()),
            "must be at least from_rpm, " + format_number(from_si(field::band_from, band.from)),
            format_number(from_si(field::band_to, band.to)));
    }
    if (band.speeds < 2 || band.speeds > field::most_speeds) {
        throw InputError(parent + "/speeds",
                         "must be a whole number from 2 to " + std::to_string(field::most_speeds),
                         std::to_string(band.speeds));
    }
    constexpr double largest_speed = 1e6;  // rad/s; far above any engine, its square is harmless
    if (!(band.to <= largest_speed)) {
        throw InputError(pointer(field::band_to, parent.c_str()), "must be at most 1e6 rad/s",
                         format_number(band.to) + " rad/s");
    }
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
    check_torque(input);
    if (!field::step.range.contains(input.step_deg)) {
        throw InputError(pointer(field::step), field::step.range.describe(),
                         format_number(input.step_deg));
    }
    check(field::rod_length, input.rod_length);
    check(field::rod_mass, input.rod_mass);
    check(field::crank_share, input.crank_share);
    check(field::backlash, input.gears.backlash, "/input/gears");
    if (input.gears.teeth < 6 || input.gears.teeth > field::most_teeth ||
        std::abs(input.gears.shifted_teeth) >= input.gears.teeth) {
        throw InputError("/input/gears/shifted_teeth",
                         "must be less than the teeth, which must be from 6 to " +
                             std::to_string(field::most_teeth),
                         std::to_string(input.gears.shifted_teeth));
    }
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

    if (input.speed_band) {
        check_speed_band(*input.speed_band);
    }
    if (input.relieved_shaft) {
        check_relieved_shaft(*input.relieved_shaft);
    }

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
    check_together(reciprocating * input.crank_radius * input.crank_radius * speed * speed,
                   "the inertia torque", field::crank_radius);
    check_together(input.torque.cylinder.bore, "the cylinder", field::bore);
    check_together(input.torque.cylinder.offset, "the cylinder", field::offset);
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
