#include "v8-plugs/compensation.h"

#include <algorithm>
#include <cmath>

namespace ravnoves::v8_plugs {

double unbalanced_mass(const MassChanges& changes, double rod_coefficient) {
    return changes.piston + (2.0 + rod_coefficient) * changes.rod_big_end +
           changes.repair_piston_and_rings + changes.repair_bearing;
}

Coefficients coefficients(const Engine& engine) {
    const double crank_radius = engine.crank_radius.value();
    const double k_p = engine.plug_radius.value() / crank_radius;
    return {k_p, 2.0 * k_p,
            engine.has_new_plug ? std::optional(2.0 * engine.new_plug_radius.value() / crank_radius)
                                : std::nullopt};
}

std::optional<Option> evaluate_option(OptionId id, const Engine& engine, double unbalanced_mass,
                                      double tolerance) {
    const bool steel = has_steel_plugs(id);
    const bool new_crankshaft = needs_new_crankshaft(id);
    if ((!steel && !engine.has_aluminium_plug) || (new_crankshaft && !engine.has_new_plug)) {
        return std::nullopt;
    }
    Option option{};
    option.id = id;
    const double crank_radius = engine.crank_radius.value();
    const double steel_mass = engine.steel_plug_mass.value();
    option.plug_radius = engine.plug_radius.value();
    option.plug_mass_unmachined = steel ? steel_mass : engine.aluminium_plug_mass.value();
    option.max_reduction =
        (steel ? engine.max_steel_reduction : engine.max_aluminium_reduction).value();
    if (has_new_plugs(id)) {
        option.plug_radius = engine.new_plug_radius.value();
        option.plug_mass_unmachined = engine.new_steel_plug_mass.value();
        option.max_reduction *= std::min(1.0, option.plug_mass_unmachined / steel_mass);
    }
    const double k_y = 2.0 * option.plug_radius / crank_radius;
    option.slope = k_y;
    if (has_new_plugs(id)) {
        option.constant = 0.0;  // the counterweights expect these plugs
    } else if (new_crankshaft) {
        // (13), (14): the counterweights expect the new plugs, today's are fitted.
        option.constant = *coefficients(engine).k_y_new * engine.new_steel_plug_mass.value() -
                          k_y * option.plug_mass_unmachined;
    } else {
        option.constant = k_y * (steel_mass - option.plug_mass_unmachined);  // (12), or 0
    }
    option.maximum = option.constant + k_y * option.max_reduction;
    option.required_reduction = (unbalanced_mass - option.constant) / k_y;
    option.reduction = std::clamp(option.required_reduction, 0.0, option.max_reduction);
    // What the limits leave; exactly nothing where they do not bind.
    if (option.required_reduction < 0.0) {
        option.residual_mass = unbalanced_mass - option.constant;
    } else if (option.required_reduction > option.max_reduction) {
        option.residual_mass = unbalanced_mass - option.maximum;
    } else {
        option.residual_mass = 0.0;
    }
    option.residual_unbalance = option.residual_mass * crank_radius;
    option.feasible = std::abs(option.residual_unbalance) <= tolerance;
    return option;
}

double BobWeight::sum() const {
    double total = 0.0;
    for (const shop::WeightLine& line : lines) {
        total += line.product();
    }
    return total;
}

BobWeight bob_weight(const Engine& engine, const MassChanges& changes, double plug_mass,
                     double plug_radius) {
    const shop::WeightLine plugs{
        {"plugs", Text::tr("Plug")}, 2.0 * plug_radius / engine.crank_radius.value(), plug_mass};
    const shop::WeightLine oil{
        {"oil", Text::tr("Oil mₘ")}, engine.oil_coefficient.value(), engine.oil_mass.value()};
    return {{{{"reciprocating_mass", Text::tr("Reciprocating mass mⱼ")},
              1.0,
              engine.reciprocating_mass.value(),
              true},
             {{"rotating_mass", Text::tr("Rotating mass")}, 2.0, engine.rotating_mass.value()},
             plugs,
             oil,
             {{"piston", Text::tr("Improved piston Δmₚᵢ")}, 1.0, changes.piston, true},
             {{"rod_big_end", Text::tr("Rod big end")},
              2.0 + engine.rod_coefficient.value(),
              changes.rod_big_end},
             {{"repair_piston_and_rings", Text::tr("Repair piston and rings Δmᵣₚ")},
              1.0,
              changes.repair_piston_and_rings,
              true},
             {{"repair_bearing", Text::tr("Repair shells Δmₛₕ")}, 1.0, changes.repair_bearing}},
            plugs.product(),
            oil.product()};
}

std::optional<BobWeight> bob_weight(const Engine& engine, const MassChanges& changes,
                                    Crankshaft crankshaft) {
    if (crankshaft == Crankshaft::standard) {
        return bob_weight(engine, changes, engine.steel_plug_mass.value(),
                          engine.plug_radius.value());
    }
    return engine.has_new_plug
               ? std::optional(bob_weight(engine, changes, engine.new_steel_plug_mass.value(),
                                          engine.new_plug_radius.value()))
               : std::nullopt;
}

}  // namespace ravnoves::v8_plugs
