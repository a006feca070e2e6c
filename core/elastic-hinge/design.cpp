#include "elastic-hinge/design.h"

#include <algorithm>
#include <boost/math/interpolators/quintic_hermite.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/cos_pi.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/special_functions/sin_pi.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>

#include "numerics/angle.h"
#include "numerics/periodic_integral.h"

namespace ravnoves::elastic_hinge {

std::shared_ptr<const AngleGrid> angle_grid(int samples) {
    thread_local std::shared_ptr<const AngleGrid> kept;
    const auto n = static_cast<std::size_t>(std::max(samples, 13));
    if (kept && kept->size() == n) {
        return kept;
    }
    AngleGrid grid;
    grid.angle_deg.resize(n);
    grid.angle.resize(n);
    grid.sin_phi.resize(n);
    grid.cos_phi.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double turn = static_cast<double>(i) / static_cast<double>(n - 1);
        grid.angle_deg[i] = 360.0 * static_cast<double>(i) / static_cast<double>(n - 1);
        grid.angle[i] = two_pi * turn;
        grid.sin_phi[i] = boost::math::sin_pi(2.0 * turn);
        grid.cos_phi[i] = boost::math::cos_pi(2.0 * turn);
    }
    kept = std::make_shared<const AngleGrid>(std::move(grid));
    return kept;
}

Design::Design(const Input& input, bool with_rod, bool with_moments, int samples)
    : mechanism_((check_input(input), mechanism_of(input))),
      omega_(input.angular_speed),
      kinematics_(input.kinematics),
      sharp_(input.lambda > 0.97),
      grid_(angle_grid(samples)),
      states_(grid_->size()) {
    const bool solved = input.rod_counterweight && !input.rod_counterweight->mass;
    static_moment_ = solved ? 0.0 : mechanism_.static_moment();
    const double lambda = mechanism_.lambda;
    integral_ = mechanism_.gravity * static_moment_ *
                (kinematics_ == Kinematics::exact ? 4.0 * boost::math::ellint_2(lambda)
                                                  : two_pi * (1.0 - 0.25 * lambda * lambda));
    tabulate_states(with_moments);
    if (has_exact_kinematics() && with_rod) {
        tabulate_work();
        find_range(Hinge::crank_with_rod);
        find_range(Hinge::rod);
    }
    if (has_exact_kinematics()) {
        find_range(Hinge::crank);
    }
}

void Design::tabulate_states(bool with_moments) {
    for (std::size_t i = 0; 2 * i < states_.size(); ++i) {
        const double s = grid_->sin_phi[i];
        const double c = grid_->cos_phi[i];
        AngleState state{};
        if (has_exact_kinematics()) {
            state.exact = rod_angle_exact(mechanism_.lambda, s, c);
            state.inertia = reduced_inertia(mechanism_, s, c, state.exact);
        }
        if (with_moments) {
            const RodAngle<double> rod = kinematics_ == Kinematics::exact
                                             ? state.exact
                                             : rod_angle_series(mechanism_.lambda, s, c);
            state.moment = rod_hinge_moment(mechanism_, static_moment_, s, c, rod);
            state.cos_psi = rod.cos_psi;
        }
        states_[i] = state;
        // −φ mirrors φ.
        const std::size_t mirror = states_.size() - 1 - i;
        if (mirror == i) {
            continue;
        }
        state.exact.sin_psi = -state.exact.sin_psi;
        state.exact.dcos = -state.exact.dcos;
        state.exact.d3cos = -state.exact.d3cos;
        state.exact.d2psi = -state.exact.d2psi;
        state.inertia.slope = -state.inertia.slope;
        state.moment.inertia = -state.moment.inertia;
        state.moment.true_inertia = -state.moment.true_inertia;
        state.moment.dweight = -state.moment.dweight;
        states_[mirror] = state;
    }
}

RodHingeMoment<double> Design::rod_moment(double sin_phi, double cos_phi) const {
    return rod_hinge_moment(mechanism_, static_moment_, sin_phi, cos_phi,
                            rod_angle(kinematics_, mechanism_.lambda, sin_phi, cos_phi));
}

double Design::work_slope(double phi) const {
    const double s = std::sin(phi);
    const double c = std::cos(phi);
    const double cos_psi = std::sqrt((1.0 - mechanism_.lambda * s) * (1.0 + mechanism_.lambda * s));
    return (rod_moment(s, c).value(omega_) - rod_hinge_mean()) *
           (1.0 + mechanism_.lambda * c / cos_psi);
}

void Design::tabulate_work() {
    const std::size_t n = grid_->size();
    const double step = two_pi / static_cast<double>(n - 1);
    const double mean = rod_hinge_mean();
    std::vector<double> slope(n);
    std::vector<double> second(n);
    for (std::size_t i = 0; i < n; ++i) {
        const AngleState& state = states_[i];
        const double potential = state.moment.value(omega_) - mean;
        const double dtheta = 1.0 + state.exact.dpsi;
        slope[i] = potential * dtheta;
        second[i] = state.moment.slope(omega_) * dtheta + potential * state.exact.d2psi;
    }
    if (sharp_) {
        work_.assign(n, 0.0);
        for (std::size_t i = 0; i + 1 < n; ++i) {
            work_[i + 1] = work_[i] + integrate_work(grid_->angle[i], grid_->angle[i + 1]);
        }
        return;
    }
    work_ = cumulative_periodic_integral({slope.data(), n - 1}, step);
    auto copy = work_;
    boost::math::interpolators::cardinal_quintic_hermite<std::vector<double>> interpolator(
        std::move(copy), std::move(slope), std::move(second), 0.0, step);
    interpolated_work_ = [interpolator, last = step * static_cast<double>(n - 1)](double x) {
        return interpolator(std::min(x, last));
    };
}

