#include "elastic-hinge/input.h"

#include "case-file/field_reader.h"
#include "case-file/field_writer.h"
#include "case-file/input_error.h"
#include "elastic-hinge/fields.h"

namespace ravnoves::elastic_hinge {

void check_input(const Input& input) {
    check_fields(input);
    const bool weights = input.masses_as_weights;
    const double sum =
        (input.crank_mass + input.rod_mass + input.slider_mass) * (weights ? input.gravity : 1.0);
    if (!(sum >= 1e-12)) {
        throw InputError(weights ? "/input/weights_N" : "/input/masses_kg",
                         Text::tr("must together be more than 0"), Number{sum});
    }
    if (input.kinematics == Kinematics::exact && !(input.lambda < 1.0)) {
        throw InputError(
            "/input/lambda",
            Text::tr("must be less than 1 for the exact kinematics (else the mechanism locks at a "
                     "crank angle of 90°; \"kinematics\": \"series\" draws the paper's curves)"),
            Number{input.lambda});
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

Input read_input(const Json& json) {
    Input input = read_fields<Input>(json);
    check_input(input);
    return input;
}

Json write_input(const Input& input) {
    return write_fields(input);
}

}  // namespace ravnoves::elastic_hinge
