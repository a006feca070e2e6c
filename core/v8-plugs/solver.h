#pragma once

#include <array>
#include <optional>
#include <string>

#include "case-file/case_context.h"
#include "case-file/json_fwd.h"
#include "v8-plugs/case_input.h"

namespace ravnoves::v8_plugs {

/// One material of plug: what its dimensions weigh against the mass in the method.
struct PlugMass {
    double geometry;  ///< kg
    double typed;     ///< kg
    bool fits;        ///< within mass_mismatch
};

/// Bob weights of one option.
struct OptionBobWeight {
    BobWeight after;
    BobWeight nominal;  ///< of the crankshaft that the option is for
};

/// Everything the page, the job card and the result file show. Parts that need values which are
/// not there yet are empty, so that a form half filled shows what can be known.
struct Solution {
    MassChanges changes;
    std::optional<double> unbalanced_mass;  ///< Δm_y, kg; needs k_ш
    std::optional<PlugSet> plugs;
    std::array<std::optional<Option>, 4> options;  ///< in the order of all_options
    std::optional<Advice> advice;

    // bob weights; need the nominal masses too
    std::optional<BobWeight> nominal;  ///< of the crankshaft that is fitted
    std::optional<BobWeight> before;   ///< these parts, the plugs the crankshaft was made for
    std::array<std::optional<OptionBobWeight>, 4> bob_weights;

    // weigh-in
    std::optional<std::array<double, crankpin_count>> crankpin_excess;  ///< kg
    std::optional<Assignment> assignment;
    std::optional<std::array<double, crankpin_count>> assigned_excess;  ///< kg

    // plug
    std::optional<PlugMass> steel_plug;
    std::optional<PlugMass> aluminium_plug;
    std::array<std::optional<Boring>, 4> boring;  ///< for each option's reduction

    std::optional<BalancingVerdict> balancing;

    const std::optional<Option>& option(OptionId id) const {
        return options[static_cast<std::size_t>(id)];
    }
};

/// Computes whatever the input allows.
Solution solve(const CaseInput& input);

/// The scene's entry for case files: reads the input, solves it, writes the result of the contract.
/// @throws InputError
Json solve_case_input(const Json& input, const CaseContext& context);

}  // namespace ravnoves::v8_plugs
