#include "methods/present_case.h"

#include <algorithm>
#include <cmath>

#include "balance-shaft/scene.h"
#include "balance-shaft/solver.h"
#include "case-file/json.h"
#include "elastic-hinge/scene.h"
#include "inertia-moments/engine.h"
#include "inertia-moments/scene.h"
#include "numerics/angle.h"
#include "numerics/constants.h"

namespace ravnoves::methods {

namespace {

using Value = std::optional<double>;

Value of_balance_shaft(std::string_view sweep, const balance_shaft::Input& input) {
    if (sweep == "shaft-angle" || sweep == "pure-sine") {
        return wrap(input.shaft_angle / degree, 360.0);
    }
    if (sweep == "amplitude") {
        return balance_shaft::Solver(input).result().moment_amplitude;
    }
    return std::nullopt;
}

Value of_elastic_hinge(std::string_view sweep, const elastic_hinge::Input& input) {
    if (sweep == "lambda") {
        return input.lambda;
    }
    if (sweep == "speed") {
        return input.angular_speed;
    }
    if (sweep == "stiffness") {
        return input.spring ? Value(input.spring->stiffness) : std::nullopt;
    }
    if (sweep == "turns") {
        return input.motion ? Value(input.motion->turns) : std::nullopt;
    }
    if (sweep == "start-speed") {
        return input.motion && input.motion->start_speed && input.angular_speed > 0.0
                   ? Value(*input.motion->start_speed / input.angular_speed)
                   : std::nullopt;
    }
    return std::nullopt;
}

Value of_inertia_moments(std::string_view sweep, const inertia_moments::Input& input) {
    if (sweep == "lambda") {
        return input.ratio();
    }
    if (sweep == "offset") {
        double largest = 0.0;
        for (const auto& cylinder : inertia_moments::make_engine(input).cylinders) {
            largest = std::max(largest, std::abs(cylinder.offset));
        }
        return largest / input.crank_radius;
    }
    return std::nullopt;
}

}  // namespace

std::optional<double> present_value(const Kernel& kernel, std::size_t sweep, const Json& input,
                                    const CaseContext& context) {
    const std::string_view id = kernel.sweeps.at(sweep).id;
    if (kernel.choice.scene == "balance-shaft") {
        return of_balance_shaft(id, balance_shaft::read_input(input, context));
    }
    if (kernel.choice.scene == "elastic-hinge") {
        return of_elastic_hinge(id, elastic_hinge::read_input(input));
    }
    if (kernel.choice.scene == "inertia-moments") {
        return of_inertia_moments(id, inertia_moments::read_input(input));
    }
    return std::nullopt;
}

}  // namespace ravnoves::methods
