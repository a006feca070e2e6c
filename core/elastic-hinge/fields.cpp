#include "elastic-hinge/fields.h"

#include "case-file/field_visitor.h"
#include "elastic-hinge/input.h"

namespace ravnoves::elastic_hinge {

void visit_fields(FieldVisitor& visitor, Spring& spring) {
    visitor.number(field::stiffness, spring.stiffness);
    visitor.number(field::free_length, spring.free_length);
    visitor.number(field::guide_radius, spring.guide_radius_at_zero);
}

void visit_fields(FieldVisitor& visitor, GuideWish& wish) {
    visitor.number(field::wanted_relief, wish.relief);
    visitor.number(field::outer_diameter, wish.outer_diameter);
    visitor.number(field::smallest_spring_length, wish.smallest_spring_length);
    visitor.number(field::preload_margin, wish.preload_margin, GuideWish{}.preload_margin);
}

void visit_fields(FieldVisitor& visitor, MotionWish& wish) {
    const MotionWish usual;
    visitor.number(field::turns, wish.turns, usual.turns);
    visitor.number(field::start_speed, wish.start_speed);
    visitor.number(field::start_angle, wish.start_angle, usual.start_angle);
    visitor.number(field::crank_torque, wish.crank_torque, usual.crank_torque);
    visitor.flag(field::with_profile_error, wish.with_profile_error, usual.with_profile_error);
}

void visit_fields(FieldVisitor& visitor, Input& input) {
    constexpr auto always = FieldVisitor::Written::always;
    const int given =
        visitor.one_of({field::weights.key, field::masses.key}, input.masses_as_weights ? 0 : 1);
    if (visitor.is_reading()) {
        input.masses_as_weights = given == 0;
    }
    const bool all = given < 0;
    const bool weights = all || input.masses_as_weights;
    visitor.number(weights ? field::gravity : field::gravity_with_masses, input.gravity,
                   standard_gravity, always);
    const auto weight = [&](const Field& field) { return field::as_weight(field, input.gravity); };
    if (weights) {
        visitor.object_of(field::weights, true, true, [&] {
            visitor.number(weight(field::crank_weight), input.crank_mass);
            visitor.number(weight(field::rod_weight), input.rod_mass);
            visitor.number(weight(field::slider_weight), input.slider_mass);
        });
    }
    if (all || !weights) {
        visitor.object_of(field::masses, true, true, [&] {
            visitor.number(field::crank_mass, input.crank_mass);
            visitor.number(field::rod_mass, input.rod_mass);
            visitor.number(field::slider_mass, input.slider_mass);
        });
    }
    visitor.number(field::crank_radius, input.crank_radius);
    visitor.number(field::lambda, input.lambda);
    visitor.number(field::angular_speed, input.angular_speed);
    visitor.choice(field::kinematics, input.kinematics, Kinematics::exact, always);
    visitor.choice(field::guide_sign, input.guide_sign, GuideSign::energy, always);
    visitor.object(field::spring, input.spring);
    visitor.object(field::rod_hinge_spring, input.rod_hinge_spring, [&](Spring& spring) {
        visitor.number(field::rod_stiffness, spring.stiffness);
        visitor.number(field::rod_free_length, spring.free_length);
        visitor.number(field::rod_guide_radius, spring.guide_radius_at_zero);
    });
    visitor.object(field::rod_counterweight, input.rod_counterweight, [&](RodCounterweight& it) {
        visitor.number(field::counterweight_distance, it.distance);
        if (weights) {
            visitor.number_or_word(weight(field::counterweight_weight), it.mass, "solve");
        }
        if (all || !weights) {
            visitor.number_or_word(field::counterweight_mass, it.mass, "solve");
        }
        visitor.choice(field::counterweight_inertia, it.inertia, RodCounterweight{}.inertia,
                       always);
    });
    const Input usual;
    visitor.number(field::roller_radius, input.roller_radius, usual.roller_radius);
    visitor.number(field::profile_error, input.profile_error, usual.profile_error);
    visitor.integer(field::profile_error_waves, input.profile_error_waves,
                    usual.profile_error_waves);
    visitor.object(field::guide_search, input.guide_search);
    visitor.object(field::motion, input.motion);
}

}  // namespace ravnoves::elastic_hinge
