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

Message locking_of(const SliderCrank<double>& crank, std::size_t cylinder) {
    const double margin = crank.rod_length - 1.0 - std::abs(crank.offset);
    if (!(margin < nearest_to_locking * crank.rod_length)) {
        return {};
    }
    // As good as locked: the angle is that of the mechanism that just locks.
    const SliderCrank<double> just{1.0, 1.0 + std::abs(crank.offset), crank.offset};
    const auto angles = (crank.locks() ? crank : just).locking_angles();
    const auto number = static_cast<double>(cylinder + 1);
    if (!angles) {
        return {Text::tr("the mechanism of cylinder %1 is not possible: the rod does not reach "
                         "the piston at any crank angle"),
                number};
    }
    return {Text::tr("the mechanism of cylinder %1 locks with the crank at %2 turning forward and "
                     "at %3 turning back, measured from the cylinder's axis"),
            number, Number{angles->forward / degree, units::degree, 4},
            Number{angles->backward / degree, units::degree, 4}};
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
        // All throws have as many: check_input().
        engine.rotating_mass /= static_cast<double>(engine.throws.front().cylinders.size());
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

std::vector<CylinderPose> engine_pose(const Engine& engine, double crank_angle) {
    std::vector<CylinderPose> poses;
    poses.reserve(engine.cylinders.size());
    const double radius = engine.crank_radius;
    for (std::size_t i = 0; i < engine.cylinders.size(); ++i) {
        const Cylinder& cylinder = engine.cylinders[i];
        const ArticulatedCrank crank = engine.crank(i);
        const double theta = crank_angle + engine.crank_phase(cylinder);
        const ArticulatedMotion motion = crank.at(std::sin(theta), std::cos(theta));
        CylinderPose pose;
        pose.axis_direction = {-std::sin(cylinder.bank_angle), std::cos(cylinder.bank_angle)};
        // The offset's side is the axis turned by +90°.
        pose.axis_foot = pose.axis_direction * Complex(0.0, cylinder.offset);
        pose.crankpin = pose.axis_direction * std::polar(radius, theta);
        pose.rod_foot = pose.crankpin + pose.axis_direction * radius * motion.arm;
        pose.articulated = cylinder.articulated.has_value();
        pose.piston_pin = pose.axis_foot + pose.axis_direction * radius * motion.piston.s;
        const auto place = [&](double angle) {
            return radius * crank.at(std::sin(angle), std::cos(angle)).piston.s;
        };
        pose.top = place(crank.top_dead_centre());
        pose.bottom = place(crank.bottom_dead_centre());
        poses.push_back(pose);
    }
    return poses;
}

}  // namespace ravnoves::inertia_moments
