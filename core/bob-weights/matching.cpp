#include "bob-weights/matching.h"

#include "numerics/constants.h"

namespace ravnoves::bob_weights {

namespace {

/// Of the throws from the front, degrees.
std::vector<double> usual_angles(const shop::Crank& crank) {
    switch (crank.angle_count()) {
        case 1:
            return {0};
        case 2:
            return crank.has_throws ? std::vector<double>{0, 180} : std::vector<double>{};
        case 3:
            return {0, 120, 240};
        case 4:
            return crank.has_throws ? std::vector<double>{0, 90, 270, 180}
                                    : std::vector<double>{0, 180, 180, 0};
        case 5:
            return {0, 144, 216, 288, 72};
        case 6:
            return {0, 120, 240, 240, 120, 0};
        default:
            return {};
    }
}

}  // namespace

shop::Crank crank_of(const Input& input) {
    const Engine& engine = input.engine;
    shop::Crank crank;
    crank.cylinders = engine.cylinders;
    crank.rods_per_pin = engine.rods_on_crankpin();
    const bool in_line = engine.type == EngineType::in_line;
    const bool boxer = engine.type == EngineType::boxer;
    crank.has_banks = !in_line;
    crank.has_throws = !in_line && engine.cylinders % 2 == 0 &&
                       (boxer || engine.rods_per_pin == 2 || engine.pin_split != 0.0);
    crank.bank_angle = boxer ? pi : engine.bank_angle;
    // The pistons of a boxer that have a crankpin each meet and part.
    crank.split = boxer && engine.rods_per_pin == 1 ? pi : engine.pin_split;
    if (in_line || crank.has_throws) {
        crank.angles = usual_angles(crank);
        for (double& angle : crank.angles) {
            angle *= degree;
        }
    }
    if (input.weigh_in) {
        crank.follow(*input.weigh_in);
    }
    return crank;
}

shop::PartFactors weighed_factors(const Input& input, double factor) {
    shop::PartFactors factors{};
    for (const PartField& part : part_fields()) {
        if (is_weighed(input, part)) {
            factors[static_cast<std::size_t>(*part.column)] =
                part.kind == PartKind::reciprocating ? factor : 1.0;
        }
    }
    return factors;
}

void place_parts(const Input& input, const shop::PartFactors& factors, Result& result) {
    if (!input.weigh_in || input.weigh_in->is_empty() ||
        input.engine.cylinders % input.engine.rods_per_pin != 0) {
        return;
    }
    result.placing = shop::match({*input.weigh_in, crank_of(input), factors});
    if (!result.bob_weight) {
        return;
    }
    result.crankpins.assign(static_cast<std::size_t>(input.engine.crankpins()), *result.bob_weight);
    if (result.placing) {
        result.placed_crankpins = result.crankpins;
        for (std::size_t pin = 0; pin < result.crankpins.size(); ++pin) {
            result.crankpins[pin] += result.placing->before.crankpins[pin];
            result.placed_crankpins[pin] += result.placing->after.crankpins[pin];
        }
    }
}

}  // namespace ravnoves::bob_weights
