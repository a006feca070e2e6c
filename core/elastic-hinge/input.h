#pragma once

#include <optional>
#include <string>
#include <vector>

#include "case-file/range.h"
#include "elastic-hinge/mechanism.h"
#include "numerics/constants.h"

/// Slider-crank mechanism with elastic hinges of prescribed characteristics.
///
/// Source: [zotov-sviridov] of the bibliography; equation numbers below are that paper's.
///
/// The crank axis is the origin, the slider moves along +x, gravity along −y; φ is the crank angle
/// from the slider line, counter-clockwise. A is the crankpin, B the slider pin. A hinge is a
/// spring of free length ℓ₀ whose two ends roll on guides of polar radius ρ; the spring's energy is
/// ½ c (ℓ₀ − 2ρ)².
namespace ravnoves::elastic_hinge {

/// The inputs that are one number, with the ranges that case file and form share. The upper and
/// lower ends are far beyond any machine; they keep every product within double.
namespace field {
inline constexpr double millimetre = 1e-3;  ///< m per mm
inline constexpr double micrometre = 1e-6;  ///< m per µm
/// Of the objects weights_N and masses_kg: crank, rod, slider. Together they must be more than 0.
inline constexpr FieldSpec weight{"", "N", Range::between(0, 1e9)};
inline constexpr FieldSpec mass{"", "kg", Range::between(0, 1e8)};
inline constexpr FieldSpec gravity{"gravity_m_s2", "m/s²", Range::between(1e-3, 1e3)};
/// Where masses are given, gravity may be 0 (the mechanism lies flat).
inline constexpr FieldSpec gravity_with_masses{"gravity_m_s2", "m/s²", Range::between(0, 1e3)};
inline constexpr FieldSpec crank_radius{"crank_radius_mm", "mm", Range::between(1e-3, 1e5),
                                        millimetre};
inline constexpr FieldSpec lambda{"lambda", "", Range::between(1e-6, 1)};
inline constexpr FieldSpec angular_speed{"angular_speed_rad_s", "rad/s", Range::between(0, 1e6)};
// Of the objects spring and rod_hinge_spring.
inline constexpr FieldSpec stiffness{"stiffness_N_m", "N/m", Range::between(1e-3, 1e15)};
inline constexpr FieldSpec free_length{"free_length_mm", "mm", Range::between(1e-3, 1e6),
                                       millimetre};
inline constexpr FieldSpec guide_radius{"guide_radius_at_zero_mm", "mm", Range::between(1e-6, 1e6),
                                        millimetre};
// Of the object rod_counterweight.
inline constexpr FieldSpec counterweight_distance{"distance_mm", "mm", Range::between(1e-3, 1e5),
                                                  millimetre};
inline constexpr FieldSpec counterweight_weight{"weight_N", "N", Range::between(0, 1e12)};
inline constexpr FieldSpec counterweight_mass{"mass_kg", "kg", Range::between(0, 1e11)};
// Of the making of the guide.
inline constexpr FieldSpec roller_radius{"roller_radius_mm", "mm", Range::between(0, 1e5),
                                         millimetre};
inline constexpr FieldSpec profile_error{"profile_error_um", "µm", Range::between(0, 1e4),
                                         micrometre};
inline constexpr int smallest_waves = 1;
inline constexpr int largest_waves = 1000;
// Of the object guide_search.
inline constexpr FieldSpec wanted_relief{"relief_mm", "mm", Range::between(1e-6, 1e5), millimetre};
inline constexpr FieldSpec outer_diameter{"outer_diameter_mm", "mm", Range::between(1e-3, 1e6),
                                          millimetre};
inline constexpr FieldSpec smallest_spring_length{"smallest_spring_length_mm", "mm",
                                                  Range::between(0, 1e6), millimetre};
// Of the object motion.
inline constexpr FieldSpec turns{"turns", "", Range::between(0.01, 1000)};
inline constexpr FieldSpec start_speed{"start_speed_rad_s", "rad/s", Range::between(-1e6, 1e6)};
inline constexpr FieldSpec start_angle{"start_angle_deg", "°", Range::between(-3600, 3600), degree};
inline constexpr FieldSpec crank_torque{"crank_torque_Nm", "N·m", Range::between(-1e9, 1e9)};
}  // namespace field

/// Which way the guide stores energy.
enum class GuideSign {
    energy,      ///< Π = const − (T + V): the spring gives out what the mechanism takes up
    as_printed,  ///< Π = const + (T + V), the paper's (1): drawable, keeps no speed constant
};

/// The spring of one hinge.
struct Spring {
    double stiffness = 0.0;             ///< c, N/m
    double free_length = 0.0;           ///< ℓ₀, m
    double guide_radius_at_zero = 0.0;  ///< ρ₀ at φ = 0, m; below ℓ₀/2 compressed, above stretched

