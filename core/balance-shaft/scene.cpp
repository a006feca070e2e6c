#include "balance-shaft/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

#include "balance-shaft/crank_balance.h"
#include "balance-shaft/engine_torque.h"
#include "balance-shaft/envelope_study.h"
#include "balance-shaft/fields.h"
#include "balance-shaft/gear_error.h"
#include "balance-shaft/moments.h"
#include "balance-shaft/position_study.h"
#include "balance-shaft/speed_study.h"
#include "case-file/field_reader.h"
#include "case-file/field_writer.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/object_reader.h"
#include "case-file/sha256.h"
#include "case-file/text_file.h"

namespace ravnoves::balance_shaft {

namespace {

/// Reads and parses a file that the case names, and takes its sum; a case without one is made with
/// the file as it is now.
template <typename Parse>
auto read_beside(const std::string& name, const std::string& place, const CaseContext& context,
                 FileSum& sum, Parse parse) {
    if (name.find('\0') != std::string::npos || name.empty()) {
        throw InputError(place, CORE_TEXT("core", "must be a file name"), show(Json(name)));
    }
    if (!context.may_read(name)) {
        throw InputError(place,
                         CORE_TEXT("core",
                                   "must be a file in the folder of the case, unless "
                                   "--allow-files is given"),
                         show(Json(name)));
    }
    try {
        const std::string text = read_text_file(context.directory / name);
        sum.now = sha256(text);
        if (sum.then.empty()) {
            sum.then = sum.now;
        }
        return parse(text);
    } catch (const InputError& error) {
        throw InputError::in_file(place, printable(name), error);
    }
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
        json["note"] = optimum.note.english();
    }
    return json;
}

Json write_optima(const Optimum& range, const Optimum& rms) {
    return {{"range", write(range, "range_Nm")}, {"rms", write(rms, "rms_Nm")}};
}

/// Of what can be built; null, with the reason, where nothing can.
Json write_buildable_optima(const Result& result) {
    if (result.buildable.stretches.empty()) {
        return {
            {"range", nullptr}, {"rms", nullptr}, {"reason", result.buildable.reason.english()}};
    }
    return write_optima(result.best_range_buildable, result.best_rms_buildable);
}

Json write_buildable(const Result& result) {
    Json stretches = Json::array();
    for (const AngleStretch& stretch : result.buildable.stretches) {
        stretches.push_back({stretch.from / degree, stretch.to / degree});
    }
    Json json = {{"shaft_angles_deg", stretches}, {"at_shaft_angle", result.is_buildable}};
    if (!result.buildable.reason.empty()) {
        json["reason"] = result.buildable.reason.english();
    }
    return json;
}

/// Free space at the shaft's angle and the sizes that it comes from.
Json write_clearances(const FrontView& view, double shaft_angle) {
    const ShaftClearance free = shaft_clearance(view, shaft_angle);
    return {{"crank_mm", free.crank / units::mm},
            {"cylinder_mm", free.cylinder / units::mm},
            {"rod_mm", free.rod / units::mm},
            {"least_allowed_mm", view.clearance / units::mm},
            {"shaft_swing_radius_mm", view.shaft_swing_radius / units::mm},
            {"crank_swing_radius_mm", view.crank_swing_radius / units::mm},
            {"rod_width_mm", view.rod_width / units::mm},
            {"cylinder_bore_mm", view.cylinder_bore / units::mm},
            {"cylinder_wall_mm", view.cylinder_wall / units::mm},
            {"cylinder_bottom_mm", view.cylinder_bottom / units::mm},
            {"cylinder_top_mm", view.cylinder_top / units::mm},
            {"gear_tip_radius_mm", view.gear_tip_radius / units::mm}};
}

Json write(const IndicatedCycle& indicated, double power, double angular_speed) {
    return {{"displacement_cm3", indicated.displacement / units::cm3},
            {"clearance_volume_cm3", number_or_null(indicated.clearance, 1.0 / units::cm3.to_si)},
            {"heat_J", number_or_null(indicated.heat, 1.0)},
            {"work_J", indicated.work},
            {"mean_effective_pressure_bar", indicated.imep / units::bar},
            {"power_kW", power / units::kW},
            {"mean_torque_Nm", power / angular_speed},
            {"peak_pressure_bar", indicated.peak_pressure / units::bar},
            {"peak_pressure_crank_angle_deg", indicated.peak_pressure_angle / degree}};
}

Json write(const InertiaCheck& check) {
    Json json = {{"fitted_m_r2_w2_Nm", number_or_null(check.fitted, 1.0)},
                 {"entered_m_r2_w2_Nm", check.entered},
                 {"fitted_lambda", check.fitted ? Json(check.fitted_lambda) : Json(nullptr)},
                 {"consistent", check.consistent ? Json(*check.consistent) : Json(nullptr)}};
    if (check.fitted) {
        json["residual_rms_Nm"] = check.residual_rms;
        json["matching_speed_rpm"] = check.matching_speed / units::rpm;
        json["matching_mass_kg"] = check.matching_mass;
        json["lambda_is_given"] = !check.lambda_fitted;
    }
    if (!check.consistent) {
        json["reason"] = check.text.english();
    }
    json["text"] = check.text.english();
    return json;
}

Json write(const Flywheel& flywheel) {
    return {{"excess_work_J", flywheel.excess_work},
            {"fluctuation", number_or_null(flywheel.fluctuation, 1.0)},
            {"inertia_kg_m2", number_or_null(flywheel.inertia, 1.0)},
            {"max_energy_J", flywheel.max_energy},
            {"max_crank_angle_deg", flywheel.max_angle / degree},
            {"min_energy_J", flywheel.min_energy},
            {"min_crank_angle_deg", flywheel.min_angle / degree}};
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
                                 {"width_mm", study.width[i] / units::mm},
                                 {"height_mm", study.height[i] / units::mm},
                                 {"range_Nm", study.range[i]}});
        }
    }
    return {{"efficient", efficient}};
}

