#pragma once

#include "numerics/periodic_piecewise.h"
#include "numerics/slider_crank.h"

namespace ravnoves::balance_shaft {

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
