#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "case-file/message.h"
#include "inertia-moments/articulated_rods.h"
#include "inertia-moments/input.h"
#include "inertia-moments/throws.h"
#include "numerics/slider_crank.h"

namespace ravnoves::inertia_moments {

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

/// A cylinder whose mechanism locks.
struct Locking {
    std::size_t cylinder = 0;  ///< index in the table
    /// Crank angles from the cylinder's axis between which the crank can move, rad; empty where the
    /// rod cannot even be fitted, |e| > R + L.
    std::optional<LockingAngles<double>> angles;
};

/// The first cylinder with a rod on its crankpin whose mechanism locks or is nearer to it than
/// nearest_to_locking, if any is.
std::optional<Locking> find_locking(double crank_radius, double lambda,
                                    const std::vector<Cylinder>& cylinders);

/// Why the crank cannot turn, as a phrase: "the mechanism of cylinder 1 locks with the crank at
/// 203.5° turning forward and at -23.5° turning back, measured from the cylinder's axis".
Message describe(const Locking& locking);

/// Reduces the input to the engine, checking the master rods only.
/// @throws InputError as complete_rods()
Engine reduce(const Input& input);

/// The engine of a checked input.
/// @throws InputError as check_input()
Engine make_engine(const Input& input);

}  // namespace ravnoves::inertia_moments
