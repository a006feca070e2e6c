#include "balance-shaft/trace_check.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "balance-shaft/table_reading.h"
#include "case-file/decimal.h"
#include "numerics/constants.h"
#include "numerics/units.h"

namespace ravnoves::balance_shaft {

namespace {

struct LineFit {
    double slope = 0.0;
    double level = 0.0;
    double residual = 0.0;  ///< RMS
};

LineFit fit_line(const Eigen::ArrayXd& x, const Eigen::ArrayXd& y) {
    const Eigen::ArrayXd from_mean = x - x.mean();
    const double slope = (from_mean * y).sum() / from_mean.square().sum();
    const double level = y.mean() - slope * x.mean();
    return {slope, level, std::sqrt((y - level - slope * x).square().mean())};
}

/// The mean pressure about an angle from top dead centre, Pa.
double mean_pressure(const CylinderGas& gas, double angle_deg) {
    constexpr int reach = 10;
    double sum = 0.0;
    for (int i = -reach; i <= reach; ++i) {
        sum += gas.pressure(gas.top_dead_centre() + (angle_deg + i) * degree);
    }
    return sum / (2 * reach + 1);
}

/// Place of the peak from the firing top dead centre, −cycle/2 … cycle/2, °.
double lateness(const Input& input, const IndicatedCycle& cycle) {
    return std::remainder(cycle.peak_pressure_angle / degree - 360.0, input.cycle_deg());
}

bool is_usual_lateness(double angle) {
    constexpr double earliest = -6.0;
    constexpr double latest = 45.0;
    return angle > earliest && angle < latest;
}

}  // namespace

std::optional<CompressionFit> fit_compression(const CylinderGas& gas) {
    constexpr int rows = 51;      // every degree
    Eigen::ArrayXd volume(rows);  // without V_c, displacements
    Eigen::ArrayXd pressure(rows);
    const double clearance = gas.volume(gas.top_dead_centre());
    for (int i = 0; i < rows; ++i) {
        const double theta = gas.top_dead_centre() + two_pi - (80 - i) * degree;
        volume[i] = (gas.volume(theta) - clearance) / gas.displacement();
        pressure[i] = gas.pressure(theta);
    }
    if (!(pressure > 0.0).all()) {
        return std::nullopt;
    }
    constexpr int ratios = 200;
    constexpr double min_ratio = 4.0;
    constexpr double largest_ratio = 30.0;
    constexpr double usual_exponent = 1.35;
    CompressionFit fit;
    double min_residual = 0.0;
    for (int k = 0; k <= ratios; ++k) {
        const double ratio = min_ratio * std::pow(largest_ratio / min_ratio, 1.0 * k / ratios);
        const Eigen::ArrayXd whole = volume + 1.0 / (ratio - 1.0);
        const LineFit free = fit_line(whole.log(), pressure.log());
        if (k == 0 || free.residual < fit.residual) {
            fit.exponent = -free.slope;
            fit.residual = free.residual;
        }
        const LineFit held = fit_line(whole.pow(-usual_exponent), pressure);
        if (k == 0 || held.residual < min_residual) {
            fit.missing_pressure = -held.level;
            min_residual = held.residual;
        }
    }
    return fit;
}

Message coarse_rows(const PressureTrace& trace) {
    const std::vector<double>& angle = trace.crank_angle_deg;
    const auto peak = std::max_element(trace.pressure.begin(), trace.pressure.end());
    const double at = angle[static_cast<std::size_t>(peak - trace.pressure.begin())];
    const double period = angle.back() - angle.front();
    constexpr double reach = 60.0;  // of the steep part, each way
    double widest = 0.0;
    for (std::size_t i = 1; i < angle.size(); ++i) {
        if (std::abs(std::remainder(angle[i - 1] - at, period)) < reach) {
            widest = std::max(widest, angle[i] - angle[i - 1]);
        }
    }
    constexpr double largest = 6.0;
    return widest > largest
               ? Message(Text::tr("Pressure trace: %1 between rows near the peak; peak and work "
                                  "are uncertain, and the dead centre requires steps of 4°."),
                         Number{widest, units::degree, 3})
               : Message();
}

bool peaks_a_turn_off(const Input& input, const IndicatedCycle& cycle) {
    const double late = lateness(input, cycle);
    return input.strokes == 4 && !is_usual_lateness(late) &&
           is_usual_lateness(std::remainder(late - 360.0, input.cycle_deg()));
}

Message check_trace(const Input& input, const CylinderGas& gas) {
    const PressureTrace& trace = input.torque.trace;
    constexpr double atmosphere = 1.0 * units::bar;
    const IndicatedCycle cycle = gas.indicated();
    const double peak = cycle.peak_pressure;
    const double minimum = *std::min_element(trace.pressure.begin(), trace.pressure.end());
    constexpr double min_rise = 2.0;
    if (!(peak > min_rise * minimum)) {
        return {};  // nothing that has a phase
    }
    const auto rounded = [](double value, int digits) {
        return Number{rounded_to_digits(value, digits)};
    };

    const double peak_deg = cycle.peak_pressure_angle / degree;
    const double late = lateness(input, cycle);
    if (!is_usual_lateness(late)) {
        if (peaks_a_turn_off(input, cycle)) {
            return {
                Text::tr("The peak of the pressure trace is at %1, near the gas-exchange dead "
                         "centre. The firing dead centre is at 360°: shift the trace by one turn."),
                Number{peak_deg, units::degree, 4}};
        }
        return {Text::tr("The peak of the pressure trace is %1 after the firing dead centre at %2; "
                         "usual: 5° before to 45° after. Check the phase of the crank angles."),
                Number{late, units::degree, 3},
                Number{input.strokes == 4 ? 360.0 : 0.0, units::degree}};
    }

    // Pressure at the bottom dead centre before compression.
    const double bottom = mean_pressure(gas, 180.0);
    constexpr double min_bottom = 0.2;  // of the atmosphere; throttled engines reach 0.25
    constexpr double largest_bottom = 8.0;
    const double parts = bottom / atmosphere;
    const std::optional<CompressionFit> fit = fit_compression(gas);
    const bool lacks_atmosphere = fit && fit->exponent > 1.6 &&
                                  fit->missing_pressure > 0.6 * atmosphere &&
                                  fit->missing_pressure < 1.5 * atmosphere;
    constexpr double largest_ratio = 300.0;  // of peak to bottom pressure
    if (lacks_atmosphere || (parts < min_bottom && peak > largest_ratio * bottom)) {
        if (input.torque.crankcase_pressure < atmosphere / 2.0) {
            return {};  // both are gauge pressures, so the torque is right
        }
        return {Text::tr("The trace looks like gauge pressure: %1 bar at the bottom dead centre "
                         "before compression. Read it as gauge pressure (\"gauge\": true)."),
                rounded(bottom / units::bar, 3)};
    }
    if (parts > largest_bottom || parts < min_bottom) {
        std::vector<double> numbers = trace.pressure;
        for (double& number : numbers) {
            number = number / trace.unit;
        }
        const Unit likely = likely_unit(Measured::pressure, std::move(numbers));
        if (likely != trace.unit) {
            return {Text::tr("Pressure at the bottom dead centre before compression: %1 bar. The "
                             "numbers look like %2; %3 is used."),
                    rounded(bottom / units::bar, 3), Text{likely.name.data()},
                    Text{trace.unit.name.data()}};
        }
    }
    constexpr double min_exponent = 1.2;
    constexpr double largest_exponent = 1.48;
    constexpr double largest_residual = 0.02;  // of a curve that is a polytrope
    if (fit && fit->residual < largest_residual &&
        !(fit->exponent >= min_exponent && fit->exponent <= largest_exponent)) {
        return {Text::tr("Polytropic exponent of the compression: %1; usual: 1.25 to 1.42. Check "
                         "the phase of the crank angles and the zero of the pressure."),
                rounded(fit->exponent, 3)};
    }
    return {};
}

}  // namespace ravnoves::balance_shaft
