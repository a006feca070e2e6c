#include "balance-shaft/scene.h"

#include "balance-shaft/crank_balance.h"
#include "balance-shaft/envelope_study.h"
#include "balance-shaft/gear_error.h"
#include "balance-shaft/speed_study.h"
#include "case-file/json.h"

namespace ravnoves::balance_shaft {

namespace {

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
    constexpr double millimetre = 1e-3;
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

RelievedShaft relieved_shaft(const Solver& solver) {
    const Input& input = solver.input();
    const double speed2 = input.angular_speed * input.angular_speed;
    return design_relieved_shaft(input.relieved_shaft.value_or(default_relieved_shaft),
                                 solver.counterweight_force() / speed2, input.angular_speed);
}

Json write_whole_result(const Solver& solver, const Result& result) {
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
    return write_whole_result(solver, solver.result());
}

}  // namespace ravnoves::balance_shaft