Json write(const std::optional<BestPosition>& best) {
    if (!best) {
        return nullptr;
    }
    return {{"centre_distance_mm", best->position.centre_distance() / units::mm},
            {"shaft_angle_deg", best->position.shaft_angle() / degree},
            {"range_Nm", best->criteria.range},
            {"rms_Nm", best->criteria.rms},
            {"gap_Nm", best->gap}};
}

Json write(const BestPositions& best) {
    Json json = {{"range", write(best.range)}, {"rms", write(best.rms)}};
    if (!best.reason.empty()) {
        json["reason"] = best.reason.english();
    }
    return json;
}

Json write_front(const std::vector<FrontPosition>& front) {
    Json json = Json::array();
    for (const FrontPosition& one : front) {
        json.push_back({{"centre_distance_mm", one.position.centre_distance() / units::mm},
                        {"shaft_angle_deg", one.position.shaft_angle() / degree},
                        {"range_Nm", one.criteria.range},
                        {"rms_Nm", one.criteria.rms},
                        {"size_m2", one.criteria.size}});
    }
    return json;
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
        json["reason"] = shaft.reason.english();
    }
    const auto put = [&](const char* key, double value, const Unit& unit) {
        if (shaft.feasible || value > 0.0) {
            json[key] = value / unit;
        }
    };
    put("required_unbalance_g_mm", shaft.required, units::gram_mm);
    put("unbalance_g_mm", shaft.unbalance, units::gram_mm);
    put("diameter_mm", shaft.diameter, units::mm);
    put("depth_mm", shaft.depth, units::mm);
    put("length_mm", shaft.length, units::mm);
    put("flat_width_mm", 2.0 * shaft.half_width, units::mm);
    put("removed_mass_kg", shaft.removed_mass, units::kg);
    put("relieved_part_mass_kg", shaft.mass, units::kg);
    put("centre_of_mass_radius_mm", shaft.centre_of_mass_radius, units::mm);
    put("critical_radius_mm", shaft.critical_radius, units::mm);
    put("critical_length_mm", shaft.critical_length, units::mm);
    if (!shaft.note.empty()) {
        json["note"] = shaft.note.english();
    }
    return json;
}

}  // namespace

Input read_input(const Json& json, const CaseContext& context) {
    Input input = read_fields<Input>(json);
    TorqueSource& source = input.torque;
    if (source.kind == TorqueSource::Kind::csv) {
        source.table =
            read_beside(source.csv, "/input/torque/csv", context, source.csv_sum,
                        [](const std::string& text) { return parse_torque_table(text).table; });
    } else if (source.kind == TorqueSource::Kind::pressure) {
        source.trace =
            read_beside(source.trace_csv, "/input/torque/pressure/csv", context, source.trace_sum,
                        [](const std::string& text) { return parse_pressure_trace(text).trace; });
    }
    check_input(input);
    return input;
}

