#include "inertia-moments/balancing.h"

#include <cmath>

namespace ravnoves::inertia_moments {

RotatingMasses rotating_masses(const Engine& engine) {
    RotatingMasses sums;
    const auto count = static_cast<double>(engine.cylinders.size());
    for (const Cylinder& cylinder : engine.cylinders) {
        sums.mean_position += cylinder.axial_position / count;
    }
    for (const Cylinder& cylinder : engine.cylinders) {
        const Complex pin = std::polar(1.0, cylinder.crankpin_angle);
        const double lever = cylinder.axial_position - sums.mean_position;
        sums.force_factor += pin;
        sums.moment_factor += lever * pin;
        sums.moment_scale += std::abs(lever);
    }
    sums.force_scale = count;
    sums.mass_force =
        engine.rotating_mass * engine.crank_radius * engine.angular_speed * engine.angular_speed;
    return sums;
}

Complex crankpin_direction(const Engine& engine) {
    const double beta = engine.cylinders.front().bank_angle;
    return Complex(-std::sin(beta), std::cos(beta));
}

CounterweightDesign design_counterweights(const Engine& engine, const RotatingMasses& rotating,
                                          const EngineOrder& first_order, const EndWebs& webs) {
    CounterweightDesign design;
    const Complex to_pin = std::conj(crankpin_direction(engine));
    const Complex force_1 = first_order.force.forward * to_pin * webs.first_order_share;
    // The moment of that force moves with the point from the reference position to z̄.
    const Complex moment_1 = first_order.moment.forward * to_pin * webs.first_order_share +
                             force_1 * (engine.reference_position - rotating.mean_position);
    const Complex balanced_force = rotating.force() + force_1;
    const Complex balanced_moment = rotating.moment() + moment_1;

    const double omega_2 = engine.angular_speed * engine.angular_speed;
    const double distance = webs.front_position - webs.rear_position;
    const double front_lever = webs.front_position - rotating.mean_position;
    const double rear_lever = webs.rear_position - rotating.mean_position;
    // Front and rear together −F at z̄, and a couple −M over the distance of the webs.
    design.against_force = -balanced_force / omega_2;
    design.against_moment = -balanced_moment / (omega_2 * distance);
    design.front = {design.against_force * (-rear_lever / distance) + design.against_moment,
                    webs.front_position, webs.front_radius};
    design.rear = {design.against_force * (front_lever / distance) - design.against_moment,
                   webs.rear_position, webs.rear_radius};

    const double force_scale = rotating.mass_force * rotating.force_scale +
                               webs.first_order_share * first_order.force_scale;
    const double moment_scale =
        rotating.mass_force * rotating.moment_scale +
        webs.first_order_share * (first_order.moment_scale +
                                  first_order.force_scale *
                                      std::abs(engine.reference_position - rotating.mean_position));
    design.scale = (force_scale * (std::abs(front_lever) + std::abs(rear_lever)) + moment_scale) /
                   (omega_2 * std::abs(distance));

    const Complex from_pin = crankpin_direction(engine) * omega_2;
    design.force = (design.front.unbalance + design.rear.unbalance) * from_pin;
    design.moment = (design.front.unbalance * (webs.front_position - engine.reference_position) +
                     design.rear.unbalance * (webs.rear_position - engine.reference_position)) *
                    from_pin;
    return design;
}

namespace {

bool same_task(const Shaft& a, const Shaft& b) {
    return a.order == b.order && a.direction == b.direction && a.balances == b.balances;
}

/// Its part of a pair.
Complex RotatingPair::*way(const Shaft& shaft) {
    return shaft.direction == Direction::forward ? &RotatingPair::forward : &RotatingPair::backward;
}

}  // namespace

std::vector<ShaftDesign> design_shafts(const Engine& engine, const EngineOrders& orders,
                                       const std::vector<Shaft>& shafts) {
    std::vector<ShaftDesign> designs(shafts.size());
    const auto design_one = [&](std::size_t i) {
        ShaftDesign& design = designs[i];
        const Shaft& shaft = shafts[i];
        design.shaft = shaft;
        RotatingPair task;
        if (shaft.order <= static_cast<int>(orders.orders.size())) {
            const EngineOrder& order = orders.order(shaft.order);
            task = shaft.balances == Balances::force ? order.force : order.moment;
            design.scale =
                shaft.balances == Balances::force ? order.force_scale : order.moment_scale;
        }
        if (shaft.balances == Balances::moment) {
            for (const ShaftDesign& other : designs) {
                if (other.shaft.balances == Balances::force && other.shaft.enabled &&
                    other.shaft.order == shaft.order) {
                    task += other.moment;
                }
            }
        }
        double sharing = 0.0;
        for (const Shaft& other : shafts) {
            sharing += same_task(other, shaft) && (other.enabled || &other == &shaft) ? 1.0 : 0.0;
        }
        design.target = task.*way(shaft) / (shaft.enabled ? sharing : 1.0);
        const double speed = shaft.order * engine.angular_speed;
        const double arm = shaft.balances == Balances::force ? 1.0 : shaft.weight_distance;
        design.unbalance = std::abs(design.target) / (arm * speed * speed);
        if (shaft.weight_radius) {
            design.mass = design.unbalance / *shaft.weight_radius;
        }
        // A forward shaft that runs ahead by the error leads in +; a backward one in −.
        const double sign = shaft.direction == Direction::forward ? 1.0 : -1.0;
        const Complex added = -design.target * std::polar(1.0, sign * shaft.phase_error);
        if (std::abs(design.target) > zero_share * design.scale) {
            design.phase = std::arg(added);
        }
        design.moment.*way(shaft) = added;
        if (shaft.balances == Balances::force) {
            design.force.*way(shaft) = added;
            const double z = shaft.axial_position.value_or(engine.reference_position);
            design.moment.*way(shaft) *= z - engine.reference_position;
        }
        design.before = task.max();
        task.*way(shaft) += added;
        design.remaining = task.max();
    };
    for (const Balances balances : {Balances::force, Balances::moment}) {
        for (std::size_t i = 0; i < shafts.size(); ++i) {
            if (shafts[i].balances == balances) {
                design_one(i);
            }
        }
    }
    return designs;
}

}  // namespace ravnoves::inertia_moments
