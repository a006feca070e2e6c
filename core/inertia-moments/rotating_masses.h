#pragma once

#include <optional>

#include "inertia-moments/engine.h"
#include "inertia-moments/orders.h"

namespace ravnoves::inertia_moments {

/// Sums over the crankpins. As complex numbers relative to crankpin 1: the direction of crankpin 1
/// is the real axis, counter-clockwise positive; they turn with the crank.
struct RotatingMasses {
    Complex force_factor;        ///< Σ e^{iκ}
    Complex moment_factor;       ///< Σ (z − z̄) e^{iκ} about the mean axial position z̄, m
    double force_scale = 0.0;    ///< N, the number of crankpins: what zero is measured against
    double moment_scale = 0.0;   ///< Σ |z − z̄|, m
    double mean_position = 0.0;  ///< z̄, m
    double mass_force = 0.0;     ///< m_rot R ω² of one crankpin, N
    Complex force() const { return mass_force * force_factor; }    ///< N
    Complex moment() const { return mass_force * moment_factor; }  ///< about z̄, N·m
    /// About another point z, N·m.
    Complex moment_about(double z) const { return moment() + force() * (mean_position - z); }
};

RotatingMasses rotating_masses(const Engine& engine);

/// e^{i(β₁ + π/2)}: turns a vector relative to crankpin 1 into one in the front view at φ = 0.
Complex crankpin_direction(const Engine& engine);

/// One counterweight.
struct Counterweight {
    Complex unbalance;      ///< m ρ, kg·m, relative to crankpin 1 as above
    double position = 0.0;  ///< z, m
    double radius = 0.0;    ///< ρ, m
    double mass() const { return std::abs(unbalance) / radius; }  ///< kg
};

/// The counterweights of the two end webs.
struct CounterweightDesign {
    Counterweight front;  ///< one weight for both tasks on the front web
    Counterweight rear;
    /// The same apart: m ρ against the force (its sum over both webs, acting at z̄) and m ρ of each
    /// of the two opposite weights against the moment (the front web's). kg·m
    Complex against_force;
    Complex against_moment;
    /// Their share of the engine's orders in the front view at φ = 0, forward rotating: N and N·m
    /// about the reference position.
    Complex force;
    Complex moment;
    /// kg·m: what zero is measured against for the weights, all that may cancel in them added up.
    double scale = 0.0;
};

/// Two counterweights that cancel the rotating masses and a share of the forward-rotating part of
/// the reciprocating first order.
/// @param first_order  exact or two-term order 1 of the engine
/// @param webs         checked: two different positions, radii > 0
CounterweightDesign design_counterweights(const Engine& engine, const RotatingMasses& rotating,
                                          const EngineOrder& first_order, const EndWebs& webs);

}  // namespace ravnoves::inertia_moments
