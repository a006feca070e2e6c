#pragma once

#include "case-file/result_visitor.h"

/// The values of the scene's result: keys, units, decimals and names.
namespace ravnoves::bob_weights::result_field {

// ------------------------------------------------------------------------------ bob weight
inline constexpr ResultField reciprocating{"reciprocating_g", units::gram, 1,
                                           CORE_TEXT("bob-weights", "Reciprocating mass"),
                                           CORE_TEXT("bob-weights", "Mass of one cylinder.")};
inline constexpr ResultField rotating{"rotating_g", units::gram, 1,
                                      CORE_TEXT("bob-weights", "Rotating mass"),
                                      CORE_TEXT("bob-weights", "Mass of one cylinder.")};
inline constexpr ResultField reciprocating_percent{"reciprocating_percent", units::percent, 1,
                                                   CORE_TEXT("bob-weights", "Balance factor")};
inline constexpr ResultField bob_weight{"bobweight_g", units::gram, 1,
                                        CORE_TEXT("bob-weights", "Bob weight")};
inline constexpr ResultField bob_weights{
    .key = "bobweights", .label = CORE_TEXT("bob-weights", "Number of bob weights")};
inline constexpr ResultField theory{.key = "theory", .label = CORE_TEXT("bob-weights", "Theory")};
inline constexpr ResultField effect{.key = "effect"};
inline constexpr ResultField cylinders{.key = "cylinders",
                                       .label = CORE_TEXT("bob-weights", "Cylinders")};
inline constexpr ResultField forward{"forward_g", units::gram, 1,
                                     CORE_TEXT("bob-weights", "Force with the crank")};
inline constexpr ResultField backward{"backward_g", units::gram, 1,
                                      CORE_TEXT("bob-weights", "Force against the crank")};
inline constexpr ResultField upright{"upright_g", units::gram, 1,
                                     CORE_TEXT("bob-weights", "Force upright")};
inline constexpr ResultField across{"across_g", units::gram, 1,
                                    CORE_TEXT("bob-weights", "Force across")};
inline constexpr ResultField not_given{.key = "not_given"};
inline constexpr ResultField not_counted{.key = "not_counted"};
inline constexpr ResultField looks_like_kilograms{.key = "looks_like_kilograms"};
inline constexpr ResultField crankpins{"crankpins_g", units::gram, 1,
                                       CORE_TEXT("bob-weights", "Bob weights of the crankpins")};

// ------------------------------------------------------------------------------ correction
inline constexpr ResultField permissible{"permissible_g_mm", units::gram_mm, 1,
                                         CORE_TEXT("bob-weights", "Permissible")};
inline constexpr ResultField permissible_rotor{
    "permissible_rotor_g_mm", units::gram_mm, 1,
    CORE_TEXT("bob-weights", "Permissible, whole shaft")};
inline constexpr ResultField correction{.key = "correction",
                                        .label = CORE_TEXT("bob-weights", "Correction")};
inline constexpr ResultField planes{.key = "planes", .label = CORE_TEXT("bob-weights", "Plane")};
inline constexpr ResultField unbalance{"unbalance_g_mm", units::gram_mm, 1,
                                       CORE_TEXT("bob-weights", "Unbalance")};
inline constexpr ResultField angle{"angle_deg", units::degree, 1,
                                   CORE_TEXT("bob-weights", "Heavy spot")};
inline constexpr ResultField grams_at_radius{"grams_at_radius", units::gram, 2,
                                             CORE_TEXT("bob-weights", "Mass at drilling radius")};
inline constexpr ResultField holes{.key = "holes", .label = CORE_TEXT("bob-weights", "Hole")};
inline constexpr ResultField slugs{.key = "slugs", .label = CORE_TEXT("bob-weights", "Slug")};
inline constexpr ResultField remaining{"remaining_g_mm", units::gram_mm, 1,
                                       CORE_TEXT("bob-weights", "Residual")};
inline constexpr ResultField remaining_angle{"remaining_angle_deg", units::degree, 1,
                                             CORE_TEXT("bob-weights", "Direction of the residual")};
inline constexpr ResultField within_as_measured{
    .key = "within_tolerance_as_measured",
    .label = CORE_TEXT("bob-weights", "Within tolerance as measured")};
inline constexpr ResultField within{.key = "within_tolerance",
                                    .label = CORE_TEXT("bob-weights", "Within tolerance")};
inline constexpr ResultField beyond_sector{"edge_beyond_sector_mm", units::mm, 2,
                                           CORE_TEXT("bob-weights", "Edge beyond the sector")};
inline constexpr ResultField runs{.key = "runs", .label = CORE_TEXT("bob-weights", "Run")};
inline constexpr ResultField expected{.key = "expected",
                                      .label = CORE_TEXT("bob-weights", "Expected")};
inline constexpr ResultField acted_opposite{
    .key = "drilling_acted_opposite",
    .label = CORE_TEXT("bob-weights", "Drilling acted the opposite way")};
inline constexpr ResultField acted_in_other_plane{
    .key = "drilling_acted_in_other_plane",
    .label = CORE_TEXT("bob-weights", "Drilling acted in the other plane")};
inline constexpr ResultField drilled_holes{.key = "drilled_holes",
                                           .label = CORE_TEXT("bob-weights", "Drilled hole")};
inline constexpr ResultField drilled_slugs{.key = "drilled_slugs",
                                           .label = CORE_TEXT("bob-weights", "Pressed-in slug")};
inline constexpr ResultField amplification{"amplification", units::none, 2,
                                           CORE_TEXT("bob-weights", "Amplification of errors")};

// ----------------------------------------------------------------------------------- a hole
inline constexpr ResultField diameter{"diameter_mm", units::mm, 2,
                                      CORE_TEXT("bob-weights", "Diameter")};
inline constexpr ResultField depth{"depth_mm", units::mm, 1, CORE_TEXT("bob-weights", "Depth")};
inline constexpr ResultField hole_angle{"angle_deg", units::degree, 1,
                                        CORE_TEXT("bob-weights", "Angle")};
inline constexpr ResultField removed{"removed_g", units::gram, 2,
                                     CORE_TEXT("bob-weights", "Takes off")};
inline constexpr ResultField removed_unbalance{"removed_g_mm", units::gram_mm, 1,
                                               CORE_TEXT("bob-weights", "Takes off, unbalance")};
inline constexpr ResultField added{"added_g", units::gram, 2, CORE_TEXT("bob-weights", "Adds")};
inline constexpr ResultField added_unbalance{"added_g_mm", units::gram_mm, 1,
                                             CORE_TEXT("bob-weights", "Adds, unbalance")};
inline constexpr ResultField deepens{.key = "deepens"};
inline constexpr ResultField from_depth{"from_depth_mm", units::mm, 1,
                                        CORE_TEXT("bob-weights", "Depth before")};
inline constexpr ResultField centrifugal_force{
    "centrifugal_force_N", units::newton, 0, CORE_TEXT("bob-weights", "Centrifugal force"),
    CORE_TEXT("bob-weights", "Centrifugal force of the slug at the service speed.")};
inline constexpr ResultField direction{.key = "direction"};
inline constexpr ResultField slug_radius{"radius_mm", units::mm, 1,
                                         CORE_TEXT("bob-weights", "Radius of the hole centre"),
                                         CORE_TEXT("bob-weights",
                                                   "Radius of the slug's centre about the crank "
                                                   "axis.")};
inline constexpr ResultField slug_mass{"slug_g", units::gram, 2,
                                       CORE_TEXT("bob-weights", "Mass of the slug")};

}  // namespace ravnoves::bob_weights::result_field
