#include "v8-plugs/v8_text.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

namespace ravnoves::v8_text {

using namespace v8_plugs;

namespace {

constexpr double gram = 1e-3;
constexpr double millimetre = 1e-3;
constexpr double gramMillimetre = 1e-6;
constexpr double worthSaying = 0.005 * gram;  // what two decimals show

std::size_t index(OptionId id) {
    return static_cast<std::size_t>(id);
}

QString withUnit(const QString& number, const QString& unit) {
    return number + QChar(0x00A0) + unit;
}

/// The action of an option in the imperative.
QString action(const Words& words, const Option& option) {
    const bool machined = option.reduction >= worthSaying;
    const QString each = grams(words, option.reduction);
    if (keeps_steel_plugs(option.id)) {
        return machined ? words.translate("V8", "Machine all 8 steel plugs by %1 each.").arg(each)
                        : words.translate("V8", "Fit today's 8 steel plugs as they are.");
    }
    return machined
               ? words
                     .translate("V8", "Replace all 8 plugs by aluminium ones lightened by %1 each.")
                     .arg(each)
               : words.translate("V8", "Replace all 8 plugs by aluminium ones as they are.");
}

QString overOrUnder(const Words& words, const Option& option) {
    return option.residual_mass > 0
               ? words.translate("V8", "leaves %1 too much on each crankpin")
                     .arg(grams(words, option.residual_mass))
               : words.translate("V8", "over-compensates by %1 on each crankpin")
                     .arg(grams(words, -option.residual_mass));
}

QString within(const Words& words, double unbalance, double tolerance) {
    return words.translate("V8", "%1, within the %2 allowed")
        .arg(gramMillimetres(words, std::abs(unbalance)), gramMillimetres(words, tolerance));
}

QString against(const Words& words, double unbalance, double tolerance) {
    return words.translate("V8", "%1 against the %2 allowed")
        .arg(gramMillimetres(words, std::abs(unbalance)), gramMillimetres(words, tolerance));
}

}  // namespace

QString grams(const Words& words, double kilograms, int decimals) {
    return withUnit(words.number(kilograms / gram, decimals), words.translate("V8", "g", "unit"));
}

QString gramMillimetres(const Words& words, double kilogramMetres, int decimals) {
    return withUnit(words.number(kilogramMetres / gramMillimetre, decimals),
                    words.translate("V8", "g·mm", "unit"));
}

QString millimetres(const Words& words, double metres, int decimals) {
    return withUnit(words.plain(metres / millimetre, decimals),
                    words.translate("V8", "mm", "unit"));
}

QString unitName(const Words& words, std::string_view unit) {
    if (unit == "g") {
        return words.translate("V8", "g", "unit");
    }
    if (unit == "mm") {
        return words.translate("V8", "mm", "unit");
    }
    if (unit == "g·mm") {
        return words.translate("V8", "g·mm", "unit");
    }
    if (unit == "kg") {
        return words.translate("V8", "kg", "unit");
    }
    if (unit == "kg/m³") {
        return words.translate("V8", "kg/m³", "unit");
    }
    if (unit == "mm/s") {
        return words.translate("V8", "mm/s", "unit");
    }
    if (unit == "min⁻¹") {
        return words.translate("V8", "min⁻¹", "unit");
    }
    return QString::fromUtf8(unit.data(), static_cast<qsizetype>(unit.size()));
}

QString engineName(const Words& words, const std::string& name) {
    QString text = QString::fromStdString(name);
    if (find_preset(name) == nullptr || !text.endsWith(QLatin1String(" l"))) {
        return text;
    }
    return withUnit(words.plain(text.chopped(2).toDouble(), 2),
                    words.translate("V8", "l", "litre"));
}

QString fieldName(const Words& words, std::string_view key) {
    if (key == "crank_radius_mm") {
        return words.translate("V8", "Crank radius r");
    }
    if (key == "plug_radius_mm") {
        return words.translate("V8", "Plug radius r_p");
    }
    if (key == "new_plug_radius_mm") {
        return words.translate("V8", "New plug radius r_pn");
    }
    if (key == "steel_plug_mass_g") {
        return words.translate("V8", "Steel plug m_p");
    }
    if (key == "aluminium_plug_mass_g") {
        return words.translate("V8", "Aluminium plug m_a");
    }
    if (key == "new_steel_plug_mass_g") {
        return words.translate("V8", "New steel plug m_pn");
    }
    if (key == "new_aluminium_plug_mass_g") {
        return words.translate("V8", "New aluminium plug m_an");
    }
    if (key == "max_steel_reduction_g") {
        return words.translate("V8", "Most off steel plug Δm_pm");
    }
    if (key == "max_aluminium_reduction_g") {
        return words.translate("V8", "Most off aluminium plug Δm_am");
    }
    if (key == "rod_coefficient") {
        return words.translate("V8", "Rod coefficient k_r");
    }
    if (key == "oil_mass_g") {
        return words.translate("V8", "Oil in a crankpin m_m");
    }
    if (key == "oil_coefficient") {
        return words.translate("V8", "Oil coefficient k_m");
    }
    if (key == "reciprocating_mass_g") {
        return words.translate("V8", "Reciprocating mass m_j");
    }
    if (key == "rotating_mass_g") {
        return words.translate("V8", "Rotating mass m_R");
    }
    if (key == "piston") {
        return words.translate("V8", "Improved piston Δm_pi");
    }
    if (key == "rod_big_end") {
        return words.translate("V8", "Rod big end Δm_be");
    }
    if (key == "repair_piston_and_rings") {
        return words.translate("V8", "Repair piston and rings Δm_rp");
    }
    if (key == "repair_bearing") {
        return words.translate("V8", "Repair shells Δm_sh");
    }
    if (key == "tolerance_g_mm") {
        return words.translate("V8", "Residual unbalance allowed");
    }
    return QString::fromUtf8(key.data(), static_cast<qsizetype>(key.size()));
}

QString optionName(const Words& words, OptionId option) {
    switch (option) {
        case OptionId::steel_machined:
            return words.translate("V8", "Machine today's steel plugs");
        case OptionId::steel_to_aluminium:
            return words.translate("V8", "Aluminium plugs");
        case OptionId::new_steel_to_steel:
            return words.translate("V8", "New crankshaft, today's steel plugs");
        case OptionId::new_steel_to_aluminium:
            return words.translate("V8", "New crankshaft, aluminium plugs");
    }
    return {};
}

QString lineName(const Words& words, BobWeightLine::Part part) {
    switch (part) {
        case BobWeightLine::Part::reciprocating:
            return words.translate("V8", "Reciprocating mass m_j");
        case BobWeightLine::Part::piston:
            return words.translate("V8", "Improved piston Δm_pi");
        case BobWeightLine::Part::repair_piston_and_rings:
            return words.translate("V8", "Repair piston and rings Δm_rp");
        case BobWeightLine::Part::rotating:
            return words.translate("V8", "Rotating mass m_R");
        case BobWeightLine::Part::plugs:
            return words.translate("V8", "Plug");
        case BobWeightLine::Part::rod_big_end:
            return words.translate("V8", "Rod big end Δm_be");
        case BobWeightLine::Part::repair_bearing:
            return words.translate("V8", "Repair shells Δm_sh");
        case BobWeightLine::Part::oil:
            return words.translate("V8", "Oil m_m");
    }
    return {};
}

QString shortLine(const Words& words, const BobWeightLine& line) {
    QString name;
    switch (line.part) {
        case BobWeightLine::Part::reciprocating:
            name = words.translate("V8", "reciprocating m_j");
            break;
        case BobWeightLine::Part::piston:
            name = words.translate("V8", "piston Δm_pi");
            break;
        case BobWeightLine::Part::repair_piston_and_rings:
            name = words.translate("V8", "rep. piston Δm_rp");
            break;
        case BobWeightLine::Part::rotating:
            name = words.translate("V8", "rotating m_R");
            break;
        case BobWeightLine::Part::plugs:
            name = words.translate("V8", "plug");
            break;
        case BobWeightLine::Part::rod_big_end:
            name = words.translate("V8", "big end Δm_be");
            break;
        case BobWeightLine::Part::repair_bearing:
            name = words.translate("V8", "rep. shells Δm_sh");
            break;
        case BobWeightLine::Part::oil:
            name = words.translate("V8", "oil m_m");
            break;
    }
    return words.plain(line.factor, 3) + QStringLiteral(" × ") + name;
}

QString shortOption(const Words& words, OptionId option) {
    switch (option) {
        case OptionId::steel_machined:
            return words.translate("V8", "steel");
        case OptionId::steel_to_aluminium:
            return words.translate("V8", "aluminium");
        case OptionId::new_steel_to_steel:
            return words.translate("V8", "new shaft, steel");
        case OptionId::new_steel_to_aluminium:
            return words.translate("V8", "new shaft, aluminium");
    }
    return {};
}

QString partName(const Words& words, Part part) {
    switch (part) {
        case Part::piston:
            return words.translate("V8", "Piston");
        case Part::pin:
            return words.translate("V8", "Pin");
        case Part::rings:
            return words.translate("V8", "Rings");
        case Part::rod_big_end:
            return words.translate("V8", "Rod, big end");
        case Part::rod_small_end:
            return words.translate("V8", "Rod, small end");
        case Part::shells:
            return words.translate("V8", "Shells");
    }
    return {};
}

QString processName(const Words& words, Process process) {
    return process == Process::manufacture ? words.translate("V8", "Manufacture")
                                           : words.translate("V8", "Repair");
}

QString crankshaftName(const Words& words, Crankshaft crankshaft) {
    return crankshaft == Crankshaft::standard
               ? words.translate("V8", "Standard")
               : words.translate("V8", "Made for plugs of the new design");
}

QString materialName(const Words& words, PlugMaterial material) {
    return material == PlugMaterial::steel ? words.translate("V8", "Steel")
                                           : words.translate("V8", "Aluminium");
}

QString advice(const Words& words, const CaseInput& input, const Solution& solution) {
    if (!solution.advice || !solution.unbalanced_mass) {
        return {};
    }
    const Advice& advice = *solution.advice;
    const double excess = *solution.unbalanced_mass;
    const double unbalance = excess * input.engine.crank_radius.value_or(0.0);
    QString text;
    switch (advice.kind) {
        case Advice::Kind::none_needed:
            return words
                .translate("V8",
                           "Leave the plugs as they are: the excess of %1 per crankpin is %2.")
                .arg(grams(words, excess), within(words, unbalance, input.tolerance));
        case Advice::Kind::option: {
            const Option& option = *advice.option;
            text = action(words, option);
            if (option.residual_mass != 0.0) {
                text += QLatin1Char(' ') +
                        words.translate("V8", "This %1: %2.", "leaves …: … g·mm, within …")
                            .arg(overOrUnder(words, option),
                                 within(words, option.residual_unbalance, input.tolerance));
            }
            return text;
        }
        case Advice::Kind::no_new_plug_data:
            return words.translate("V8",
                                   "The crankshaft is made for plugs of the new design; their mass "
                                   "and radius are needed.");
        case Advice::Kind::too_light:
            text = words
                       .translate("V8",
                                  "The parts are %1 per crankpin lighter than nominal (%2), and "
                                  "plugs can only be lightened: heavier parts or heavier plugs are "
                                  "needed.")
                       .arg(grams(words, -excess), gramMillimetres(words, -unbalance));
            break;
        case Advice::Kind::none_sufficient:
        case Advice::Kind::none_light_enough: {
            const Option& closest = *advice.option;
            text =
                advice.kind == Advice::Kind::none_sufficient
                    ? words.translate("V8", "No plug of this crankshaft can be made light enough.")
                    : words.translate("V8",
                                      "No plug of this crankshaft has the mass that is needed.");
            text += QLatin1Char(' ') +
                    words
                        .translate("V8", "The nearest is “%1”, which %2: %3.",
                                   "option, leaves …, … g·mm against …")
                        .arg(optionName(words, closest.id), overOrUnder(words, closest),
                             against(words, closest.residual_unbalance, input.tolerance));
            break;
        }
    }
    if (advice.with_other_crankshaft) {
        const QString name = optionName(words, *advice.with_other_crankshaft);
        text += QLatin1Char(' ') +
                (needs_new_crankshaft(*advice.with_other_crankshaft)
                     ? words.translate("V8", "A crankshaft made for the new plugs would do: “%1”.")
                     : words.translate("V8", "A standard crankshaft would do: “%1”."))
                    .arg(name);
    }
    return text;
}

QString boring(const Words& words, const CaseInput& input, const Solution& solution,
               OptionId option) {
    const auto& plan = solution.boring[index(option)];
    if (!plan || !plan->cuts || !input.plug) {
        return {};
    }
    const BoreLimits limits = input.plug->limits().value();
    const QString cutter = millimetres(words, limits.cutter_diameter, 1);
    switch (plan->limit) {
        case Boring::Limit::wall:
            return words
                .translate("V8",
                           "It cannot be bored with a %1 cutter: a wall of %2 would be left under "
                           "the thread, and %3 must stay.")
                .arg(cutter, millimetres(words, plan->wall),
                     millimetres(words, limits.minimum_wall));
        case Boring::Limit::bottom:
            return words
                .translate("V8",
                           "It cannot be bored with a %1 cutter: a bore %2 deep is needed, and a "
                           "bottom of %3 must stay.")
                .arg(cutter, millimetres(words, plan->depth),
                     millimetres(words, limits.minimum_bottom));
        case Boring::Limit::none:
            break;
    }
    if (plan->deeper > 0.0 && input.plug->bore_depth.value_or(0.0) > 0.0) {
        return words.translate("V8", "Bore %1 deeper with a %2 cutter, to %3 from the face.")
            .arg(millimetres(words, plan->deeper), cutter, millimetres(words, plan->depth));
    }
    return words.translate("V8", "Bore with a %1 cutter to %2 from the face.")
        .arg(cutter, millimetres(words, plan->depth));
}

QString verdict(const Words& words, const Option& option, double tolerance) {
    if (option.feasible) {
        return option.residual_mass == 0.0
                   ? words.translate("V8", "works")
                   : words.translate("V8", "works: %1")
                         .arg(within(words, option.residual_unbalance, tolerance));
    }
    return overOrUnder(words, option) + QStringLiteral(": ") +
           against(words, option.residual_unbalance, tolerance);
}

QStringList massWarnings(const Words& words, const Solution& solution) {
    QStringList warnings;
    const auto warn = [&](const std::optional<PlugMass>& mass, PlugMaterial material) {
        if (mass && !mass->fits) {
            warnings << words
                            .translate("V8",
                                       "%1 plug: a plug of these dimensions weighs %2, but %3 was "
                                       "typed. Weigh it.")
                            .arg(materialName(words, material), grams(words, mass->geometry, 1),
                                 grams(words, mass->typed, 2));
        }
    };
    warn(solution.steel_plug, PlugMaterial::steel);
    warn(solution.aluminium_plug, PlugMaterial::aluminium);
    return warnings;
}

QString shiftText(const Words& words, const CaseInput& input, const Option& option) {
    const double plug = option.plug_mass_unmachined - option.reduction;
    return words
        .translate("V8",
                   "Neglected by the method: the plug's centre of mass moves by 0.8 to 1.2 mm when "
                   "it is bored, which is worth %1 to %2 beside the %3 allowed.")
        .arg(words.number(shift_unbalance(plug, smallest_shift) / gramMillimetre, 1),
             gramMillimetres(words, shift_unbalance(plug, largest_shift)),
             gramMillimetres(words, input.tolerance));
}

std::optional<Option> chosenOption(const Solution& solution) {
    return solution.advice ? solution.advice->option : std::nullopt;
}

bool works(const Solution& solution) {
    return solution.advice && (solution.advice->kind == Advice::Kind::option ||
                               solution.advice->kind == Advice::Kind::none_needed);
}

QString hang(const Words& words, const Solution& solution) {
    if (!solution.before) {
        return {};
    }
    const auto option = chosenOption(solution);
    const double weight =
        option ? solution.bob_weights[index(option->id)]->after.sum() : solution.before->sum();
    return (works(solution) ? words.translate("V8", "Hang %1 on each crankpin.")
                            : words.translate("V8", "Bob weight with the nearest option: %1."))
        .arg(grams(words, weight, 1));
}

QString bobWeightCheck(const Words& words, const CaseInput& input, const Solution& solution) {
    if (!solution.nominal || !solution.before) {
        return {};
    }
    const auto option = chosenOption(solution);
    const double after =
        option ? solution.bob_weights[index(option->id)]->after.sum() : solution.before->sum();
    const double difference = after - solution.nominal->sum();
    // Rounding of the sum, not a difference.
    if (std::abs(difference) < 1e-9 * solution.nominal->sum()) {
        return words.translate("V8", "After equals nominal: balanced.");
    }
    return words.translate("V8", "After less nominal: %1, which is %2.")
        .arg(grams(words, difference),
             gramMillimetres(words, difference * input.engine.crank_radius.value_or(0.0)));
}

QString assignmentText(const Words& words, const Solution& solution) {
    if (!solution.assignment || !solution.crankpin_excess || !solution.assigned_excess) {
        return {};
    }
    const auto spread = [](const std::array<double, crankpin_count>& totals) {
        const auto [least, most] = std::minmax_element(totals.begin(), totals.end());
        return *most - *least;
    };
    const QString before = grams(words, spread(*solution.crankpin_excess));
    if (solution.assignment->moved == 0) {
        return words
            .translate("V8", "The parts are placed as well as can be: the crankpins differ by %1.")
            .arg(before);
    }
    return words
        .translate("V8", "Crankpins differ by %1 as weighed and by %2 after moving %3 sets.")
        .arg(before, grams(words, spread(*solution.assigned_excess)),
             QString::number(solution.assignment->moved));
}

}  // namespace ravnoves::v8_text
