#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "balance-shaft/cylinder_gas.h"
#include "numerics/slider_crank.h"

namespace ravnoves::balance_shaft::test {

/// A cylinder of one zone with heat lost to its walls: nothing of the program's own cycle. γ falls
/// with the temperature, the heat transfer is Woschni's, combustion Wiebe's.
struct SyntheticEngine {
    const char* name = "";
    SliderCrank<double> crank{0.046, 0.150, 0.0};
    double bore = 0.0955;
    double ratio = 18.0;
    double intake = 1e5;  ///< Pa
    double speed = 3000.0 * units::rpm;
    double heat = 0.0;        ///< J; 0: motored
    double start = -8.0;      ///< of combustion, ° from the dead centre
    double duration = 60.0;   ///< °
    double form = 1.0;        ///< of Wiebe's law
    double wall_share = 1.0;  ///< of Woschni's heat transfer
    double polytrope = 0.0;   ///< where not 0, in place of γ and of the heat lost
    int strokes = 4;

    /// Pa, at degrees from the firing dead centre, −360…360 or −180…180.
    std::vector<double> pressure(double step_deg) const {
        const double top = crank.top_dead_centre();
        const double area = pi / 4.0 * bore * bore;
        const double longest = crank.at(top).s;
        const double clearance = area * crank.stroke() / (ratio - 1.0);
        const auto volume = [&](double at) {
            return clearance + area * (longest - crank.at(top + at * degree).s);
        };
        const auto burnt = [&](double at) {
            const double tau = std::clamp((at - start) / duration, 0.0, 1.0);
            return -std::expm1(-std::log(1000.0) * std::pow(tau, form + 1.0));
        };
        const double shut = strokes == 4 ? -140.0 : -112.0;
        const double open = strokes == 4 ? 130.0 : 108.0;
        const double gas = intake * volume(shut) / 340.0;
        const double piston_speed = crank.stroke() * speed / pi;
        const auto slope = [&](double at, double p) {  // dp/dφ, Pa/°
            constexpr double h = 1e-3;
            const double v = volume(at);
            const double dv = (volume(at + h) - volume(at - h)) / (2.0 * h);
            const double temperature = p * v / gas;
            const double gamma =
                polytrope > 0.0 ? polytrope : std::max(1.26, 1.40 - 8e-5 * (temperature - 300.0));
            const double transfer = 130.0 * std::pow(bore, -0.2) * std::pow(p / 1e5, 0.8) *
                                    std::pow(temperature, -0.53) *
                                    std::pow(2.28 * piston_speed, 0.8);
            const double wall = 2.0 * area + pi * bore * v / area;
            const double lost = polytrope > 0.0 ? 0.0
                                                : wall_share * transfer * wall *
                                                      (temperature - 420.0) * degree / speed;
            const double released = heat * (burnt(at + h) - burnt(at - h)) / (2.0 * h);
            return ((gamma - 1.0) * (released - lost) - gamma * p * dv) / v;
        };
        std::vector<double> closed{intake};
        constexpr double fine = 0.02;
        const int steps = static_cast<int>(std::lround((open - shut) / fine));
        for (int i = 0; i < steps; ++i) {
            const double at = shut + i * fine;
            const double p = closed.back();
            const double k1 = slope(at, p);
            const double k2 = slope(at + fine / 2.0, p + fine / 2.0 * k1);
            const double k3 = slope(at + fine / 2.0, p + fine / 2.0 * k2);
            const double k4 = slope(at + fine, p + fine * k3);
            closed.push_back(p + fine / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4));
        }
        const double cycle = 180.0 * strokes;
        std::vector<double> values;
        const int rows = static_cast<int>(std::lround(cycle / step_deg));
        for (int i = 0; i < rows; ++i) {
            const double at = i * step_deg - cycle / 2.0;
            if (at < shut) {
                values.push_back(intake);
            } else if (at < open) {
                const double place = (at - shut) / fine;
                const auto k = static_cast<std::size_t>(place);
                values.push_back(std::lerp(closed[k], closed[std::min(k + 1, closed.size() - 1)],
                                           place - static_cast<double>(k)));
            } else {
                values.push_back(1.05 * intake +
                                 (closed.back() - 1.05 * intake) * std::exp((open - at) / 10.0));
            }
        }
        return values;
    }
};

/// A cycle of pressures at equal steps; the last row repeats the first.
inline PressureTrace trace_of(std::vector<double> pressure, double step_deg,
                              double first_deg = 0.0) {
    PressureTrace trace;
    pressure.push_back(pressure.front());
    for (std::size_t i = 0; i < pressure.size(); ++i) {
        trace.crank_angle_deg.push_back(first_deg + static_cast<double>(i) * step_deg);
    }
    trace.pressure = std::move(pressure);
    return trace;
}

inline std::vector<SyntheticEngine> synthetic_engines() {
    return {
        {.name = "diesel", .heat = 1300.0},
        {.name = "supercharged diesel", .ratio = 15.0, .intake = 2.2e5, .heat = 2600.0},
        {.name = "late diesel", .ratio = 16.0, .heat = 1100.0, .start = 2.0},
        {.name = "offset diesel", .crank = {0.046, 0.150, 0.008}, .heat = 1300.0},
        {.name = "long-stroke diesel", .crank = {0.060, 0.220, 0.0}, .heat = 1500.0},
        {.name = "polytropic diesel", .heat = 1300.0, .polytrope = 1.35},
        {.name = "motored diesel"},
        {.name = "motored diesel, cold", .speed = 1000.0 * units::rpm, .wall_share = 2.0},
        {.name = "motored petrol engine", .ratio = 10.0, .speed = 1200.0 * units::rpm},
        {.name = "motored polytrope", .polytrope = 1.33},
        {.name = "two-stroke", .ratio = 14.0, .heat = 800.0, .start = -5.0, .strokes = 2},
        {.name = "petrol engine",
         .ratio = 10.0,
         .intake = 0.95e5,
         .heat = 1500.0,
         .start = -12.0,
         .duration = 50.0,
         .form = 2.0},
        {.name = "petrol engine, early",
         .ratio = 10.0,
         .intake = 0.95e5,
         .heat = 1500.0,
         .start = -20.0,
         .duration = 55.0,
         .form = 2.5},
    };
}

}  // namespace ravnoves::balance_shaft::test
