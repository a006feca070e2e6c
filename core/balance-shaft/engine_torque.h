#pragma once

#include <optional>
#include <vector>

#include "balance-shaft/cylinder_gas.h"
#include "balance-shaft/inertia_check.h"
#include "balance-shaft/input.h"
#include "numerics/periodic_piecewise.h"
#include "numerics/slider_crank.h"

namespace ravnoves::balance_shaft {

/// The mechanism of an input. Crank angles φ of inputs and results count from the true top dead
/// centre, so its θ is φ + top_dead_centre().
SliderCrank<double> slider_crank(const Input& input);

/// The gas side of an input whose torque is computed, else nothing.
/// @throws InputError where the cycle cannot be
std::optional<CylinderGas> cylinder_gas(const Input& input);

/// Fills in what a computed torque needs and the input lacks: the default length of the rod and
/// bore.
void fill_cylinder(Input& input);

/// Takes the torque from another source. Missing inputs of a computed torque are filled in; a cycle
/// without a load gets the load of the previous torque.
/// @param mean_torque  of the previous torque, N·m, driving where positive
void take_torque_kind(Input& input, TorqueSource::Kind kind, double mean_torque);

/// Engine torque over the crank angle in degrees, in the part that follows the speed and the part
/// that does not: M_id = gas + ω² unit_inertia. What an offset cylinder adds to the tipping moment
/// is in neither (with_offset_term()).
struct TorqueParts {
    PeriodicPiecewise gas;           ///< N·m
    PeriodicPiecewise unit_inertia;  ///< −m_j s′ s″, N·m s², with the same knots

    PeriodicPiecewise at(double angular_speed) const {
        return PeriodicPiecewise::sum(gas, unit_inertia, angular_speed * angular_speed);
    }
};

/// Of an input whose torque is computed: cubics between every 0.5° and every place where the
/// pressure has a kink, so that the curve is the torque itself to about 1e-5 of its range, whatever
/// interpolation a table would have.
TorqueParts torque_parts(const Input& input, const CylinderGas& gas);

/// The parts of a table that belongs to the masses and the speed entered: its fitted inertia torque
/// and the rest. Nothing where it does not belong to them.
std::optional<TorqueParts> torque_parts(const Input& input, const InertiaCheck& check);

/// M_id of a table over the crank angle in degrees, by the interpolation asked for.
PeriodicPiecewise torque_curve(const TorqueTable& table, Interpolation interpolation);

/// First order of the piston's acceleration: s″ = −r₁ cos(θ − δ) + higher orders, θ from the
/// crank's position along the cylinder.
///
/// A centred crank has r₁ = r and δ = 0. An offset one has a part in quadrature, so its first-order
/// inertia force m_j r₁ ω² cos(θ − δ) cannot be met by counterweights opposite the crankpin: both
/// must lag by δ behind that direction.
struct PistonFirstOrder {
    double radius = 0.0;  ///< r₁, m
    double lag = 0.0;     ///< δ, rad
};

/// The first Fourier coefficients of the exact s″. The mechanism must not lock.
PistonFirstOrder piston_first_order(const SliderCrank<double>& crank);

/// e s″(θ), m²: the moment about the crank axis that an offset cylinder adds to the engine block,
/// per unit of m_j ω².
///
/// On the block act the gas force on the head, −e F_g about the crank axis, the piston's side force
/// N on the wall, s N, and the bearing forces, which have no lever. With N = F_rod,x and
/// F_rod,y = F_g + m_j ω² s″ this is −M_id + e m_j ω² s″: the reciprocating masses have angular
/// momentum about the crank axis.
inline double offset_lever(const SliderCrank<double>& crank, double theta) {
    return crank.offset * crank.at(theta).d2s;
}

/// The moment over the crank angle φ from top dead centre, in degrees, with factor × e s″ added:
/// by cubics through it every half degree. The moment itself where the offset is 0.
/// @param factor  m_j ω², kg/s², or m_j for what follows ω²; 0 gives the same knots
PeriodicPiecewise with_offset_term(const PeriodicPiecewise& moment,
                                   const SliderCrank<double>& crank, double factor);

}  // namespace ravnoves::balance_shaft
