#pragma once

#include "case-file/result_visitor.h"

/// The values of the scene's result: keys, units, decimals and names.
namespace ravnoves::v8_plugs::result_field {

// ------------------------------------------------------------------------------- the whole
inline constexpr ResultField unbalanced_mass{
    "unbalanced_mass_g", units::gram, 3, CORE_TEXT("v8-plugs", "Excess on a crankpin Δmᵤ"),
    CORE_TEXT("v8-plugs", "Excess mass of the parts on the crankpin axis.")};
inline constexpr ResultField unbalance{"unbalance_g_mm", units::gram_mm, 1,
                                       CORE_TEXT("v8-plugs", "Unbalance of a crankpin")};
inline constexpr ResultField k_p{"k_p", units::none, 3, CORE_TEXT("v8-plugs", "Coefficient kₚ")};
inline constexpr ResultField k_y{"k_y", units::none, 3, CORE_TEXT("v8-plugs", "Coefficient kᵤ")};
inline constexpr ResultField k_y_new{"k_y_new", units::none, 3,
                                     CORE_TEXT("v8-plugs", "Coefficient kᵤₙ")};
inline constexpr ResultField slope_angle{"slope_angle_deg", units::degree, 1,
                                         CORE_TEXT("v8-plugs", "Slope angle")};
inline constexpr ResultField mass_changes{.key = "mass_changes_g",
                                          .label = CORE_TEXT("v8-plugs", "Mass changes")};
inline constexpr ResultField not_counted{.key = "not_counted"};
inline constexpr ResultField options{.key = "options", .label = CORE_TEXT("v8-plugs", "Options")};
inline constexpr ResultField recommended{.key = "recommended"};
inline constexpr ResultField state{.key = "state"};
inline constexpr ResultField warning{.key = "warning"};
inline constexpr ResultField plug{.key = "plug", .label = CORE_TEXT("v8-plugs", "Plug")};

// ------------------------------------------------------------------------------- an option
inline constexpr ResultField constant{"constant_g", units::gram, 3,
                                      CORE_TEXT("v8-plugs", "Fixed part"),
                                      CORE_TEXT("v8-plugs", "Compensated without machining.")};
inline constexpr ResultField slope{"slope", units::none, 3, CORE_TEXT("v8-plugs", "Gain"),
                                   CORE_TEXT("v8-plugs", "Compensated by a gram off each plug.")};
inline constexpr ResultField maximum{"maximum_g", units::gram, 3, CORE_TEXT("v8-plugs", "Maximum")};
inline constexpr ResultField required_reduction{"required_reduction_g", units::gram, 3,
                                                CORE_TEXT("v8-plugs", "Required off each plug")};
inline constexpr ResultField reduction{"reduction_g", units::gram, 3,
                                       CORE_TEXT("v8-plugs", "Take off each plug")};
inline constexpr ResultField residual_mass{"residual_mass_g", units::gram, 3,
                                           CORE_TEXT("v8-plugs", "Remains")};
inline constexpr ResultField residual_unbalance{"residual_unbalance_g_mm", units::gram_mm, 1,
                                                CORE_TEXT("v8-plugs", "Residual unbalance")};
inline constexpr ResultField bob_weight_sum{"bobweight_g", units::gram, 1,
                                            CORE_TEXT("v8-plugs", "Bob weight")};
inline constexpr ResultField with_plugs_in{"bobweight_with_plugs_in_g", units::gram, 1,
                                           CORE_TEXT("v8-plugs", "Bob weight, plugs in")};
inline constexpr ResultField nominal_bob_weight{"nominal_bobweight_g", units::gram, 1,
                                                CORE_TEXT("v8-plugs", "Bob weight, nominal")};
inline constexpr ResultField plug_mass{"plug_mass_g", units::gram, 3,
                                       CORE_TEXT("v8-plugs", "Mass of a plug")};

inline constexpr ResultField shifts{.key = "centre_of_mass_shift",
                                    .label = CORE_TEXT("v8-plugs", "Shift")};
inline constexpr ResultField shift{"shift_mm", units::mm, 2, CORE_TEXT("v8-plugs", "Shift")};
inline constexpr ResultField coefficient{"coefficient", units::none, 4,
                                         CORE_TEXT("v8-plugs", "Coefficient")};
inline constexpr ResultField shift_effect{.key = "shift_effect",
                                          .label = CORE_TEXT("v8-plugs", "Effect of the shift")};
inline constexpr ResultField from{.key = "from"};
inline constexpr ResultField beyond_tolerance{.key = "beyond_tolerance",
                                              .label = CORE_TEXT("v8-plugs", "Beyond tolerance")};
inline constexpr ResultField corrected_reduction{"corrected_reduction_g", units::gram};
inline constexpr ResultField corrected_depth{"corrected_depth_mm", units::mm, 2,
                                             CORE_TEXT("v8-plugs", "Corrected depth")};

inline constexpr ResultField boring{.key = "boring", .label = CORE_TEXT("v8-plugs", "Boring")};
inline constexpr ResultField possible{.key = "possible",
                                      .label = CORE_TEXT("v8-plugs", "Possible")};
inline constexpr ResultField limited_by{.key = "limited_by"};
inline constexpr ResultField depth{"depth_mm", units::mm, 2, CORE_TEXT("v8-plugs", "Depth")};
inline constexpr ResultField deeper_by{"deeper_by_mm", units::mm, 2,
                                       CORE_TEXT("v8-plugs", "Deeper by")};
inline constexpr ResultField wall{"wall_mm", units::mm, 2, CORE_TEXT("v8-plugs", "Wall")};
inline constexpr ResultField bottom{"bottom_mm", units::mm, 2, CORE_TEXT("v8-plugs", "Bottom")};
inline constexpr ResultField maximum_reduction{"maximum_reduction_g", units::gram, 3,
                                               CORE_TEXT("v8-plugs", "Maximum by the walls")};
inline constexpr ResultField shift_unbalance{"shift_unbalance_g_mm", units::gram_mm, 2,
                                             CORE_TEXT("v8-plugs", "Effect of the shift")};

// ------------------------------------------------------------------------------ bob weights
inline constexpr ResultField bob_weight{.key = "bobweight",
                                        .label = CORE_TEXT("v8-plugs", "Bob weight")};
inline constexpr ResultField nominal{.key = "nominal", .label = CORE_TEXT("v8-plugs", "Nominal")};
inline constexpr ResultField before{.key = "before", .label = CORE_TEXT("v8-plugs", "Before")};
inline constexpr ResultField sum{"sum_g", units::gram, 1, CORE_TEXT("v8-plugs", "Sum")};

// --------------------------------------------------------------------- crankpins, plug
inline constexpr ResultField crankpins{.key = "crankpins",
                                       .label = CORE_TEXT("v8-plugs", "Crankpins")};
inline constexpr ResultField deviation{"deviation_g_mm", units::gram_mm, 1};
inline constexpr ResultField steel{.key = "steel", .label = CORE_TEXT("v8-plugs", "Steel")};
inline constexpr ResultField aluminium{.key = "aluminium",
                                       .label = CORE_TEXT("v8-plugs", "Aluminium")};
inline constexpr ResultField geometry_mass{"geometry_mass_g", units::gram, 2,
                                           CORE_TEXT("v8-plugs", "Mass by the sizes")};
inline constexpr ResultField entered_mass{"entered_mass_g", units::gram, 3,
                                          CORE_TEXT("v8-plugs", "Mass as entered")};
inline constexpr ResultField fits{.key = "fits", .label = CORE_TEXT("v8-plugs", "Masses agree")};

}  // namespace ravnoves::v8_plugs::result_field
