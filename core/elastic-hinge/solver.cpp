#include "elastic-hinge/solver.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "case-file/decimal.h"
#include "case-file/input_error.h"
#include "case-file/unusual_engine.h"
#include "numerics/maximum.h"

namespace ravnoves::elastic_hinge {

namespace {

/// The largest |value| of a curve, of which the samples are given, over the continuous turn.
template <typename Function>
double largest(const std::vector<double>& samples, const std::vector<double>& angles,
               const Function& curve) {
    Maximum found;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        found.take(std::abs(samples[i]), angles[i]);
    }
    found.sharpen([&](double phi) { return std::abs(curve(phi)); }, angles[1] - angles[0]);
    return found.value;
}

/// Not finite anywhere: the sum of finite numbers in range is finite, of others it is not.
bool all_finite(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) {
        sum += value * 0.0;
    }
    return sum == 0.0;
}

bool all_finite(const MechanismCurves& curves) {
    for (const auto* list :
         {&curves.reduced_inertia, &curves.crank_moment, &curves.rod_hinge_moment,
          &curves.rod_hinge_moment_potential, &curves.side_force_without_hinge,
          &curves.side_force_with_hinge, &curves.crank_moment_with_rod_hinge}) {
        if (!all_finite(*list)) {
            return false;
        }
    }
    return true;
}

[[noreturn]] void reject_extreme() {
    throw InputError(
        "/input",
        Text::tr("has values whose result exceeds the range of numbers; enter realistic values"));
}

void resize(MechanismCurves& curves, std::size_t n, bool exact) {
    curves.rod_hinge_moment.resize(n);
    curves.rod_hinge_moment_potential.resize(n);
    curves.side_force_without_hinge.resize(n);
    curves.side_force_with_hinge.resize(n);
    curves.reduced_inertia.resize(exact ? n : 0);
    curves.crank_moment.resize(exact ? n : 0);
    curves.crank_moment_with_rod_hinge.resize(exact ? n : 0);
}

/// The curves of one mechanism at one speed, filled angle by angle.
class CurveWriter {
  public:
    CurveWriter(MechanismCurves& curves, const Mechanism<double>& mechanism, const AngleGrid& grid,
                double omega, double mean)
        : curves_(curves),
          grid_(grid),
          exact_(mechanism.lambda < 1.0),
          square_(omega * omega),
          mean_(mean),
          lever_(mechanism.lambda / mechanism.crank_radius),
          weight_(exact_ ? potential_amplitude(mechanism) : 0.0) {
        resize(curves, grid.size(), exact_);
    }

    void put(std::size_t i, const AngleState& state) {
        const double moment = state.moment.weight + square_ * state.moment.inertia;
        const double arm = lever_ / state.cos_psi;
        curves_.rod_hinge_moment[i] = moment;
        curves_.rod_hinge_moment_potential[i] = moment - mean_;
        curves_.side_force_without_hinge[i] =
            -(state.moment.weight + square_ * state.moment.true_inertia) * arm;
        curves_.side_force_with_hinge[i] = -mean_ * arm;
        if (exact_) {
            const double crank = 0.5 * square_ * state.inertia.slope + weight_ * grid_.cos_phi[i];
            curves_.reduced_inertia[i] = state.inertia.value;
            curves_.crank_moment[i] = crank;
            curves_.crank_moment_with_rod_hinge[i] =
                crank + (moment - mean_) * (1.0 + state.exact.dpsi);
        }
    }

  private:
    MechanismCurves& curves_;
    const AngleGrid& grid_;
    bool exact_;
    double square_;
    double mean_;
    double lever_;  ///< 1/ℓ
    double weight_;
};

void fill(MechanismCurves& curves, const Mechanism<double>& mechanism,
          const std::vector<AngleState>& states, const AngleGrid& grid, double omega, double mean) {
    CurveWriter writer(curves, mechanism, grid, omega, mean);
    for (std::size_t i = 0; i < states.size(); ++i) {
        writer.put(i, states[i]);
    }
}

/// The curves for another λ (the counterweight solved again, where it is).
MechanismCurves curves_at_lambda(Input input, double lambda, const AngleGrid& grid) {
    input.lambda = lambda;
    const Mechanism<double> mechanism = mechanism_of(input);
    const bool solved = input.rod_counterweight && !input.rod_counterweight->mass;
    const double static_moment = solved ? 0.0 : mechanism.static_moment();
    const double mean = rod_hinge_integral(mechanism, static_moment, input.kinematics) / two_pi;
    MechanismCurves curves;
    CurveWriter writer(curves, mechanism, grid, input.angular_speed, mean);
    visit_turn(mechanism, static_moment, input.kinematics, grid, true,
               [&](std::size_t i, const AngleState& state) { writer.put(i, state); });
    return curves;
}

