#include "inertia-moments/engine.h"

#include <cmath>

#include "case-file/field_index.h"
#include "inertia-moments/layouts.h"

namespace ravnoves::inertia_moments {

std::vector<Cylinder> rounded(std::vector<Cylinder> cylinders) {
    for (Cylinder& cylinder : cylinders) {
        for (const FieldEntry& entry : list_fields(cylinder)) {
            const bool is_there =
                cylinder.articulated || !entry.pointer.starts_with("/articulated");
            if (is_there && entry.place != nullptr) {
                *entry.place = ravnoves::rounded(*entry.place, entry.field, 12);
            }
        }
    }
    return cylinders;
}

std::optional<Locking> find_locking(double crank_radius, double lambda,
                                    const std::vector<Cylinder>& cylinders) {
    for (std::size_t i = 0; i < cylinders.size(); ++i) {
        if (cylinders[i].articulated) {
            continue;
        }
        const SliderCrank<double> crank{1.0, 1.0 / lambda, cylinders[i].offset / crank_radius};
        if (crank.locks()) {
            return Locking{i, crank.locking_angles()};
        }
        const double margin = crank.rod_length - 1.0 - std::abs(crank.offset);
        if (margin < nearest_to_locking * crank.rod_length) {
            // As good as locked: the angle is that of the mechanism that just locks.
            const SliderCrank<double> just{1.0, 1.0 + std::abs(crank.offset), crank.offset};
            return Locking{i, just.locking_angles()};
        }
    }
    return std::nullopt;
}

ArticulatedCrank Engine::crank(std::size_t cylinder) const {
    const Cylinder& own = cylinders[cylinder];
    const double offset = own.offset / crank_radius;
    if (!own.articulated) {
        return {mechanism(own), 1.0, 0.0, 1.0 / lambda, offset};
    }
    const ArticulatedRod& rod = *own.articulated;
    const Cylinder& master = cylinders[static_cast<std::size_t>(rod.master) - 1];
    const double between = own.bank_angle - master.bank_angle;
    return {mechanism(master), std::polar(1.0, between),
            std::polar(rod.knuckle_radius / crank_radius, *rod.knuckle_angle - between),
            *rod.rod_length / crank_radius, offset};
}

double Engine::stroke(std::size_t cylinder) const {
    const double relative = crank(cylinder).stroke();
    // Rods so long that their square overflows move the piston as a Scotch yoke does.
    return crank_radius * (std::isfinite(relative) ? relative : 2.0);
}

Message describe(const Locking& locking) {
    const auto number = static_cast<double>(locking.cylinder + 1);
    if (!locking.angles) {
        return {Text::tr("the mechanism of cylinder %1 is not possible: the rod does not reach "
                         "the piston at any crank angle"),
                number};
    }
    return {Text::tr("the mechanism of cylinder %1 locks with the crank at %2 turning forward and "
                     "at %3 turning back, measured from the cylinder's axis"),
            number, Number{locking.angles->forward / degree, units::degree, 4},
            Number{locking.angles->backward / degree, units::degree, 4}};
}

Engine reduce(const Input& input) {
    Engine engine;
    engine.crank_radius = input.crank_radius;
    engine.lambda = input.ratio();
    engine.angular_speed = input.angular_speed;
    engine.reciprocating_mass = input.reciprocating_mass;
    engine.reference_position = input.reference_position;
    engine.cylinders = input.layout ? make_cylinders(input) : input.cylinders;
    for (Cylinder& cylinder : engine.cylinders) {
        cylinder.crankpin_angle = wrap_turn(cylinder.crankpin_angle);
    }
    engine.throws = crank_throws(engine.cylinders, engine.crank_radius);
    complete_rods(engine.cylinders, engine.throws, input.rod_length());
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