    double preload() const;  ///< |ℓ₀/2 − ρ₀|, m: half the change of the spring's length at φ = 0
    bool operator==(const Spring&) const = default;
};

/// A counterweight on the rod, beyond the crankpin.
struct RodCounterweight {
    double distance = 0.0;       ///< ℓ₂ from A, m
    std::optional<double> mass;  ///< kg; empty: solved from (10)
    CounterweightInertia inertia = CounterweightInertia::as_printed;
    bool operator==(const RodCounterweight&) const = default;
};

/// What a search for a guide that can be made is asked for.
struct GuideWish {
    double relief = 1e-3;          ///< wanted max ρ − min ρ, m
    double outer_diameter = 0.25;  ///< the profile must fit in, m
    /// m; the spring gets no shorter than that (its solid length). Empty: 0.4 ℓ₀.
    std::optional<double> smallest_spring_length;
    bool operator==(const GuideWish&) const = default;
};

/// Which hinges a motion is computed with.
enum class HingeSet {
    none,           ///< the bare mechanism
    crank,          ///< between frame and crank, for M
    crank_and_rod,  ///< between crank and rod for M₁₂, and between frame and crank for M₁
};

/// What a forward motion starts from.
struct MotionWish {
    double turns = 5.0;                 ///< of the crank, > 0
    std::optional<double> start_speed;  ///< rad/s; empty: the design speed ω
    double start_angle = 0.0;           ///< rad
    double crank_torque = 0.0;          ///< constant moment on the crank, N·m
    bool with_profile_error = false;    ///< the guide as made, with the input's profile error
    bool operator==(const MotionWish&) const = default;
};

/// The input of the scene.
struct Input {
    double crank_mass = 0.0;                    ///< P₁/g, kg
    double rod_mass = 0.0;                      ///< P₂/g, kg
    double slider_mass = 0.0;                   ///< P₃/g, kg
    bool masses_as_weights = true;              ///< the case gives weights (N), not masses (kg)
    double gravity = standard_gravity;          ///< m/s²
    double crank_radius = 0.0;                  ///< r, m
    double lambda = 0.0;                        ///< r/ℓ; below 1 for the exact kinematics
    double angular_speed = 0.0;                 ///< ω that the hinges are designed for, rad/s
    Kinematics kinematics = Kinematics::exact;  ///< of M₁₂ and what follows from it
    GuideSign guide_sign = GuideSign::energy;
    std::optional<Spring> spring;            ///< of the crank's hinge
    std::optional<Spring> rod_hinge_spring;  ///< of the rod's hinge; empty: the crank's again
    std::optional<RodCounterweight> rod_counterweight;
    double roller_radius = 0.0;   ///< m; ρ is the path of the roller's centre
    double profile_error = 5e-6;  ///< amplitude of the profile's waves, m
    int profile_error_waves = 2;  ///< waves in one turn of the guide
    std::optional<GuideWish> guide_search;
    std::optional<MotionWish> motion;

    bool operator==(const Input&) const = default;
};

/// Checks every range of `field`, and what fields rule out together.
/// @throws InputError that names the JSON pointer as a case would have it
void check_input(const Input& input);

/// The input's mechanism, with the counterweight's mass given or solved.
/// @throws InputError where the solved counterweight is beyond the range of weights
Mechanism<double> mechanism_of(const Input& input);

}  // namespace ravnoves::elastic_hinge
