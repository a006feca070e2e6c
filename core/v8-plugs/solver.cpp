#include "v8-plugs/solver.h"

#include <cmath>

namespace ravnoves::v8_plugs {

namespace {

PlugMaterial material_of(OptionId id) {
    return has_steel_plugs(id) ? PlugMaterial::steel : PlugMaterial::aluminium;
}

/// What follows from the plug's sizes and its cutter.
void solve_plug(const Input& input, Result& result) {
    const auto geometry = input.plug ? input.plug->geometry() : std::nullopt;
    const auto fault = geometry ? geometry_fault(*geometry) : std::nullopt;
    const auto limits = geometry ? input.plug->limits() : std::nullopt;
    for (auto& option : result.options) {
        if (!option) {
            continue;
        }
        std::optional<BoreSetup> setup;
        if (fault && !has_new_plugs(option->id)) {
            option->hindrance = *fault;
        } else if (limits && !fault && !has_new_plugs(option->id)) {
            setup = BoreSetup{*geometry, *limits, input.plug->density(material_of(option->id))};
            option->boring = plan_boring(*setup, option->reduction);
            if (option->boring->limit != Boring::Limit::none) {
                option->hindrance = describe(*option->boring, *limits);
                setup.reset();
            }
        }
        option->shift = shift_effect(*option, input.tolerance, setup);
    }
}

void solve_bob_weights(const Input& input, bool changes_known, Result& result) {
    if (!result.engine || !has_nominal_masses(input.engine)) {
        return;
    }
    const Engine& engine = *result.engine;
    result.nominal = bob_weight(engine, {}, input.crankshaft);
    if (changes_known) {
        result.before = bob_weight(engine, result.changes, input.crankshaft);
    }
    for (auto& option : result.options) {
        if (option) {
            option->bob_weight =
                bob_weight(engine, result.changes, option->fitted_mass(), option->fitted_radius());
        }
    }
}

/// The first option that works in the order of cost (nothing, steel plugs, aluminium plugs) among
/// those for the crankshaft that is fitted.
Advice advise(const Input& input, const Result& result) {
    const double excess = result.unbalanced_mass.value();
    if (std::abs(excess * result.engine->crank_radius.value()) <= input.tolerance) {
        return {Advice::Kind::none_needed};
    }
    Advice advice{Advice::Kind::no_new_plug_data};
    const SolvedOption* not_made = nullptr;  // the first that would do
    const SolvedOption* nearest = nullptr;
    bool any_over = false;
    for (const auto& option : result.options) {  // in the order of cost
        if (!option) {
            continue;
        }
        const bool is_fitted =
            needs_new_crankshaft(option->id) == (input.crankshaft == Crankshaft::new_plugs);
        if (is_fitted && option->works()) {
            return {Advice::Kind::option, option->id};
        }
        if (!is_fitted) {
            if (option->works() && !advice.with_other_crankshaft) {
                advice.with_other_crankshaft = option->id;
            }
        } else if (option->feasible) {
            not_made = not_made != nullptr ? not_made : &*option;
        } else {
            any_over = any_over || option->residual_mass < 0;
            if (nearest == nullptr ||
                std::abs(option->residual_mass) < std::abs(nearest->residual_mass)) {
                nearest = &*option;
            }
        }
    }
    if (not_made != nullptr) {
        advice.kind = Advice::Kind::cannot_be_made;
        advice.option = not_made->id;
    } else if (nearest != nullptr) {
        advice.kind = excess < 0 ? Advice::Kind::too_light
                      : any_over ? Advice::Kind::none_light_enough
                                 : Advice::Kind::none_sufficient;
        advice.option = nearest->id;
    }
    return advice;
}

}  // namespace

Result solve(const Input& input, bool changes_known) {
    Result result;
    result.changes = input.changes();
    const auto k = input.rod_coefficient();
    if (changes_known && k) {
        result.unbalanced_mass = unbalanced_mass(result.changes, *k);
    }
    if (has_plug_data(input.engine)) {
        result.engine = input.engine;
        result.engine->rod_coefficient = k.value();
    }
    const bool can_advise = result.engine && result.unbalanced_mass;
    for (std::size_t i = 0; can_advise && i < all_options.size(); ++i) {
        if (const auto option = evaluate_option(all_options.at(i), *result.engine,
                                                *result.unbalanced_mass, input.tolerance)) {
            result.options.at(i).emplace(SolvedOption{*option, {}, {}, {}, {}});
        }
    }
    solve_plug(input, result);
    if (can_advise) {
        result.advice = advise(input, result);
    }
    solve_bob_weights(input, changes_known, result);
    if (input.weigh_in && input.weigh_in->is_counted() && k) {
        // What is typed and not weighed is the same on every crankpin.
        result.weighed_excess = unbalanced_mass(input.changes_from_weigh_in
                                                    ? result.changes
                                                    : mass_changes(*input.weigh_in, input.process),
                                                *k);
    }
    return result;
}

}  // namespace ravnoves::v8_plugs