/// Where the paper's series and the exact kinematics part.
void compare_kinematics(const Input& input, const Design& design,
                        const std::vector<AngleState>& states, const AngleGrid& grid,
                        Result& result) {
    const Mechanism<double>& mechanism = design.mechanism();
    const bool exact = design.has_exact_kinematics();
    const double square = input.angular_speed * input.angular_speed;
    const std::size_t n = grid.size();
    Maximum cosine_error;
    Maximum moment_error;
    result.other_rod_hinge_moment.resize(exact ? n : 0);
    for (std::size_t i = 0; 2 * i < n; ++i) {
        const double s = grid.sin_phi[i];
        const double c = grid.cos_phi[i];
        const auto series = rod_angle_series(mechanism.lambda, s, c);
        cosine_error.take(
            std::abs(series.cos_psi - (exact ? states[i].exact.cos_psi : std::abs(c))),
            grid.angle[i]);
        if (exact) {
            const auto other =
                rod_hinge_moment(mechanism, design.static_moment(), s, c,
                                 input.kinematics == Kinematics::series ? states[i].exact : series);
            result.other_rod_hinge_moment[i] = other.weight + square * other.inertia;
            result.other_rod_hinge_moment[n - 1 - i] = other.weight - square * other.inertia;
            // At φ or at −φ, whichever is worse.
            moment_error.take(std::abs(other.weight - states[i].moment.weight) +
                                  square * std::abs(other.inertia - states[i].moment.inertia),
                              grid.angle[i]);
        }
    }
    const double step = grid.angle[1] - grid.angle[0];
    const auto error_of_cosine = [&](double phi) {
        const double s = std::sin(phi);
        const double c = std::cos(phi);
        return std::abs(rod_angle_series(mechanism.lambda, s, c).cos_psi -
                        rod_angle_exact(mechanism.lambda, s, c).cos_psi);
    };
    const auto error_of_moment = [&](double phi) {
        const double s = std::sin(phi);
        const double c = std::cos(phi);
        const auto one = rod_hinge_moment(mechanism, design.static_moment(), s, c,
                                          rod_angle_exact(mechanism.lambda, s, c));
        const auto other = rod_hinge_moment(mechanism, design.static_moment(), s, c,
                                            rod_angle_series(mechanism.lambda, s, c));
        return std::abs(other.weight - one.weight) + square * std::abs(other.inertia - one.inertia);
    };
    if (exact) {
        cosine_error.sharpen(error_of_cosine, step);
        moment_error.sharpen(error_of_moment, step);
        result.series_moment_error = moment_error.value;
    }
    result.series_error = cosine_error.value;
    result.series_error_angle = cosine_error.place;
}

void find_largest_side_forces(const Input& input, const Design& design, const AngleGrid& grid,
                              bool hinge_is_true, Result& result) {
    const Mechanism<double>& mechanism = design.mechanism();
    const double square = input.angular_speed * input.angular_speed;
    const double mean = design.rod_hinge_mean();
    struct Forces {
        double without, with, by_newton_euler;
    };
    const auto at = [&](double phi) {
        const double s = std::sin(phi);
        const double c = std::cos(phi);
        const auto rod = rod_angle(input.kinematics, mechanism.lambda, s, c);
        const auto chosen = rod_hinge_moment(mechanism, design.static_moment(), s, c, rod);
        const double lever = mechanism.lambda / mechanism.crank_radius;
        Forces forces{-(chosen.weight + square * chosen.true_inertia) * lever / rod.cos_psi,
                      -mean * lever / rod.cos_psi, 0.0};
        if (!result.side_force_true.empty()) {
            const auto exact_rod = rod_angle_exact(mechanism.lambda, s, c);
            const auto moment =
                rod_hinge_moment(mechanism, design.static_moment(), s, c, exact_rod);
            forces.by_newton_euler = (chosen.weight + square * chosen.inertia - mean -
                                      (moment.weight + square * moment.true_inertia)) *
                                     lever / exact_rod.cos_psi;
        }
        return forces;
    };
    result.largest_side_force_without = largest(result.curves.side_force_without_hinge, grid.angle,
                                                [&](double phi) { return at(phi).without; });
    result.largest_side_force_with = largest(result.curves.side_force_with_hinge, grid.angle,
                                             [&](double phi) { return at(phi).with; });
    result.largest_side_force_true =
        hinge_is_true && !result.side_force_true.empty()
            ? result.largest_side_force_with
            : largest(result.side_force_true, grid.angle,
                      [&](double phi) { return at(phi).by_newton_euler; });
}

