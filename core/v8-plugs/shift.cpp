#include "v8-plugs/shift.h"

#include <algorithm>
#include <cmath>

namespace ravnoves::v8_plugs {

namespace {

/// x (r_p + d(x)) = Δm r_p: what is cut counts at its own radius, not at that of the plug.
double bored_reduction(const Option& option, const BoreSetup& setup) {
    const double wanted = option.required_reduction * option.plug_radius;
    double low = 0.0;
    double high = option.max_reduction;
    const auto removed = [&](double x) {
        return x * (option.plug_radius + plan_boring(setup, x).cut_distance);
    };
    if (removed(high) <= wanted) {
        return high;
    }
    for (int i = 0; i < 200 && low < high; ++i) {
        const double middle = 0.5 * (low + high);
        if (middle == low || middle == high) {
            break;
        }
        (removed(middle) < wanted ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// (m − x)(r_p − Δr) = (m − Δm) r_p
double shifted_reduction(const Option& option, double shift) {
    const double mass = option.plug_mass_unmachined;
    const double wanted = mass - (mass - option.required_reduction) * option.plug_radius /
                                     (option.plug_radius - shift);
    return std::clamp(wanted, 0.0, option.max_reduction);
}

}  // namespace

std::optional<ShiftEffect> shift_effect(const Option& option, double tolerance,
                                        const std::optional<BoreSetup>& setup) {
    if (!option.machined()) {
        return std::nullopt;
    }
    const double mass = option.plug_mass_unmachined;
    const double plug = mass - option.reduction;
    ShiftEffect effect;
    effect.planned = setup.has_value();
    if (setup) {
        // The body's own shift; what is cut off counts at its radius, whatever the plug weighs.
        const Boring boring = plan_boring(*setup, option.reduction);
        effect.min_shift = effect.max_shift = boring.shift;
        effect.minimum = effect.maximum = 2.0 * option.reduction * boring.cut_distance;
    } else {
        effect.min_shift = smallest_shift;
        effect.max_shift = largest_shift;
        effect.minimum = shift_unbalance(plug, smallest_shift);
        effect.maximum = shift_unbalance(plug, largest_shift);
    }
    const double one = option.residual_unbalance - effect.minimum;
    const double other = option.residual_unbalance - effect.maximum;
    effect.residual_unbalance = std::abs(one) > std::abs(other) ? one : other;
    effect.matters = option.feasible && std::abs(effect.residual_unbalance) > tolerance;
    if (setup) {
        effect.min_reduction = effect.max_reduction = effect.reduction =
            bored_reduction(option, *setup);
        const Boring boring = plan_boring(*setup, effect.reduction);
        effect.radius =
            option.plug_radius - effect.reduction * boring.cut_distance / (mass - effect.reduction);
        if (boring.limit == Boring::Limit::none) {
            effect.depth = boring.depth;
        }
    } else {
        effect.min_reduction = shifted_reduction(option, effect.max_shift);
        effect.max_reduction = shifted_reduction(option, effect.min_shift);
        const double halfway = 0.5 * (effect.min_shift + effect.max_shift);
        effect.reduction = shifted_reduction(option, halfway);
        effect.radius = option.plug_radius - (effect.reduction > 0.0 ? halfway : 0.0);
        for (const double shift : {effect.min_shift, effect.max_shift}) {
            const double left = (mass - effect.reduction) * (option.plug_radius - shift) -
                                (mass - option.required_reduction) * option.plug_radius;
            effect.uncertainty = std::max(effect.uncertainty, 2.0 * std::abs(left));
        }
    }
    return effect;
}

Message describe(const ShiftEffect& effect, double tolerance) {
    if (!effect.matters) {
        return {};
    }
    const Number beyond = shop::in_gram_millimetres(std::abs(effect.residual_unbalance));
    const Number allowed = shop::in_gram_millimetres(tolerance);
    const Message neglect =
        effect.planned
            ? Message(
                  Text::tr("The paper's method alone would leave %1, permissible %2: it neglects "
                           "the shift of the plug's centre of mass."),
                  beyond, allowed)
            : Message(Text::tr("The method neglects the shift of the plug's centre of mass, %3 to "
                               "%4 in the paper: the residual is up to %1, permissible %2."),
                      beyond, allowed, Number{smallest_shift / units::mm, units::mm, 0, true},
                      Number{largest_shift / units::mm, units::mm});
    const Number off = shop::in_grams(effect.reduction);
    if (!effect.planned) {
        return shop::two_sentences(
            neglect, {Text::tr("Enter the plug's sizes and the cutter, or take off %1 each: the "
                               "residual is then up to %2."),
                      off, shop::in_gram_millimetres(effect.uncertainty)});
    }
    if (!effect.depth) {
        return shop::two_sentences(neglect, {Text::tr("Take off %1 each."), off});
    }
    return shop::two_sentences(neglect, {Text::tr("Bore to %1 from the face, %2 off each plug."),
                                         Number{*effect.depth / units::mm, units::mm, -2}, off});
}

}  // namespace ravnoves::v8_plugs
