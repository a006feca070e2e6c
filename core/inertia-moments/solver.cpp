#include "inertia-moments/solver.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "case-file/unusual_engine.h"

namespace ravnoves::inertia_moments {

namespace {

constexpr double usual_step = 1.0 * degree;

/// A rod's mass is between its bearings or little beyond them.
void doubt_rod(const RigidRod& rod, double length, std::vector<Message>& doubts) {
    if (rod.centre_from_big_end < 0.0 || rod.centre_from_big_end > length) {
        doubts.emplace_back(Text::tr("The rod's centre of mass, %1 from the big end, is outside "
                                     "the rod of %2: check it."),
                            in_mm(rod.centre_from_big_end), in_mm(length));
    }
    const double gyration = std::sqrt(rod.inertia / rod.mass);
    if (gyration > length) {
        doubts.emplace_back(Text::tr("The rod's inertia is implausible: radius of gyration %1, "
                                     "rod %2. Check its unit."),
                            in_mm(gyration), in_mm(length));
    }
}

/// Adds the constant-speed parts (forward order 1) and the shafts to curves of the reciprocating
/// parts: less work than a sum over all orders, and exact.
WrenchCurves balanced_curves(const WrenchCurves& curves, const EngineOrders& orders,
                             const EngineOrders& remaining) {
    // The differences of the orders are what was added, a handful of rotating vectors.
    EngineOrders added;
    for (std::size_t i = 0; i < orders.orders.size(); ++i) {
        EngineOrder& order = added.orders.emplace_back();
        order.order = orders.orders[i].order;
        order.force = remaining.orders[i].force - orders.orders[i].force;
        order.moment = remaining.orders[i].moment - orders.orders[i].moment;
    }
    return with_orders(curves, added);
}

/// The orders with the rotating masses added.
EngineOrders with_rotating(const Engine& engine, EngineOrders orders,
                           const RotatingMasses& rotating) {
    const Complex pin = crankpin_direction(engine);
    EngineOrder& first = orders.orders.front();
    first.force.forward += rotating.force() * pin;
    first.moment.forward += rotating.moment_about(engine.reference_position) * pin;
    return orders;
}

/// What is left over: with the counterweights and shafts that are on.
EngineOrders with_balancing(EngineOrders orders,
                            const std::optional<CounterweightDesign>& counterweights,
                            const std::vector<ShaftDesign>& shafts) {
    if (counterweights) {
        orders.orders.front().force.forward += counterweights->force;
        orders.orders.front().moment.forward += counterweights->moment;
    }
    for (const ShaftDesign& design : shafts) {
        if (design.shaft.enabled) {
            EngineOrder& order = orders.orders[static_cast<std::size_t>(design.shaft.order) - 1];
            order.force += design.force;
            order.moment += design.moment;
        }
    }
    return orders;
}

}  // namespace

Result solve(const Input& input, bool with_curves) {
    Result result;
    result.engine = make_engine(input);
    const Engine& engine = result.engine;
    result.exact = exact_orders(engine);
    result.two_term = two_term_orders(engine);
    result.differences = compare(result.exact, result.two_term);
    result.rotating = rotating_masses(engine);
    const EngineOrders& basis =
        input.shaft_basis == DesignBasis::exact ? result.exact : result.two_term;
    if (input.end_webs) {
        result.counterweights =
            design_counterweights(engine, result.rotating, basis.order(1), *input.end_webs);
    }
    // Counterweights may take the forward part of order 1 over: shafts are made for the rest.
    const bool weighted = result.counterweights && input.end_webs->enabled;
    const auto counted = weighted ? result.counterweights : std::nullopt;
    const EngineOrders for_shafts =
        weighted ? with_balancing(with_rotating(engine, basis, result.rotating), counted, {})
                 : basis;
    result.shafts = design_shafts(engine, for_shafts, input.shafts);
    result.unbalanced = with_rotating(engine, result.exact, result.rotating);
    result.two_term_unbalanced = with_rotating(engine, result.two_term, result.rotating);
    result.remaining = with_balancing(result.unbalanced, counted, result.shafts);
    const auto& order = input.layout ? input.layout->firing_order : input.firing_order;
    result.firing = firing_events(engine, order, input.cycle());
    if (result.firing.empty() && !order.empty()) {
        result.firing_trouble = describe_misfit(engine, order, input.cycle());
    }
    result.notes = articulated_rod_notes(engine.throws, engine.cylinders, engine.crank_radius);
    std::vector<Message> doubts = unusual_engine_notes(
        {input.angular_speed,
         input.crank_radius,
         input.rod_length(),
         {input.reciprocating_mass, input.rotating_mass, input.rod ? input.rod->mass : 0.0}});
    if (input.rod) {
        doubt_rod(*input.rod, input.rod_length(), doubts);
    }
    if (const Message note = unusual_rod_note(engine.cylinders, input.rod_length());
        !note.empty()) {
        result.notes.push_back(note);
    }
    result.notes.insert(result.notes.end(), doubts.begin(), doubts.end());
    if (with_curves) {
        const double step = input.step.value_or(usual_step);
        const double intervals = std::ceil(two_pi / step - 1e-9);
        std::vector<double> angles;
        for (double i = 0.0; i <= intervals; ++i) {
            angles.push_back(two_pi * i / intervals);
        }
        result.curves = exact_curves(engine, std::move(angles));
        result.unbalanced_curves = balanced_curves(result.curves, result.exact, result.unbalanced);
        result.remaining_curves = balanced_curves(result.curves, result.exact, result.remaining);
    }
    return result;
}

}  // namespace ravnoves::inertia_moments
