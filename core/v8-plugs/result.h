#pragma once

#include <array>
#include <optional>

#include "v8-plugs/compensation.h"
#include "v8-plugs/plug_geometry.h"
#include "v8-plugs/shift.h"
#include "v8-plugs/weigh_in.h"

namespace ravnoves::v8_plugs {

/// Where an option's values are in the arrays below.
constexpr std::size_t index(OptionId id) {
    return static_cast<std::size_t>(id);
}

/// One material of plug: what its dimensions weigh against the mass in the method.
struct PlugMass {
    double geometry;  ///< kg
    double typed;     ///< kg
    bool fits;        ///< within mass_mismatch
};

/// Everything the page, the job card and the result file show. Parts that need values which are
/// not there yet are empty, so that a form half filled shows what can be known.
struct Result {
    MassChanges changes;
    std::optional<double> unbalanced_mass;  ///< Δm_y, kg; needs k_ш and the changes
    std::optional<Engine> engine;           ///< that has_plug_data(), with k_ш as it counts
    std::array<std::optional<Option>, all_options.size()> options;  ///< in the order of all_options
    std::optional<Advice> advice;

    // bob weights; need the nominal masses too, all but the nominal one the changes
    std::optional<BobWeight> nominal;  ///< of the crankshaft that is fitted
    std::optional<BobWeight> before;   ///< these parts, the plugs the crankshaft was made for
    std::array<std::optional<BobWeight>, all_options.size()> bob_weights;  ///< with the option

    std::optional<double> weighed_excess;  ///< on a crankpin in the mean, by the weigh-in, kg

    // plug
    std::optional<PlugMass> steel_plug;
    std::optional<PlugMass> aluminium_plug;
    /// For each option's reduction; not of new plugs, of which the sheet says nothing.
    std::array<std::optional<Boring>, all_options.size()> boring;
    /// Where an option machines its plugs.
    std::array<std::optional<ShiftEffect>, all_options.size()> shift;

    /// The bob weight to hang on a crankpin, the plugs out of the shaft; the present one where no
    /// change is needed; null while unknown.
    const BobWeight* hung_weight() const {
        const auto* weight =
            advice && advice->option ? &bob_weights[index(advice->option->id)] : &before;
        return *weight ? &**weight : before ? &*before : nullptr;
    }
    bool plug_can_exist = true;  ///< false where the sizes of the plug sheet leave no plug
    /// False where the plug of the sheet cannot exist, or its cutter cannot bore what the option
    /// takes off.
    bool can_be_made(OptionId id) const {
        if (!plug_can_exist && !has_new_plugs(id)) {
            return false;
        }
        const auto& plan = boring[index(id)];
        return !plan || !plan->cuts || plan->limit == Boring::Limit::none;
    }
    const std::optional<Option>& option(OptionId id) const { return options[index(id)]; }
    /// The bore to make: where the neglected shift matters, the one that counts it; empty where
    /// no bore does.
    std::optional<Boring> right_boring(OptionId id) const {
        std::optional<Boring> bored = boring[index(id)];
        const auto& effect = shift[index(id)];
        if (!bored || !effect || !effect->matters) {
            return bored;
        }
        if (!effect->depth) {
            return std::nullopt;
        }
        bored->deeper += bored->deeper > 0.0 ? *effect->depth - bored->depth : 0.0;
        bored->depth = *effect->depth;
        return bored;
    }
    /// What the neglected shift does to the option that is advised; nothing where it does not
    /// matter.
    const ShiftEffect* shift_that_matters() const {
        if (!advice || advice->kind != Advice::Kind::option) {
            return nullptr;
        }
        const auto& effect = shift[index(advice->option->id)];
        return effect && effect->matters ? &*effect : nullptr;
    }
};

}  // namespace ravnoves::v8_plugs
