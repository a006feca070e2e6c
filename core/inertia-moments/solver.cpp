#include "inertia-moments/solver.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "case-file/unusual_engine.h"
#include "inertia-moments/presets.h"

namespace ravnoves::inertia_moments {

namespace {

constexpr double usual_step = 1.0 * degree;

/// What no engine is like, a slip of the keys or of a unit. Along the crank it is measured by the
/// crank radius R: cylinders of one direction are 0.7 R (long strokes) to 6 R (racing engines)
/// apart.
void add_doubts(const Input& input, Result& result) {
    const Engine& engine = result.engine;
    const double length = input.rod_length();
    const double radius = input.crank_radius;
    const auto doubt = [&](bool is_odd, const Text& text, Number size, Number beside) {
        if (is_odd) {
            result.notes.emplace_back(text, size, beside);
        }
    };
    if (input.rod) {
        const double centre = input.rod->centre_from_big_end;
        doubt(centre < 0.0 || centre > length,
              Text::tr("The rod's centre of mass, %1 from the big end, is outside the rod of %2: "
                       "check it."),
              in_mm(centre), in_mm(length));
        const double gyration = std::sqrt(input.rod->inertia / input.rod->mass);
        doubt(gyration > length,
              Text::tr("The rod's inertia is implausible: radius of gyration %1, rod %2. Check its "
                       "unit."),
              in_mm(gyration), in_mm(length));
    }
    if (input.layout && input.layout->stagger != 0.0 &&
        !has_paired_banks(arrangement_of(*input.layout))) {
        result.notes.emplace_back(
            Text::tr("The stagger of %1 has no effect: no throw has cylinders of two banks."),
            in_mm(input.layout->stagger));
    }
    const auto count = static_cast<double>(engine.cylinders.size());
    const auto [rear, front] = extent(engine.cylinders);
    double spacing = (front - rear) / std::max(count - 1.0, 1.0);
    bool is_close = false;
    for (const Cylinder& one : engine.cylinders) {
        for (const Cylinder& other : engine.cylinders) {
            const double gap = std::abs(one.axial_position - other.axial_position);
            if (&one < &other && one.bank_angle == other.bank_angle && one.offset == other.offset &&
                gap < 0.4 * radius) {
                spacing = is_close ? std::min(spacing, gap) : gap;
                is_close = true;
            }
        }
    }
    constexpr double far = 8.0;
    doubt(is_close || spacing > far * radius,
          Text::tr("Cylinder spacing %1 is implausible with crank radius %2: check it."),
          in_mm(spacing), in_mm(radius));
    const double beyond =
        std::max(input.reference_position - front, rear - input.reference_position);
    doubt(beyond > front - rear + far * radius,
          Text::tr("The centre of mass z₀ is %1 outside the cylinders, with crank radius %2: check "
                   "it."),
          in_mm(beyond), in_mm(radius));
    if (const auto& weights = result.counterweights) {
        const EndWebs& webs = *input.end_webs;
        doubt(webs.front_position < front || webs.rear_position > rear,
              Text::tr("The counterweights at z = %1 and %2 are not beyond the outer cylinders: "
                       "check their places."),
              in_mm(webs.front_position), in_mm(webs.rear_position));
        const double mass = std::max(weights->front.mass(), weights->rear.mass());
        const double all = count * (engine.rotating_mass + engine.reciprocating_mass);
        doubt(mass > all,
              Text::tr("A counterweight of %1 is heavier than all throws and pistons (%2): check "
                       "places and radii of the counterweights."),
              Number{mass, units::kg, 4}, Number{all, units::kg, 4});
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
    if (const Message note = unusual_rod_note(engine.cylinders, input.rod_length());
        !note.empty()) {
        result.notes.push_back(note);
    }
    std::ranges::move(unusual_engine_notes({input.angular_speed,
                                            input.crank_radius,
                                            input.rod_length(),
                                            {input.reciprocating_mass, input.rotating_mass,
                                             input.rod ? input.rod->mass : 0.0}}),
                      std::back_inserter(result.notes));
    add_doubts(input, result);
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
