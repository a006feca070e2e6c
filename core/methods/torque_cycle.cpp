#include "methods/torque_cycle.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "balance-shaft/presets.h"
#include "balance-shaft/solver.h"
#include "numerics/constants.h"

namespace ravnoves::methods {

namespace {

constexpr double peak_deg = 383.77;         // of the combustion: on no node of a round step
constexpr double paper_amplitude = 430.39;  // N·m, of the paper's Table 3

/// Rows of a function of the crank angle (°).
template <typename Function>
TorqueCycle from_rows(std::vector<double> angle_deg, const Function& moment) {
    TorqueCycle cycle;
    cycle.angle_deg = std::move(angle_deg);
    cycle.moment.reserve(cycle.angle_deg.size());
    for (const double angle : cycle.angle_deg) {
        cycle.moment.push_back(moment(angle));
    }
    cycle.moment.back() = cycle.moment.front();
    cycle.amplitude = paper_amplitude;
    cycle.alpha = 50.0 * degree;
    return cycle;
}

std::vector<double> equal_rows(std::size_t n) {
    std::vector<double> angle;
    for (std::size_t i = 0; i < n; ++i) {
        angle.push_back(cycle_deg * static_cast<double>(i) / static_cast<double>(n));
    }
    angle.push_back(cycle_deg);
    return angle;
}

/// Gas and inertia of a small engine in outline: a peak after the firing top dead centre, the
/// compression before it and the inertia's second order.
double outline(double angle_deg, double width_deg) {
    const auto bell = [&](double centre, double width) {
        const double u = std::remainder(angle_deg - centre, cycle_deg) / width;
        return std::exp(-0.5 * u * u);
    };
    return -(500.0 * bell(peak_deg, width_deg) - 150.0 * bell(335.0, 20.0) +
             180.0 * std::sin(2.0 * angle_deg * degree));
}

/// A torque with a combustion peak of 500 N·m and the given half width, on rows that are dense
/// there and every 15° elsewhere.
TorqueCycle peak_cycle(double width_deg) {
    std::vector<double> angle = equal_rows(48);
    constexpr int steps_per_width = 4;
    for (int k = -16; k <= 16; ++k) {
        const double row = peak_deg + width_deg * k / steps_per_width;
        if (row > 0.0 && row < cycle_deg) {
            angle.push_back(row);
        }
    }
    std::sort(angle.begin(), angle.end());
    // Rows closer than a billionth of the cycle are one row.
    angle.erase(std::unique(angle.begin(), angle.end(),
                            [](double a, double b) { return b - a < 1e-9 * cycle_deg; }),
                angle.end());
    angle.back() = cycle_deg;
    TorqueCycle cycle =
        from_rows(std::move(angle), [&](double a) { return outline(a, width_deg); });
    cycle.alpha = 230.0 * degree;  // where the shaft's moment adds to the peak's
    return cycle;
}

/// A smooth torque on n equally spaced rows, read through the periodic spline.
TorqueCycle spline_cycle(double rows) {
    TorqueCycle cycle = from_rows(equal_rows(static_cast<std::size_t>(rows)),
                                  [](double a) { return outline(a, 18.0); });
    cycle.cubic = true;
    return cycle;
}

/// n rows at irregular angles with irregular torques, from a fixed seed.
TorqueCycle irregular_cycle(double rows) {
    const auto n = static_cast<std::size_t>(rows);
    std::mt19937 generator(static_cast<unsigned>(n));
    // The generator's own numbers: distributions differ between standard libraries.
    const auto unit = [&] { return static_cast<double>(generator()) / 4294967296.0; };
    std::vector<double> angle{0.0};
    for (std::size_t i = 0; i < n; ++i) {
        angle.push_back(angle.back() + 0.2 + unit());
    }
    const double scale = cycle_deg / angle.back();
    for (double& a : angle) {
        a *= scale;
    }
    angle.back() = cycle_deg;
    return from_rows(std::move(angle), [&](double) { return 1000.0 * (unit() - 0.5); });
}

}  // namespace

double TorqueCycle::size() const {
    double largest = 0.0;
    for (const double value : moment) {
        largest = std::max(largest, std::abs(value));
    }
    return largest + amplitude;
}

TorqueCycle paper_cycle() {
    const balance_shaft::Solver solver(balance_shaft::preset_tmz_650d());
    const balance_shaft::TorqueTable& table = solver.input().torque.table;
    TorqueCycle cycle;
    cycle.angle_deg = table.crank_angle_deg;
    for (const double torque : table.torque) {
        cycle.moment.push_back(-torque);
    }
    cycle.amplitude = solver.result().moment_amplitude;
    cycle.alpha = solver.input().shaft_angle;
    return cycle;
}

TorqueCycle pure_sine_cycle(double alpha_deg) {
    TorqueCycle cycle = from_rows(equal_rows(24), [](double) { return 0.0; });
    cycle.alpha = alpha_deg * degree;
    return cycle;
}

TorqueCycle two_minima_cycle(double share) {
    return from_rows(equal_rows(48), [&](double a) {
        return 600.0 * (std::cos(2.0 * a * degree) + share * std::cos(a * degree));
    });
}

std::vector<Sweep<TorqueCycle>> torque_sweeps(std::initializer_list<std::string_view> ids) {
    static const std::vector<Sweep<TorqueCycle>> sweeps = [] {
        const TorqueCycle paper = paper_cycle();
        const auto paper_with = [&](double TorqueCycle::*member, double unit) {
            return [=](double value) {
                TorqueCycle cycle = paper;
                cycle.*member = value * unit;
                return cycle;
            };
        };
        constexpr Spacing by_decades = Spacing::logarithmic;
        return std::vector<Sweep<TorqueCycle>>{
            {{"shaft-angle", Text::tr("shaft angle α, the paper's engine"), units::degree, 0.0,
              360.0, Spacing::linear, 0.0, 360.0, paper.alpha / degree},
             paper_with(&TorqueCycle::alpha, degree)},
            {{"pure-sine", Text::tr("shaft angle α, no torque but the shaft's"), units::degree, 0.0,
              360.0, Spacing::linear, 0.0, 360.0, 90.0},
             pure_sine_cycle},
            {{"amplitude", Text::tr("amplitude of the shaft's moment, the paper's torque"),
              units::N_m, 1.0, 1e5, by_decades, 1.0, 1e5, paper.amplitude},
             paper_with(&TorqueCycle::amplitude, 1.0)},
            {{"second-minimum", Text::tr("difference of the two minima"), units::none, 1e-12, 1.0,
              by_decades, 1e-12, 1.0, 0.1},
             two_minima_cycle},
            {{"peak-width", Text::tr("width of the combustion peak"), units::degree, 0.05, 60.0,
              by_decades, 0.05, 60.0, 15.0},
             peak_cycle},
            {{"spline-rows", Text::tr("rows of a table read by the spline"), units::none, 8.0,
              160.0, by_decades, 8.0, 160.0, 48.0},
             spline_cycle},
            {{"irregular-rows", Text::tr("rows of an irregular table"), units::none, 6.0, 400.0,
              by_decades, 6.0, 400.0, 48.0},
             irregular_cycle}};
    }();
    std::vector<Sweep<TorqueCycle>> chosen;
    for (const std::string_view id : ids) {
        chosen.push_back(
            *std::ranges::find(sweeps, id, [](const auto& each) { return each.info.id; }));
    }
    return chosen;
}

}  // namespace ravnoves::methods
