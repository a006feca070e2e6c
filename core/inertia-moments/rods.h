#pragma once

#include <cmath>
#include <complex>
#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "case-file/field.h"
#include "case-file/message.h"
#include "inertia-moments/input.h"
#include "numerics/slider_crank.h"

namespace ravnoves::inertia_moments {

/// A throw of the crank: one crankpin with the rods that run on it.
struct Throw {
    std::vector<std::size_t> cylinders;  ///< indices in the table, from the front to the rear
    double position = 0.0;               ///< mean axial position of its rods, m
    double crankpin_angle = 0.0;         ///< κ, rad
};

/// "1, 4" of indices.
std::string numbers_of(std::span<const std::size_t> cylinders);

/// The throws, from the front to the rear. Rods share a crankpin where it is at the same angle for
/// both, their cylinders are in different directions, and they are less than the crank radius apart
/// along the crank (0 where they are forked, else the width of a big end).
std::vector<Throw> crank_throws(std::span<const Cylinder> cylinders, double crank_radius);

/// By each number of rods, from the fewest to the most, the first throw with it.
std::map<std::size_t, const Throw*> kinds_of_throw(std::span<const Throw> throws);

/// The motion of a cylinder whose rod hangs on a master rod, by its own crank angle θ, in units of
/// R. Vectors are complex: along the cylinder's axis + i across it, counter-clockwise.
struct ArticulatedMotion {
    PistonMotion<double> piston;  ///< s, s′, s″ of its piston pin
    std::complex<double> arm;     ///< from the crankpin to the knuckle pin
    std::complex<double> darm;    ///< d/dθ
    std::complex<double> d2arm;   ///< d²/dθ²
};

/// The mechanism of a cylinder in units of R, its rod on a master rod or on the crankpin itself.
///
/// The crankpin is at e^{iθ} from the cylinder's axis; the master rod swings by its own
/// slider-crank, sin ψ = λ(K_m − sin θ_m) with θ_m = θ + β − β_m, and carries the knuckle pin:
/// q = e^{iθ} + ρ e^{i(ψ + c)}, ρ = r_k/R, c = γ − (β − β_m). The piston pin closes the loop on
/// its axis, s = Re q + √(l² − (Im q − K)²). Derived from the geometry alone; with ρ = 0 it is the
/// plain slider-crank. The tests derive it a second way, by Newton's method in 50 digits.
struct ArticulatedCrank {
    SliderCrank<double> master;        ///< {1, 1/λ, K_m}; must not lock
    std::complex<double> master_lead;  ///< e^{i(θ_m − θ)} = e^{i(β − β_m)}
    std::complex<double> knuckle;      ///< ρ e^{ic}: the pin from the crankpin while ψ = 0
    double rod_length = 0.0;           ///< l/R
    double offset = 0.0;               ///< K = e/R

    /// Exact, from sin θ and cos θ. Neither mechanism may lock.
    ArticulatedMotion at(double sin_theta, double cos_theta) const;
    /// With the cosines of both rods' angles as 1 − half the square, as in the paper's two-term
    /// form, which this is for ρ = 0: the force has orders 1 and 2 only. The error of s″ is of the
    /// third order in λ and R/l.
    ArticulatedMotion two_term_at(double sin_theta, double cos_theta) const;

    double top_dead_centre() const;     ///< θ of the maximum s, rad in −π…π
    double bottom_dead_centre() const;  ///< θ where s is smallest, rad in 0…2π
    double stroke() const;              ///< maximum minus minimum s

    /// Farthest distance of the knuckle pin from the cylinder's axis, |Im q − K|: the rod must be
    /// longer.
    double reach() const;

  private:
    bool is_plain() const { return knuckle == 0.0; }
    SliderCrank<double> plain() const { return {1.0, rod_length, offset}; }
    ArticulatedMotion at(double theta) const { return at(std::sin(theta), std::cos(theta)); }
    double dead_centre(double side) const;
};

/// JSON pointer of a field of a cylinder's articulated rod.
std::string rod_pointer(std::size_t cylinder, const Field& field);

/// Fills in what the input leaves out of articulated rods: the master, where one plain rod alone
/// runs on the same pin; γ, the difference of the bank angles; l, the master rod's length less r_k.
/// They run on the master's crankpin, whatever rounding left in the table.
/// @throws InputError at the cylinder's field: a master that is not there, is itself articulated or
/// runs on another pin, or that must be named; a knuckle radius of a rod's length
void complete_rods(std::vector<Cylinder>& cylinders, std::span<const Throw> throws,
                   double rod_length);

/// The usual knuckle radius of a radial: the pins are close round the crankpin's bearing.
inline constexpr double usual_knuckle_share = 0.75;  ///< of the crank radius

/// Hangs the rods of each throw on the rod of its first cylinder, as in a radial; throws with one
/// rod are unchanged.
void hang_on_masters(std::vector<Cylinder>& cylinders, double crank_radius);

}  // namespace ravnoves::inertia_moments
