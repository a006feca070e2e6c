#include "inertia-moments/rotating_masses.h"

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

}  // namespace ravnoves::inertia_moments
