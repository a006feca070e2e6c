#pragma once

#include "case-file/case_context.h"
#include "case-file/json_fwd.h"
#include "case-file/wanted.h"
#include "elastic-hinge/input.h"

namespace ravnoves::elastic_hinge {

/// Reads the "input" object of a case. Beside the contract's keys: masses_kg in the place of
/// weights_N (then the counterweight has mass_kg, and gravity may be 0), rod_hinge_spring,
/// rod_counterweight/inertia "newton-euler" (default) or "as-printed", roller_radius_mm,
/// profile_error_um, profile_error_waves, guide_search {relief_mm, outer_diameter_mm,
/// smallest_spring_length_mm} and motion {turns, start_speed_rad_s, start_angle_deg,
/// crank_torque_Nm, with_profile_error}.
/// @throws InputError that names the JSON pointer
Input read_input(const Json& input);

/// The "input" object that reads back to the same Input.
Json write_input(const Input& input);

/// The scene as the case file sees it.
/// @throws InputError
Json solve_scene(const Json& input, const CaseContext& context, const Wanted& wanted = {});

}  // namespace ravnoves::elastic_hinge
