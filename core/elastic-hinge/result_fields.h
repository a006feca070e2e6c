#pragma once

#include "case-file/result_visitor.h"

/// The values of the hinges' result: keys, units, decimals, names and tips.
namespace ravnoves::elastic_hinge::result_field {

// ------------------------------------------------------------------------------- the whole
inline constexpr ResultField rod_hinge_moment_integral{
    "rod_hinge_moment_integral_J", units::joule, 3, CORE_TEXT("elastic-hinge", "∮ M₁₂ dφ"),
    CORE_TEXT("elastic-hinge",
              "Work of the rod hinge's moment over a turn; 0 if a spring can supply it.")};
inline constexpr ResultField counterweight_weight{
    "counterweight_weight_N", units::newton, 3, CORE_TEXT("elastic-hinge", "Counterweight P₄"),
    CORE_TEXT("elastic-hinge", "Weight on the rod for ∮ M₁₂ dφ = 0, or as entered.")};
inline constexpr ResultField counterweight_mass{
    "counterweight_mass_kg", units::kg, 4, CORE_TEXT("elastic-hinge", "Counterweight P₄"),
    CORE_TEXT("elastic-hinge", "Weight on the rod for ∮ M₁₂ dφ = 0, or as entered.")};
inline constexpr ResultField balancing_weight{"balancing_weight_N", units::newton, 3,
                                              CORE_TEXT("elastic-hinge", "Balancing weight")};
inline constexpr ResultField guide{"guide", units::none, 3,
                                   CORE_TEXT("elastic-hinge", "Crank guide")};
inline constexpr ResultField guide_beside_rod_hinge{
    "guide_beside_rod_hinge", units::none, 3,
    CORE_TEXT("elastic-hinge", "Crank guide with the rod hinge")};
inline constexpr ResultField rod_hinge_guide{"rod_hinge_guide", units::none, 3,
                                             CORE_TEXT("elastic-hinge", "Rod hinge guide")};
inline constexpr ResultField guide_search{"guide_search", units::none, 3,
                                          CORE_TEXT("elastic-hinge", "Proposed guide")};
inline constexpr ResultField side_force{"side_force", units::none, 3,
                                        CORE_TEXT("elastic-hinge", "Side force")};
inline constexpr ResultField series{"series", units::none, 3,
                                    CORE_TEXT("elastic-hinge", "Series against exact")};
inline constexpr ResultField motion{"motion", units::none, 3, CORE_TEXT("elastic-hinge", "Motion")};
inline constexpr ResultField curves{"curves", units::none, 3, CORE_TEXT("elastic-hinge", "Curves")};

// -------------------------------------------------------------------------------- a guide
inline constexpr ResultField preload{"preload_mm", units::mm, 2,
                                     CORE_TEXT("elastic-hinge", "Preload"),
                                     CORE_TEXT("elastic-hinge", "|ℓ₀/2 − ρ₀| of the spring.")};
inline constexpr ResultField minimum_preload{
    "minimum_preload_mm", units::mm, 2, CORE_TEXT("elastic-hinge", "Minimum preload"),
    CORE_TEXT("elastic-hinge", "Minimum |ℓ₀/2 − ρ₀| to store the energy.")};
inline constexpr ResultField minimum_stiffness{"minimum_stiffness_N_m", units::N_per_m, 0,
                                               CORE_TEXT("elastic-hinge", "Minimum stiffness")};
inline constexpr ResultField first_missing_crank_angle{
    "first_missing_crank_angle_deg", units::degree, 1,
    CORE_TEXT("elastic-hinge", "Guide ends at φ")};
inline constexpr ResultField worst_crank_angle{
    "worst_crank_angle_deg", units::degree, 1,
    CORE_TEXT("elastic-hinge", "φ of the maximum energy")};
inline constexpr ResultField branch{"branch", units::none, 3, CORE_TEXT("elastic-hinge", "Branch")};
inline constexpr ResultField relief{
    "relief_mm", units::mm, 4, CORE_TEXT("elastic-hinge", "Relief of the guide"),
    CORE_TEXT("elastic-hinge", "Maximum minus minimum radius of the guide.")};
inline constexpr ResultField spring_travel{
    "spring_travel_mm", units::mm, 3, CORE_TEXT("elastic-hinge", "Spring travel"),
    CORE_TEXT("elastic-hinge", "Maximum minus minimum length of the spring over a turn.")};
inline constexpr ResultField largest_spring_force{
    "largest_spring_force_N", units::newton, 1, CORE_TEXT("elastic-hinge", "Maximum spring force"),
    CORE_TEXT("elastic-hinge", "c |ℓ − ℓ₀|, maximum over a turn.")};
inline constexpr ResultField smallest_spring_force{
    "smallest_spring_force_N", units::newton, 1,
    CORE_TEXT("elastic-hinge", "Minimum spring force")};
inline constexpr ResultField largest_moment{"largest_moment_Nm", units::N_m, 3,
                                            CORE_TEXT("elastic-hinge", "Maximum moment")};
inline constexpr ResultField compressed{"compressed", units::none, 3,
                                        CORE_TEXT("elastic-hinge", "Spring compressed")};
inline constexpr ResultField stretched{"stretched", units::none, 3,
                                       CORE_TEXT("elastic-hinge", "Spring stretched")};
inline constexpr ResultField min_radius{"min_radius_mm", units::mm, 3,
                                        CORE_TEXT("elastic-hinge", "Minimum ρ")};
inline constexpr ResultField max_radius{"max_radius_mm", units::mm, 3,
                                        CORE_TEXT("elastic-hinge", "Maximum ρ")};
inline constexpr ResultField smallest_curvature_radius{
    "smallest_curvature_radius_mm", units::mm, 2,
    CORE_TEXT("elastic-hinge", "Minimum curvature radius"),
    CORE_TEXT("elastic-hinge", "Radius of curvature of the guide; a cutter must be smaller.")};
inline constexpr ResultField largest_roller_radius{
    "largest_roller_radius_mm", units::mm, 2, CORE_TEXT("elastic-hinge", "Maximum roller radius"),
    CORE_TEXT("elastic-hinge", "Maximum radius of a roller that touches the whole guide.")};
inline constexpr ResultField undercut{"undercut", units::none, 3,
                                      CORE_TEXT("elastic-hinge", "Undercut")};
inline constexpr ResultField profile_min_radius{
    "profile_min_radius_mm", units::mm, 3, CORE_TEXT("elastic-hinge", "Minimum profile radius")};
inline constexpr ResultField profile_max_radius{
    "profile_max_radius_mm", units::mm, 3, CORE_TEXT("elastic-hinge", "Maximum profile radius")};
inline constexpr ResultField max_pressure_angle{
    "max_pressure_angle_deg", units::degree, 2,
    CORE_TEXT("elastic-hinge", "Maximum pressure angle")};
inline constexpr ResultField profile_error{"profile_error", units::none, 3,
                                           CORE_TEXT("elastic-hinge", "Profile error")};
inline constexpr ResultField amplitude{"amplitude_um", units::micrometre, 3,
                                       CORE_TEXT("elastic-hinge", "Amplitude")};
inline constexpr ResultField waves{"waves", units::none, 3, CORE_TEXT("elastic-hinge", "Waves")};
inline constexpr ResultField error_torque{
    "torque_Nm", units::N_m, 2, CORE_TEXT("elastic-hinge", "Moment error"),
    CORE_TEXT("elastic-hinge", "Maximum error of the hinge's moment at this profile error.")};
inline constexpr ResultField relative_torque{
    "relative_torque", units::none, 3, CORE_TEXT("elastic-hinge", "Moment error, share"),
    CORE_TEXT("elastic-hinge", "Moment error over the hinge's maximum moment.")};
inline constexpr ResultField error_energy{"energy_J", units::joule, 3,
                                          CORE_TEXT("elastic-hinge", "Energy error")};
inline constexpr ResultField hinge_angle{"hinge_angle_deg", units::degree, 3,
                                         CORE_TEXT("elastic-hinge", "Hinge angle θ")};
inline constexpr ResultField guide_radius_compressed{
    "guide_radius_compressed_mm", units::mm, 3, CORE_TEXT("elastic-hinge", "ρ, spring compressed")};
inline constexpr ResultField guide_radius_stretched{
    "guide_radius_stretched_mm", units::mm, 3, CORE_TEXT("elastic-hinge", "ρ, spring stretched")};

// -------------------------------------------------------------------------- proposed guide
inline constexpr ResultField spring{"spring", units::none, 3, CORE_TEXT("elastic-hinge", "Spring")};
inline constexpr ResultField stiffness{"stiffness_N_m", units::N_per_m, 0,
                                       CORE_TEXT("elastic-hinge", "Stiffness c")};
inline constexpr ResultField free_length{"free_length_mm", units::mm, 3,
                                         CORE_TEXT("elastic-hinge", "Free length ℓ₀")};
inline constexpr ResultField guide_radius_at_zero{"guide_radius_at_zero_mm", units::mm, 3,
                                                  CORE_TEXT("elastic-hinge", "Guide radius ρ₀")};
inline constexpr ResultField outer_diameter{"outer_diameter_mm", units::mm, 1,
                                            CORE_TEXT("elastic-hinge", "Outer diameter")};
inline constexpr ResultField smallest_spring_length{
    "smallest_spring_length_mm", units::mm, 1, CORE_TEXT("elastic-hinge", "Minimum spring length")};
inline constexpr ResultField largest_spring_energy{
    "largest_spring_energy_J", units::joule, 3,
    CORE_TEXT("elastic-hinge", "Maximum spring energy")};

// ------------------------------------------------------------------------------ side force
inline constexpr ResultField largest_without_hinge{
    "largest_without_hinge_N", units::newton, 1, CORE_TEXT("elastic-hinge", "Side force, no hinge"),
    CORE_TEXT("elastic-hinge", "Maximum force of the slider on its guide.")};
inline constexpr ResultField largest_with_hinge{
    "largest_with_hinge_N", units::newton, 2, CORE_TEXT("elastic-hinge", "Side force, rod hinge"),
    CORE_TEXT("elastic-hinge", "Maximum force of the slider on its guide with the rod hinge.")};
inline constexpr ResultField largest_by_newton_euler{
    "largest_by_newton_euler_N", units::newton, 2,
    CORE_TEXT("elastic-hinge", "Side force by Newton–Euler")};
inline constexpr ResultField reduction_factor{
    "reduction_factor", units::none, 1, CORE_TEXT("elastic-hinge", "Side force, reduction factor")};
inline constexpr ResultField largest_cos_psi_error{
    "largest_cos_psi_error", units::none, 6, CORE_TEXT("elastic-hinge", "Maximum error of cos ψ")};
inline constexpr ResultField at_crank_angle{"at_crank_angle_deg", units::degree, 1,
                                            CORE_TEXT("elastic-hinge", "φ of the maximum error")};
inline constexpr ResultField largest_rod_hinge_moment_error{
    "largest_rod_hinge_moment_error_Nm", units::N_m, 3,
    CORE_TEXT("elastic-hinge", "Maximum error of M₁₂")};

// ---------------------------------------------------------------------------------- motion
inline constexpr ResultField without_hinge{"without_hinge", units::none, 3,
                                           CORE_TEXT("elastic-hinge", "Without hinge")};
inline constexpr ResultField with_crank_hinge{"with_crank_hinge", units::none, 3,
                                              CORE_TEXT("elastic-hinge", "Crank hinge")};
inline constexpr ResultField with_both_hinges{"with_both_hinges", units::none, 3,
                                              CORE_TEXT("elastic-hinge", "Both hinges")};
inline constexpr ResultField end{"end", units::none, 3,
                                 CORE_TEXT("elastic-hinge", "End of the motion")};
inline constexpr ResultField time{"time_s", units::second, 3, CORE_TEXT("elastic-hinge", "Time")};
inline constexpr ResultField end_crank_angle{"crank_angle_deg", units::degree, 1,
                                             CORE_TEXT("elastic-hinge", "Crank angle φ")};
inline constexpr ResultField speed{"speed_rad_s", units::rad_per_s, 3,
                                   CORE_TEXT("elastic-hinge", "Speed")};
inline constexpr ResultField mean_speed{"mean_speed_rad_s", units::rad_per_s, 3,
                                        CORE_TEXT("elastic-hinge", "Mean speed")};
inline constexpr ResultField min_speed{"min_speed_rad_s", units::rad_per_s, 3,
                                       CORE_TEXT("elastic-hinge", "Minimum speed")};
inline constexpr ResultField max_speed{"max_speed_rad_s", units::rad_per_s, 3,
                                       CORE_TEXT("elastic-hinge", "Maximum speed")};
inline constexpr ResultField speed_ripple{
    "speed_ripple", units::none, 5, CORE_TEXT("elastic-hinge", "Speed ripple"),
    CORE_TEXT("elastic-hinge", "(ω_max − ω_min) / ω mean of the free motion.")};
inline constexpr ResultField energy_drift{"energy_drift", units::none, 3,
                                          CORE_TEXT("elastic-hinge", "Energy drift")};
inline constexpr ResultField steps{"steps", units::none, 3, CORE_TEXT("elastic-hinge", "Steps")};

// ---------------------------------------------------------------------------------- curves
inline constexpr ResultField crank_angle{"crank_angle_deg", units::none, 3,
                                         CORE_TEXT("elastic-hinge", "Crank angle φ")};
inline constexpr ResultField reduced_inertia{"reduced_inertia_kg_m2", units::kg_m2, 3,
                                             CORE_TEXT("elastic-hinge", "Reduced inertia")};
inline constexpr ResultField crank_moment{"crank_moment_Nm", units::N_m, 3,
                                          CORE_TEXT("elastic-hinge", "Crank hinge moment M")};
inline constexpr ResultField rod_hinge_moment{"rod_hinge_moment_Nm", units::N_m, 3,
                                              CORE_TEXT("elastic-hinge", "Rod hinge moment M₁₂")};
inline constexpr ResultField rod_hinge_moment_potential{
    "rod_hinge_moment_potential_Nm", units::N_m, 3,
    CORE_TEXT("elastic-hinge", "Rod hinge moment, potential part")};
inline constexpr ResultField side_force_without_hinge{
    "side_force_without_hinge_N", units::newton, 3,
    CORE_TEXT("elastic-hinge", "Side force without hinge")};
inline constexpr ResultField side_force_with_hinge{
    "side_force_with_hinge_N", units::newton, 3,
    CORE_TEXT("elastic-hinge", "Side force with hinge")};
inline constexpr ResultField crank_moment_with_rod_hinge{
    "crank_moment_with_rod_hinge_Nm", units::N_m, 3,
    CORE_TEXT("elastic-hinge", "Crank hinge moment with the rod hinge")};

}  // namespace ravnoves::elastic_hinge::result_field
