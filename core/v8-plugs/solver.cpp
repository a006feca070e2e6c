#include "v8-plugs/solver.h"

namespace ravnoves::v8_plugs {

namespace {

PlugMaterial material_of(OptionId id) {
    return has_steel_plugs(id) ? PlugMaterial::steel : PlugMaterial::aluminium;
}

PlugMass plug_mass(double typed, const PlugGeometry& geometry, double density) {
    const double weighs = geometry.volume() * density;
    return {weighs, typed, mass_fits(typed, weighs)};
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
            option->boring = plan_boring(*geometry, *limits, option->reduction, setup->density);
            if (option->boring->limit != Boring::Limit::none) {
                option->hindrance = describe(*option->boring, *limits);
                setup.reset();
            }
        }
        option->shift = shift_effect(*option, input.tolerance, setup);
    }
    if (!geometry || fault) {
        return;
    }
    if (input.engine.steel_plug_mass) {
        result.steel_plug =
            plug_mass(*input.engine.steel_plug_mass, *geometry, input.plug->steel_density);
    }
    if (input.engine.aluminium_plug_mass) {
        result.aluminium_plug =
            plug_mass(*input.engine.aluminium_plug_mass, *geometry, input.plug->aluminium_density);
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
            option->bob_weight = bob_weight(engine, result.changes, *option);
        }
    }
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
        result.advice =
            advise(*result.engine, input.crankshaft, *result.unbalanced_mass, input.tolerance,
                   [&](const Option& option) { return result.option(option.id)->hindrance; });
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