Json write_input(const Input& input) {
    return write_fields(input);
}

Json write_kept(const Input& input) {
    using Kind = TorqueSource::Kind;
    const TorqueSource& source = input.torque;
    Json torque = Json::object();
    const auto keep = [&](Kind kind) {
        Input other = input;
        other.torque.kind = kind;
        other.rod_length = input.effective_rod_length();
        torque.update(write_input(other).at("torque"));
    };
    if (source.is_computed() && !source.csv.empty()) {
        keep(Kind::csv);
    } else if (source.is_computed() && source.table.size() > 0) {
        keep(Kind::table);
    }
    if (source.kind != Kind::pressure && !source.trace_csv.empty()) {
        keep(Kind::pressure);
    }
    if (source.kind != Kind::cycle && (source.cycle.heat || source.cycle.imep)) {
        keep(Kind::cycle);
    }
    return torque.empty() ? Json() : Json{{"torque", torque}};
}

namespace {

/// One kept source, read as if it were in use; files are not read.
TorqueSource read_kept_source(const Input& input, const Json& torque) {
    Json json = write_input(input);
    json.erase("rod_length_mm");
    json.erase("offset_mm");
    json["torque"] = torque;
    try {
        TorqueSource source = read_fields<Input>(json).torque;
        if (source.kind == TorqueSource::Kind::table) {
            check_torque_table(source.table, "/input/torque/torque_Nm");
        }
        return source;
    } catch (const InputError& error) {
        std::string place = error.where();
        const std::string root = "/input";
        if (place.starts_with(root)) {
            place.replace(0, root.size(), "/kept");
        }
        throw InputError(place, error.allowed_message(), error.found_message());
    }
}

}  // namespace

void read_kept(const Json& kept, const CaseContext& context, Input& input) {
    using Kind = TorqueSource::Kind;
    if (kept.is_null()) {
        return;
    }
    ObjectReader reader(kept, "/kept");
    if (!reader.has("torque")) {
        reader.finish();
        return;
    }
    const auto keys = reader.object("torque").keys();
    reader.finish();
    TorqueSource& source = input.torque;
    const auto take = [&](const Json& torque) {
        const TorqueSource other = read_kept_source(input, torque);
        if (other.is_computed() && !source.is_computed()) {
            source.cylinder.bore = other.cylinder.bore;
            source.cylinder.crankcase_pressure = other.cylinder.crankcase_pressure;
        }
        // A file that is not there may come back; until then its numbers are missing.
        try {
            if (other.kind == Kind::csv) {
                source.csv = other.csv;
                source.csv_sum = other.csv_sum;
                source.table = read_beside(
                    other.csv, "/kept/torque/csv", context, source.csv_sum,
                    [](const std::string& text) { return parse_torque_table(text).table; });
            } else if (other.kind == Kind::pressure) {
                source.trace_csv = other.trace_csv;
                source.trace_sum = other.trace_sum;
                source.trace_shift = other.trace_shift;
                source.trace = read_beside(
                    other.trace_csv, "/kept/torque/pressure/csv", context, source.trace_sum,
                    [](const std::string& text) { return parse_pressure_trace(text).trace; });
            } else if (other.kind == Kind::table) {
                source.table = other.table;
            } else {
                source.cycle = other.cycle;
            }
        } catch (const InputError&) {
            // It is named still.
        }
    };
    Json table = Json::object();
    for (const std::string& key : keys) {
        const Json& value = kept.at("torque").at(key);
        if (key == field::csv_sum.key) {
            continue;  // goes with its file
        }
        if (key == field::csv.key && kept.at("torque").contains(field::csv_sum.key)) {
            take({{key, value}, {field::csv_sum.key, kept.at("torque").at(field::csv_sum.key)}});
        } else if (key == field::pressure.key || key == field::cycle.key || key == field::csv.key) {
            take({{key, value}});
        } else {
            table[key] = value;
        }
    }
    if (!table.empty()) {
        take(table);
    }
}

