#pragma once

#include <array>

#include "case-file/field.h"

/// The inputs of the scene, each described once. The upper and lower ends of the ranges are far
/// beyond any machine; they keep every product within double.
namespace ravnoves::elastic_hinge::field {

/// The choice between the objects weights_N and masses_kg.
inline constexpr Field given_as{
    .key = "masses_given_as",
    .label = Text::tr("Given &as"),
    .hint = Text::tr("With masses, gravity may be 0 (horizontal mechanism)."),
};
inline constexpr Field weights{.key = "weights_N",
                               .hint = Text::tr("Weights of crank, rod and slider.")};
inline constexpr Field masses{
    .key = "masses_kg", .hint = Text::tr("Masses of crank, rod and slider, instead of weights.")};

inline constexpr Range weight_range = Range::between(0, 1e9);  ///< N
// Together they must be more than 0. The unit of weights is made with gravity, by as_weight().
inline constexpr Field crank_weight{
    .key = "crank",
    .range = weight_range,
    .label = Text::tr("C&rank P₁"),
    .symbol = "P₁",
    .hint = Text::tr("The crank is a uniform bar of length r."),
};
inline constexpr Field rod_weight{
    .key = "rod",
    .range = weight_range,
    .label = Text::tr("Ro&d P₂"),
    .symbol = "P₂",
    .hint = Text::tr("The rod is a uniform bar of length r/λ."),
};
inline constexpr Field slider_weight{
    .key = "slider",
    .range = weight_range,
    .label = Text::tr("S&lider P₃"),
    .symbol = "P₃",
    .hint = Text::tr("All parts that move along the slider line."),
};
constexpr Field as_mass(Field weight, Text label, std::string_view symbol) {
    weight.unit = units::kg;
    weight.range = Range::between(0, 1e8);
    weight.label = label;
    weight.symbol = symbol;
    return weight;
}
inline constexpr Field crank_mass = as_mass(crank_weight, Text::tr("C&rank m₁"), "m₁");
inline constexpr Field rod_mass = as_mass(rod_weight, Text::tr("Ro&d m₂"), "m₂");
inline constexpr Field slider_mass = as_mass(slider_weight, Text::tr("S&lider m₃"), "m₃");
inline constexpr Field gravity{
    .key = "gravity_m_s2",
    .range = Range::between(1e-3, 1e3),
    .label = Text::tr("&Gravity g"),
    .symbol = "g",
    .hint = Text::tr("The standard value is 9.80665 m/s²."),
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
    .label = Text::tr("&Crank radius r"),
    .symbol = "r",
    .hint = Text::tr("From the crank's axis to the crankpin; the rod is r/λ long."),
};
inline constexpr Field lambda{
    .key = "lambda",
    .range = Range::between(1e-6, 1),
    .label = Text::tr("Ratio λ"),
    .symbol = "λ",
    .hint = Text::tr("Crank radius to rod length, below 1 (1 with the series only)."),
};
inline constexpr Field angular_speed{
    .key = "angular_speed_rad_s",
    .range = Range::between(0, 1e6),
    .label = Text::tr("Crank speed"),
    .symbol = "ω",
    .hint = Text::tr("Design speed of the hinges."),
};
inline constexpr std::array kinematics_words{
    Word{"exact", Text::tr("exact")},
    Word{"series", Text::tr("paper's series")},
};
inline constexpr Field kinematics{
    .key = "kinematics",
    .label = Text::tr("&Kinematics of M₁₂"),
    .hint = Text::tr("The paper's series for cos ψ is accurate for small λ only; the exact form "
                     "needs λ < 1. M and the crank's guide are always exact."),
    .words = kinematics_words,
};
inline constexpr std::array guide_sign_words{
    Word{"energy", Text::tr("keeps the energy")},
    Word{"as-printed", Text::tr("as printed (1)")},
};
inline constexpr Field guide_sign{
    .key = "guide_sign",
    .label = Text::tr("Sign of the g&uide"),
    .hint = Text::tr("For constant crank speed the spring releases the energy that the mechanism "
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

inline constexpr Field spring{.key = "spring",
                              .hint = Text::tr("The spring of the crank's hinge.")};
inline constexpr Field stiffness{
    .key = "stiffness_N_m",
    .range = Range::between(1e-3, 1e15),
    .label = Text::tr("Stiffness"),
    .symbol = "c",
    .hint = Text::tr("Stiffness of the spring of the crank's hinge. A softer "
                     "spring gives more relief."),
};
inline constexpr Field free_length{
    .key = "free_length_mm",
    .range = Range::between(1e-3, 1e6),
    .label = Text::tr("&Free length ℓ₀"),
    .symbol = "ℓ₀",
    .hint = Text::tr("Unloaded length of the spring of the crank's hinge."),
    .placeholder = Text::tr("none"),
};
inline constexpr Field guide_radius{
    .key = "guide_radius_at_zero_mm",
    .range = Range::between(1e-6, 1e6),
    .label = Text::tr("Guide radius ρ₀"),
    .symbol = "ρ₀",
    .hint = Text::tr(
        "Radius of the guide at φ = 0: below ℓ₀/2 the spring is compressed, above it stretched."),
};
inline constexpr Field rod_hinge_spring{
    .key = "rod_hinge_spring",
    .label = Text::tr("Own spring for the rod's &hinge"),
    .hint = Text::tr("If off, the rod's hinge has the same spring as the crank's hinge"),
};
inline constexpr Field rod_stiffness =
    named(stiffness, Text::tr("Its &stiffness c"), Text::tr("Value of the rod hinge's own spring"));
inline constexpr Field rod_free_length =
    named(free_length, Text::tr("Its free length &ℓ₀"), rod_stiffness.hint);
inline constexpr Field rod_guide_radius =
    named(guide_radius, Text::tr("Its radius ρ&₀"),
          Text::tr("Radius of the rod hinge's own guide at θ = 0"));

inline constexpr Field rod_counterweight{
    .key = "rod_counterweight",
    .label = Text::tr("Counter&weight beyond the crankpin"),
    .hint = Text::tr("Counterweight at the distance ℓ₂ beyond the crankpin (slider above). With "
                     "the weight of (10) the rod's hinge makes the side force zero."),
};
inline constexpr Field counterweight_distance{
    .key = "distance_mm",
    .range = Range::between(1e-3, 1e5),
    .label = Text::tr("Counterweight's distance"),
    .symbol = "ℓ₂",
    .hint = Text::tr("From the crankpin to the counterweight on the rod."),
};
inline constexpr Field counterweight_weight{
    .key = "weight_N",
    .range = Range::between(0, 1e12),
    .label = Text::tr("Weight P&₄"),
    .symbol = "P₄",
    .if_empty = Text::tr("solved from (10), P₄ ℓ₂ = (P₃ + P₂/2) ℓ, for zero mean of M₁₂"),
    .placeholder = Text::tr("by (10)"),
};
inline constexpr Field counterweight_mass{
    .key = "mass_kg",
    .range = Range::between(0, 1e11),
    .label = Text::tr("Mass m&₄"),
    .symbol = "m₄",
    .if_empty = counterweight_weight.if_empty,
    .placeholder = counterweight_weight.placeholder,
};
inline constexpr std::array counterweight_inertia_words{
    Word{"as-printed", Text::tr("as printed (9)")},
    Word{"newton-euler", Text::tr("Newton–Euler")},
};
inline constexpr Field counterweight_inertia{
    .key = "inertia",
    .label = Text::tr("&Inertia in M₁₂"),
    .hint = Text::tr("Equation (9) as printed has the wrong sign of the counterweight's inertia "
                     "forces; Newton–Euler makes the side force zero."),
    .words = counterweight_inertia_words,
};

inline constexpr Field roller_radius{
    .key = "roller_radius_mm",
    .range = Range::between(0, 1e5),
    .label = Text::tr("Roller radi&us"),
    .hint = Text::tr("ρ is the path of the roller's centre; the profile is offset by the roller's "
                     "radius. Paper: 0."),
};
inline constexpr Field profile_error{
    .key = "profile_error_um",
    .range = Range::between(0, 1e4),
    .label = Text::tr("Profile error"),
    .hint = Text::tr(
        "Amplitude of the waves of the manufactured profile. Good grinding: a few micrometres."),
};
inline constexpr Field profile_error_waves{
    .key = "profile_error_waves",
    .range = Range::between(1, 1000),
    .label = Text::tr("Error &waves"),
    .hint = Text::tr("Number of error waves in one turn, a whole number: 1 is an eccentric guide, "
                     "2 an oval guide."),
};

inline constexpr Field guide_search{.key = "guide_search",
                                    .hint = Text::tr("Search for a spring with a feasible guide.")};
inline constexpr Field wanted_relief{
    .key = "relief_mm",
    .range = Range::between(1e-6, 1e5),
    .label = Text::tr("R&elief"),
    .hint = Text::tr("Maximum minus minimum radius of the guide"),
};
inline constexpr Field outer_diameter{
    .key = "outer_diameter_mm",
    .range = Range::between(1e-3, 1e6),
    .label = Text::tr("&Outer diameter"),
    .hint = Text::tr("Guide and rollers must fit in this diameter"),
};
inline constexpr Field smallest_spring_length{
    .key = "smallest_spring_length_mm",
    .range = Range::between(0, 1e6),
    .label = Text::tr("&Shortest spring"),
    .hint = Text::tr("Minimum length of the spring (solid length)."),
    .if_empty = Text::tr("0.4 ℓ₀"),
    .placeholder = Text::tr("0.4 ℓ₀"),
};
inline constexpr Field preload_margin{
    .key = "preload_margin_mm",
    .range = Range::between(0, 1e3),
    .label = Text::tr("Preload &margin"),
    .hint = Text::tr("Preload beyond the guide's minimum."),
};

inline constexpr Field motion{.key = "motion", .hint = Text::tr("Motion, by integration.")};
inline constexpr Field turns{
    .key = "turns",
    .range = Range::between(0.01, 1000),
    .label = Text::tr("Tur&ns"),
    .hint = Text::tr("Turns of the crank to compute"),
    .is_setting = true,
};
inline constexpr Field start_speed{
    .key = "start_speed_rad_s",
    .range = Range::between(-1e6, 1e6),
    .label = Text::tr("Off-design sp&eed"),
    .hint = Text::tr("Start speed for comparison with the design speed ω, the only speed at which "
                     "the hinge is exact."),
    .if_empty = Text::tr("ω; the page compares it with 1.2 ω"),
    .placeholder = Text::tr("1.2 ω"),
};
inline constexpr Field start_angle{
    .key = "start_angle_deg",
    .range = Range::between(-3600, 3600),
    .label = Text::tr("S&tart angle"),
    .hint = Text::tr("Crank angle at which the motion starts"),
};
inline constexpr Field crank_torque{
    .key = "crank_torque_Nm",
    .range = Range::between(-1e9, 1e9),
    .label = Text::tr("&Moment on the crank"),
    .hint = Text::tr("A constant moment that drives the crank; negative brakes it"),
};
inline constexpr Field with_profile_error{
    .key = "with_profile_error",
    .label = Text::tr("With the profile &error"),
    .hint = Text::tr("Uses the manufactured guide, with the waves of the profile error"),
};

// Of a guide's drawing and table; not in the case file.
inline constexpr Field chord_tolerance{
    .key = "chord_tolerance_mm",
    .range = Range::between(1e-5, 1),
    .label = Text::tr("Chord to&lerance"),
    .hint = Text::tr("DXF: maximum distance of the polyline from the curve"),
};
inline constexpr Field table_step{
    .key = "step_deg",
    .range = Range::between(0.01, 90),
    .label = Text::tr("S&tep of the table"),
    .hint = Text::tr("CSV: step of the crank angle"),
};

/// A field of weights: its SI value is the mass, which gravity (m/s², > 0) makes of them.
constexpr Field as_weight(Field field, double gravity) {
    field.unit = {units::newton.name, 1.0 / gravity};
    return field;
}

}  // namespace ravnoves::elastic_hinge::field
