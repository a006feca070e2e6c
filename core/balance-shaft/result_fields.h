#pragma once

#include "case-file/result_visitor.h"

/// The values of the balance shaft's result: keys, units, decimals, names and tips.
namespace ravnoves::balance_shaft::result_field {

// ------------------------------------------------------------------------------- the whole
inline constexpr ResultField angular_speed{"angular_speed_rad_s", units::rad_per_s, 2,
                                           CORE_TEXT("balance-shaft", "Angular speed ω")};
inline constexpr ResultField reciprocating_mass{
    "reciprocating_mass_kg", units::kg, 4, CORE_TEXT("balance-shaft", "Reciprocating mass mⱼ")};
inline constexpr ResultField inertia_force_1_max{
    "inertia_force_1_max_N", units::newton, 1,
    CORE_TEXT("balance-shaft", "Inertia force Pⱼ₁, maximum"),
    CORE_TEXT("balance-shaft", "First order, mⱼ r ω².")};
inline constexpr ResultField counterweight_mass{
    "counterweight_mass_kg", units::kg, 4, CORE_TEXT("balance-shaft", "Counterweight mass m₁"),
    CORE_TEXT("balance-shaft",
              "Mass of each of the two counterweights, mⱼ r / (2 ρ₁), eq. (1), or as entered.")};
inline constexpr ResultField counterweight_force{
    "counterweight_force_N", units::newton, 1, CORE_TEXT("balance-shaft", "Counterweight force P₁"),
    CORE_TEXT("balance-shaft", "m₁ ρ₁ ω².")};
inline constexpr ResultField shaft_bearing_load{
    "shaft_bearing_load_N", units::newton, 1,
    CORE_TEXT("balance-shaft", "Load on the shaft bearings, P₁"),
    CORE_TEXT("balance-shaft",
              "Force on both bearings of the shaft together; it rotates with the shaft.")};
inline constexpr ResultField moment_amplitude{
    "moment_amplitude_Nm", units::N_m, 2, CORE_TEXT("balance-shaft", "Amplitude of Mₛ, P₁ l"),
    CORE_TEXT("balance-shaft", "Maximum moment of the shaft.")};
inline constexpr ResultField shaft_angle{"shaft_angle_deg", units::degree, 2,
                                         CORE_TEXT("balance-shaft", "α")};
inline constexpr ResultField metrics{"metrics", units::none, 3};
inline constexpr ResultField M_up{"M_up", units::none, 3, CORE_TEXT("balance-shaft", "Mᵤₚ")};
inline constexpr ResultField M_s{"M_s", units::none, 3, CORE_TEXT("balance-shaft", "Mₛ")};
inline constexpr ResultField M_ups{"M_ups", units::none, 3, CORE_TEXT("balance-shaft", "Mᵤₚₛ")};
inline constexpr ResultField change_without_shaft{
    "change_without_shaft", units::none, 3, CORE_TEXT("balance-shaft", "Change vs. no shaft")};
inline constexpr ResultField range_percent{"range_percent", units::percent, 1,
                                           CORE_TEXT("balance-shaft", "range")};
inline constexpr ResultField rms_percent{"rms_percent", units::percent, 1,
                                         CORE_TEXT("balance-shaft", "RMS")};
inline constexpr ResultField printed_mean{"printed_mean", units::none, 3,
                                          CORE_TEXT("balance-shaft", "Mean of table rows (paper)")};
inline constexpr ResultField M_s_25_nodes{"M_s_25_nodes_Nm", units::N_m, 2,
                                          CORE_TEXT("balance-shaft", "Mₛ, 25 rows")};
inline constexpr ResultField M_up_nodes{"M_up_nodes_Nm", units::N_m, 2,
                                        CORE_TEXT("balance-shaft", "Mᵤₚ, table rows")};
inline constexpr ResultField M_ups_nodes{"M_ups_nodes_Nm", units::N_m, 2,
                                         CORE_TEXT("balance-shaft", "Mᵤₚₛ, table rows")};
inline constexpr ResultField optimum{"optimum", units::none, 3,
                                     CORE_TEXT("balance-shaft", "Best α")};
inline constexpr ResultField optimum_buildable{"optimum_buildable", units::none, 3,
                                               CORE_TEXT("balance-shaft", "Best feasible α")};
inline constexpr ResultField optimum_range{"range", units::none, 3,
                                           CORE_TEXT("balance-shaft", "minimum range")};
inline constexpr ResultField optimum_rms{"rms", units::none, 3,
                                         CORE_TEXT("balance-shaft", "minimum RMS")};
inline constexpr ResultField buildable{"buildable", units::none, 3,
                                       CORE_TEXT("balance-shaft", "Feasible positions")};
inline constexpr ResultField buildable_angles{"shaft_angles_deg", units::none, 3,
                                              CORE_TEXT("balance-shaft", "Feasible α")};
inline constexpr ResultField at_shaft_angle{"at_shaft_angle", units::none, 0,
                                            CORE_TEXT("balance-shaft", "Feasible at this α")};
inline constexpr ResultField order_1{"order_1", units::none, 3,
                                     CORE_TEXT("balance-shaft", "First order of Mᵤₚ")};
inline constexpr ResultField share_of_variance{"share_of_variance", units::none, 3,
                                               CORE_TEXT("balance-shaft", "share of the variance")};
inline constexpr ResultField dead_centre{"dead_centre_deg", units::degree, 3,
                                         CORE_TEXT("balance-shaft", "Crank angle at TDC")};
inline constexpr ResultField counterweight_lag{
    "counterweight_lag_deg", units::degree, 3,
    CORE_TEXT("balance-shaft", "Lag of the counterweights")};
inline constexpr ResultField envelope{"envelope", units::none, 3,
                                      CORE_TEXT("balance-shaft", "Envelope")};
inline constexpr ResultField inertia_check{
    "inertia_check", units::none, 3, CORE_TEXT("balance-shaft", "Check of the inertia torque")};
inline constexpr ResultField spectrum{"spectrum", units::none, 3,
                                      CORE_TEXT("balance-shaft", "Order spectrum")};
inline constexpr ResultField flywheel{"flywheel", units::none, 3,
                                      CORE_TEXT("balance-shaft", "Flywheel")};
inline constexpr ResultField indicated{"indicated", units::none, 3,
                                       CORE_TEXT("balance-shaft", "Indicated cycle")};
inline constexpr ResultField curves{"curves", units::none, 3, CORE_TEXT("balance-shaft", "Curves")};
inline constexpr ResultField sweep{"sweep", units::none, 3,
                                   CORE_TEXT("balance-shaft", "Sweep over α")};
inline constexpr ResultField clearances{"clearances", units::none, 3,
                                        CORE_TEXT("balance-shaft", "Clearances")};
inline constexpr ResultField crank_only{"crank_only", units::none, 3,
                                        CORE_TEXT("balance-shaft", "Without shaft")};
inline constexpr ResultField envelope_study{"envelope_study", units::none, 3,
                                            CORE_TEXT("balance-shaft", "Range and size")};
inline constexpr ResultField best_position{
    "best_position", units::none, 3, CORE_TEXT("balance-shaft", "Optimum ignoring clearance")};
inline constexpr ResultField best_position_buildable{
    "best_position_buildable", units::none, 3, CORE_TEXT("balance-shaft", "Best feasible place")};
inline constexpr ResultField gear_error{"gear_error", units::none, 3,
                                        CORE_TEXT("balance-shaft", "Gears")};
inline constexpr ResultField relieved_shaft{"relieved_shaft", units::none, 3,
                                            CORE_TEXT("balance-shaft", "Relieved shaft")};
inline constexpr ResultField speed_band{"speed_band", units::none, 3,
                                        CORE_TEXT("balance-shaft", "Speed band")};

// -------------------------------------------------------------------------------- a moment
inline constexpr ResultField mean{"mean_Nm", units::N_m, 2, CORE_TEXT("balance-shaft", "mean")};
inline constexpr ResultField max{"max_Nm", units::N_m, 2, CORE_TEXT("balance-shaft", "maximum")};
inline constexpr ResultField min{"min_Nm", units::N_m, 2, CORE_TEXT("balance-shaft", "minimum")};
inline constexpr ResultField range{
    "range_Nm", units::N_m, 2, CORE_TEXT("balance-shaft", "range"),
    CORE_TEXT("balance-shaft", "Maximum minus minimum over the cycle.")};
inline constexpr ResultField rms{"rms_Nm", units::N_m, 2, CORE_TEXT("balance-shaft", "RMS"),
                                 CORE_TEXT("balance-shaft", "About the mean, over the cycle.")};
inline constexpr ResultField max_crank_angle{"max_crank_angle_deg", units::degree, 1,
                                             CORE_TEXT("balance-shaft", "φ of the maximum")};
inline constexpr ResultField min_crank_angle{"min_crank_angle_deg", units::degree, 1,
                                             CORE_TEXT("balance-shaft", "φ of the minimum")};
inline constexpr ResultField amplitude{"amplitude_Nm", units::N_m, 2,
                                       CORE_TEXT("balance-shaft", "amplitude")};
inline constexpr ResultField phase{"phase_deg", units::degree, 1,
                                   CORE_TEXT("balance-shaft", "phase")};

// ----------------------------------------------------------------------------------- sizes
inline constexpr ResultField width{"width_mm", units::mm, 1, CORE_TEXT("balance-shaft", "width")};
inline constexpr ResultField height{"height_mm", units::mm, 1,
                                    CORE_TEXT("balance-shaft", "height")};
inline constexpr ResultField crank_clearance{"crank_mm", units::mm, 1,
                                             CORE_TEXT("balance-shaft", "to the crank")};
inline constexpr ResultField cylinder_clearance{"cylinder_mm", units::mm, 1,
                                                CORE_TEXT("balance-shaft", "to the cylinder")};
inline constexpr ResultField rod_clearance{"rod_mm", units::mm, 1,
                                           CORE_TEXT("balance-shaft", "to the rod")};
inline constexpr ResultField min_allowed{"least_allowed_mm", units::mm, 1,
                                         CORE_TEXT("balance-shaft", "minimum allowed")};
inline constexpr ResultField shaft_swing_radius{
    "shaft_swing_radius_mm", units::mm, 1, CORE_TEXT("balance-shaft", "swing radius of the shaft")};
inline constexpr ResultField crank_swing_radius{
    "crank_swing_radius_mm", units::mm, 1, CORE_TEXT("balance-shaft", "swing radius of the crank")};
inline constexpr ResultField rod_width{"rod_width_mm", units::mm, 1,
                                       CORE_TEXT("balance-shaft", "width of the rod")};
inline constexpr ResultField cylinder_bore{"cylinder_bore_mm", units::mm, 1,
                                           CORE_TEXT("balance-shaft", "cylinder bore")};
inline constexpr ResultField cylinder_wall{"cylinder_wall_mm", units::mm, 1,
                                           CORE_TEXT("balance-shaft", "cylinder wall")};
inline constexpr ResultField cylinder_bottom{"cylinder_bottom_mm", units::mm, 1,
                                             CORE_TEXT("balance-shaft", "bottom of the cylinder")};
inline constexpr ResultField cylinder_top{"cylinder_top_mm", units::mm, 1,
                                          CORE_TEXT("balance-shaft", "top of the cylinder")};
inline constexpr ResultField gear_tip_radius{"gear_tip_radius_mm", units::mm, 1,
                                             CORE_TEXT("balance-shaft", "tip radius of the gear")};
inline constexpr ResultField efficient{"efficient", units::none, 3,
                                       CORE_TEXT("balance-shaft", "Pareto-optimal")};

// --------------------------------------------------------------------------- inertia check
inline constexpr ResultField fitted{"fitted_m_r2_w2_Nm", units::N_m, 2,
                                    CORE_TEXT("balance-shaft", "m r² ω² fitted")};
inline constexpr ResultField entered{"entered_m_r2_w2_Nm", units::N_m, 2,
                                     CORE_TEXT("balance-shaft", "m r² ω² entered")};
inline constexpr ResultField fitted_lambda{"fitted_lambda", units::none, 4,
                                           CORE_TEXT("balance-shaft", "λ fitted")};
inline constexpr ResultField consistent{"consistent", units::none, 0,
                                        CORE_TEXT("balance-shaft", "consistent")};
inline constexpr ResultField residual_rms{"residual_rms_Nm", units::N_m, 2,
                                          CORE_TEXT("balance-shaft", "residual RMS")};
inline constexpr ResultField matching_speed{"matching_speed_rpm", units::rpm, 0,
                                            CORE_TEXT("balance-shaft", "speed that fits")};
inline constexpr ResultField matching_mass{"matching_mass_kg", units::kg, 4,
                                           CORE_TEXT("balance-shaft", "mass that fits")};
inline constexpr ResultField lambda_is_given{"lambda_is_given", units::none, 0,
                                             CORE_TEXT("balance-shaft", "λ is given")};

// -------------------------------------------------------------------------------- spectrum
inline constexpr ResultField orders{"order", units::none, 1, CORE_TEXT("balance-shaft", "order")};
inline constexpr ResultField M_up_amplitude{"M_up_amplitude_Nm", units::N_m, 2,
                                            CORE_TEXT("balance-shaft", "Mᵤₚ, amplitude")};
inline constexpr ResultField M_up_phase{"M_up_phase_deg", units::degree, 1,
                                        CORE_TEXT("balance-shaft", "Mᵤₚ, phase")};
inline constexpr ResultField M_ups_amplitude{"M_ups_amplitude_Nm", units::N_m, 2,
                                             CORE_TEXT("balance-shaft", "Mᵤₚₛ, amplitude")};
inline constexpr ResultField M_ups_phase{"M_ups_phase_deg", units::degree, 1,
                                         CORE_TEXT("balance-shaft", "Mᵤₚₛ, phase")};

// -------------------------------------------------------------------------------- flywheel
inline constexpr ResultField excess_work{
    "excess_work_J", units::joule, 1, CORE_TEXT("balance-shaft", "excess work ΔE"),
    CORE_TEXT("balance-shaft", "Maximum minus minimum of ∫ (Mᵢ − mean) dφ over the cycle.")};
inline constexpr ResultField fluctuation{
    "fluctuation", units::none, 5, CORE_TEXT("balance-shaft", "speed fluctuation δ"),
    CORE_TEXT("balance-shaft", "(ω_max − ω_min) / ω = ΔE / (J ω²).")};
inline constexpr ResultField inertia{
    "inertia_kg_m2", units::kg_m2, 4, CORE_TEXT("balance-shaft", "moment of inertia J"),
    CORE_TEXT("balance-shaft", "Moment of inertia of all rotating parts, ΔE / (δ ω²).")};
inline constexpr ResultField max_energy{"max_energy_J", units::joule, 1,
                                        CORE_TEXT("balance-shaft", "maximum energy")};
inline constexpr ResultField min_energy{"min_energy_J", units::joule, 1,
                                        CORE_TEXT("balance-shaft", "minimum energy")};

// ------------------------------------------------------------------------- indicated cycle
inline constexpr ResultField displacement{"displacement_cm3", units::cm3, 1,
                                          CORE_TEXT("balance-shaft", "displacement"),
                                          CORE_TEXT("balance-shaft", "Piston area times stroke.")};
inline constexpr ResultField clearance_volume{
    "clearance_volume_cm3", units::cm3, 2, CORE_TEXT("balance-shaft", "clearance volume"),
    CORE_TEXT("balance-shaft", "Displacement over the compression ratio minus 1.")};
inline constexpr ResultField heat{
    "heat_J", units::joule, 1, CORE_TEXT("balance-shaft", "heat per cycle"),
    CORE_TEXT("balance-shaft",
              "Heat released by the combustion, entered or from the mean pressure.")};
inline constexpr ResultField work{"work_J", units::joule, 1,
                                  CORE_TEXT("balance-shaft", "indicated work per cycle"),
                                  CORE_TEXT("balance-shaft", "∮ (p − p₀) dV.")};
inline constexpr ResultField mean_effective_pressure{
    "mean_effective_pressure_bar", units::bar, 3,
    CORE_TEXT("balance-shaft", "indicated mean effective pressure"),
    CORE_TEXT("balance-shaft", "Work of a cycle over the displacement.")};
inline constexpr ResultField power{
    "power_kW", units::kW, 3, CORE_TEXT("balance-shaft", "indicated power"),
    CORE_TEXT("balance-shaft", "Work of a cycle times cycles a second.")};
inline constexpr ResultField mean_torque{
    "mean_torque_Nm", units::N_m, 2, CORE_TEXT("balance-shaft", "mean torque"),
    CORE_TEXT("balance-shaft", "Work of a cycle over its crank angle.")};
inline constexpr ResultField peak_pressure{
    "peak_pressure_bar", units::bar, 2, CORE_TEXT("balance-shaft", "peak pressure"),
    CORE_TEXT("balance-shaft", "Maximum pressure in the cylinder.")};
inline constexpr ResultField peak_pressure_crank_angle{
    "peak_pressure_crank_angle_deg", units::degree, 1,
    CORE_TEXT("balance-shaft", "φ of the peak pressure")};

// ---------------------------------------------------------------------------------- curves
inline constexpr ResultField crank_angles{"crank_angle_deg", units::none, 1,
                                          CORE_TEXT("balance-shaft", "Crank angle φ")};
inline constexpr ResultField M_up_curve{"M_up_Nm", units::N_m, 2,
                                        CORE_TEXT("balance-shaft", "Mᵤₚ")};
inline constexpr ResultField M_s_curve{"M_s_Nm", units::N_m, 2, CORE_TEXT("balance-shaft", "Mₛ")};
inline constexpr ResultField M_ups_curve{"M_ups_Nm", units::N_m, 2,
                                         CORE_TEXT("balance-shaft", "Mᵤₚₛ")};
inline constexpr ResultField excess_energy{"excess_energy_J", units::joule, 1,
                                           CORE_TEXT("balance-shaft", "excess energy")};
inline constexpr ResultField M_gas{"M_gas_Nm", units::N_m, 2,
                                   CORE_TEXT("balance-shaft", "gas torque")};
inline constexpr ResultField M_inertia{"M_inertia_Nm", units::N_m, 2,
                                       CORE_TEXT("balance-shaft", "inertia torque")};
inline constexpr ResultField M_offset{"M_offset_Nm", units::N_m, 2,
                                      CORE_TEXT("balance-shaft", "moment of the offset")};
inline constexpr ResultField pressure{"pressure_bar", units::bar, 2,
                                      CORE_TEXT("balance-shaft", "pressure")};
inline constexpr ResultField volume{"volume_cm3", units::cm3, 2,
                                    CORE_TEXT("balance-shaft", "volume")};
inline constexpr ResultField shaft_angles{"shaft_angle_deg", units::none, 1,
                                          CORE_TEXT("balance-shaft", "α")};
inline constexpr ResultField mean_M_s{"mean_M_s_Nm", units::N_m, 2,
                                      CORE_TEXT("balance-shaft", "mean of Mₛ")};
inline constexpr ResultField mean_M_ups{"mean_M_ups_Nm", units::N_m, 2,
                                        CORE_TEXT("balance-shaft", "mean of Mᵤₚₛ")};
inline constexpr ResultField printed_mean_M_s{"printed_mean_M_s_25_nodes_Nm", units::N_m, 2,
                                              CORE_TEXT("balance-shaft", "mean of 25 rows of Mₛ")};
inline constexpr ResultField printed_mean_M_ups{
    "printed_mean_M_ups_nodes_Nm", units::N_m, 2,
    CORE_TEXT("balance-shaft", "mean of table rows of Mᵤₚₛ")};

// --------------------------------------------------------------------------- without shaft
inline constexpr ResultField share{"share", units::none, 3,
                                   CORE_TEXT("balance-shaft", "share balanced on the crank")};
inline constexpr ResultField first_order{
    "first_order_N", units::newton, 1, CORE_TEXT("balance-shaft", "first order, P"),
    CORE_TEXT("balance-shaft", "First-order inertia force, mⱼ r ω².")};
inline constexpr ResultField along_cylinder{
    "along_cylinder_N", units::newton, 1,
    CORE_TEXT("balance-shaft", "along the cylinder, (1 − κ) P"),
    CORE_TEXT("balance-shaft", "Half-axis of the ellipse along the cylinder.")};
inline constexpr ResultField across_cylinder{
    "across_cylinder_N", units::newton, 1, CORE_TEXT("balance-shaft", "across the cylinder, κ P"),
    CORE_TEXT("balance-shaft", "Half-axis of the ellipse across the cylinder.")};
inline constexpr ResultField largest{"largest_N", units::newton, 1,
                                     CORE_TEXT("balance-shaft", "maximum")};
inline constexpr ResultField counterweight_moment{
    "counterweight_moment_kg_m", units::kg_m, 5,
    CORE_TEXT("balance-shaft", "unbalance of the crank's counterweight")};
inline constexpr ResultField with_shaft{
    "with_shaft_N", units::newton, 1, CORE_TEXT("balance-shaft", "first order with the shaft"),
    CORE_TEXT("balance-shaft", "Residual first order with the shaft.")};
inline constexpr ResultField second_order{
    "second_order_N", units::newton, 1, CORE_TEXT("balance-shaft", "second order, λ mⱼ r ω²"),
    CORE_TEXT("balance-shaft", "Second order along the cylinder, with and without a shaft.")};

// ---------------------------------------------------------------------------------- places
inline constexpr ResultField centre_distance{"centre_distance_mm", units::mm, 2,
                                             CORE_TEXT("balance-shaft", "centre distance l")};
inline constexpr ResultField gap{"gap_Nm", units::N_m, 6,
                                 CORE_TEXT("balance-shaft", "certified gap")};
inline constexpr ResultField front{"front", units::none, 3,
                                   CORE_TEXT("balance-shaft", "Pareto-optimal places")};
inline constexpr ResultField front_gap{"front_gap", units::none, 6,
                                       CORE_TEXT("balance-shaft", "certified gap of the places")};
inline constexpr ResultField size{"size_m2", units::none, 4, CORE_TEXT("balance-shaft", "size")};

// ----------------------------------------------------------------------------------- gears
inline constexpr ResultField phase_error{"phase_error_deg", units::degree, 3,
                                         CORE_TEXT("balance-shaft", "phase error")};
inline constexpr ResultField residual_force{
    "residual_force_N", units::newton, 1, CORE_TEXT("balance-shaft", "residual force"),
    CORE_TEXT("balance-shaft", "Constant force that turns against the crank, 2 P₁ |sin(δ/2)|.")};
inline constexpr ResultField play{"play_deg", units::degree, 3, CORE_TEXT("balance-shaft", "play")};
inline constexpr ResultField play_force{"play_force_N", units::newton, 1,
                                        CORE_TEXT("balance-shaft", "force from the play")};
inline constexpr ResultField play_range_low{
    "play_range_low_Nm", units::N_m, 2, CORE_TEXT("balance-shaft", "minimum range over the play")};
inline constexpr ResultField play_range_high{
    "play_range_high_Nm", units::N_m, 2, CORE_TEXT("balance-shaft", "maximum range over the play")};

// -------------------------------------------------------------------------- relieved shaft
inline constexpr ResultField required_unbalance{
    "required_unbalance_g_mm", units::gram_mm, 0, CORE_TEXT("balance-shaft", "required unbalance"),
    CORE_TEXT("balance-shaft", "Unbalance m₁ ρ₁ of both counterweights by equation (1).")};
inline constexpr ResultField unbalance{
    "unbalance_g_mm", units::gram_mm, 0, CORE_TEXT("balance-shaft", "unbalance of the shaft"),
    CORE_TEXT("balance-shaft", "U = 2/3 ρ b a³, a² = h (D − h).")};
inline constexpr ResultField diameter{"diameter_mm", units::mm, 2,
                                      CORE_TEXT("balance-shaft", "diameter")};
inline constexpr ResultField depth{"depth_mm", units::mm, 3,
                                   CORE_TEXT("balance-shaft", "depth of the relief")};
inline constexpr ResultField length{"length_mm", units::mm, 2,
                                    CORE_TEXT("balance-shaft", "length of the relief")};
inline constexpr ResultField flat_width{"flat_width_mm", units::mm, 2,
                                        CORE_TEXT("balance-shaft", "width of the flat"),
                                        CORE_TEXT("balance-shaft", "2 a = 2 √(h (D − h)).")};
inline constexpr ResultField removed_mass{
    "removed_mass_kg", units::kg, 4, CORE_TEXT("balance-shaft", "mass milled away"),
    CORE_TEXT("balance-shaft", "ρ b times the area of the segment.")};
inline constexpr ResultField relieved_part_mass{
    "relieved_part_mass_kg", units::kg, 4, CORE_TEXT("balance-shaft", "remaining mass"),
    CORE_TEXT("balance-shaft", "ρ b A of the remaining section.")};
inline constexpr ResultField centre_of_mass_radius{
    "centre_of_mass_radius_mm", units::mm, 3, CORE_TEXT("balance-shaft", "centroid radius"),
    CORE_TEXT("balance-shaft",
              "U over the mass of the relieved part, on the side away from the flat.")};
inline constexpr ResultField critical_radius{
    "critical_radius_mm", units::mm, 2, CORE_TEXT("balance-shaft", "critical bar radius"),
    CORE_TEXT("balance-shaft",
              "Minimum bar radius for the unbalance at this length, ∛(3 U / (2 ρ b)); not a "
              "vibration limit.")};
inline constexpr ResultField critical_length{
    "critical_length_mm", units::mm, 2, CORE_TEXT("balance-shaft", "critical length"),
    CORE_TEXT("balance-shaft",
              "Minimum length of the relief for the unbalance with this bar, 3 U / (2 ρ R³); not a "
              "vibration limit.")};

// ------------------------------------------------------------------------------ speed band
inline constexpr ResultField speeds{"speed_rpm", units::rpm, 0,
                                    CORE_TEXT("balance-shaft", "speed")};
inline constexpr ResultField range_without_shaft{"range_without_shaft_Nm", units::N_m, 2,
                                                 CORE_TEXT("balance-shaft", "range without shaft")};
inline constexpr ResultField rms_without_shaft{"rms_without_shaft_Nm", units::N_m, 2,
                                               CORE_TEXT("balance-shaft", "RMS without shaft")};
inline constexpr ResultField best_range_angle{"best_range_shaft_angle_deg", units::degree, 2,
                                              CORE_TEXT("balance-shaft", "α of the minimum range")};
inline constexpr ResultField best_range{"best_range_Nm", units::N_m, 2,
                                        CORE_TEXT("balance-shaft", "minimum range")};
inline constexpr ResultField best_rms_angle{"best_rms_shaft_angle_deg", units::degree, 2,
                                            CORE_TEXT("balance-shaft", "α of the minimum RMS")};
inline constexpr ResultField best_rms{"best_rms_Nm", units::N_m, 2,
                                      CORE_TEXT("balance-shaft", "minimum RMS")};
inline constexpr ResultField best_compromise{"least_bad", units::none, 3,
                                             CORE_TEXT("balance-shaft", "Best compromise")};
inline constexpr ResultField best_compromise_feasible{
    "least_bad_buildable", units::none, 3, CORE_TEXT("balance-shaft", "Best feasible compromise")};
inline constexpr ResultField range_relative{"range_relative", units::none, 3,
                                            CORE_TEXT("balance-shaft", "range, relative")};
inline constexpr ResultField rms_relative{"rms_relative", units::none, 3,
                                          CORE_TEXT("balance-shaft", "RMS, relative")};
inline constexpr ResultField ratio{"ratio", units::none, 4,
                                   CORE_TEXT("balance-shaft", "over its value without shaft")};
inline constexpr ResultField worst_speed{"worst_speed_rpm", units::rpm, 0,
                                         CORE_TEXT("balance-shaft", "worst speed")};
inline constexpr ResultField map{"map", units::none, 3,
                                 CORE_TEXT("balance-shaft", "Map over speed and α")};

}  // namespace ravnoves::balance_shaft::result_field