namespace {

/// An object that takes what is wanted of it, in the order in which it is offered.
class WantedObject {
  public:
    WantedObject(std::string pointer, const Wanted& wanted)
        : pointer_(std::move(pointer)), wanted_(wanted) {}

    bool wants(const char* key) const { return wanted_.wants(pointer_ + "/" + key); }
    template <typename Compute>
    void put(const char* key, const Compute& compute) {
        if (wants(key)) {
            json_[key] = compute();
        }
    }
    void number(const char* key, double value) {
        put(key, [&] { return Json(value); });
    }
    Json take() { return std::move(json_); }

  private:
    std::string pointer_;
    const Wanted& wanted_;
    Json json_ = object_with_room(64);
};

/// What Moments::fill() fills in, where it is wanted.
void put_moments(const Result& result, const Wanted& wanted, WantedObject& object) {
    object.number("angular_speed_rad_s", result.angular_speed);
    object.number("reciprocating_mass_kg", result.reciprocating_mass);
    object.number("inertia_force_1_max_N", result.inertia_force_1_max);
    object.number("counterweight_mass_kg", result.counterweight_mass);
    object.number("counterweight_force_N", result.counterweight_force);
    object.number("moment_amplitude_Nm", result.moment_amplitude);
    object.number("shaft_angle_deg", result.shaft_angle / degree);
    object.put("metrics", [&] {
        WantedObject metrics("/metrics", wanted);
        metrics.put("M_up", [&] { return write(result.M_up); });
        metrics.put("M_s", [&] { return write(result.M_s); });
        metrics.put("M_ups", [&] { return write(result.M_ups); });
        return metrics.take();
    });
    object.put("change_without_shaft", [&] {
        return Json{{"range_percent", number_or_null(result.range_change, 100.0)},
                    {"rms_percent", number_or_null(result.rms_change, 100.0)}};
    });
}

/// True where Moments::fill() gives all that is wanted and written by write_moments().
bool needs_moments_alone(const Wanted& wanted) {
    constexpr std::array others{"/printed_mean",
                                "/optimum_buildable",
                                "/buildable",
                                "/order_1",
                                "/dead_centre_deg",
                                "/counterweight_lag_deg",
                                "/envelope",
                                "/notes",
                                "/inertia_check",
                                "/spectrum",
                                "/flywheel",
                                "/indicated",
                                "/curves",
                                "/sweep",
                                "/clearances",
                                "/crank_only",
                                "/envelope_study",
                                "/best_position",
                                "/best_position_buildable",
                                "/gear_error",
                                "/relieved_shaft",
                                "/speed_band"};
    return std::none_of(others.begin(), others.end(),
                        [&](const char* pointer) { return wanted.wants(pointer); });
}

Json write_moments(const Input& input, const Wanted& wanted) {
    Result result;
    Moments(input).fill(input, wanted.wants("/optimum"), result);
    WantedObject object("", wanted);
    put_moments(result, wanted, object);
    object.put("optimum", [&] { return write_optima(result.best_range, result.best_rms); });
    return object.take();
}

Json write_wanted(const Result& result, const Wanted& wanted) {
    WantedObject object("", wanted);
    put_moments(result, wanted, object);
    object.put("printed_mean", [&] {
        return Json{{"M_s_25_nodes_Nm", result.printed_mean_M_s},
                    {"M_up_nodes_Nm", result.printed_mean_M_up},
                    {"M_ups_nodes_Nm", result.printed_mean_M_ups}};
    });
    object.put("optimum", [&] { return write_optima(result.best_range, result.best_rms); });
    object.put("optimum_buildable", [&] { return write_buildable_optima(result); });
    object.put("buildable", [&] { return write_buildable(result); });
    object.put("order_1", [&] {
        return Json{{"amplitude_Nm", result.order_1_amplitude},
                    {"phase_deg", result.order_1_phase / degree},
                    {"share_of_variance", number_or_null(result.order_1_share, 1.0)}};
    });
    object.number("dead_centre_deg", result.dead_centre / degree);
    object.number("counterweight_lag_deg", result.counterweight_lag / degree);
    object.put("envelope", [&] {
        return Json{{"width_mm", result.envelope.width() / units::mm},
                    {"height_mm", result.envelope.height() / units::mm}};
    });
    object.put("notes", [&] {
        std::vector<std::string> notes = english(result.doubts);
        for (const Message& note : result.notes) {
            notes.push_back(note.english());
        }
        if (!result.assumed_sizes.empty()) {
            notes.push_back(result.assumed_sizes.english());
        }
        return Json(notes);
    });
    object.put("inertia_check", [&] { return write(result.inertia_check); });
    object.put("spectrum", [&] { return write_spectrum(result); });
    object.put("flywheel", [&] { return write(result.flywheel); });
    if (result.indicated) {
        object.put("indicated", [&] {
            return write(*result.indicated, result.indicated_power, result.angular_speed);
        });
    }
    object.put("curves", [&] {
        Json curves = object_with_room(10);
        curves["crank_angle_deg"] = result.curves.crank_angle_deg;
        curves["M_up_Nm"] = result.curves.M_up;
        curves["M_s_Nm"] = result.curves.M_s;
        curves["M_ups_Nm"] = result.curves.M_ups;
        curves["excess_energy_J"] = result.flywheel.energy;
        if (result.indicated) {
            curves["M_gas_Nm"] = result.curves.M_gas;
            curves["M_inertia_Nm"] = result.curves.M_inertia;
            curves["M_offset_Nm"] = result.curves.M_offset;
            curves["pressure_bar"] = scaled(result.curves.pressure, 1.0 / units::bar.to_si);
            curves["volume_cm3"] = scaled(result.curves.volume, 1.0 / units::cm3.to_si);
        }
        return curves;
    });
    object.put("sweep", [&] {
        return object_of({{"shaft_angle_deg", result.sweep.shaft_angle_deg},
                          {"range_Nm", result.sweep.range},
                          {"rms_Nm", result.sweep.rms},
                          {"mean_M_s_Nm", result.sweep.mean_M_s},
                          {"mean_M_ups_Nm", result.sweep.mean_M_ups},
                          {"printed_mean_M_s_25_nodes_Nm", result.sweep.printed_mean_M_s},
                          {"printed_mean_M_ups_nodes_Nm", result.sweep.printed_mean_M_ups}});
    });
    return object.take();
}

}  // namespace

