#pragma once

#include <optional>
#include <string>
#include <vector>

#include "inertia-moments/balancing.h"
#include "inertia-moments/layouts.h"

namespace ravnoves::inertia_moments {

/// Everything that the page shows and that the command line prints.
struct Result {
    Engine engine;          ///< cylinders with their crankpins 0…2π
    EngineOrders two_term;  ///< reciprocating parts, orders 1…4
    EngineOrders exact;     ///< reciprocating parts, orders 1…12
    RotatingMasses rotating;
    std::vector<ShaftDesign> shafts;
    std::optional<CounterweightDesign> counterweights;
    /// Exact orders and the two-term form with the rotating masses: before balancing.
    EngineOrders unbalanced;
    EngineOrders two_term_unbalanced;
    /// The same exact orders with the enabled counterweights and the enabled shafts: the residual.
    EngineOrders remaining;
    std::vector<Difference> differences;
    std::vector<FiringEvent> firing;  ///< empty without a firing order that fits
    Message firing_trouble;           ///< why the order does not fit; empty where it does
    std::vector<Message> notes;       ///< what the model leaves out of this engine, sentences
    WrenchCurves curves;              ///< exact, reciprocating parts
    WrenchCurves unbalanced_curves;   ///< with the rotating masses
    WrenchCurves remaining_curves;    ///< with counterweights and shafts too
};

/// Solves the scene. Costs some tens of microseconds, a millisecond where rods are articulated, so
/// that every slider may call it.
/// @param with_curves  else they stay empty: two thirds of the time go there
/// @throws InputError as check_input()
Result solve(const Input& input, bool with_curves = true);

}  // namespace ravnoves::inertia_moments