double Design::rod_work(double phi) const {
    const double x = wrap_turn(phi);
    if (!sharp_) {
        return interpolated_work_(x);
    }
    const double step = two_pi / static_cast<double>(work_.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(x / step), work_.size() - 1);
    const double node = step * static_cast<double>(i);
    return x == node ? work_[i] : work_[i] + integrate_work(node, x);
}

double Design::integrate_work(double from, double to) const {
    // The integrand has a pole at a distance of about √(1 − λ²) from the real angle 90° (and 270°):
    // panels half as long as the way to it keep the seven-point rule exact to rounding.
    const double width = std::sqrt((1.0 - mechanism_.lambda) * (1.0 + mechanism_.lambda));
    const double off = std::abs(std::remainder(0.5 * (from + to) - 0.5 * pi, pi));
    const double reach = 0.5 * std::max(std::hypot(off - 0.5 * std::abs(to - from), width), width);
    const int panels =
        static_cast<int>(std::clamp(std::ceil(std::abs(to - from) / reach), 1.0, 256.0));
    double sum = 0.0;
    for (int i = 0; i < panels; ++i) {
        sum += boost::math::quadrature::gauss<double, 7>::integrate(
            [this](double x) { return work_slope(x); }, from + (to - from) * i / panels,
            from + (to - from) * (i + 1) / panels);
    }
    return sum;
}

Demand Design::demand(Hinge hinge, double phi, double sin_phi, double cos_phi,
                      const AngleState& state, double work) const {
    const auto rise = energy_rise(mechanism_, omega_, sin_phi, cos_phi, state.inertia);
    if (hinge == Hinge::crank) {
        return {phi, 1.0, rise.rise, rise.slope, rise.second};
    }
    const double dtheta = 1.0 + state.exact.dpsi;
    const double potential = state.moment.value(omega_) - rod_hinge_mean();
    const double dpotential = state.moment.slope(omega_);
    if (hinge == Hinge::rod) {
        // The hinge turns the rod by +M₁₂ against −ψ and the crank by −M₁₂: its power is −M₁₂ θ̇.
        return {phi + std::asin(state.exact.sin_psi), dtheta, -work, -potential,
                -dpotential / dtheta};
    }
    return {phi, 1.0, rise.rise + work, rise.slope + potential * dtheta,
            rise.second + dpotential * dtheta + potential * state.exact.d2psi};
}

Demand Design::demand(Hinge hinge, double phi) const {
    const double s = std::sin(phi);
    const double c = std::cos(phi);
    AngleState state{};
    state.exact = rod_angle_exact(mechanism_.lambda, s, c);
    state.inertia = reduced_inertia(mechanism_, s, c, state.exact);
    if (hinge == Hinge::crank) {
        return demand(hinge, phi, s, c, state, 0.0);
    }
    state.moment = kinematics_ == Kinematics::exact
                       ? rod_hinge_moment(mechanism_, static_moment_, s, c, state.exact)
                       : rod_moment(s, c);
    return demand(hinge, phi, s, c, state, rod_work(phi));
}

Demand Design::demand_at(Hinge hinge, std::size_t i) const {
    return demand(hinge, grid_->angle[i], grid_->sin_phi[i], grid_->cos_phi[i], states_[i],
                  hinge == Hinge::crank ? 0.0 : work_[i]);
}

void Design::find_range(Hinge hinge) {
    const std::vector<double>& angles = grid_->angle;
    DemandRange& range = ranges_[static_cast<int>(hinge)];
    const auto take = [&](double phi, double energy) {
        if (energy < range.min) {
            range.min = energy;
            range.min_angle = wrap_turn(phi);
        }
        if (energy > range.max) {
            range.max = energy;
            range.max_angle = wrap_turn(phi);
        }
    };
    double before = 0.0;  // the moment
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const Demand here = demand_at(hinge, i);
        if ((before < 0.0 && here.moment > 0.0) || (before > 0.0 && here.moment < 0.0)) {
            // An extremum of the energy is a zero of the moment, and well conditioned as that.
            std::uintmax_t steps = 60;
            const auto bracket = boost::math::tools::toms748_solve(
                [&](double phi) { return demand(hinge, phi).moment; }, angles[i - 1], angles[i],
                before, here.moment, boost::math::tools::eps_tolerance<double>(50), steps);
            const double phi = 0.5 * (bracket.first + bracket.second);
            take(phi, demand(hinge, phi).energy);
        }
        if (i + 1 < angles.size()) {  // where the turn begins again
            take(angles[i], here.energy);
        }
        before = here.moment;
    }
}

}  // namespace ravnoves::elastic_hinge
