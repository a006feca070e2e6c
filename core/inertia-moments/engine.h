#pragma once

#include <cstddef>
#include <vector>

#include "case-file/message.h"
#include "inertia-moments/input.h"
#include "inertia-moments/rods.h"
#include "numerics/slider_crank.h"

namespace ravnoves::inertia_moments {

using Complex = std::complex<double>;  ///< a vector in the front view: x + iy

/// What the calculations run on: an input with its layout turned into cylinders and its rod
/// reduced to two masses and the couple that they leave out.
struct Engine {
    double crank_radius = 0.0;        ///< R, m
    double lambda = 0.0;              ///< R/L
    double angular_speed = 0.0;       ///< ω, rad/s
    double reciprocating_mass = 0.0;  ///< kg, with the rod's share m c/L
    double rotating_mass = 0.0;       ///< kg, of one cylinder, with the rod's share m (1 − c/L)
    /// J − m c (L − c), kg·m²: the rod's inertia above the two masses'. It acts on the roll moment
    /// and the torque only.
    double rod_couple_inertia = 0.0;
    double reference_position = 0.0;  ///< m
    std::vector<Cylinder> cylinders;  ///< their articulated rods complete
    std::vector<Throw> throws;        ///< the crankpins with their rods

    /// kg on a crankpin, at the radius R
    double mass_on(const Throw& pin) const {
        return rotating_mass * static_cast<double>(pin.cylinders.size());
    }
    /// m_j R ω², N
    double force_unit() const {
        return reciprocating_mass * crank_radius * angular_speed * angular_speed;
    }
    /// The mechanism that a cylinder has with a rod on the crankpin, in units of R.
    SliderCrank<double> mechanism(const Cylinder& cylinder) const {
        return {1.0, 1.0 / lambda, cylinder.offset / crank_radius};
    }
    /// α = β₁ + κ − β: the crank's angle from the cylinder's own axis is θ = φ + α. rad
    double crank_phase(const Cylinder& cylinder) const {
        return cylinders.front().bank_angle + cylinder.crankpin_angle - cylinder.bank_angle;
    }
    /// The mechanism of any cylinder by its index, in units of R.
    ArticulatedCrank crank(std::size_t cylinder) const;
    /// θ at its top dead centre, rad.
    double top_dead_centre(std::size_t cylinder) const { return crank(cylinder).top_dead_centre(); }
    double stroke(std::size_t cylinder) const;  ///< m
};

/// Every value of the table rounded to 12 digits in its unit, so that a case file keeps it exactly.
std::vector<Cylinder> rounded(std::vector<Cylinder> cylinders);

/// The smallest 1 − λ(1 + |K|): nearer to locking, the exact orders would take more than a million
/// samples a turn, and a mechanism counts as locked.
inline constexpr double nearest_to_locking = 4e-9;

/// Why the crank of a cylinder, in units of R, cannot turn with the rod on it, as a phrase: "the
/// mechanism of cylinder 1 locks with the crank at 203.5° turning forward and at -23.5° turning
/// back, measured from the cylinder's axis". Empty where it can.
Message locking_of(const SliderCrank<double>& crank, std::size_t cylinder);

/// Reduces the input to the engine, checking the master rods only.
/// @throws InputError as complete_rods()
Engine reduce(const Input& input);

/// The engine of an input that it checks.
/// @throws InputError as check_input()
Engine make_engine(const Input& input);

/// One cylinder's mechanism at one crank angle, in the front view (x + iy, m).
struct CylinderPose {
    Complex crankpin;
    Complex piston_pin;
    Complex rod_foot;          ///< where its rod begins: the crankpin, or the knuckle pin
    bool articulated = false;  ///< its rod hangs on a master rod
    Complex axis_foot;         ///< point of the cylinder's axis nearest to the crank axis
    Complex axis_direction;    ///< unit vector outwards
    double top = 0.0;          ///< piston pin at top dead centre, m along the axis from the foot
    double bottom = 0.0;       ///< and at bottom dead centre
};

/// All cylinders at φ (rad), for the picture.
std::vector<CylinderPose> engine_pose(const Engine& engine, double crank_angle);

}  // namespace ravnoves::inertia_moments
