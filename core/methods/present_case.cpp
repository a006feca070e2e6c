#include "methods/present_case.h"

#include <algorithm>
#include <cmath>

#include "balance-shaft/scene.h"
#include "balance-shaft/solver.h"
#include "case-file/json.h"
#include "elastic-hinge/scene.h"
#include "elastic-hinge/solver.h"
#include "inertia-moments/scene.h"
#include "inertia-moments/solver.h"
#include "methods/torque_cycle.h"
#include "numerics/angle.h"
#include "numerics/constants.h"

namespace ravnoves::methods {

namespace {

using Value = std::optional<double>;

/// Half the distance between the places at which the highest peak of |M_up| has fallen to e^-½, °:
/// the standard deviation of a bell.
Value peak_width(const balance_shaft::Solver& solver) {
    constexpr int samples = 14'400;  // every 0.05°
    const auto moment = [&](int i) {
        const int wrapped = ((i % samples) + samples) % samples;
        return std::abs(solver.M_up(cycle_deg * wrapped / samples * degree));
    };
    int top = 0;
    double height = 0.0;
    for (int i = 0; i < samples; ++i) {
        const double value = moment(i);
        if (value > height) {
            height = value;
            top = i;
        }
    }
    if (!(height > 0.0)) {
        return std::nullopt;
    }
    const double level = height * std::exp(-0.5);
    const auto reach = [&](int direction) {
        int steps = 0;
        while (steps < samples / 2 && moment(top + direction * steps) > level) {
            ++steps;
        }
        return steps;
    };
    return 0.5 * (reach(1) + reach(-1)) * cycle_deg / samples;
}

bool has_equal_steps(const std::vector<double>& rows) {
    const double step = (rows.back() - rows.front()) / static_cast<double>(rows.size() - 1);
    constexpr double rounding = 1e-6;
    return std::adjacent_find(rows.begin(), rows.end(), [&](double a, double b) {
               return std::abs(b - a - step) > rounding * step;
           }) == rows.end();
}

Value table_rows(const balance_shaft::Input& input, bool cubic) {
    using balance_shaft::Interpolation;
    const std::vector<double>& rows = input.torque.table.crank_angle_deg;
    const bool is_cubic = input.interpolation == Interpolation::periodic_cubic;
    // The spline's sweep has equal rows, that of straight lines has irregular ones.
    if (input.torque.is_computed() || rows.size() < 2 || is_cubic != cubic ||
        has_equal_steps(rows) != cubic) {
        return std::nullopt;
    }
    return static_cast<double>(rows.size() - 1);
}

Value of_balance_shaft(std::string_view sweep, const balance_shaft::Input& input) {
    if (sweep == "shaft-angle" || sweep == "pure-sine") {
        return wrap(input.shaft_angle / degree, 360.0);
    }
    if (sweep == "amplitude") {
        return balance_shaft::Solver(input).result().moment_amplitude;
    }
    if (sweep == "peak-width") {
        return peak_width(balance_shaft::Solver(input));
    }
    if (sweep == "spline-rows" || sweep == "irregular-rows") {
        return table_rows(input, sweep == "spline-rows");
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
    if (sweep == "stiffness" || sweep == "stiffness-preloaded") {
        return input.spring ? Value(input.spring->stiffness) : std::nullopt;
    }
    if (sweep == "preload") {
        elastic_hinge::SolveOptions options;
        options.with_rod_guides = false;
        const auto guide = elastic_hinge::solve(input, options).crank_guide;
        return guide.minimum_preload > 0.0 ? Value(guide.preload / guide.minimum_preload - 1.0)
                                           : std::nullopt;
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
    if (sweep == "points") {
        return input.step ? Value(std::ceil(two_pi / *input.step - 1e-9)) : std::nullopt;
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
