#pragma once

#include <array>
#include <optional>
#include <vector>

#include "case-file/message.h"
#include "inertia-moments/orders.h"

namespace ravnoves::inertia_moments {

/// Of an order: force and moment, each horizontal and vertical, and the roll moment.
std::array<Harmonic<double>, 5> components(const EngineOrder& order);

/// How far the two-term form is from the exact one, in one component of one order.
struct Difference {
    int order = 0;
    std::size_t component = 0;  ///< of components()
    double exact = 0.0;         ///< amplitude, N or N·m
    double two_term = 0.0;      ///< amplitude
    double error = 0.0;         ///< amplitude of the difference (a wrong phase counts), N or N·m
    /// error / exact; empty where the exact amplitude is negligible beside the quantity's largest.
    std::optional<double> relative;
    /// error / the quantity's largest amplitude of any order (of a balanced engine: 2 % of what its
    /// cylinders would reach in phase).
    double of_largest = 0.0;
    /// Both are so large that the two-term form is not enough for this component.
    bool warning = false;
};

/// Compares all orders of `exact` component by component; orders that the two-term form does not
/// have count as left out whole.
std::vector<Difference> compare(const EngineOrders& exact, const EngineOrders& two_term);

/// A warning as a sentence: "order 1 force, vertical plane: the two-term form is 12.8 % off".
Message describe(const Difference& difference);

}  // namespace ravnoves::inertia_moments