void add_notes(const Input& input, Result& result) {
    const auto& guide = result.crank_guide;
    result.doubts = unusual_engine_notes({input.angular_speed,
                                          input.crank_radius,
                                          0.0,  // the ratio is typed itself
                                          {input.crank_mass, input.rod_mass, input.slider_mass}});
    if (input.kinematics == Kinematics::series && input.lambda > 0.4) {
        result.notes.emplace_back(Text::tr("Error of the series in cos ψ: %1 at φ = %2°; use the "
                                           "exact kinematics for a design."),
                                  Number{result.series_error, units::none, 3},
                                  std::round(result.series_error_angle / units::degree));
    }
    if (input.guide_sign == GuideSign::as_printed) {
        result.guide_notes.emplace_back(
            Text::tr("The guide has the sign as printed in the paper: the crank leaves its design "
                     "speed, which the energy sign keeps."));
    }
    if (input.rod_counterweight &&
        input.rod_counterweight->inertia == CounterweightInertia::as_printed &&
        result.counterweight_mass > 0.0 && !result.side_force_true.empty()) {
        result.notes.emplace_back(
            Text::tr("Equation (9) as printed has the wrong sign of the counterweight's inertia: "
                     "residual side force up to %1, with Newton–Euler zero."),
            Number{std::round(result.largest_side_force_true), units::newton});
    }
    if (guide.feasible && guide.relief < 0.1 * units::mm && guide.error.relative > 0.02) {
        result.guide_notes.emplace_back(
            Text::tr("The crank's guide has a relief of only %1: a profile error of %2 changes "
                     "its moment by up to %3; a softer spring gives more relief."),
            Number{rounded_to_decimals(guide.relief / units::micrometre, 1), units::micrometre},
            Number{rounded_to_decimals(guide.error.amplitude / units::micrometre, 2),
                   units::micrometre},
            Number{rounded_to_decimals(guide.error.relative / units::percent, 1), units::percent});
    }
}

void check_finite(const Guide& guide) {
    for (const double value :
         {guide.preload, guide.minimum_preload, guide.relief, guide.largest_spring_force,
          guide.largest_moment, guide.error.torque, guide.error.energy, guide.error.relative,
          guide.compressed.max_radius, guide.stretched.max_radius,
          guide.compressed.profile_max_radius, guide.stretched.profile_max_radius}) {
        if (!std::isfinite(value)) {
            reject_extreme();
        }
    }
}

}  // namespace

