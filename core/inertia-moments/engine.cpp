#include "inertia-moments/engine.h"

#include <cmath>

#include "inertia-moments/fields.h"
#include "inertia-moments/layouts.h"

namespace ravnoves::inertia_moments {

namespace {

/// Nearer to locking than this share of the rod, rounding decides whether the crank passes.
constexpr double locking_margin = 1e-12;

}  // namespace

std::vector<Cylinder> rounded(std::vector<Cylinder> cylinders) {
    const auto round = [](double& si, const Field& field) {
        si = ravnoves::rounded(si, field, 12);
    };
    for (Cylinder& cylinder : cylinders) {
        round(cylinder.axial_position, field::axial_position);
        round(cylinder.bank_angle, field::bank_angle);
        round(cylinder.offset, field::offset);
        round(cylinder.crankpin_angle, field::crankpin_angle);
    }
    return cylinders;
}

std::optional<Locking> find_locking(double crank_radius, double lambda,
                                    const std::vector<Cylinder>& cylinders) {
    for (std::size_t i = 0; i < cylinders.size(); ++i) {
        const SliderCrank<double> crank{1.0, 1.0 / lambda, cylinders[i].offset / crank_radius};
        if (crank.locks()) {
            return Locking{i, crank.locking_angles()};
        }
        const double margin = crank.rod_length - 1.0 - std::abs(crank.offset);
        if (margin < locking_margin * crank.rod_length) {
            // As good as locked: the angle is that of the mechanism that just locks.
            const SliderCrank<double> just{1.0, 1.0 + std::abs(crank.offset), crank.offset};
            return Locking{i, just.locking_angles()};
        }
    }
    return std::nullopt;
}

Message describe(const Locking& locking) {
    const auto number = static_cast<double>(locking.cylinder + 1);
    if (!locking.angles) {
        return {CORE_TEXT("inertia-moments",
                          "the mechanism of cylinder %1 cannot be joined: the rod reaches the "
                          "piston at no crank angle"),
                number};
    }
    return {CORE_TEXT("inertia-moments",
                      "the mechanism of cylinder %1 locks with the crank at %2 turning forward and "
                      "at %3 turning back, measured from the cylinder's axis"),
            number, Number{locking.angles->forward / degree, units::degree, 4},
            Number{locking.angles->backward / degree, units::degree, 4}};
}

Engine reduce(const Input& input) {
    Engine engine;
    engine.crank_radius = input.crank_radius;
    engine.lambda = input.lambda;
    engine.angular_speed = input.angular_speed;
    engine.reciprocating_mass = input.reciprocating_mass;
    engine.reference_position = input.reference_position;
    engine.cylinders = input.layout ? make_cylinders(*input.layout, input.crank_radius,
                                                     input.lambda, input.cycle())
                                    : input.cylinders;
    for (Cylinder& cylinder : engine.cylinders) {
        cylinder.crankpin_angle = wrap_turn(cylinder.crankpin_angle);
    }
    engine.throws = crank_throws(engine.cylinders, engine.crank_radius);
    engine.rotating_mass = input.rotating_mass;
    if (input.rotating_mass_of_throw) {
        engine.rotating_mass /= static_cast<double>(rods_per_throw(engine.throws).value_or(1));
    }
    if (input.rod) {
        const RigidRod& rod = *input.rod;
        const double length = input.rod_length();
        const double share = rod.centre_from_big_end / length;  // at the small end
        engine.reciprocating_mass += rod.mass * share;
        engine.rotating_mass += rod.mass * (1.0 - share);
        engine.rod_couple_inertia =
            rod.inertia - rod.mass * rod.centre_from_big_end * (length - rod.centre_from_big_end);
    }
    return engine;
}

Engine make_engine(const Input& input) {
    check_input(input);
    return reduce(input);
}

}  // namespace ravnoves::inertia_moments
