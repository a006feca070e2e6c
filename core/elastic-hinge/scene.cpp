#include "elastic-hinge/scene.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "case-file/field_reader.h"
#include "case-file/field_writer.h"
#include "case-file/json.h"
#include "elastic-hinge/solver.h"

namespace ravnoves::elastic_hinge {

namespace {

Json scaled(const std::vector<double>& values, const Unit& unit) {
    if (values.empty()) {
        return nullptr;
    }
    Json::array_t list;
    list.reserve(values.size());
    for (const double value : values) {
        if (std::isfinite(value)) {
            const double shown = value / unit;
            list.emplace_back(shown == 0.0 ? 0.0 : shown);  // no minus before zero
        } else {
            list.emplace_back(nullptr);
        }
    }
    return list;
}

Json optional(const std::optional<double>& value, const Unit& unit) {
    return value && std::isfinite(*value) ? Json(*value / unit) : Json(nullptr);
}

const char* name_of(Branch branch) {
    return branch == Branch::compressed ? "compressed" : "stretched";
}

Json write_branch(const BranchSummary& branch) {
    if (!branch.exists) {
        return nullptr;
    }
    return {{"min_radius_mm", branch.min_radius / units::mm},
            {"max_radius_mm", branch.max_radius / units::mm},
            {"smallest_curvature_radius_mm", branch.smallest_curvature_radius / units::mm},
            {"largest_roller_radius_mm", optional(branch.largest_roller_radius, units::mm)},
            {"undercut", branch.undercut},
            {"profile_min_radius_mm", branch.profile_min_radius / units::mm},
            {"profile_max_radius_mm", branch.profile_max_radius / units::mm},
            {"max_pressure_angle_deg", branch.max_pressure_angle / degree}};
}

Json write_guide(const Guide& guide) {
    const bool known = guide.shape != nullptr;
    const auto when = [](bool there, double value) { return there ? Json(value) : Json(nullptr); };
    const bool made = guide.feasible;
    Json object{{"feasible", guide.feasible},
                {"reason", guide.reason.english()},
                {"preload_mm", when(known, guide.preload / units::mm)},
                {"minimum_preload_mm", when(known, guide.minimum_preload / units::mm)},
                {"minimum_stiffness_N_m",
                 known ? optional(guide.minimum_stiffness, units::N_per_m) : Json(nullptr)}};
    const bool missing = guide.problem == GuideProblem::preload_too_small;
    object["first_missing_crank_angle_deg"] = when(missing, guide.first_missing_angle / degree);
    object["worst_crank_angle_deg"] = when(known, guide.worst_angle / degree);
    object["branch"] = known ? Json(name_of(guide.branch)) : Json(nullptr);
    object["relief_mm"] = when(made, guide.relief / units::mm);
    object["spring_travel_mm"] = when(made, guide.spring_travel / units::mm);
    object["largest_spring_force_N"] = when(made, guide.largest_spring_force);
    object["smallest_spring_force_N"] = when(made, guide.smallest_spring_force);
    object["largest_moment_Nm"] = when(known, guide.largest_moment);
    object["compressed"] = write_branch(guide.compressed);
    object["stretched"] = write_branch(guide.stretched);
    object["profile_error"] =
        made ? Json{{"amplitude_um", guide.error.amplitude / units::micrometre},
                    {"waves", guide.error.waves},
                    {"torque_Nm", guide.error.torque},
                    {"relative_torque", guide.error.relative},
                    {"energy_J", guide.error.energy}}
             : Json(nullptr);
    return object;
}

Json write_rod_guide(const Guide& guide) {
    Json object = write_guide(guide);
    object["hinge_angle_deg"] = scaled(guide.polar_angle, units::degree);
    object["guide_radius_compressed_mm"] = scaled(guide.radius_compressed, units::mm);
    object["guide_radius_stretched_mm"] = scaled(guide.radius_stretched, units::mm);
    return object;
}

Json write_proposal(const GuideProposal& proposal) {
    if (!proposal.found) {
        return {{"feasible", false}, {"reason", proposal.reason.english()}};
    }
    return {{"feasible", true},
            {"reason", ""},
            {"branch", name_of(proposal.branch)},
            {"spring", write_fields(proposal.spring)},
            {"relief_mm", proposal.relief / units::mm},
            {"outer_diameter_mm", proposal.outer_diameter / units::mm},
            {"smallest_spring_length_mm", proposal.smallest_spring_length / units::mm},
            {"largest_spring_force_N", proposal.largest_spring_force},
            {"largest_spring_energy_J", proposal.largest_spring_energy}};
}

const char* name_of(MotionEnd end) {
    switch (end) {
        case MotionEnd::completed:
            return "completed";
        case MotionEnd::reversed:
            return "reversed";
        case MotionEnd::too_slow:
            return "too-slow";
        case MotionEnd::cancelled:
            break;
    }
    return "cancelled";
}

Json write_motion(const Motion& motion) {
    return {{"feasible", true},
            {"end", name_of(motion.end)},
            {"reason", motion.reason.english()},
            {"time_s", motion.time.back()},
            {"crank_angle_deg", motion.crank_angle.back() / degree},
            {"speed_rad_s", motion.speed.back()},
            {"mean_speed_rad_s", motion.mean_speed},
            {"min_speed_rad_s", motion.min_speed},
            {"max_speed_rad_s", motion.max_speed},
            {"speed_ripple", motion.ripple},
            {"energy_drift", motion.energy_drift},
            {"steps", motion.steps}};
}

}  // namespace

Input read_input(const Json& json) {
    const Input input = read_fields<Input>(json);
    check_input(input);
    return input;
}

Json write_input(const Input& input) {
    return write_fields(input);
}

Json write_motions(const Input& input, const Result& result) {
    Json object;
    const std::pair<const char*, HingeSet> sets[] = {{"without_hinge", HingeSet::none},
                                                     {"with_crank_hinge", HingeSet::crank},
                                                     {"with_both_hinges", HingeSet::crank_and_rod}};
    const Message locked(CORE_TEXT("elastic-hinge", "at lambda = 1 the mechanism locks"));
    for (const auto& [name, hinges] : sets) {
        const Guide& guide =
            hinges == HingeSet::crank_and_rod ? result.crank_guide_with_rod : result.crank_guide;
        if (!result.design->has_exact_kinematics()) {
            object[name] = {{"feasible", false}, {"reason", locked.english()}};
        } else if (hinges != HingeSet::none && !guide.feasible) {
            object[name] = {{"feasible", false}, {"reason", guide.reason.english()}};
        } else {
            object[name] = write_motion(simulate(input, result, hinges));
        }
    }
    return object;
}

namespace {

Json write_wanted(const Input& input, const Result& result, const Wanted& wanted) {
    const double g = result.design->mechanism().gravity;
    Json json = object_with_room(16);
    json["rod_hinge_moment_integral_J"] = result.rod_hinge_integral;
    if (result.has_counterweight) {
        json["counterweight_weight_N"] = result.counterweight_mass * g;
        json["counterweight_mass_kg"] = result.counterweight_mass;
        json["balancing_weight_N"] = result.balancing_mass * g;
    }
    json["guide"] = write_guide(result.crank_guide);
    json["guide_beside_rod_hinge"] = write_guide(result.crank_guide_with_rod);
    if (wanted.wants("/rod_hinge_guide")) {
        json["rod_hinge_guide"] = write_rod_guide(result.rod_guide);
    }
    if (result.proposal) {
        json["guide_search"] = write_proposal(*result.proposal);
    } else if (input.guide_search) {
        const Message no_spring(
            CORE_TEXT("elastic-hinge", "no spring is given: its free length is needed"));
        json["guide_search"] = {{"feasible", false}, {"reason", no_spring.english()}};
    }
    const double with = result.largest_side_force_with;
    const double without = result.largest_side_force_without;
    json["side_force"] = {
        {"largest_without_hinge_N", without},
        {"largest_with_hinge_N", with},
        {"largest_by_newton_euler_N",
         result.side_force_true.empty() ? Json(nullptr) : Json(result.largest_side_force_true)},
        {"reduction_factor",
         with > 0.0 && std::isfinite(without / with) ? Json(without / with) : Json(nullptr)}};
    json["series"] = {
        {"largest_cos_psi_error", result.series_error},
        {"at_crank_angle_deg", result.series_error_angle / degree},
        {"largest_rod_hinge_moment_error_Nm", optional(result.series_moment_error, units::N_m)}};
    if (input.motion && wanted.wants("/motion")) {
        json["motion"] = write_motions(input, result);
    }
    std::vector<Message> notes = result.doubts;
    notes.insert(notes.end(), result.notes.begin(), result.notes.end());
    notes.insert(notes.end(), result.guide_notes.begin(), result.guide_notes.end());
    json["notes"] = english(notes);
    if (!wanted.wants("/curves")) {
        return json;
    }
    const MechanismCurves& curves = result.curves;
    json["curves"] = object_of(
        {{"crank_angle_deg", result.crank_angle_deg},
         {"reduced_inertia_kg_m2", scaled(curves.reduced_inertia, units::kg_m2)},
         {"crank_moment_Nm", scaled(curves.crank_moment, units::N_m)},
         {"rod_hinge_moment_Nm", scaled(curves.rod_hinge_moment, units::N_m)},
         {"rod_hinge_moment_potential_Nm", scaled(curves.rod_hinge_moment_potential, units::N_m)},
         {"side_force_without_hinge_N", scaled(curves.side_force_without_hinge, units::newton)},
         {"side_force_with_hinge_N", scaled(curves.side_force_with_hinge, units::newton)},
         {"crank_moment_with_rod_hinge_Nm", scaled(curves.crank_moment_with_rod_hinge, units::N_m)},
         {"guide_radius_compressed_mm", scaled(result.crank_guide.radius_compressed, units::mm)},
         {"guide_radius_stretched_mm", scaled(result.crank_guide.radius_stretched, units::mm)}});
    return json;
}

}  // namespace

Json write_result(const Input& input, const Result& result) {
    return write_wanted(input, result, {});
}

Json solve_scene(const Json& json, const CaseContext& /*context*/, const Wanted& wanted) {
    const Input input = read_input(json);
    return write_wanted(input, solve(input), wanted);
}

}  // namespace ravnoves::elastic_hinge