Json write_result(const Result& result) {
    return write_wanted(result, {});
}

Json write_result(const Solver& solver, const Result& result, const Wanted& wanted) {
    Json json = write_wanted(result, wanted);
    const auto put = [&](const char* key, auto&& compute) {
        if (wanted.wants(std::string("/") + key)) {
            json[key] = compute();
        }
    };
    put("clearances", [&] { return write_clearances(solver.front_view(), result.shaft_angle); });
    put("crank_only", [&] { return write_crank_balance(crank_balance(solver)); });
    put("envelope_study", [&] { return write_envelope_study(envelope_study(solver)); });
    if (wanted.wants("/best_position") || wanted.wants("/best_position_buildable")) {
        const PositionStudy positions(solver);
        put("best_position", [&] { return write(positions.best()); });
        put("best_position_buildable", [&] {
            const BestPositions buildable = positions.best_buildable();
            Json found = write(buildable);
            if (wanted.wants("/best_position_buildable/front")) {
                found["front"] = write_front(positions.front(buildable));
                found["front_gap"] = PositionStudy::front_gap;
            }
            return found;
        });
    }
    put("gear_error", [&] { return write_gear_error(gear_error(solver, result.shaft_angle)); });
    if (solver.input().relieved_shaft) {
        put("relieved_shaft", [&] { return write_relieved_shaft(relieved_shaft(solver)); });
    }
    if (const auto& band = solver.input().speed_band) {
        put("speed_band", [&] {
            const SpeedStudy study(solver.input(), *band);
            constexpr std::size_t map_angles = 360;
            const bool map = band->map && wanted.wants("/speed_band/map");
            return write_speed_study(study, map ? study.map(map_angles) : std::nullopt);
        });
    }
    return json;
}

Json solve_scene(const Json& input, const CaseContext& context, const Wanted& wanted) {
    const Input checked = read_input(input, context);
    if (needs_moments_alone(wanted)) {
        return write_moments(checked, wanted);
    }
    const Solver solver(checked);
    return write_result(solver, solver.result(), wanted);
}

}  // namespace ravnoves::balance_shaft
