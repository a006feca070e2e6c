#pragma once

#include <cmath>
#include <optional>

#include "case-file/json_fwd.h"
#include "elastic-hinge/mechanism.h"
#include "numerics/constants.h"

namespace ravnoves {
class FieldVisitor;
}

/// Slider-crank mechanism with elastic hinges of prescribed characteristics.
///
/// Source: [zotov-sviridov] of the bibliography; equation numbers below are that paper's.
///
/// The crank axis is the origin, the slider moves along +x, gravity along −y; φ is the crank angle
/// from the slider line, counter-clockwise. A is the crankpin, B the slider pin. A hinge is a
/// spring of free length ℓ₀ whose two ends roll on guides of polar radius ρ; the spring's energy is
/// ½ c (ℓ₀ − 2ρ)².
namespace ravnoves::elastic_hinge {

/// Which way the guide stores energy.
enum class GuideSign {
    energy,      ///< Π = const − (T + V): the spring gives out what the mechanism absorbs
    as_printed,  ///< Π = const + (T + V), the paper's (1): drawable, keeps no speed constant
};

/// On which side of its free length the spring works.
enum class Branch {
    compressed,  ///< ρ < ℓ₀/2: minus in (3); the guide is outside the rollers
    stretched,   ///< ρ > ℓ₀/2: plus in (3); the guide is inside the rollers
};

/// The spring of one hinge; the paper's to begin with.
struct Spring {
    double stiffness = 2e7;              ///< c, N/m
    double free_length = 0.2;            ///< ℓ₀, m
    double guide_radius_at_zero = 0.09;  ///< ρ₀ at φ = 0, m; below ℓ₀/2 compressed, above stretched

    /// |ℓ₀/2 − ρ₀|, m: half the change of the spring's length at φ = 0.
    double preload() const { return std::abs(0.5 * free_length - guide_radius_at_zero); }
    /// The branch of ρ₀.
    Branch branch() const {
        return guide_radius_at_zero > 0.5 * free_length ? Branch::stretched : Branch::compressed;
    }
    double start_radius(Branch of) const {  ///< at φ = 0 on a branch, m
        return of == branch() ? guide_radius_at_zero : free_length - guide_radius_at_zero;
    }
    bool operator==(const Spring&) const = default;
};

/// A counterweight on the rod, beyond the crankpin.
struct RodCounterweight {
    double distance = 0.1;       ///< ℓ₂ from A, m
    std::optional<double> mass;  ///< kg; empty: solved from (10)
    CounterweightInertia inertia = CounterweightInertia::newton_euler;
    bool operator==(const RodCounterweight&) const = default;
};

/// What a search for a guide that can be made is asked for.
struct GuideWish {
    double relief = 1e-3;          ///< wanted max ρ − min ρ, m
    double outer_diameter = 0.25;  ///< the profile must fit in, m
    /// m; the spring gets no shorter than that (its solid length). Empty: 0.4 ℓ₀.
    std::optional<double> smallest_spring_length;
    double preload_margin = 1e-4;  ///< of the preload over the smallest that the guide needs, m

    /// The shortest that a spring of this free length may get, m.
    double shortest(double free_length) const {
        return smallest_spring_length.value_or(0.4 * free_length);
    }
    /// At this length it is solid: as entered, else where no coil spring is not, m.
    double solid(double free_length) const {
        return smallest_spring_length.value_or(0.1 * free_length);
    }
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
    double turns = 5.0;                                ///< of the crank, > 0
    std::optional<double> start_speed = std::nullopt;  ///< rad/s; empty: the design speed ω
    double start_angle = 0.0;                          ///< rad
    double crank_torque = 0.0;                         ///< constant moment on the crank, N·m
    bool with_profile_error = false;  ///< the guide as made, with the input's profile error
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

/// The fields of a case, in its order.
void visit_fields(FieldVisitor& visitor, Spring& spring);
void visit_fields(FieldVisitor& visitor, GuideWish& wish);
void visit_fields(FieldVisitor& visitor, MotionWish& wish);
void visit_fields(FieldVisitor& visitor, Input& input);

/// Checks the range of every field, and what fields rule out together.
/// @throws InputError that names the JSON pointer as a case would have it
void check_input(const Input& input);

/// Reads the "input" object of a case, and checks it.
/// @throws InputError that names the JSON pointer
Input read_input(const Json& input);
/// The "input" object that reads back to the same Input.
Json write_input(const Input& input);

/// The input's mechanism, with the counterweight's mass given or solved.
Mechanism<double> mechanism_of(const Input& input);

}  // namespace ravnoves::elastic_hinge
