#include "balance-shaft/cylinder_gas.h"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>

#include "balance-shaft/torque_table.h"
#include "case-file/decimal.h"
#include "case-file/input_error.h"
#include "numerics/angle.h"

namespace ravnoves::balance_shaft {

namespace {

using boost::math::quadrature::gauss;

constexpr int combustion_steps = 256;
const double vibe_a = std::log(1000.0);

}  // namespace

CylinderGas::CylinderGas(const SliderCrank<double>& crank, double bore, double crankcase_pressure)
    : crank_(crank),
      crankcase_pressure_(crankcase_pressure),
      area_(pi / 4.0 * bore * bore),
      top_dead_centre_(crank.top_dead_centre()),
      bottom_(crank.bottom_dead_centre() - crank.top_dead_centre()),
      longest_(crank.at(top_dead_centre_).s) {
    indicated_.displacement = area_ * crank_.stroke();
}

CylinderGas::CylinderGas(const SliderCrank<double>& crank, double bore, double crankcase_pressure,
                         const PressureTrace& trace, bool smooth)
    : CylinderGas(crank, bore, crankcase_pressure) {
    trace_ = smooth ? PeriodicPiecewise::cubic(trace.crank_angle_deg, trace.pressure)
                    : PeriodicPiecewise::linear(trace.crank_angle_deg, trace.pressure);
    period_ = pi * strokes_of(trace.crank_angle_deg);
    breaks_.reserve(trace.crank_angle_deg.size());
    for (const double angle : trace.crank_angle_deg) {
        breaks_.push_back(wrap(angle * degree, period_));
    }
    find_indicated();
}

CylinderGas::CylinderGas(const SliderCrank<double>& crank, double bore, double crankcase_pressure,
                         const GasCycle& gas_cycle, int strokes)
    : CylinderGas(crank, bore, crankcase_pressure) {
    cycle_ = gas_cycle;
    period_ = pi * strokes;
    clearance_ = indicated_.displacement / (cycle_.compression_ratio - 1.0);
    indicated_.clearance = clearance_;
    const double end = cycle_.combustion_start + cycle_.combustion_duration;
    if (strokes == 2) {
        // The ports close where the piston stands as at their opening, on its way up.
        const double place = crank_.at(top_dead_centre_ + cycle_.ports_open).s;
        const auto [low, high] = boost::math::tools::bisect(
            [&](double angle) { return crank_.at(top_dead_centre_ + angle).s - place; }, bottom_,
            two_pi, boost::math::tools::eps_tolerance<double>());
        ports_close_ = (low + high) / 2.0;
        breaks_ = {cycle_.ports_open, bottom_, ports_close_, cycle_.combustion_start, end};
    } else {
        breaks_ = {0.0, bottom_, cycle_.combustion_start, end, two_pi, two_pi + bottom_};
    }
    // The pressure leaves the start of combustion as τ^(m+1), m any: steps that grow from there.
    for (int parts = 1024; parts > 2; parts /= 4) {
        breaks_.push_back(cycle_.combustion_start + cycle_.combustion_duration / parts);
    }

    for (double& angle : breaks_) {
        angle = wrap(angle, period_);
    }

    const double volume_at_closing = strokes == 2 ? volume(ports_close_ + top_dead_centre_)
                                                  : clearance_ + indicated_.displacement;
    intake_constant_ =
        cycle_.intake_pressure * std::pow(volume_at_closing, cycle_.polytropic_compression);
    const double start_volume = volume(cycle_.combustion_start + top_dead_centre_);
    start_constant_ = intake_constant_ * std::pow(start_volume, cycle_.polytropic_expansion -
                                                                    cycle_.polytropic_compression);
    integral_.assign(combustion_steps + 1, 0.0);
    for (int k = 0; k < combustion_steps; ++k) {
        const double step = cycle_.combustion_duration / combustion_steps;
        integral_[static_cast<std::size_t>(k) + 1] =
            integral_[static_cast<std::size_t>(k)] +
            wiebe_integral(cycle_.combustion_start + k * step,
                           cycle_.combustion_start + (k + 1) * step);
    }
    if (cycle_.heat) {
        heat_ = *cycle_.heat;
    } else {
        // The work is linear in the heat.
        const double motored = work();
        heat_ = cycle_.intake_pressure * indicated_.displacement;
        const double per_heat = (work() - motored) / heat_;
        const double wanted = cycle_.imep.value_or(0.0) * indicated_.displacement;
        heat_ = (wanted - motored) / per_heat;
        if (!(heat_ >= 0.0) || !std::isfinite(heat_)) {
            throw InputError("/input/torque/cycle/indicated_mean_effective_pressure_bar",
                             {CORE_TEXT("balance-shaft",
                                        "must be at least %1, the value of the cycle without heat"),
                              Number{motored / indicated_.displacement / units::bar, {}, 6}},
                             Number{cycle_.imep.value_or(0.0) / units::bar});
        }
    }
    indicated_.heat = heat_;
    find_indicated();
}

double CylinderGas::volume(double theta) const {
    return clearance_ + area_ * (longest_ - crank_.at(theta).s);
}

/// ∫ Vⁿ⁻¹ (dx/dφ) dφ over a part of the combustion. At its start dx/dφ ~ τᵐ, which for an m that is
/// not whole has no Taylor series: there τ = v⁴ smooths it.
double CylinderGas::wiebe_integral(double from, double to) const {
    const double start = cycle_.combustion_start;
    const double duration = cycle_.combustion_duration;
    const double m = cycle_.wiebe_m;
    const double scale = vibe_a * (m + 1.0) / -std::expm1(-vibe_a);
    const auto integrand = [&](double tau) {
        return scale * std::pow(tau, m) * std::exp(-vibe_a * std::pow(tau, m + 1.0)) *
               std::pow(volume(start + duration * tau + top_dead_centre_),
                        cycle_.polytropic_expansion - 1.0);
    };
    const double low = std::max((from - start) / duration, 0.0);
    const double high = (to - start) / duration;
    if (low < 0.5 / combustion_steps) {
        return gauss<double, 15>::integrate(
            [&](double v) { return 4.0 * v * v * v * integrand(v * v * v * v); },
            std::pow(low, 0.25), std::pow(high, 0.25));
    }
    return gauss<double, 7>::integrate(integrand, low, high);
}

double CylinderGas::released_integral(double angle) const {
    const double part =
        (angle - cycle_.combustion_start) / cycle_.combustion_duration * combustion_steps;
    if (part <= 0.0) {
        return 0.0;
    }
    if (part >= combustion_steps) {
        return integral_.back();
    }
    const double whole = std::floor(part);
    const double from =
        cycle_.combustion_start + whole * cycle_.combustion_duration / combustion_steps;
    return integral_[static_cast<std::size_t>(whole)] + wiebe_integral(from, angle);
}

double CylinderGas::cycle_pressure(double angle) const {
    if (ports_close_ > 0.0) {
        if (angle >= ports_close_ || angle < cycle_.ports_open) {
            return closed_pressure(angle < cycle_.ports_open ? angle + two_pi : angle);
        }
        if (angle >= bottom_) {
            return cycle_.intake_pressure;
        }
        const double rest = (bottom_ - angle) / (bottom_ - cycle_.ports_open);
        const double released = closed_pressure(two_pi + cycle_.ports_open);
        return cycle_.exhaust_pressure + (released - cycle_.exhaust_pressure) * rest * rest;
    }
    if (angle < bottom_) {
        return cycle_.intake_pressure;
    }
    if (angle >= two_pi + bottom_) {
        return cycle_.exhaust_pressure;
    }
    return closed_pressure(angle);
}

/// From the end of the intake to the release.
double CylinderGas::closed_pressure(double angle) const {
    const double v = volume(angle + top_dead_centre_);
    if (angle < cycle_.combustion_start) {
        return intake_constant_ * std::pow(v, -cycle_.polytropic_compression);
    }
    return (start_constant_ +
            (cycle_.polytropic_expansion - 1.0) * heat_ * released_integral(angle)) *
           std::pow(v, -cycle_.polytropic_expansion);
}

double CylinderGas::pressure(double theta) const {
    const double angle = wrap(theta - top_dead_centre_, period_);
    return trace_ ? (*trace_)(angle / degree) : cycle_pressure(angle);
}

double CylinderGas::torque(double theta) const {
    return -(pressure(theta) - crankcase_pressure_) * area_ * crank_.at(theta).ds;
}

std::vector<double> CylinderGas::breaks_deg() const {
    std::vector<double> places;
    places.reserve(breaks_.size());
    for (const double angle : breaks_) {
        // A place given in whole degrees stays so.
        const double rounded = rounded_to_decimals(angle / degree, 9);
        places.push_back(wrap(rounded, std::round(period_ / degree)));
    }
    std::sort(places.begin(), places.end());
    return places;
}

double CylinderGas::work() const {
    // Between the breaks the integrand is smooth: 7 nodes on 5° are exact to rounding.
    std::vector<double> ends = breaks_;
    ends.push_back(0.0);
    ends.push_back(period_);
    std::sort(ends.begin(), ends.end());
    const auto power = [&](double angle) {
        return -pressure(angle + top_dead_centre_) * area_ * crank_.at(angle + top_dead_centre_).ds;
    };
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const double h = ends[i + 1] - ends[i];
        if (h <= 0.0) {
            continue;
        }
        const int parts = std::max(1, static_cast<int>(std::ceil(h / (5.0 * degree))));
        for (int k = 0; k < parts; ++k) {
            sum += gauss<double, 7>::integrate(power, ends[i] + h * k / parts,
                                               ends[i] + h * (k + 1) / parts);
        }
    }
    return sum;
}

void CylinderGas::find_indicated() {
    indicated_.work = work();
    indicated_.imep = indicated_.work / indicated_.displacement;
    constexpr int samples = 1440;
    int highest = 0;
    for (int i = 0; i < samples; ++i) {
        const double p = pressure(period_ * i / samples + top_dead_centre_);
        if (p > indicated_.peak_pressure) {
            indicated_.peak_pressure = p;
            highest = i;
        }
    }
    const auto [highest_angle, negative] = boost::math::tools::brent_find_minima(
        [this](double angle) { return -pressure(angle + top_dead_centre_); },
        period_ * (highest - 1) / samples, period_ * (highest + 1) / samples, 30);
    indicated_.peak_pressure_angle = period_ * highest / samples;
    if (-negative > indicated_.peak_pressure) {
        indicated_.peak_pressure = -negative;
        indicated_.peak_pressure_angle = wrap(highest_angle, period_);
    }
}

}  // namespace ravnoves::balance_shaft
