#include "balance-shaft/scene.h"

#include <cmath>
#include <filesystem>

#include "balance-shaft/crank_balance.h"
#include "balance-shaft/engine_torque.h"
#include "balance-shaft/envelope_study.h"
#include "balance-shaft/gear_error.h"
#include "balance-shaft/speed_study.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/object_reader.h"
#include "case-file/text_file.h"

namespace ravnoves::balance_shaft {

namespace {

constexpr const char* masses_key = "reciprocating_masses_kg";
constexpr double millimetre = 1e-3;
constexpr double cubic_centimetre = 1e-6;
constexpr double percent = 100.0;

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

Json number_or_null(const std::optional<double>& value, double factor) {
    return value ? Json(*value * factor) : Json(nullptr);
}

Json write(const MomentMetrics& metrics) {
    return {{"mean_Nm", metrics.mean},
            {"max_Nm", metrics.max},
            {"min_Nm", metrics.min},
            {"range_Nm", metrics.range},
            {"rms_Nm", metrics.rms},
            {"max_crank_angle_deg", metrics.max_angle / degree},
            {"min_crank_angle_deg", metrics.min_angle / degree}};
}

Json write(const Optimum& optimum, const char* value_key) {
    Json json = {{"shaft_angle_deg", number_or_null(optimum.shaft_angle, 1.0 / degree)},
                 {value_key, optimum.value}};
    if (!optimum.note.empty()) {
        json["note"] = optimum.note;
    }
    return json;
}

Json write(const IndicatedCycle& indicated, double power) {
    return {{"displacement_cm3", indicated.displacement / cubic_centimetre},
            {"clearance_volume_cm3", number_or_null(indicated.clearance, 1.0 / cubic_centimetre)},
            {"heat_J", number_or_null(indicated.heat, 1.0)},
            {"work_J", indicated.work},
            {"mean_effective_pressure_bar", indicated.imep / field::bar},
            {"power_kW", power / 1000.0},
            {"mean_torque_Nm", indicated.work / (4.0 * pi)},
            {"peak_pressure_bar", indicated.peak_pressure / field::bar},
            {"peak_pressure_crank_angle_deg", indicated.peak_pressure_angle / degree}};
}

Json write(const InertiaCheck& check) {
    Json json = {{"fitted_m_r2_w2_Nm", number_or_null(check.fitted, 1.0)},
                 {"entered_m_r2_w2_Nm", check.entered},
                 {"fitted_lambda", check.fitted ? Json(check.fitted_lambda) : Json(nullptr)},
                 {"consistent", check.consistent ? Json(*check.consistent) : Json(nullptr)}};
    if (check.fitted) {
        json["residual_rms_Nm"] = check.residual_rms;
        json["matching_speed_rpm"] = check.matching_speed / rpm;
        json["matching_mass_kg"] = check.matching_mass;
    }
    json["text"] = check.text;
    return json;
}

Json write_spectrum(const Result& result) {
    Json json = {{"order", Json::array()},
                 {"M_up_amplitude_Nm", Json::array()},
                 {"M_up_phase_deg", Json::array()},
                 {"M_ups_amplitude_Nm", Json::array()},
                 {"M_ups_phase_deg", Json::array()}};
    for (const OrderLine& line : result.spectrum_M_up) {
        json["order"].push_back(line.order);
        json["M_up_amplitude_Nm"].push_back(line.amplitude);
        json["M_up_phase_deg"].push_back(line.phase / degree);
    }
    for (const OrderLine& line : result.spectrum_M_ups) {
        json["M_ups_amplitude_Nm"].push_back(line.amplitude);
        json["M_ups_phase_deg"].push_back(line.phase / degree);
    }
    return json;
}

std::vector<double> scaled(std::vector<double> values, double factor) {
    for (double& value : values) {
        value *= factor;
    }
    return values;
}

Json write_crank_balance(const CrankBalance& balance) {
    return {{"share", balance.share},
            {"first_order_N", balance.first_order},
            {"along_cylinder_N", balance.along},
            {"across_cylinder_N", balance.across},
            {"largest_N", balance.largest},
            {"counterweight_moment_kg_m", balance.counterweight_moment},
            {"with_shaft_N", balance.with_shaft},
            {"second_order_N", balance.second_order}};
}

Json write_envelope_study(const EnvelopeStudy& study) {
    Json efficient = Json::array();
    for (std::size_t i = 0; i < study.efficient.size(); ++i) {
        if (study.efficient[i]) {
            efficient.push_back({{"shaft_angle_deg", study.shaft_angle_deg[i]},
                                 {"width_mm", study.width[i] * 1e3},
                                 {"height_mm", study.height[i] * 1e3},
                                 {"range_Nm", study.range[i]}});
        }
    }
    return {{"efficient", efficient}};
}

Json write_gear_error(const GearError& error) {
    return {{"phase_error_deg", error.phase_error / degree},
            {"residual_force_N", error.residual_force},
            {"range_Nm", error.range},
            {"rms_Nm", error.rms},
            {"play_deg", error.play / degree},
            {"play_force_N", error.play_force},
            {"play_range_low_Nm", error.play_range_low},
            {"play_range_high_Nm", error.play_range_high}};
}

Json write_relieved_shaft(const RelievedShaft& shaft) {
    Json json = {{"feasible", shaft.feasible}};
    if (!shaft.feasible) {
        json["reason"] = shaft.reason;
    }
    const auto put = [&](const char* key, double value, double unit) {
        if (shaft.feasible || value > 0.0) {
            json[key] = value / unit;
        }
    };
    constexpr double gram_millimetre = 1e-6;  // kg·m
    put("required_unbalance_g_mm", shaft.required, gram_millimetre);
    put("unbalance_g_mm", shaft.unbalance, gram_millimetre);
    put("diameter_mm", shaft.diameter, millimetre);
    put("depth_mm", shaft.depth, millimetre);
    put("length_mm", shaft.length, millimetre);
    put("flat_width_mm", 2.0 * shaft.half_width, millimetre);
    put("removed_mass_kg", shaft.removed_mass, 1.0);
    put("relieved_part_mass_kg", shaft.mass, 1.0);
    put("centre_of_mass_radius_mm", shaft.centre_of_mass_radius, millimetre);
    put("critical_radius_mm", shaft.critical_radius, millimetre);
    put("critical_length_mm", shaft.critical_length, millimetre);
    put("sag_mm", shaft.sag, millimetre);
    put("bending_stress_MPa", shaft.bending_stress, 1e6);
    if (!shaft.note.empty()) {
        json["note"] = shaft.note;
    }
    return json;
}

}  // namespace

Input read_input(const Json& json, const CaseContext& context) {
    ObjectReader reader(json, "/input");
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

Json write_result(const Result& result) {
    Json notes = Json::array();
    for (const Note& note : result.notes) {
        notes.push_back(note.text);
    }
    Json json = {
        {"angular_speed_rad_s", result.angular_speed},
        {"reciprocating_mass_kg", result.reciprocating_mass},
        {"inertia_force_1_max_N", result.inertia_force_1_max},
        {"counterweight_mass_kg", result.counterweight_mass},
        {"counterweight_force_N", result.counterweight_force},
        {"moment_amplitude_Nm", result.moment_amplitude},
        {"shaft_angle_deg", result.shaft_angle / degree},
        {"metrics",
         {{"M_up", write(result.M_up)},
          {"M_s", write(result.M_s)},
          {"M_ups", write(result.M_ups)}}},
        {"change_without_shaft",
         {{"range_percent", number_or_null(result.range_change, percent)},
          {"rms_percent", number_or_null(result.rms_change, percent)}}},
        {"printed_mean",
         {{"M_s_25_nodes_Nm", result.printed_mean_M_s},
          {"M_up_nodes_Nm", result.printed_mean_M_up},
          {"M_ups_nodes_Nm", result.printed_mean_M_ups}}},
        {"optimum",
         {{"range", write(result.best_range, "range_Nm")},
          {"rms", write(result.best_rms, "rms_Nm")}}},
        {"order_1",
         {{"amplitude_Nm", result.order_1_amplitude},
          {"phase_deg", result.order_1_phase / degree},
          {"share_of_variance", number_or_null(result.order_1_share, 1.0)}}},
        {"envelope",
         {{"width_mm", result.envelope.width() / millimetre},
          {"height_mm", result.envelope.height() / millimetre}}},
        {"notes", notes},
    };
    json["inertia_check"] = write(result.inertia_check);
    json["spectrum"] = write_spectrum(result);
    if (result.indicated) {
        json["indicated"] = write(*result.indicated, result.indicated_power);
    }
    Json curves = {{"crank_angle_deg", result.curves.crank_angle_deg},
                   {"M_up_Nm", result.curves.M_up},
                   {"M_s_Nm", result.curves.M_s},
                   {"M_ups_Nm", result.curves.M_ups}};
    if (result.indicated) {
        curves["M_gas_Nm"] = result.curves.M_gas;
        curves["M_inertia_Nm"] = result.curves.M_inertia;
        curves["pressure_bar"] = scaled(result.curves.pressure, 1.0 / field::bar);
        curves["volume_cm3"] = scaled(result.curves.volume, 1.0 / cubic_centimetre);
    }
    json["curves"] = std::move(curves);
    json["sweep"] = {{"shaft_angle_deg", result.sweep.shaft_angle_deg},
                     {"range_Nm", result.sweep.range},
                     {"rms_Nm", result.sweep.rms},
                     {"mean_M_s_Nm", result.sweep.mean_M_s},
                     {"mean_M_ups_Nm", result.sweep.mean_M_ups},
                     {"printed_mean_M_s_25_nodes_Nm", result.sweep.printed_mean_M_s},
                     {"printed_mean_M_ups_nodes_Nm", result.sweep.printed_mean_M_ups}};
    return json;
}

Json write_result(const Solver& solver, const Result& result) {
    Json json = write_result(result);
    json["crank_only"] = write_crank_balance(crank_balance(solver));
    json["envelope_study"] = write_envelope_study(envelope_study(solver));
    json["gear_error"] = write_gear_error(gear_error(solver, result.shaft_angle));
    if (solver.input().relieved_shaft) {
        json["relieved_shaft"] = write_relieved_shaft(relieved_shaft(solver));
    }
    if (const auto& band = solver.input().speed_band) {
        const SpeedStudy study(solver.input(), *band);
        constexpr std::size_t map_angles = 360;
        json["speed_band"] =
            write_speed_study(study, band->map ? study.map(map_angles) : std::nullopt);
    }
    return json;
}

Json solve_scene(const Json& input, const CaseContext& context) {
    const Solver solver(read_input(input, context));
    return write_result(solver, solver.result());
}

}  // namespace ravnoves::balance_shaft
