#include "balance-shaft/cylinder_gas.h"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>

#include "balance-shaft/torque_table.h"
#include "case-file/decimal.h"
#include "case-file/input_error.h"
#include "numerics/angle.h"
#include "numerics/maximum.h"

namespace ravnoves::balance_shaft {

namespace {

using boost::math::quadrature::gauss;

constexpr int combustion_steps = 64;
const double vibe_a = std::log(1000.0);

}  // namespace

CylinderGas::CylinderGas(const SliderCrank<double>& crank, double bore, double crankcase_pressure)
    : crank_(crank),
      crankcase_pressure_(crankcase_pressure),
      area_(pi / 4.0 * bore * bore),
      top_dead_centre_(crank.top_dead_centre()),
      bottom_(crank.bottom_dead_centre() - crank.top_dead_centre()),
      longest_(crank.at(top_dead_centre_).s),
      displacement_(area_ * crank.stroke()) {}

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
}

CylinderGas::CylinderGas(const SliderCrank<double>& crank, double bore, double crankcase_pressure,
                         const GasCycle& gas_cycle, int strokes)
    : CylinderGas(crank, bore, crankcase_pressure) {
    cycle_ = gas_cycle;
    period_ = pi * strokes;
    clearance_ = displacement_ / (cycle_.compression_ratio - 1.0);
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

    const double volume_at_closing =
        strokes == 2 ? volume(ports_close_ + top_dead_centre_) : clearance_ + displacement_;
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
    if (strokes == 2) {
        const double opening = two_pi + cycle_.ports_open;
        at_opening_ = closed_pressure(opening, volume(opening + top_dead_centre_));
    }
    if (cycle_.heat) {
        heat_ = *cycle_.heat;
    } else {
        const double motored = work({1.0, 0.0});
        heat_ = (cycle_.imep.value_or(0.0) * displacement_ - motored) / work({0.0, 1.0});
        if (!(heat_ >= 0.0) || !std::isfinite(heat_)) {
            throw InputError("/input/torque/cycle/indicated_mean_effective_pressure_bar",
                             {Text::tr("must be at least %1, the value of the cycle without heat"),
                              Number{motored / displacement_ / units::bar, {}, 6}},
                             Number{cycle_.imep.value_or(0.0) / units::bar});
        }
    }
}

double CylinderGas::volume(double theta) const {
    return volume_above(crank_.at(theta).s);
}

/// ∫ Vⁿ⁻¹ (dx/dφ) dφ over a part of the combustion. At its start dx/dφ ~ τᵐ, which for an m that is
/// not whole has no Taylor series: there τ = v⁴ smooths it.
double CylinderGas::wiebe_integral(double from, double to) const {
    const double start = cycle_.combustion_start;
    const double duration = cycle_.combustion_duration;
    const double m = cycle_.wiebe_m;
    const double scale = vibe_a * (m + 1.0) / -std::expm1(-vibe_a);
    const auto integrand = [&](double tau) {
        const double power = std::pow(tau, m);
        return scale * power * std::exp(-vibe_a * power * tau) *
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

CylinderGas::Parts CylinderGas::pressure_parts(double angle, double volume) const {
    if (trace_) {
        return {(*trace_)(angle / degree), 0.0};
    }
    if (ports_close_ > 0.0) {
        if (angle >= ports_close_ || angle < cycle_.ports_open) {
            return closed_pressure(angle < cycle_.ports_open ? angle + two_pi : angle, volume);
        }
        if (angle >= bottom_) {
            return {cycle_.intake_pressure, 0.0};
        }
        const double rest = (bottom_ - angle) / (bottom_ - cycle_.ports_open);
        const double part = rest * rest;
        return {cycle_.exhaust_pressure + (at_opening_.motored - cycle_.exhaust_pressure) * part,
                at_opening_.per_heat * part};
    }
    if (angle < bottom_) {
        return {cycle_.intake_pressure, 0.0};
    }
    if (angle >= two_pi + bottom_) {
        return {cycle_.exhaust_pressure, 0.0};
    }
    return closed_pressure(angle, volume);
}

/// From the end of the intake to the release.
CylinderGas::Parts CylinderGas::closed_pressure(double angle, double volume) const {
    if (angle < cycle_.combustion_start) {
        return {intake_constant_ * std::pow(volume, -cycle_.polytropic_compression), 0.0};
    }
    const double expansion = std::pow(volume, -cycle_.polytropic_expansion);
    return {start_constant_ * expansion,
            (cycle_.polytropic_expansion - 1.0) * released_integral(angle) * expansion};
}

double CylinderGas::pressure(double theta) const {
    return of(pressure_parts(wrap(theta - top_dead_centre_, period_), volume(theta)));
}

double CylinderGas::torque(double theta, const PistonMotion<double>& motion) const {
    const double angle = wrap(theta - top_dead_centre_, period_);
    const double pressure = of(pressure_parts(angle, volume_above(motion.s)));
    return -(pressure - crankcase_pressure_) * area_ * motion.ds;
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

double CylinderGas::work(const Parts& weight) const {
    const auto integrand = [&](double angle) {
        const PistonMotion<double> motion = crank_.at(angle + top_dead_centre_);
        const Parts pressure = pressure_parts(angle, volume_above(motion.s));
        return -area_ * motion.ds *
               (weight.motored * pressure.motored + weight.per_heat * pressure.per_heat);
    };
    // Between the breaks the integrand is smooth: 7 nodes on 5° are exact to rounding.
    std::vector<double> ends = breaks_;
    ends.push_back(0.0);
    ends.push_back(period_);
    std::sort(ends.begin(), ends.end());
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const double h = ends[i + 1] - ends[i];
        const int parts = static_cast<int>(std::ceil(h / (5.0 * degree)));
        for (int k = 0; k < parts; ++k) {
            sum += gauss<double, 7>::integrate(integrand, ends[i] + h * k / parts,
                                               ends[i] + h * (k + 1) / parts);
        }
    }
    return sum;
}

IndicatedCycle CylinderGas::indicated() const {
    IndicatedCycle result;
    result.displacement = displacement_;
    if (!trace_) {
        result.clearance = clearance_;
        result.heat = heat_;
    }
    result.work = work({1.0, heat_});
    result.imep = result.work / displacement_;
    constexpr int samples = 1440;
    const double step = period_ / samples;
    const auto at = [this](double angle) { return pressure(angle + top_dead_centre_); };
    Maximum peak;
    for (int i = 0; i < samples; ++i) {
        peak.take(at(step * i), step * i);
    }
    peak.sharpen(at, step);
    result.peak_pressure = peak.value;
    result.peak_pressure_angle = wrap(peak.place, period_);
    return result;
}

}  // namespace ravnoves::balance_shaft
