#include "balance-shaft/balance_shaft.h"

#include "case-file/json.h"

namespace ravnoves::balance_shaft {

namespace {

constexpr double millimetre = 1e-3;
constexpr double cubic_centimetre = 1e-6;
constexpr double percent = 100.0;

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

}  // namespace

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

}  // namespace ravnoves::balance_shaft
