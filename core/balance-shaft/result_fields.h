#pragma once

#include "case-file/result_visitor.h"

/// The values of the result that the page has in its tables too.
namespace ravnoves::balance_shaft::result_field {

inline constexpr ResultField inertia_force_1_max{"inertia_force_1_max_N",
                                                 Text::tr("Inertia force Pⱼ₁, maximum"), 1,
                                                 Text::tr("First order, mⱼ r ω².")};
inline constexpr ResultField counterweight_mass{
    "counterweight_mass_kg", Text::tr("Counterweight mass m₁"), 4,
    Text::tr("Mass of each of the two counterweights, mⱼ r / (2 ρ₁), eq. (1), or as entered.")};
inline constexpr ResultField counterweight_force{
    "counterweight_force_N", Text::tr("Counterweight force P₁"), 1, Text::tr("m₁ ρ₁ ω².")};
inline constexpr ResultField shaft_bearing_load{
    "shaft_bearing_load_N", Text::tr("Load on the shaft bearings, P₁"), 1,
    Text::tr("Force on both bearings of the shaft together; it rotates with the shaft.")};
inline constexpr ResultField moment_amplitude{"moment_amplitude_Nm",
                                              Text::tr("Amplitude of Mₛ, P₁ l"), 2,
                                              Text::tr("Maximum moment of the shaft.")};
inline constexpr ResultField excess_work{
    "excess_work_J", Text::tr("excess work ΔE"), 1,
    Text::tr("Maximum minus minimum of ∫ (Mᵢ − mean) dφ over the cycle.")};
inline constexpr ResultField fluctuation{"fluctuation", Text::tr("speed fluctuation δ"), 5,
                                         Text::tr("(ω_max − ω_min) / ω = ΔE / (J ω²).")};
inline constexpr ResultField inertia{
    "inertia_kg_m2", Text::tr("moment of inertia J"), 4,
    Text::tr("Moment of inertia of all rotating parts, ΔE / (δ ω²).")};
inline constexpr ResultField displacement{"displacement_cm3", Text::tr("displacement"), 1,
                                          Text::tr("Piston area times stroke.")};
inline constexpr ResultField clearance_volume{"clearance_volume_cm3", Text::tr("clearance volume"),
                                              2,
                                              Text::tr("Displacement / (compression ratio − 1).")};
inline constexpr ResultField heat{
    "heat_J", Text::tr("heat per cycle"), 1,
    Text::tr("Heat released by the combustion, entered or from the mean pressure.")};
inline constexpr ResultField work{"work_J", Text::tr("indicated work per cycle"), 1,
                                  Text::tr("∮ (p − p₀) dV.")};
inline constexpr ResultField mean_effective_pressure{
    "mean_effective_pressure_bar", Text::tr("indicated mean effective pressure"), 3,
    Text::tr("Work of a cycle over the displacement.")};
inline constexpr ResultField power{"power_kW", Text::tr("indicated power"), 3,
                                   Text::tr("Work of a cycle times cycles a second.")};
inline constexpr ResultField mean_torque{"mean_torque_Nm", Text::tr("mean torque"), 2,
                                         Text::tr("Work of a cycle over its crank angle.")};
inline constexpr ResultField peak_pressure{"peak_pressure_bar", Text::tr("peak pressure"), 2,
                                           Text::tr("Maximum pressure in the cylinder.")};
inline constexpr ResultField peak_pressure_crank_angle =
    ResultField{"peak_pressure_crank_angle_deg", Text::tr("φ of the peak pressure"), 1}.with(
        Period::cycle);
inline constexpr ResultField first_order{"first_order_N", Text::tr("first order, P"), 1,
                                         Text::tr("First-order inertia force, mⱼ r ω².")};
inline constexpr ResultField along_cylinder{
    "along_cylinder_N", Text::tr("along the cylinder, (1 − κ) P"), 1,
    Text::tr("Half-axis of the ellipse along the cylinder.")};
inline constexpr ResultField across_cylinder{
    "across_cylinder_N", Text::tr("across the cylinder, κ P"), 1,
    Text::tr("Half-axis of the ellipse across the cylinder.")};
inline constexpr ResultField with_shaft{"with_shaft_N", Text::tr("first order with the shaft"), 1,
                                        Text::tr("Residual first order with the shaft.")};
inline constexpr ResultField second_order{
    "second_order_N", Text::tr("second order, λ mⱼ r ω²"), 1,
    Text::tr("Second order along the cylinder, with and without a shaft.")};
inline constexpr ResultField residual_force{
    "residual_force_N", Text::tr("residual force"), 1,
    Text::tr("Constant force that turns against the crank, 2 P₁ |sin(δ/2)|.")};
inline constexpr ResultField required_unbalance{
    "required_unbalance_g_mm", Text::tr("required unbalance"), 0,
    Text::tr("Unbalance m₁ ρ₁ of both counterweights by equation (1).")};
inline constexpr ResultField unbalance{"unbalance_g_mm", Text::tr("unbalance of the shaft"), 0,
                                       Text::tr("U = 2/3 ρ b a³, a² = h (D − h).")};
inline constexpr ResultField flat_width{"flat_width_mm", Text::tr("width of the flat"), 2,
                                        Text::tr("2 a = 2 √(h (D − h)).")};
inline constexpr ResultField removed_mass{"removed_mass_kg", Text::tr("mass milled away"), 4,
                                          Text::tr("ρ b times the area of the segment.")};
inline constexpr ResultField relieved_part_mass{"relieved_part_mass_kg", Text::tr("remaining mass"),
                                                4, Text::tr("ρ b A of the remaining section.")};
inline constexpr ResultField centre_of_mass_radius{
    "centre_of_mass_radius_mm", Text::tr("centroid radius"), 3,
    Text::tr("U over the mass of the relieved part, on the side away from the flat.")};
inline constexpr ResultField critical_radius{
    "critical_radius_mm", Text::tr("minimum bar radius"), 2,
    Text::tr("Minimum bar radius for the unbalance at this length, ∛(3 U / (2 ρ b)).")};
inline constexpr ResultField critical_length{
    "critical_length_mm", Text::tr("minimum relief length"), 2,
    Text::tr("Minimum length of the relief for the unbalance with this bar, 3 U / (2 ρ R³).")};

}  // namespace ravnoves::balance_shaft::result_field
