#include "inertia-moments/result.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "case-file/unusual_engine.h"
#include "inertia-moments/presets.h"

namespace ravnoves::inertia_moments {

namespace {

constexpr double usual_step = 1.0 * degree;

/// Where the rods of a throw cannot be as they are given: three or more cannot run on one pin in
/// one plane, so all but one of them hang on the master rod, and are not longer than it.
void add_rod_doubts(const Engine& engine, double rod_length, std::vector<Message>& notes) {
    constexpr double same_plane = 1e-3;  // of the crank radius
    constexpr double rounding = 1e-9;    // of the length
    for (const Throw& each : engine.throws) {
        // From the front to the rear: those of one plane follow one another.
        std::vector<std::size_t> plane;
        std::vector<std::size_t> widest;
        for (const std::size_t i : each.cylinders) {
            const Cylinder& cylinder = engine.cylinders[i];
            if (cylinder.articulated) {
                continue;
            }
            if (!plane.empty() &&
                std::abs(cylinder.axial_position - engine.cylinders[plane.back()].axial_position) >
                    same_plane * engine.crank_radius) {
                plane.clear();
            }
            plane.push_back(i);
            if (plane.size() > widest.size()) {
                widest = plane;
            }
        }
        if (widest.size() >= 3) {
            notes.emplace_back(
                Text::tr("Cylinders %1 share a crankpin but are computed as plain rods: "
                         "\"Articulated rods\" above the table adds a second order of 5 to 12 % "
                         "and uneven dead centres."),
                numbers_of(widest));
        }
    }
    std::vector<std::size_t> longer;
    for (std::size_t i = 0; i < engine.cylinders.size(); ++i) {
        const auto& rod = engine.cylinders[i].articulated;
        if (rod && *rod->rod_length > rod_length * (1.0 + rounding)) {
            longer.push_back(i);
        }
    }
    if (!longer.empty()) {
        notes.emplace_back(
            Text::tr("The articulated rods of cylinders %1 are longer than the master rod (%2); "
                     "usual: shorter by about the knuckle radius."),
            numbers_of(longer),
            Number{.value = rod_length / units::mm, .unit = units::mm, .digits = 6});
    }
}

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
    if (input.layout && input.layout->stagger != 0.0 && !has_paired_banks(*input.layout)) {
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
    add_rod_doubts(engine, input.rod_length(), result.notes);
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
        // What is added: less work than a sum over all orders, and exact.
        EngineOrders added;
        while (added.orders.size() < result.exact.orders.size()) {
            const auto order = static_cast<int>(added.orders.size()) + 1;
            added.orders.emplace_back().order = order;
        }
        added = with_rotating(engine, std::move(added), result.rotating);
        result.unbalanced_curves = with_orders(result.curves, added);
        result.remaining_curves =
            with_orders(result.curves, with_balancing(std::move(added), counted, result.shafts));
    }
    return result;
}

}  // namespace ravnoves::inertia_moments
