#include "inertia-moments/comparison.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace ravnoves::inertia_moments {

namespace {

struct Component {
    Quantity quantity;
    Plane plane;
};
constexpr std::array components{
    Component{Quantity::force, Plane::horizontal}, Component{Quantity::force, Plane::vertical},
    Component{Quantity::moment, Plane::horizontal}, Component{Quantity::moment, Plane::vertical},
    Component{Quantity::roll, Plane::none}};

Harmonic<double> value_of(const EngineOrder& order, const Component& component) {
    if (component.quantity == Quantity::roll) {
        return order.roll();
    }
    const RotatingPair& pair = component.quantity == Quantity::force ? order.force : order.moment;
    return component.plane == Plane::horizontal ? pair.horizontal() : pair.vertical();
}

}  // namespace

std::vector<Difference> compare(const EngineOrders& exact, const EngineOrders& two_term) {
    // A quantity's size: what its cylinders would reach in phase is the floor under rounding.
    std::array<double, 3> largest{};
    std::array<double, 3> scale{};
    for (const EngineOrder& order : exact.orders) {
        for (const Component& component : components) {
            const auto q = static_cast<std::size_t>(component.quantity);
            largest[q] = std::max(largest[q], amplitude(value_of(order, component)));
        }
        scale[0] = std::max(scale[0], order.force_scale);
        scale[1] = std::max(scale[1], order.moment_scale);
        scale[2] = std::max(scale[2], order.roll_scale);
    }
    std::vector<Difference> differences;
    differences.reserve(exact.orders.size() * components.size());
    for (const EngineOrder& order : exact.orders) {
        for (const Component& component : components) {
            const auto q = static_cast<std::size_t>(component.quantity);
            const Harmonic<double> right = value_of(order, component);
            Harmonic<double> short_form;
            if (order.order <= static_cast<int>(two_term.orders.size())) {
                short_form = value_of(two_term.order(order.order), component);
            }
            Difference d;
            d.order = order.order;
            d.quantity = component.quantity;
            d.plane = component.plane;
            d.exact = amplitude(right);
            d.two_term = amplitude(short_form);
            d.error = std::hypot(right.cos - short_form.cos, right.sin - short_form.sin);
            const double floor = zero_share * scale[q];
            const double reference = std::max(largest[q], balanced_share * scale[q]);
            if (reference > 0.0) {
                d.of_largest = d.error / reference;
            }
            if (d.exact > std::max(floor, zero_share * largest[q])) {
                d.relative = d.error / d.exact;
                d.warning = *d.relative > warning_share && d.of_largest > negligible_share;
            }
            differences.push_back(d);
        }
    }
    return differences;
}

std::string describe(const Difference& difference) {
    std::string text = "order " + std::to_string(difference.order);
    switch (difference.quantity) {
        case Quantity::force:
            text += " force";
            break;
        case Quantity::moment:
            text += " moment";
            break;
        case Quantity::roll:
            text += " roll moment";
            break;
    }
    switch (difference.plane) {
        case Plane::horizontal:
            text += ", horizontal plane";
            break;
        case Plane::vertical:
            text += ", vertical plane";
            break;
        case Plane::none:
            break;
    }
    std::array<char, 64> number{};
    if (difference.two_term == 0.0) {
        std::snprintf(number.data(), number.size(), "%.1f", 100.0 * difference.of_largest);
        return text + ": the two-term form leaves it out, " + number.data() +
               " % of the largest order";
    }
    std::snprintf(number.data(), number.size(), "%.1f", 100.0 * difference.relative.value_or(0.0));
    return text + ": the two-term form is " + number.data() + " % off";
}

}  // namespace ravnoves::inertia_moments
