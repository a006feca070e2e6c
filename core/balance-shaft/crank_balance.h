#pragma once

#include <vector>

#include "balance-shaft/solver.h"

namespace ravnoves::balance_shaft {

/// First-order force on the engine without a shaft when a share κ of m_j r is balanced on the crank
/// alone, and its residual with the shaft.
///
/// The counterweight κ m_j r opposite the crankpin adds −κ P (sin φ, cos φ) to the inertia force
/// P cos φ along the cylinder, P = m_j r ω²: the force (−κ P sin φ, (1 − κ) P cos φ) runs on an
/// ellipse, a line at κ = 0 and 1, a circle at κ = ½. The shaft with two equal counterweights by
/// equation (1) makes it a point. The second order P λ cos 2φ along the cylinder remains either
/// way. In an offset engine the first order is P′ cos(θ − δ) with P′ a little above P
/// (PistonFirstOrder), and all counterweights lag by δ; the residual of equation (1) remains.
/// Source: [gots-klevtsov], the introduction of the method; text-book result.
struct CrankBalance {
    double share = 0.0;                 ///< κ
    double first_order = 0.0;           ///< P′ = m_j r₁ ω², N; r₁ = r without offset
    double along = 0.0;                 ///< half-axis along the cylinder, P′ − κ P, N
    double across = 0.0;                ///< half-axis across it, κ P, N
    double largest = 0.0;               ///< the larger of the two, N
    double counterweight_moment = 0.0;  ///< κ m_j r, kg·m
    double with_shaft = 0.0;            ///< first order that remains with the shaft, N
    double second_order = 0.0;          ///< P λ, N; λ of the rod given or by default
    double dead_centre = 0.0;           ///< θ where φ is 0, rad
    double lag = 0.0;                   ///< δ, rad
};

/// @throws nothing: the solver's input is checked
CrankBalance crank_balance(const Solver& solver);

/// A closed curve of forces on the engine, N, x across and y along the cylinder: every 2° of φ.
struct ForceLocus {
    std::vector<double> x;
    std::vector<double> y;
};

/// A first order with these half-axes and a second order along the cylinder, N: without a shaft
/// across, along and second_order of the balance; with it 0, with_shaft and second_order.
ForceLocus force_locus(const CrankBalance& balance, double across, double along,
                       double second_order);

}  // namespace ravnoves::balance_shaft
