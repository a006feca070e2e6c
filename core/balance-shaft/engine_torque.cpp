#include "balance-shaft/engine_torque.h"

#include <algorithm>
#include <cmath>

namespace ravnoves::balance_shaft {

SliderCrank<double> slider_crank(const Input& input) {
    return {input.crank_radius, input.effective_rod_length(), input.torque.cylinder.offset};
}

std::optional<CylinderGas> cylinder_gas(const Input& input) {
    const TorqueSource& source = input.torque;
    switch (source.kind) {
        case TorqueSource::Kind::pressure:
            return CylinderGas(slider_crank(input), source.cylinder, source.trace,
                               input.interpolation == Interpolation::periodic_cubic);
        case TorqueSource::Kind::cycle:
            return CylinderGas(slider_crank(input), source.cylinder, source.cycle);
        default:
            return std::nullopt;
    }
}

std::vector<double> TorqueParts::torque(double angular_speed) const {
    std::vector<double> sum(gas.size());
    for (std::size_t i = 0; i < sum.size(); ++i) {
        sum[i] = gas[i] + angular_speed * angular_speed * unit_inertia[i];
    }
    return sum;
}

TorqueParts torque_parts(const Input& input, const CylinderGas& gas) {
    double rows_per_degree = 2.0;
    if (input.torque.kind == TorqueSource::Kind::pressure) {
        rows_per_degree =
            std::clamp(static_cast<double>(input.torque.trace.pressure.size() - 1) / 720.0,
                       rows_per_degree, 10.0);
    }
    const int rows = static_cast<int>(std::lround(720.0 * rows_per_degree));
    const SliderCrank<double> crank = slider_crank(input);
    const double top = crank.top_dead_centre();
    const double mass = input.reciprocating_mass();
    TorqueParts parts;
    for (int i = 0; i <= rows; ++i) {
        const double angle = 720.0 * i / rows;
        const double theta = 720.0 * (i % rows) / rows * degree + top;
        parts.crank_angle_deg.push_back(angle);
        parts.gas.push_back(gas.torque(theta));
        parts.unit_inertia.push_back(inertia_torque(crank, mass, 1.0, theta));
    }
    return parts;
}

std::optional<TorqueParts> torque_parts(const Input& input, const InertiaCheck& check) {
    if (input.torque.is_computed() || !check.fitted || !check.consistent.value_or(false)) {
        return std::nullopt;
    }
    const TorqueTable& table = input.torque.table;
    // m_j r² of the fit, on a crank of radius 1.
    const double speed2 = input.angular_speed * input.angular_speed;
    const SliderCrank<double> crank{1.0, 1.0 / check.fitted_lambda};
    TorqueParts parts;
    parts.crank_angle_deg = table.crank_angle_deg;
    for (std::size_t i = 0; i < table.size(); ++i) {
        const double unit =
            inertia_torque(crank, *check.fitted / speed2, 1.0, table.crank_angle_deg[i] * degree);
        parts.unit_inertia.push_back(unit);
        parts.gas.push_back(table.torque[i] - speed2 * unit);
    }
    return parts;
}

PeriodicPiecewise tipping_moment(const std::vector<double>& crank_angle_deg,
                                 const std::vector<double>& torque, Interpolation interpolation) {
    std::vector<double> angle = crank_angle_deg;
    angle.back() = angle.front() + 720.0;
    std::vector<double> moment(torque.size());
    std::transform(torque.begin(), torque.end(), moment.begin(),
                   [](double value) { return 0.0 - value; });
    moment.back() = moment.front();
    return interpolation == Interpolation::linear ? PeriodicPiecewise::linear(angle, moment)
                                                  : PeriodicPiecewise::cubic(angle, moment);
}

}  // namespace ravnoves::balance_shaft
