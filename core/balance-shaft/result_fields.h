#pragma once

#include "case-file/result_visitor.h"

/// The values of the result that the page has in its tables too.
namespace ravnoves::balance_shaft::result_field {

inline constexpr ResultField inertia_force_1_max{
    "inertia_force_1_max_N", CORE_TEXT("balance-shaft", "Inertia force Pⱼ₁, maximum"), 1,
    CORE_TEXT("balance-shaft", "First order, mⱼ r ω².")};
inline constexpr ResultField counterweight_mass{
    "counterweight_mass_kg", CORE_TEXT("balance-shaft", "Counterweight mass m₁"), 4,
    CORE_TEXT("balance-shaft",
              "Mass of each of the two counterweights, mⱼ r / (2 ρ₁), eq. (1), or as entered.")};
inline constexpr ResultField counterweight_force{
    "counterweight_force_N", CORE_TEXT("balance-shaft", "Counterweight force P₁"), 1,
    CORE_TEXT("balance-shaft", "m₁ ρ₁ ω².")};
inline constexpr ResultField shaft_bearing_load{
    "shaft_bearing_load_N", CORE_TEXT("balance-shaft", "Load on the shaft bearings, P₁"), 1,
    CORE_TEXT("balance-shaft",
              "Force on both bearings of the shaft together; it rotates with the shaft.")};
inline constexpr ResultField moment_amplitude{
    "moment_amplitude_Nm", CORE_TEXT("balance-shaft", "Amplitude of Mₛ, P₁ l"), 2,
    CORE_TEXT("balance-shaft", "Maximum moment of the shaft.")};
inline constexpr ResultField excess_work{
    "excess_work_J", CORE_TEXT("balance-shaft", "excess work ΔE"), 1,
    CORE_TEXT("balance-shaft", "Maximum minus minimum of ∫ (Mᵢ − mean) dφ over the cycle.")};
inline constexpr ResultField fluctuation{
    "fluctuation", CORE_TEXT("balance-shaft", "speed fluctuation δ"), 5,
    CORE_TEXT("balance-shaft", "(ω_max − ω_min) / ω = ΔE / (J ω²).")};
inline constexpr ResultField inertia{
    "inertia_kg_m2", CORE_TEXT("balance-shaft", "moment of inertia J"), 4,
    CORE_TEXT("balance-shaft", "Moment of inertia of all rotating parts, ΔE / (δ ω²).")};
inline constexpr ResultField displacement{"displacement_cm3",
                                          CORE_TEXT("balance-shaft", "displacement"), 1,
                                          CORE_TEXT("balance-shaft", "Piston area times stroke.")};
inline constexpr ResultField clearance_volume{
    "clearance_volume_cm3", CORE_TEXT("balance-shaft", "clearance volume"), 2,
    CORE_TEXT("balance-shaft", "Displacement / (compression ratio − 1).")};
inline constexpr ResultField heat{
    "heat_J", CORE_TEXT("balance-shaft", "heat per cycle"), 1,
    CORE_TEXT("balance-shaft",
              "Heat released by the combustion, entered or from the mean pressure.")};
inline constexpr ResultField work{"work_J", CORE_TEXT("balance-shaft", "indicated work per cycle"),
                                  1, CORE_TEXT("balance-shaft", "∮ (p − p₀) dV.")};
inline constexpr ResultField mean_effective_pressure{
    "mean_effective_pressure_bar", CORE_TEXT("balance-shaft", "indicated mean effective pressure"),
    3, CORE_TEXT("balance-shaft", "Work of a cycle over the displacement.")};
inline constexpr ResultField power{
    "power_kW", CORE_TEXT("balance-shaft", "indicated power"), 3,
    CORE_TEXT("balance-shaft", "Work of a cycle times cycles a second.")};
inline constexpr ResultField mean_torque{
    "mean_torque_Nm", CORE_TEXT("balance-shaft", "mean torque"), 2,
    CORE_TEXT("balance-shaft", "Work of a cycle over its crank angle.")};
inline constexpr ResultField peak_pressure{
    "peak_pressure_bar", CORE_TEXT("balance-shaft", "peak pressure"), 2,
    CORE_TEXT("balance-shaft", "Maximum pressure in the cylinder.")};
inline constexpr ResultField peak_pressure_crank_angle{
    "peak_pressure_crank_angle_deg", CORE_TEXT("balance-shaft", "φ of the peak pressure"), 1};
inline constexpr ResultField first_order{
    "first_order_N", CORE_TEXT("balance-shaft", "first order, P"), 1,
    CORE_TEXT("balance-shaft", "First-order inertia force, mⱼ r ω².")};
inline constexpr ResultField along_cylinder{
    "along_cylinder_N", CORE_TEXT("balance-shaft", "along the cylinder, (1 − κ) P"), 1,
    CORE_TEXT("balance-shaft", "Half-axis of the ellipse along the cylinder.")};
inline constexpr ResultField across_cylinder{
    "across_cylinder_N", CORE_TEXT("balance-shaft", "across the cylinder, κ P"), 1,
    CORE_TEXT("balance-shaft", "Half-axis of the ellipse across the cylinder.")};
inline constexpr ResultField with_shaft{
    "with_shaft_N", CORE_TEXT("balance-shaft", "first order with the shaft"), 1,
    CORE_TEXT("balance-shaft", "Residual first order with the shaft.")};
inline constexpr ResultField second_order{
    "second_order_N", CORE_TEXT("balance-shaft", "second order, λ mⱼ r ω²"), 1,
    CORE_TEXT("balance-shaft", "Second order along the cylinder, with and without a shaft.")};
inline constexpr ResultField residual_force{
    "residual_force_N", CORE_TEXT("balance-shaft", "residual force"), 1,
    CORE_TEXT("balance-shaft", "Constant force that turns against the crank, 2 P₁ |sin(δ/2)|.")};
inline constexpr ResultField required_unbalance{
    "required_unbalance_g_mm", CORE_TEXT("balance-shaft", "required unbalance"), 0,
    CORE_TEXT("balance-shaft", "Unbalance m₁ ρ₁ of both counterweights by equation (1).")};
inline constexpr ResultField unbalance{
    "unbalance_g_mm", CORE_TEXT("balance-shaft", "unbalance of the shaft"), 0,
    CORE_TEXT("balance-shaft", "U = 2/3 ρ b a³, a² = h (D − h).")};
inline constexpr ResultField flat_width{"flat_width_mm",
                                        CORE_TEXT("balance-shaft", "width of the flat"), 2,
                                        CORE_TEXT("balance-shaft", "2 a = 2 √(h (D − h)).")};
inline constexpr ResultField removed_mass{
    "removed_mass_kg", CORE_TEXT("balance-shaft", "mass milled away"), 4,
    CORE_TEXT("balance-shaft", "ρ b times the area of the segment.")};
inline constexpr ResultField relieved_part_mass{
    "relieved_part_mass_kg", CORE_TEXT("balance-shaft", "remaining mass"), 4,
    CORE_TEXT("balance-shaft", "ρ b A of the remaining section.")};
inline constexpr ResultField centre_of_mass_radius{
    "centre_of_mass_radius_mm", CORE_TEXT("balance-shaft", "centroid radius"), 3,
    CORE_TEXT("balance-shaft",
              "U over the mass of the relieved part, on the side away from the flat.")};
inline constexpr ResultField critical_radius{
    "critical_radius_mm", CORE_TEXT("balance-shaft", "minimum bar radius"), 2,
    CORE_TEXT("balance-shaft",
              "Minimum bar radius for the unbalance at this length, ∛(3 U / (2 ρ b)).")};
inline constexpr ResultField critical_length{
    "critical_length_mm", CORE_TEXT("balance-shaft", "minimum relief length"), 2,
    CORE_TEXT("balance-shaft",
              "Minimum length of the relief for the unbalance with this bar, 3 U / (2 ρ R³).")};

}  // namespace ravnoves::balance_shaft::result_field
