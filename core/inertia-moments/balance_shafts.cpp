#include "inertia-moments/balance_shafts.h"

#include <cmath>

namespace ravnoves::inertia_moments {

namespace {

bool same_task(const Shaft& a, const Shaft& b) {
    return a.order == b.order && a.direction == b.direction && a.balances == b.balances;
}

/// Its part of a pair.
Complex RotatingPair::*way(const Shaft& shaft) {
    return shaft.direction == Direction::forward ? &RotatingPair::forward : &RotatingPair::backward;
}

/// With the shaft's own weight of task and error: what it adds to force or moment.
Complex counter_vector(const ShaftDesign& design) {
    // A forward shaft that runs ahead by the error leads in +; a backward one in −.
    const double sign = design.shaft.direction == Direction::forward ? 1.0 : -1.0;
    return -design.target * std::polar(1.0, sign * design.shaft.phase_error);
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
        const Complex added = counter_vector(design);
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
