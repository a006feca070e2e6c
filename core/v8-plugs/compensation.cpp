#include "v8-plugs/compensation.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace ravnoves::v8_plugs {

namespace {

constexpr double gram = 1e-3;
constexpr double gram_millimetre = 1e-6;

/// A number with the given decimals, without "-0".
std::string fixed(double value, int decimals) {
    std::array<char, 400> text{};
    std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
    std::string written = text.data();
    std::replace(written.begin(), written.end(), ',', '.');
    if (written.starts_with('-') && written.find_first_not_of("-0.") == std::string::npos) {
        written.erase(0, 1);
    }
    return written;
}

std::string grams(double mass) {
    return fixed(mass / gram, 2) + " g";
}

std::string gram_millimetres(double unbalance) {
    return fixed(unbalance / gram_millimetre, 1) + " g·mm";
}

/// The action of an option in the imperative.
std::string action(const Option& option) {
    // A hundredth of a gram is what the words show; less is not worth a set-up of the machine.
    const bool machined = option.reduction >= 0.005 * gram;
    const std::string count = std::to_string(plug_count);
    if (keeps_steel_plugs(option.id)) {
        return machined
                   ? "Machine all " + count + " steel plugs by " + grams(option.reduction) + " each"
                   : "Fit today's " + count + " steel plugs as they are";
    }
    return machined ? "Replace all " + count + " plugs by aluminium ones lightened by " +
                          grams(option.reduction) + " each"
                    : "Replace all " + count + " plugs by aluminium ones as they are";
}

std::string over_or_under(const Option& option) {
    return option.residual_mass > 0
               ? "leaves " + grams(option.residual_mass) + " too much on each crankpin"
               : "over-compensates by " + grams(-option.residual_mass) + " on each crankpin";
}

}  // namespace

double unbalanced_mass(Process process, const MassChanges& changes, double rod_coefficient) {
    const double manufacture = changes.piston + (2.0 + rod_coefficient) * changes.rod_big_end;
    return process == Process::manufacture
               ? manufacture
               : manufacture + changes.repair_piston_and_rings + changes.repair_bearing;
}

Coefficients PlugSet::coefficients() const {
    const double k_p = plug_radius / crank_radius;
    return {k_p, 2.0 * k_p,
            new_design ? std::optional(2.0 * new_design->radius / crank_radius) : std::nullopt};
}

std::optional<PlugSet> plug_set(const Engine& engine) {
    if (!missing_fields(engine, false).empty() || !engine_conflicts(engine).empty()) {
        return std::nullopt;
    }
    PlugSet plugs{engine.crank_radius.value(),
                  engine.plug_radius.value(),
                  engine.steel_plug_mass.value(),
                  engine.max_steel_reduction.value(),
                  engine.rod_coefficient.value(),
                  std::nullopt,
                  std::nullopt};
    if (engine.has_aluminium_plug) {
        plugs.aluminium = PlugSet::Aluminium{engine.aluminium_plug_mass.value(),
                                             engine.max_aluminium_reduction.value()};
    }
    if (engine.has_new_plug) {
        plugs.new_design =
            PlugSet::NewDesign{engine.new_plug_radius.value(), engine.new_steel_plug_mass.value()};
    }
    return plugs;
}

std::optional<GearMasses> gear_masses(const Engine& engine) {
    if (!engine.reciprocating_mass || !engine.rotating_mass || !engine.oil_mass ||
        !engine.oil_coefficient) {
        return std::nullopt;
    }
    return GearMasses{*engine.reciprocating_mass, *engine.rotating_mass, *engine.oil_mass,
                      *engine.oil_coefficient};
}

std::string_view option_name(OptionId option) {
    switch (option) {
        case OptionId::steel_machined:
            return "steel-machined";
        case OptionId::steel_to_aluminium:
            return "steel-to-aluminium";
        case OptionId::new_steel_to_steel:
            return "new-steel-to-steel";
        case OptionId::new_steel_to_aluminium:
            return "new-steel-to-aluminium";
    }
    return "";
}

bool keeps_steel_plugs(OptionId option) {
    return option == OptionId::steel_machined || option == OptionId::new_steel_to_steel;
}

