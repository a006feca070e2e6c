#include "balance-shaft/engine_torque.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "numerics/constants.h"
#include "numerics/harmonics.h"

namespace ravnoves::balance_shaft {

SliderCrank<double> slider_crank(const Input& input) {
    return {input.crank_radius, input.effective_rod_length(), input.cylinder.offset};
}

std::optional<CylinderGas> cylinder_gas(const Input& input) {
    const TorqueSource& source = input.torque;
    switch (source.kind) {
        case TorqueSource::Kind::pressure: {
            PressureTrace trace = source.trace;
            for (double& angle : trace.crank_angle_deg) {
                angle += source.trace_shift / degree;
            }
            return CylinderGas(slider_crank(input), input.effective_bore(),
                               source.crankcase_pressure, trace,
                               input.interpolation == Interpolation::periodic_cubic);
        }
        case TorqueSource::Kind::cycle:
            return CylinderGas(slider_crank(input), input.effective_bore(),
                               source.crankcase_pressure, source.cycle, input.strokes);
        default:
            return std::nullopt;
    }
}

namespace {

/// Every 0.5° of the cycle and the breaks, ascending; what all but coincides counts once.
std::vector<double> torque_knots(const CylinderGas& gas) {
    const int steps = static_cast<int>(std::lround(gas.period() / degree * 2.0));
    std::vector<double> knots = gas.breaks_deg();
    const auto breaks = static_cast<std::ptrdiff_t>(knots.size());
    for (int i = 0; i <= steps; ++i) {
        knots.push_back(i / 2.0);
    }
    std::inplace_merge(knots.begin(), knots.begin() + breaks, knots.end());
    constexpr double same = 1e-7;
    knots.erase(
        std::unique(knots.begin(), knots.end(), [](double a, double b) { return b - a < same; }),
        knots.end());
    knots.back() = steps / 2.0;
    return knots;
}

}  // namespace

void fill_cylinder(Input& input) {
    input.cylinder.bore = input.effective_bore();
    input.cylinder.rod_length = input.effective_rod_length();
}

void take_torque_kind(Input& input, TorqueSource::Kind kind, double mean_torque) {
    using Kind = TorqueSource::Kind;
    // The table is that of its file, as long as nobody changes it.
    input.torque.kind = kind == Kind::table && !input.torque.csv.name.empty() ? Kind::csv : kind;
    input.strokes = input.strokes_of_torque();
    if (!input.torque.is_computed()) {
        return;
    }
    fill_cylinder(input);
    GasCycle& cycle = input.torque.cycle;
    if (kind == Kind::cycle && !cycle.heat && !cycle.imep) {
        cycle.combustion_start = 352.0 * degree;
        cycle.combustion_duration = 60.0 * degree;
        // Mean torque × cycle = work per cycle.
        const double radius = 0.5 * input.effective_bore();
        const double displacement = pi * radius * radius * 2.0 * input.crank_radius;
        cycle.imep = std::max(0.0, mean_torque) * input.cycle_deg() * degree / displacement;
    }
}

TorqueParts torque_parts(const Input& input, const CylinderGas& gas) {
    const SliderCrank<double> crank = slider_crank(input);
    const double top = crank.top_dead_centre();
    const double mass = input.reciprocating_mass();
    const std::vector<double> knots = torque_knots(gas);
    return {PeriodicPiecewise::through(
                [&](const double& angle) { return gas.torque(angle * degree + top); }, knots),
            PeriodicPiecewise::through(
                [&](const double& angle) {
                    return inertia_torque(crank.at(angle * degree + top), mass, 1.0);
                },
                knots)};
}

std::optional<TorqueParts> torque_parts(const Input& input, const InertiaCheck& check) {
    if (input.torque.is_computed() || !check.fitted || !check.consistent.value_or(false)) {
        return std::nullopt;
    }
    const TorqueTable& table = input.torque.table;
    const double speed2 = input.angular_speed * input.angular_speed;
    std::vector<double> gas(table.size());
    std::vector<double> unit_inertia(table.size());
    for (std::size_t i = 0; i < table.size(); ++i) {
        unit_inertia[i] = *check.fitted / speed2 *
                          unit_inertia_torque(input, check.fitted_lambda, table.crank_angle_deg[i]);
        gas[i] = table.torque[i] - speed2 * unit_inertia[i];
    }
    const auto curve = [&](std::vector<double>&& values) {
        return torque_curve({table.crank_angle_deg, std::move(values)}, input.interpolation);
    };
    return TorqueParts{curve(std::move(gas)), curve(std::move(unit_inertia))};
}

PeriodicPiecewise torque_curve(const TorqueTable& table, Interpolation interpolation) {
    // Rounding must not leave a period other than the cycle's, or a step at its end.
    std::vector<double> angle = table.crank_angle_deg;
    angle.back() = angle.front() + 180.0 * strokes_of(angle);
    std::vector<double> torque = table.torque;
    torque.back() = torque.front();
    return interpolation == Interpolation::linear ? PeriodicPiecewise::linear(angle, torque)
                                                  : PeriodicPiecewise::cubic(angle, torque);
}

PistonFirstOrder piston_first_order(const SliderCrank<double>& crank) {
    if (crank.offset == 0.0) {
        return {crank.crank_radius, 0.0};  // √(L² − r² sin²θ) has even orders alone
    }
    const UniformTransform<double> turn(transform_length(crank.harmonic_decay(), 1, 1e-17));
    std::vector<double> acceleration;
    for (std::size_t i = 0; i < turn.size(); ++i) {
        acceleration.push_back(-crank.at(turn.node_sin()[i], turn.node_cos()[i]).d2s);
    }
    const Harmonic<double> first = turn.orders(acceleration, 1)[1];
    return {std::hypot(first.cos, first.sin), std::atan2(first.sin, first.cos)};
}

PeriodicPiecewise with_offset_term(const PeriodicPiecewise& moment,
                                   const SliderCrank<double>& crank, double factor) {
    if (crank.offset == 0.0) {
        return moment;
    }
    const std::vector<double>& ends = moment.knots();
    constexpr double longest_deg = 0.5;
    std::vector<double> knots;
    for (std::size_t i = 0; i < moment.size(); ++i) {
        const double h = ends[i + 1] - ends[i];
        const int parts = std::max(1, static_cast<int>(std::ceil(h / longest_deg)));
        for (int part = 0; part < parts; ++part) {
            knots.push_back(ends[i] + h * part / parts);
        }
    }
    knots.push_back(ends.back());
    const double top = crank.top_dead_centre();
    return PeriodicPiecewise::through(
        [&](const double& angle) {
            return moment(angle) + factor * offset_lever(crank, angle * degree + top);
        },
        std::move(knots));
}

}  // namespace ravnoves::balance_shaft
