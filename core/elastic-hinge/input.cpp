#include "elastic-hinge/input.h"

#include <string>

#include "case-file/input_error.h"

namespace ravnoves::elastic_hinge {

namespace {

void check(double value, const FieldSpec& field, const std::string& pointer) {
    const double shown = value / field.to_si;
    // One part in 10¹² of play: a limit typed in the field's unit passes after its conversion.
    const double slack = 1e-12 * std::abs(shown);
    if (!std::isfinite(value) ||
        !(field.range.contains(shown) || field.range.contains(shown - slack) ||
          field.range.contains(shown + slack))) {
        throw InputError(pointer, field.range.describe(), format_number(shown));
    }
}

void check(double value, const FieldSpec& field) {
    check(value, field, "/input/" + std::string(field.key));
}

void check(const Spring& spring, const std::string& pointer) {
    check(spring.stiffness, field::stiffness, pointer + "/" + std::string(field::stiffness.key));
    check(spring.free_length, field::free_length,
          pointer + "/" + std::string(field::free_length.key));
    check(spring.guide_radius_at_zero, field::guide_radius,
          pointer + "/" + std::string(field::guide_radius.key));
}

void check_masses(const Input& input) {
    const bool weights = input.masses_as_weights;
    const std::string pointer = weights ? "/input/weights_N" : "/input/masses_kg";
    const struct {
        const char* key;
        double mass;
    } parts[] = {
        {"crank", input.crank_mass}, {"rod", input.rod_mass}, {"slider", input.slider_mass}};
    double sum = 0.0;
    for (const auto& part : parts) {
        const double value = weights ? part.mass * input.gravity : part.mass;
        check(value, weights ? field::weight : field::mass, pointer + "/" + part.key);
        sum += value;
    }
    if (!(sum >= 1e-12)) {
        throw InputError(pointer, "must together be more than 0", format_number(sum));
    }
}

}  // namespace

void check_input(const Input& input) {
    check(input.gravity, input.masses_as_weights ? field::gravity : field::gravity_with_masses);
    check_masses(input);
    check(input.crank_radius, field::crank_radius);
    check(input.lambda, field::lambda);
    if (input.kinematics == Kinematics::exact && !(input.lambda < 1.0)) {
        throw InputError("/input/lambda",
                         "must be less than 1 for the exact kinematics (a rod no longer than the "
                         "crank locks the mechanism at a crank angle of 90°; \"kinematics\": "
                         "\"series\" still draws the paper's curves)",
                         format_number(input.lambda));
    }
    check(input.angular_speed, field::angular_speed);
    if (input.spring) {
        check(*input.spring, "/input/spring");
    }
    if (input.rod_hinge_spring) {
        check(*input.rod_hinge_spring, "/input/rod_hinge_spring");
    }
    if (input.rod_counterweight) {
        const std::string pointer = "/input/rod_counterweight/";
        check(input.rod_counterweight->distance, field::counterweight_distance,
              pointer + std::string(field::counterweight_distance.key));
        if (input.rod_counterweight->mass) {
            const FieldSpec& field =
                input.masses_as_weights ? field::counterweight_weight : field::counterweight_mass;
            const double mass = *input.rod_counterweight->mass;
            check(input.masses_as_weights ? mass * input.gravity : mass, field,
                  pointer + std::string(field.key));
        }
    }
    check(input.roller_radius, field::roller_radius);
    check(input.profile_error, field::profile_error);
    if (input.profile_error_waves < field::smallest_waves ||
        input.profile_error_waves > field::largest_waves) {
        throw InputError("/input/profile_error_waves", "must be a whole number from 1 to 1000",
                         std::to_string(input.profile_error_waves));
    }
    if (input.guide_search) {
        const std::string pointer = "/input/guide_search/";
        const GuideWish& wish = *input.guide_search;
        check(wish.relief, field::wanted_relief, pointer + std::string(field::wanted_relief.key));
        check(wish.outer_diameter, field::outer_diameter,
              pointer + std::string(field::outer_diameter.key));
        if (wish.smallest_spring_length) {
            check(*wish.smallest_spring_length, field::smallest_spring_length,
                  pointer + std::string(field::smallest_spring_length.key));
        }
    }
    if (input.motion) {
        const std::string pointer = "/input/motion/";
        const MotionWish& wish = *input.motion;
        check(wish.turns, field::turns, pointer + std::string(field::turns.key));
        check(wish.start_angle, field::start_angle, pointer + std::string(field::start_angle.key));
        check(wish.crank_torque, field::crank_torque,
              pointer + std::string(field::crank_torque.key));
        if (wish.start_speed) {
            check(*wish.start_speed, field::start_speed,
                  pointer + std::string(field::start_speed.key));
        }
    }
}

Mechanism<double> mechanism_of(const Input& input) {
    Mechanism<double> mechanism{input.crank_mass, input.rod_mass,     input.slider_mass,
                                input.gravity,    input.crank_radius, input.lambda};
    if (input.rod_counterweight) {
        mechanism.counterweight_distance = input.rod_counterweight->distance;
        mechanism.counterweight_inertia = input.rod_counterweight->inertia;
        mechanism.counterweight_mass =
            input.rod_counterweight->mass.value_or(mechanism.balancing_mass());
    }
    return mechanism;
}

}  // namespace ravnoves::elastic_hinge