bool needs_new_crankshaft(OptionId option) {
    return option == OptionId::new_steel_to_steel || option == OptionId::new_steel_to_aluminium;
}

std::optional<Option> evaluate_option(OptionId id, const PlugSet& plugs, double unbalanced_mass,
                                      double tolerance) {
    const bool steel = keeps_steel_plugs(id);
    const bool new_crankshaft = needs_new_crankshaft(id);
    if ((!steel && !plugs.aluminium) || (new_crankshaft && !plugs.new_design)) {
        return std::nullopt;
    }
    const double k_y = plugs.coefficients().k_y;
    Option option{};
    option.id = id;
    option.slope = k_y;
    option.plug_mass_unmachined = steel ? plugs.steel_mass : plugs.aluminium->mass;
    option.max_reduction = steel ? plugs.max_steel_reduction : plugs.aluminium->max_reduction;
    if (new_crankshaft) {
        // (13), (14): the counterweights expect the new plugs, today's are fitted.
        option.constant = *plugs.coefficients().k_y_new * plugs.new_design->mass -
                          k_y * option.plug_mass_unmachined;
    } else {
        option.constant = k_y * (plugs.steel_mass - option.plug_mass_unmachined);  // (12), or 0
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
    option.residual_unbalance = option.residual_mass * plugs.crank_radius;
    option.feasible = std::abs(option.residual_unbalance) <= tolerance;
    return option;
}

Advice advise(const PlugSet& plugs, Crankshaft crankshaft, double unbalanced_mass,
              double tolerance) {
    const bool new_crankshaft = crankshaft == Crankshaft::new_plugs;
    Advice advice{Advice::Kind::none_sufficient, std::nullopt, std::nullopt};
    if (std::abs(unbalanced_mass * plugs.crank_radius) <= tolerance) {
        advice.kind = Advice::Kind::none_needed;
        return advice;
    }
    bool any_over = false;
    bool any_evaluated = false;
    for (const OptionId id : all_options) {  // in the order of cost
        const auto option = evaluate_option(id, plugs, unbalanced_mass, tolerance);
        if (!option) {
            continue;
        }
        if (needs_new_crankshaft(id) != new_crankshaft) {
            if (option->feasible && !advice.with_other_crankshaft) {
                advice.with_other_crankshaft = id;
            }
            continue;
        }
        any_evaluated = true;
        if (option->feasible) {
            advice.kind = Advice::Kind::option;
            advice.option = option;
            advice.with_other_crankshaft.reset();
            return advice;
        }
        any_over = any_over || option->residual_mass < 0;
        if (!advice.option ||
            std::abs(option->residual_mass) < std::abs(advice.option->residual_mass)) {
            advice.option = option;
        }
    }
    if (!any_evaluated) {
        advice.kind = Advice::Kind::no_new_plug_data;
    } else if (unbalanced_mass < 0) {
        advice.kind = Advice::Kind::too_light;
    } else {
        advice.kind = any_over ? Advice::Kind::none_light_enough : Advice::Kind::none_sufficient;
    }
    return advice;
}

std::string describe_failure(const Option& option, double tolerance) {
    if (option.feasible) {
        return {};
    }
    return over_or_under(option) + ": " + gram_millimetres(std::abs(option.residual_unbalance)) +
           " against the " + gram_millimetres(tolerance) + " allowed";
}

std::string describe(const Advice& advice, double unbalanced_mass, double crank_radius,
                     double tolerance) {
    std::string text;
    switch (advice.kind) {
        case Advice::Kind::none_needed:
            return "Leave the plugs as they are: the excess of " + grams(unbalanced_mass) +
                   " per crankpin is " +
                   gram_millimetres(std::abs(unbalanced_mass) * crank_radius) + ", within the " +
                   gram_millimetres(tolerance) + " allowed.";
        case Advice::Kind::option: {
            const Option& option = advice.option.value();
            text = action(option) + ".";
            if (option.residual_mass != 0.0) {
                text += " This " + over_or_under(option) + ", " +
                        gram_millimetres(std::abs(option.residual_unbalance)) + ", within the " +
                        gram_millimetres(tolerance) + " allowed.";
            }
            return text;
        }
        case Advice::Kind::no_new_plug_data:
            return "The crankshaft is made for plugs of the new design; without their mass and "
                   "radius nothing can be advised.";
        case Advice::Kind::too_light:
            text = "The parts are " + grams(-unbalanced_mass) +
                   " per crankpin lighter than nominal (" +
                   gram_millimetres(-unbalanced_mass * crank_radius) +
                   "), and plugs can only be lightened: heavier parts or heavier plugs are needed.";
            break;
        case Advice::Kind::none_sufficient:
        case Advice::Kind::none_light_enough: {
            const Option& closest = advice.option.value();
            text = advice.kind == Advice::Kind::none_sufficient
                       ? "No plug of this crankshaft can be made light enough"
                       : "No plug of this crankshaft has the mass that is needed";
            text += ". The nearest is " + std::string(option_name(closest.id)) + ", which " +
                    describe_failure(closest, tolerance) + ".";
            break;
        }
    }
    if (advice.with_other_crankshaft) {
        text += needs_new_crankshaft(*advice.with_other_crankshaft)
                    ? " A crankshaft made for the new plugs would do (" +
                          std::string(option_name(*advice.with_other_crankshaft)) + ")."
                    : " A standard crankshaft would do (" +
                          std::string(option_name(*advice.with_other_crankshaft)) + ").";
    }
    return text;
}

std::string_view part_name(BobWeightLine::Part part) {
    switch (part) {
        case BobWeightLine::Part::reciprocating:
            return "reciprocating_mass";
        case BobWeightLine::Part::piston:
            return "piston";
        case BobWeightLine::Part::repair_piston_and_rings:
            return "repair_piston_and_rings";
        case BobWeightLine::Part::rotating:
            return "rotating_mass";
        case BobWeightLine::Part::plugs:
            return "plugs";
        case BobWeightLine::Part::rod_big_end:
            return "rod_big_end";
        case BobWeightLine::Part::repair_bearing:
            return "repair_bearing";
        case BobWeightLine::Part::oil:
            return "oil";
    }
    return "";
}

double BobWeight::sum() const {
    double total = 0.0;
    for (const BobWeightLine& line : lines) {
        total += line.product();
    }
    return total;
}

BobWeight bob_weight(const PlugSet& plugs, const GearMasses& gear, Process process,
                     const MassChanges& changes, double plug_mass, double plug_radius) {
    using Part = BobWeightLine::Part;
    BobWeight weight;
    weight.lines = {{Part::reciprocating, 1.0, gear.reciprocating},
                    {Part::rotating, 2.0, gear.rotating},
                    {Part::plugs, 2.0 * plug_radius / plugs.crank_radius, plug_mass},
                    {Part::oil, gear.oil_coefficient, gear.oil},
                    {Part::piston, 1.0, changes.piston},
                    {Part::rod_big_end, 2.0 + plugs.rod_coefficient, changes.rod_big_end}};
    if (process == Process::repair) {
        weight.lines.push_back(
            {Part::repair_piston_and_rings, 1.0, changes.repair_piston_and_rings});
        weight.lines.push_back({Part::repair_bearing, 1.0, changes.repair_bearing});
    }
    return weight;
}

std::optional<BobWeight> nominal_bob_weight(const PlugSet& plugs, const GearMasses& gear,
                                            Crankshaft crankshaft) {
    if (crankshaft == Crankshaft::new_plugs) {
        if (!plugs.new_design) {
            return std::nullopt;
        }
        return bob_weight(plugs, gear, Process::repair, {}, plugs.new_design->mass,
                          plugs.new_design->radius);
    }
    return bob_weight(plugs, gear, Process::repair, {}, plugs.steel_mass, plugs.plug_radius);
}

BobWeight option_bob_weight(const PlugSet& plugs, const GearMasses& gear, Process process,
                            const MassChanges& changes, const Option& option) {
    return bob_weight(plugs, gear, process, changes, option.plug_mass_unmachined - option.reduction,
                      plugs.plug_radius);
}

double shift_coefficient(double shift, double crank_radius) {
    return shift / crank_radius;
}

double shift_unbalance(double plug_mass, double shift) {
    return 2.0 * plug_mass * shift;
}

}  // namespace ravnoves::v8_plugs
