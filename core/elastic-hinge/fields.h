#pragma once

#include <array>

#include "case-file/field.h"

/// The inputs of the scene, each described once. The upper and lower ends of the ranges are far
/// beyond any machine; they keep every product within double.
namespace ravnoves::elastic_hinge::field {

/// The choice between the objects weights_N and masses_kg.
inline constexpr Field given_as{
    .key = "masses_given_as",
    .label = CORE_TEXT("elastic-hinge", "Given &as"),
    .hint = CORE_TEXT("elastic-hinge", "With masses, gravity may be 0 (horizontal mechanism)."),
};
inline constexpr Field weights{
    .key = "weights_N", .hint = CORE_TEXT("elastic-hinge", "Weights of crank, rod and slider.")};
inline constexpr Field masses{
    .key = "masses_kg",
    .hint = CORE_TEXT("elastic-hinge", "Masses of crank, rod and slider, instead of weights.")};

inline constexpr Range weight_range = Range::between(0, 1e9);  ///< N
inline constexpr Range mass_range = Range::between(0, 1e8);    ///< kg
inline constexpr Text crank_hint =
    CORE_TEXT("elastic-hinge", "The crank is a uniform bar of length r.");
inline constexpr Text rod_hint =
    CORE_TEXT("elastic-hinge", "The rod is a uniform bar of length r/λ.");
inline constexpr Text slider_hint =
    CORE_TEXT("elastic-hinge", "All parts that move along the slider line.");
// Together they must be more than 0. The unit of weights is made with gravity, by as_weight().
inline constexpr Field crank_weight{
    .key = "crank",
    .range = weight_range,
    .label = CORE_TEXT("elastic-hinge", "C&rank P₁"),
    .symbol = "P₁",
    .hint = crank_hint,
};
inline constexpr Field rod_weight{
    .key = "rod",
    .range = weight_range,
    .label = CORE_TEXT("elastic-hinge", "Ro&d P₂"),
    .symbol = "P₂",
    .hint = rod_hint,
};
inline constexpr Field slider_weight{
    .key = "slider",
    .range = weight_range,
    .label = CORE_TEXT("elastic-hinge", "S&lider P₃"),
    .symbol = "P₃",
    .hint = slider_hint,
};
inline constexpr Field crank_mass{
    .key = "crank",
    .unit = units::kg,
    .range = mass_range,
    .label = CORE_TEXT("elastic-hinge", "C&rank m₁"),
    .symbol = "m₁",
    .hint = crank_hint,
};
inline constexpr Field rod_mass{
    .key = "rod",
    .unit = units::kg,
    .range = mass_range,
    .label = CORE_TEXT("elastic-hinge", "Ro&d m₂"),
    .symbol = "m₂",
    .hint = rod_hint,
};
inline constexpr Field slider_mass{
    .key = "slider",
    .unit = units::kg,
    .range = mass_range,
    .label = CORE_TEXT("elastic-hinge", "S&lider m₃"),
    .symbol = "m₃",
    .hint = slider_hint,
};
inline constexpr Field gravity{
    .key = "gravity_m_s2",
    .range = Range::between(1e-3, 1e3),
    .label = CORE_TEXT("elastic-hinge", "&Gravity g"),
    .symbol = "g",
    .hint = CORE_TEXT("elastic-hinge", "The standard value is 9.80665 m/s²."),
};
/// With masses, gravity may be 0 (a horizontal mechanism).
inline constexpr Field gravity_with_masses = [] {
    Field field = gravity;
    field.range = Range::between(0, 1e3);
    return field;
}();
inline constexpr Field crank_radius{
    .key = "crank_radius_mm",
    .range = Range::between(1e-3, 1e5),
    .label = CORE_TEXT("elastic-hinge", "&Crank radius r"),
    .symbol = "r",
    .hint =
        CORE_TEXT("elastic-hinge", "From the crank's axis to the crankpin; the rod is r/λ long."),
};
inline constexpr Field lambda{
    .key = "lambda",
    .range = Range::between(1e-6, 1),
    .label = CORE_TEXT("elastic-hinge", "Ratio λ"),
    .symbol = "λ",
    .hint =
        CORE_TEXT("elastic-hinge", "Crank radius to rod length, below 1 (1 with the series only)."),
};
inline constexpr Field angular_speed{
    .key = "angular_speed_rad_s",
    .range = Range::between(0, 1e6),
    .label = CORE_TEXT("elastic-hinge", "Crank speed"),
    .symbol = "ω",
    .hint = CORE_TEXT("elastic-hinge", "Design speed of the hinges."),
};
inline constexpr std::array kinematics_words{
    Word{"exact", CORE_TEXT("elastic-hinge", "exact")},
    Word{"series", CORE_TEXT("elastic-hinge", "paper's series")},
};
inline constexpr Field kinematics{
    .key = "kinematics",
    .label = CORE_TEXT("elastic-hinge", "&Kinematics of M₁₂"),
    .hint = CORE_TEXT("elastic-hinge",
                      "The paper's series for cos ψ is accurate for small λ only; the exact form "
                      "needs λ < 1. M and the crank's guide are always exact."),
    .words = kinematics_words,
};
inline constexpr std::array guide_sign_words{
    Word{"energy", CORE_TEXT("elastic-hinge", "keeps the energy")},
    Word{"as-printed", CORE_TEXT("elastic-hinge", "as printed (1)")},
};
inline constexpr Field guide_sign{
    .key = "guide_sign",
    .label = CORE_TEXT("elastic-hinge", "Sign of the g&uide"),
    .hint = CORE_TEXT("elastic-hinge",
                      "For constant crank speed the spring releases the energy that the mechanism "
                      "absorbs: Π = const − (T + V). Equation (1) is printed with a plus."),
    .words = guide_sign_words,
};

/// The same quantity of another part.
constexpr Field named(Field field, Text label, Text hint) {
    field.label = label;
    field.hint = hint;
    field.placeholder = {};
    return field;
}

inline constexpr Field spring{
    .key = "spring", .hint = CORE_TEXT("elastic-hinge", "The spring of the crank's hinge.")};
inline constexpr Field stiffness{
    .key = "stiffness_N_m",
    .range = Range::between(1e-3, 1e15),
    .label = CORE_TEXT("elastic-hinge", "Stiffness"),
    .symbol = "c",
    .hint = CORE_TEXT("elastic-hinge",
                      "Stiffness of the spring of the crank's hinge. A softer "
                      "spring gives more relief."),
};
inline constexpr Field free_length{
    .key = "free_length_mm",
    .range = Range::between(1e-3, 1e6),
    .label = CORE_TEXT("elastic-hinge", "&Free length ℓ₀"),
    .symbol = "ℓ₀",
    .hint = CORE_TEXT("elastic-hinge", "Unloaded length of the spring of the crank's hinge."),
    .placeholder = CORE_TEXT("elastic-hinge", "none"),
};
inline constexpr Field guide_radius{
    .key = "guide_radius_at_zero_mm",
    .range = Range::between(1e-6, 1e6),
    .label = CORE_TEXT("elastic-hinge", "Guide radius ρ₀"),
    .symbol = "ρ₀",
    .hint = CORE_TEXT(
        "elastic-hinge",
        "Radius of the guide at φ = 0: below ℓ₀/2 the spring is compressed, above it stretched."),
};
inline constexpr Field rod_hinge_spring{
    .key = "rod_hinge_spring",
    .label = CORE_TEXT("elastic-hinge", "Own spring for the rod's &hinge"),
    .hint = CORE_TEXT("elastic-hinge",
                      "If off, the rod's hinge has the same spring as the crank's hinge"),
};
inline constexpr Field rod_stiffness =
    named(stiffness, CORE_TEXT("elastic-hinge", "Its &stiffness c"),
          CORE_TEXT("elastic-hinge", "Value of the rod hinge's own spring"));
inline constexpr Field rod_free_length =
    named(free_length, CORE_TEXT("elastic-hinge", "Its free length &ℓ₀"), rod_stiffness.hint);
inline constexpr Field rod_guide_radius =
    named(guide_radius, CORE_TEXT("elastic-hinge", "Its radius ρ&₀"),
          CORE_TEXT("elastic-hinge", "Radius of the rod hinge's own guide at θ = 0"));

inline constexpr Field rod_counterweight{
    .key = "rod_counterweight",
    .label = CORE_TEXT("elastic-hinge", "Counter&weight beyond the crankpin"),
    .hint = CORE_TEXT("elastic-hinge",
                      "Counterweight at the distance ℓ₂ beyond the crankpin (slider above). With "
                      "the weight of (10) the rod's hinge makes the side force zero."),
};
inline constexpr Field counterweight_distance{
    .key = "distance_mm",
    .range = Range::between(1e-3, 1e5),
    .label = CORE_TEXT("elastic-hinge", "Counterweight's distance"),
    .symbol = "ℓ₂",
    .hint = CORE_TEXT("elastic-hinge", "From the crankpin to the counterweight on the rod."),
};
inline constexpr Field counterweight_weight{
    .key = "weight_N",
    .range = Range::between(0, 1e12),
    .label = CORE_TEXT("elastic-hinge", "Weight P&₄"),
    .symbol = "P₄",
    .if_empty =
        CORE_TEXT("elastic-hinge", "solved from (10), P₄ ℓ₂ = (P₃ + P₂/2) ℓ, for zero mean of M₁₂"),
    .placeholder = CORE_TEXT("elastic-hinge", "by (10)"),
};
inline constexpr Field counterweight_mass{
    .key = "mass_kg",
    .range = Range::between(0, 1e11),
    .label = CORE_TEXT("elastic-hinge", "Mass m&₄"),
    .symbol = "m₄",
    .if_empty = counterweight_weight.if_empty,
    .placeholder = counterweight_weight.placeholder,
};
inline constexpr std::array counterweight_inertia_words{
    Word{"as-printed", CORE_TEXT("elastic-hinge", "as printed (9)")},
    Word{"newton-euler", CORE_TEXT("elastic-hinge", "Newton–Euler")},
};
inline constexpr Field counterweight_inertia{
    .key = "inertia",
    .label = CORE_TEXT("elastic-hinge", "&Inertia in M₁₂"),
    .hint = CORE_TEXT("elastic-hinge",
                      "Equation (9) as printed has the wrong sign of the counterweight's inertia "
                      "forces; Newton–Euler makes the side force zero."),
    .words = counterweight_inertia_words,
};

inline constexpr Field roller_radius{
    .key = "roller_radius_mm",
    .range = Range::between(0, 1e5),
    .label = CORE_TEXT("elastic-hinge", "Roller radi&us"),
    .hint = CORE_TEXT("elastic-hinge",
                      "ρ is the path of the roller's centre; the profile is offset by the roller's "
                      "radius. Paper: 0."),
};
inline constexpr Field profile_error{
    .key = "profile_error_um",
    .range = Range::between(0, 1e4),
    .label = CORE_TEXT("elastic-hinge", "Profile error"),
    .hint = CORE_TEXT(
        "elastic-hinge",
        "Amplitude of the waves of the manufactured profile. Good grinding: a few micrometres."),
};
inline constexpr Field profile_error_waves{
    .key = "profile_error_waves",
    .range = Range::between(1, 1000),
    .label = CORE_TEXT("elastic-hinge", "Error &waves"),
    .hint = CORE_TEXT("elastic-hinge",
                      "Number of error waves in one turn, a whole number: 1 is an eccentric guide, "
                      "2 an oval guide."),
};

inline constexpr Field guide_search{
    .key = "guide_search",
    .hint = CORE_TEXT("elastic-hinge", "Search for a spring with a feasible guide.")};
inline constexpr Field wanted_relief{
    .key = "relief_mm",
    .range = Range::between(1e-6, 1e5),
    .label = CORE_TEXT("elastic-hinge", "R&elief"),
    .hint = CORE_TEXT("elastic-hinge", "Maximum minus minimum radius of the guide"),
};
inline constexpr Field outer_diameter{
    .key = "outer_diameter_mm",
    .range = Range::between(1e-3, 1e6),
    .label = CORE_TEXT("elastic-hinge", "&Outer diameter"),
    .hint = CORE_TEXT("elastic-hinge", "Guide and rollers must fit in this diameter"),
};
inline constexpr Field smallest_spring_length{
    .key = "smallest_spring_length_mm",
    .range = Range::between(0, 1e6),
    .label = CORE_TEXT("elastic-hinge", "&Shortest spring"),
    .hint = CORE_TEXT("elastic-hinge", "Minimum length of the spring (solid length)."),
    .if_empty = CORE_TEXT("elastic-hinge", "0.4 ℓ₀"),
    .placeholder = CORE_TEXT("elastic-hinge", "0.4 ℓ₀"),
};
inline constexpr Field preload_margin{
    .key = "preload_margin_mm",
    .range = Range::between(0, 1e3),
    .label = CORE_TEXT("elastic-hinge", "Preload &margin"),
    .hint = CORE_TEXT("elastic-hinge", "Preload beyond the guide's minimum."),
};

inline constexpr Field motion{.key = "motion",
                              .hint = CORE_TEXT("elastic-hinge", "Motion, by integration.")};
inline constexpr Field turns{
    .key = "turns",
    .range = Range::between(0.01, 1000),
    .label = CORE_TEXT("elastic-hinge", "Tur&ns"),
    .hint = CORE_TEXT("elastic-hinge", "Turns of the crank to compute"),
    .is_setting = true,
};
inline constexpr Field start_speed{
    .key = "start_speed_rad_s",
    .range = Range::between(-1e6, 1e6),
    .label = CORE_TEXT("elastic-hinge", "Off-design sp&eed"),
    .hint = CORE_TEXT("elastic-hinge",
                      "Start speed for comparison with the design speed ω, the only speed at which "
                      "the hinge is exact."),
    .if_empty = CORE_TEXT("elastic-hinge", "ω; the page compares it with 1.2 ω"),
    .placeholder = CORE_TEXT("elastic-hinge", "1.2 ω"),
};
inline constexpr Field start_angle{
    .key = "start_angle_deg",
    .range = Range::between(-3600, 3600),
    .label = CORE_TEXT("elastic-hinge", "S&tart angle"),
    .hint = CORE_TEXT("elastic-hinge", "Crank angle at which the motion starts"),
};
inline constexpr Field crank_torque{
    .key = "crank_torque_Nm",
    .range = Range::between(-1e9, 1e9),
    .label = CORE_TEXT("elastic-hinge", "&Moment on the crank"),
    .hint =
        CORE_TEXT("elastic-hinge", "A constant moment that drives the crank; negative brakes it"),
};
inline constexpr Field with_profile_error{
    .key = "with_profile_error",
    .label = CORE_TEXT("elastic-hinge", "With the profile &error"),
    .hint = CORE_TEXT("elastic-hinge",
                      "Uses the manufactured guide, with the waves of the profile error"),
};

// Of a guide's drawing and table; not in the case file.
inline constexpr Field chord_tolerance{
    .key = "chord_tolerance_mm",
    .range = Range::between(1e-5, 1),
    .label = CORE_TEXT("elastic-hinge", "Chord to&lerance"),
    .hint = CORE_TEXT("elastic-hinge", "DXF: maximum distance of the polyline from the curve"),
};
inline constexpr Field table_step{
    .key = "step_deg",
    .range = Range::between(0.01, 90),
    .label = CORE_TEXT("elastic-hinge", "S&tep of the table"),
    .hint = CORE_TEXT("elastic-hinge", "CSV: step of the crank angle"),
};

/// A field of weights: its SI value is the mass, which gravity (m/s², > 0) makes of them.
constexpr Field as_weight(Field field, double gravity) {
    field.unit = {units::newton.name, 1.0 / gravity};
    return field;
}

}  // namespace ravnoves::elastic_hinge::field
