#pragma once

#include <optional>
#include <vector>

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

/// A balance shaft designed for the engine.
struct ShaftDesign {
    Shaft shaft;  ///< as asked for
    /// The target: A or B of the order, N or N·m, in the front view at φ = 0.
    Complex target;
    /// m ρ: the weight's (force), or each of the two opposite ones' (moment), kg·m.
    /// m ρ (kω)² = |target| for a force, m ρ L (kω)² = |target| for a moment.
    double unbalance = 0.0;
    std::optional<double> mass;  ///< kg of one weight, where the radius is given
    /// Direction of the weight (moment: of the one towards cylinder 1) at φ = 0, from +x
    /// counter-clockwise, rad; empty without a target.
    std::optional<double> phase;
    /// What the shaft adds to the engine: N, and N·m about the reference position.
    RotatingPair force;
    RotatingPair moment;
    /// Largest value of its order (force or moment) with this shaft alone, and without: N or N·m.
    double remaining = 0.0;
    double before = 0.0;
    double scale = 0.0;  ///< what zero is measured against for these and the target, N or N·m
};

/// Designs the shafts so that each cancels its order and direction. Force shafts come first; a
/// moment shaft also cancels the moment that enabled force shafts of its order add. Where several
/// shafts have the same order, direction and task, they share it equally.
/// @param orders  the orders to cancel, up to each shaft's order (else: no target)
std::vector<ShaftDesign> design_shafts(const Engine& engine, const EngineOrders& orders,
                                       const std::vector<Shaft>& shafts);

}  // namespace ravnoves::inertia_moments