Result solve(const Input& input, const SolveOptions& options) {
    Result result;
    const bool with_moments =
        options.with_rod_guides || options.with_curves || !options.speeds.empty();
    result.design = std::make_shared<const Design>(input, options.with_rod_guides, with_moments);
    const Design& design = *result.design;
    const Mechanism<double>& mechanism = design.mechanism();
    const bool exact = design.has_exact_kinematics();
    const double omega = input.angular_speed;

    const auto kept = angle_grid(options.samples);
    const AngleGrid& grid = *kept;
    const std::size_t n = grid.size();
    result.crank_angle_deg = grid.angle_deg;
    result.rod_hinge_integral = design.rod_hinge_integral();
    const double mean = design.rod_hinge_mean();
    result.has_counterweight = input.rod_counterweight.has_value();
    result.counterweight_mass = mechanism.counterweight_mass;
    result.balancing_mass = result.has_counterweight ? mechanism.balancing_mass() : 0.0;
    if (!std::isfinite(mean) || !std::isfinite(result.balancing_mass)) {
        reject_extreme();
    }

    std::vector<AngleState> other_states;
    if (n != design.states().size()) {
        other_states = turn_states(mechanism, design.static_moment(), input.kinematics, grid);
    }
    const std::vector<AngleState>& states = other_states.empty() ? design.states() : other_states;
    if (options.with_curves) {
        fill(result.curves, mechanism, states, grid, omega, mean);
        compare_kinematics(input, design, states, grid, result);
    }
    for (const double speed : options.speeds) {
        result.by_speed.push_back({speed, {}});
        fill(result.by_speed.back().curves, mechanism, states, grid, speed, mean);
    }
    if (!options.with_profiles) {
        result.crank_guide = make_guide(result.design, Hinge::crank, input.spring, input, {});
    }
    const bool by_angle = options.with_profiles || !result.crank_guide.feasible;
    const bool rod_guides = exact && options.with_rod_guides;
    std::vector<Demand> crank_demand(exact && by_angle ? n : 0);
    std::vector<Demand> crank_with_rod_demand(rod_guides ? n : 0);
    std::vector<Demand> rod_demand(rod_guides ? n : 0);
    for (std::size_t i = 0; i < crank_demand.size(); ++i) {
        const EnergyRise<double> rise =
            energy_rise(mechanism, omega, grid.sin_phi[i], grid.cos_phi[i], states[i].inertia);
        const double phi = grid.angle[i];
        crank_demand[i] = design.demand(Hinge::crank, phi, states[i], rise, 0.0);
        if (rod_guides) {
            const double work =
                other_states.empty() ? design.work_table()[i] : design.rod_work(phi);
            crank_with_rod_demand[i] =
                design.demand(Hinge::crank_with_rod, phi, states[i], rise, work);
            rod_demand[i] = design.demand(Hinge::rod, phi, states[i], rise, work);
        }
    }

    const bool with_forces = exact && options.with_curves;
    const bool hinge_is_true =
        input.kinematics == Kinematics::exact &&
        (mechanism.counterweight_mass == 0.0 ||
         mechanism.counterweight_inertia == CounterweightInertia::newton_euler);
    if (with_forces && hinge_is_true) {
        result.side_force_true = result.curves.side_force_with_hinge;
    } else if (with_forces) {
        const double square = omega * omega;
        result.side_force_true.resize(n);
        for (std::size_t i = 0; i < n; ++i) {
            const auto moment = rod_hinge_moment(mechanism, design.static_moment(), grid.sin_phi[i],
                                                 grid.cos_phi[i], states[i].exact);
            result.side_force_true[i] = (result.curves.rod_hinge_moment_potential[i] -
                                         (moment.weight + square * moment.true_inertia)) *
                                        mechanism.lambda /
                                        (mechanism.crank_radius * states[i].exact.cos_psi);
        }
    }
    for (const double lambda : options.lambdas) {
        if (lambda < 1.0 || input.kinematics == Kinematics::series) {
            result.by_lambda.push_back({lambda, curves_at_lambda(input, lambda, grid)});
        }
    }
    if (!all_finite(result.curves) || !all_finite(result.side_force_true)) {
        reject_extreme();
    }
    for (const auto* family : {&result.by_speed, &result.by_lambda}) {
        for (const FamilyMember& member : *family) {
            if (!all_finite(member.curves)) {
                reject_extreme();
            }
        }
    }
    if (options.with_curves) {
        find_largest_side_forces(input, design, grid, hinge_is_true, result);
    }

    if (by_angle) {
        result.crank_guide =
            make_guide(result.design, Hinge::crank, input.spring, input, crank_demand);
    }
    check_finite(result.crank_guide);
    if (options.with_rod_guides) {
        const auto& rod_spring = input.rod_hinge_spring ? input.rod_hinge_spring : input.spring;
        result.crank_guide_with_rod = make_guide(result.design, Hinge::crank_with_rod, input.spring,
                                                 input, crank_with_rod_demand);
        result.rod_guide = make_guide(result.design, Hinge::rod, rod_spring, input, rod_demand);
        check_finite(result.crank_guide_with_rod);
        check_finite(result.rod_guide);
    }
    if (input.guide_search && input.spring) {
        result.proposal =
            search_guide(result.design, Hinge::crank, input.guide_sign, result.crank_guide.branch,
                         input.spring->free_length, input.roller_radius, *input.guide_search);
    }
    add_notes(input, result);
    return result;
}

Motion simulate(const Input& input, const Result& result, HingeSet hinges,
                const MotionProgress& progress) {
    const MotionWish wish = input.motion.value_or(MotionWish{});
    MotionSetup setup;
    setup.hinges = hinges;
    setup.turns = wish.turns;
    setup.start_angle = wish.start_angle;
    setup.start_speed = wish.start_speed.value_or(input.angular_speed);
    setup.crank_torque = wish.crank_torque;
    if (wish.with_profile_error) {
        setup.profile_error = input.profile_error;
        setup.profile_error_waves = input.profile_error_waves;
    }
    const Guide& guide =
        hinges == HingeSet::crank_and_rod ? result.crank_guide_with_rod : result.crank_guide;
    return simulate(result.design, guide, setup, progress);
}

MechanismPose mechanism_pose(const Result& result, double phi) {
    const Mechanism<double>& m = result.design->mechanism();
    const double s = std::sin(phi);
    const double c = std::cos(phi);
    const double sin_psi = m.lambda * s;
    const double cos_psi = std::sqrt(std::max(0.0, (1.0 - sin_psi) * (1.0 + sin_psi)));
    const double r = m.crank_radius;
    const double l = m.rod_length();
    const double l2 = m.counterweight_distance;
    MechanismPose pose;
    pose.crankpin = {r * c, r * s};
    pose.slider = {r * c + l * cos_psi, 0.0};
    pose.counterweight = {r * c - l2 * cos_psi, r * s + l2 * sin_psi};
    pose.rod_angle = -std::atan2(sin_psi, cos_psi);
    pose.spring_half_length = std::numeric_limits<double>::quiet_NaN();
    if (const auto& shape = result.crank_guide.shape) {
        pose.spring_half_length = shape->at(result.crank_guide.branch, phi).radius;
    }
    return pose;
}

}  // namespace ravnoves::elastic_hinge
