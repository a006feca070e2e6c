#include "inertia-moments/comparison.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ravnoves::inertia_moments {

std::array<Harmonic<double>, 5> components(const EngineOrder& order) {
    return {order.force.horizontal(), order.force.vertical(), order.moment.horizontal(),
            order.moment.vertical(), order.roll()};
}

std::vector<Difference> compare(const EngineOrders& exact, const EngineOrders& two_term) {
    constexpr double warning = 0.05;     // of a component, an error warns…
    constexpr double negligible = 0.01;  // …unless it is less of the quantity's largest one…
    constexpr double balanced = 0.02;  // …or of all cylinders in phase, as a balanced engine has
    // A quantity's size: what its cylinders would reach in phase is the floor under rounding.
    std::array<double, 3> largest{};
    std::array<double, 3> scale{};
    for (const EngineOrder& order : exact.orders) {
        const auto values = components(order);
        for (std::size_t c = 0; c < values.size(); ++c) {
            largest[c / 2] = std::max(largest[c / 2], amplitude(values[c]));
        }
        scale[0] = std::max(scale[0], order.force_scale);
        scale[1] = std::max(scale[1], order.moment_scale);
        scale[2] = std::max(scale[2], order.roll_scale);
    }
    std::vector<Difference> differences;
    for (const EngineOrder& order : exact.orders) {
        const auto values = components(order);
        const bool has_short = order.order <= static_cast<int>(two_term.orders.size());
        const auto short_forms =
            components(has_short ? two_term.order(order.order) : EngineOrder());
        for (std::size_t c = 0; c < values.size(); ++c) {
            const std::size_t q = c / 2;
            const Harmonic<double>& right = values[c];
            Harmonic<double> short_form = short_forms[c];
            Difference d;
            d.order = order.order;
            d.component = c;
            d.exact = amplitude(right);
            const double floor = zero_share * scale[q];
            d.two_term = amplitude(short_form);
            if (!(d.two_term > std::max(floor, zero_share * largest[q]))) {
                d.two_term = 0.0;  // what rounding leaves
                short_form = {};
            }
            d.error = std::hypot(right.cos - short_form.cos, right.sin - short_form.sin);
            const double reference = std::max(largest[q], balanced * scale[q]);
            if (reference > 0.0) {
                d.of_largest = d.error / reference;
            }
            if (d.exact > std::max(floor, zero_share * largest[q])) {
                d.relative = d.error / d.exact;
                d.warning = *d.relative > warning && d.of_largest > negligible;
            }
            differences.push_back(d);
        }
    }
    return differences;
}

Message describe(const Difference& difference) {
    constexpr Text quantities[] = {Text::tr("order %1 force"), Text::tr("order %1 moment"),
                                   Text::tr("order %1 roll moment")};
    constexpr Text planes[] = {Text::tr("%1, horizontal plane"), Text::tr("%1, vertical plane")};
    Message component(quantities[difference.component / 2], difference.order);
    if (difference.component < 4) {
        component = Message(planes[difference.component % 2], component);
    }
    const auto percent = [](double share) {
        return Number{share / units::percent, units::none, -1};
    };
    if (difference.two_term == 0.0) {
        return {Text::tr("%1: not in the two-term form, %2 % of the maximum order"), component,
                percent(difference.of_largest)};
    }
    return {Text::tr("%1: error of the two-term form %2 %"), component,
            percent(difference.relative.value_or(0.0))};
}

}  // namespace ravnoves::inertia_moments
