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

void solve_plug(const Input& input, Result& result) {
    if (!input.plug) {
        return;
    }
    const auto geometry = input.plug->geometry();
    result.plug_can_exist = !geometry || !geometry_fault(*geometry);
    if (!geometry || !result.plug_can_exist) {
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
    const auto limits = input.plug->limits();
    if (!limits) {
        return;
    }
    for (const OptionId id : all_options) {
        const auto& option = result.option(id);
        if (option && !has_new_plugs(id)) {
            result.boring[index(id)] = plan_boring(*geometry, *limits, option->reduction,
                                                   input.plug->density(material_of(id)));
        }
    }
}

/// Why the plug of the sheet cannot be made as the option needs it; empty where it can.
Message hindrance(const Input& input, const Result& result, const Option& option) {
    if (result.can_be_made(option.id)) {
        return {};
    }
    return result.plug_can_exist
               ? describe(*result.boring[index(option.id)], input.plug->limits().value())
               : geometry_fault(input.plug->geometry().value()).value();
}

void solve_shifts(const Input& input, Result& result) {
    for (const OptionId id : all_options) {
        const auto& option = result.option(id);
        if (!option) {
            continue;
        }
        const auto& boring = result.boring[index(id)];
        std::optional<BoreSetup> setup;
        if (boring && boring->limit == Boring::Limit::none) {
            setup = BoreSetup{*input.plug->geometry(), *input.plug->limits(),
                              input.plug->density(material_of(id))};
        }
        result.shift[index(id)] = shift_effect(*option, input.tolerance, setup);
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
    for (const OptionId id : all_options) {
        if (const auto& option = result.option(id)) {
            result.bob_weights[index(id)] = bob_weight(engine, result.changes, *option);
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
    if (result.engine && result.unbalanced_mass) {
        for (const OptionId id : all_options) {
            result.options[index(id)] =
                evaluate_option(id, *result.engine, *result.unbalanced_mass, input.tolerance);
        }
    }
    solve_plug(input, result);
    if (result.engine && result.unbalanced_mass) {
        result.advice =
            advise(*result.engine, input.crankshaft, *result.unbalanced_mass, input.tolerance,
                   [&](const Option& option) { return hindrance(input, result, option); });
    }
    solve_bob_weights(input, changes_known, result);
    if (input.weigh_in && input.weigh_in->is_counted() && k) {
        // What is typed and not weighed is the same on every crankpin.
        result.weighed_excess = unbalanced_mass(input.changes_from_weigh_in
                                                    ? result.changes
                                                    : mass_changes(*input.weigh_in, input.process),
                                                *k);
    }
    solve_shifts(input, result);
    return result;
}

}  // namespace ravnoves::v8_plugs
