#pragma once

#include <array>
#include <optional>

#include "v8-plugs/compensation.h"
#include "v8-plugs/plug_geometry.h"
#include "v8-plugs/shift.h"
#include "v8-plugs/weigh_in.h"

namespace ravnoves::v8_plugs {

/// An option with all that follows from its reduction.
struct SolvedOption : Option {
    std::optional<Boring> boring;  ///< not of new plugs, of which the sheet says nothing
    Message hindrance;  ///< why the plug of the sheet cannot be made so; empty where it can
    std::optional<ShiftEffect> shift;     ///< where it machines its plugs
    std::optional<BobWeight> bob_weight;  ///< needs the nominal masses

    bool works() const { return feasible && hindrance.empty(); }
    /// Works only as long as the shift is neglected.
    bool by_method_alone() const { return shift && shift->matters; }
    /// Mass to take off each plug, kg: by the method, or with the shift where that matters; within
    /// the limits of the plug.
    double take_off() const { return by_method_alone() ? shift->reduction : reduction; }
    /// One plug as the option fits it, kg, and the radius of its centre of mass, m. With less off
    /// than the method counts it is heavier, and its centre nearer to the crank axis.
    double fitted_mass() const { return plug_mass_unmachined - take_off(); }
    double fitted_radius() const { return by_method_alone() ? shift->radius : plug_radius; }
    /// The bore to make: where the neglected shift matters, the one that counts it; empty where
    /// no bore does.
    std::optional<Boring> right_boring() const {
        std::optional<Boring> bored = boring;
        if (!bored || !by_method_alone()) {
            return bored;
        }
        if (!shift->depth) {
            return std::nullopt;
        }
        bored->deeper += bored->deeper > 0.0 ? *shift->depth - bored->depth : 0.0;
        bored->depth = *shift->depth;
        return bored;
    }
};

/// What to do.
struct Advice {
    enum class Kind {
        none_needed,        ///< the excess itself is within the tolerance
        option,             ///< `option` is the cheapest that works
        too_light,          ///< lighter than nominal: plugs can only be lightened
        none_sufficient,    ///< every option falls short of the excess
        none_light_enough,  ///< every option over-compensates or falls short: a gap between them
        no_new_plug_data,   ///< crankshaft for new plugs, but their data are missing
        cannot_be_made      ///< `option` would do, but its plug cannot be made so
    };
    Kind kind;
    std::optional<OptionId> option{};  ///< the recommended one, or the one of minimum residual
    /// An option that would work if the other crankshaft were fitted.
    std::optional<OptionId> with_other_crankshaft{};
};

/// Everything the page, the job card and the result file show. Parts that need values which are
/// not there yet are empty, so that a form half filled shows what can be known.
struct Result {
    MassChanges changes;
    std::optional<double> unbalanced_mass;  ///< Δm_y, kg; needs k_ш and the changes
    std::optional<Engine> engine;           ///< that has_plug_data(), with k_ш as it counts
    std::array<std::optional<SolvedOption>, all_options.size()> options;  ///< as all_options
    std::optional<Advice> advice;

    // bob weights; need the nominal masses too, all but the nominal one the changes
    std::optional<BobWeight> nominal;  ///< of the crankshaft that is fitted
    std::optional<BobWeight> before;   ///< these parts, the plugs the crankshaft was made for

    std::optional<double> weighed_excess;  ///< on a crankpin in the mean, by the weigh-in, kg

    const std::optional<SolvedOption>& option(OptionId id) const {
        return options.at(static_cast<std::size_t>(id));
    }
    /// The recommended one, or the one of minimum residual; null without any.
    const SolvedOption* chosen() const {
        return advice && advice->option ? &*option(*advice->option) : nullptr;
    }
    /// The bob weight to hang on a crankpin, the plugs out of the shaft; the present one where no
    /// change is needed; null while unknown.
    const BobWeight* hung_weight() const {
        const auto& weight = chosen() != nullptr ? chosen()->bob_weight : before;
        return weight ? &*weight : before ? &*before : nullptr;
    }
    /// What the neglected shift does to the option that is advised; nothing where it does not
    /// matter.
    const ShiftEffect* shift_that_matters() const {
        return advice && advice->kind == Advice::Kind::option && chosen()->by_method_alone()
                   ? &*chosen()->shift
                   : nullptr;
    }
};

}  // namespace ravnoves::v8_plugs
