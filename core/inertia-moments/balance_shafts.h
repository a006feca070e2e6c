#pragma once

#include <optional>
#include <vector>

#include "inertia-moments/engine.h"
#include "inertia-moments/orders.h"

namespace ravnoves::inertia_moments {

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
