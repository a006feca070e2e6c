#pragma once

#include <optional>
#include <vector>

#include "inertia-moments/input.h"
#include "inertia-moments/result.h"

namespace ravnoves::inertia_moments {

/// Solves the scene. Costs some tens of microseconds, a millisecond where rods are articulated, so
/// that every slider may call it.
/// @throws InputError as check_input()
Result solve(const Input& input);

/// The sums of the orders with rotating masses, counterweights and shafts added.
EngineOrders with_balancing(const Engine& engine, EngineOrders orders,
                            const RotatingMasses& rotating,
                            const std::optional<CounterweightDesign>& counterweights,
                            bool counterweights_enabled, const std::vector<ShaftDesign>& shafts);

}  // namespace ravnoves::inertia_moments
