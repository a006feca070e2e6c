#include "elastic-hinge/solver.h"

#include <algorithm>
#include <array>
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

[[noreturn]] void reject_extreme() {
    throw InputError(
        "/input",
        Text::tr("has values whose result exceeds the range of numbers; enter realistic values"));
}

/// The curves of one mechanism at one speed.
/// @param visit_states  calls its argument as visit_turn() does
template <typename VisitStates>
MechanismCurves curves_of(const Mechanism<double>& mechanism, const AngleGrid& grid, double omega,
                          double mean, const VisitStates& visit_states) {
    using Curves = MechanismCurves;
    constexpr std::array of_any{&Curves::rod_hinge_moment, &Curves::rod_hinge_moment_potential,
                                &Curves::side_force_without_hinge, &Curves::side_force_with_hinge};
    constexpr std::array of_exact{&Curves::reduced_inertia, &Curves::crank_moment,
                                  &Curves::crank_moment_with_rod_hinge};
    Curves curves;
    const bool exact = mechanism.lambda < 1.0;
    for (const auto list : of_any) {
        (curves.*list).resize(grid.size());
    }
    for (const auto list : of_exact) {
        (curves.*list).resize(exact ? grid.size() : 0);
    }
    const double square = omega * omega;
    const double lever = mechanism.lambda / mechanism.crank_radius;
    const double weight = potential_amplitude(mechanism);
    visit_states([&](std::size_t i, const AngleState& state) {
        const double moment = state.moment.weight + square * state.moment.inertia;
        const double arm = lever / state.cos_psi;
        curves.rod_hinge_moment[i] = moment;
        curves.rod_hinge_moment_potential[i] = moment - mean;
        curves.side_force_without_hinge[i] =
            -(state.moment.weight + square * state.moment.true_inertia) * arm;
        curves.side_force_with_hinge[i] = -mean * arm;
        if (exact) {
            const double crank = 0.5 * square * state.inertia.slope + weight * grid.cos_phi[i];
            curves.reduced_inertia[i] = state.inertia.value;
            curves.crank_moment[i] = crank;
            curves.crank_moment_with_rod_hinge[i] =
                crank + (moment - mean) * (1.0 + state.exact.dpsi);
        }
    });
    const auto check = [&](const auto& lists) {
        for (const auto list : lists) {
            if (!all_finite(curves.*list)) {
                reject_extreme();
            }
        }
    };
    check(of_any);
    check(of_exact);
    return curves;
}

MechanismCurves curves_at_speed(const Design& design, double omega) {
    const std::vector<AngleState>& states = design.states();
    return curves_of(design.mechanism(), design.grid(), omega, design.rod_hinge_mean(),
                     [&](const auto& put) {
                         for (std::size_t i = 0; i < states.size(); ++i) {
                             put(i, states[i]);
                         }
                     });
}

/// The curves for another λ (the counterweight solved again, where it is).
MechanismCurves curves_at_lambda(Input input, double lambda, const AngleGrid& grid) {
    input.lambda = lambda;
    const Mechanism<double> mechanism = mechanism_of(input);
    const bool solved = input.rod_counterweight && !input.rod_counterweight->mass;
    const double static_moment = solved ? 0.0 : mechanism.static_moment();
    return curves_of(mechanism, grid, input.angular_speed,
                     rod_hinge_integral(mechanism, static_moment, input.kinematics) / two_pi,
                     [&](const auto& put) {
                         visit_turn(mechanism, static_moment, input.kinematics, grid, true, put);
                     });
}

/// Where the paper's series and the exact kinematics part.
void compare_kinematics(const Input& input, const Design& design, Result& result) {
    const Mechanism<double>& mechanism = design.mechanism();
    const AngleGrid& grid = design.grid();
    const bool exact = design.has_exact_kinematics();
    const double square = input.angular_speed * input.angular_speed;
    const std::size_t n = grid.size();
    const auto moment_of = [&](const RodAngle<double>& rod, double s, double c) {
        return rod_hinge_moment(mechanism, design.static_moment(), s, c, rod);
    };
    // At φ or at −φ, whichever is worse.
    const auto difference = [&](const RodHingeMoment<double>& a, const RodHingeMoment<double>& b) {
        return std::abs(a.weight - b.weight) + square * std::abs(a.inertia - b.inertia);
    };
    Maximum cosine_error;
    Maximum moment_error;
    result.other_rod_hinge_moment.resize(exact ? n : 0);
    for (std::size_t i = 0; 2 * i < n; ++i) {
        const double s = grid.sin_phi[i];
        const double c = grid.cos_phi[i];
        const AngleState& state = design.states()[i];
        const auto series = rod_angle_series(mechanism.lambda, s, c);
        cosine_error.take(std::abs(series.cos_psi - (exact ? state.exact.cos_psi : std::abs(c))),
                          grid.angle[i]);
        if (exact) {
            const auto other =
                moment_of(input.kinematics == Kinematics::series ? state.exact : series, s, c);
            result.other_rod_hinge_moment[i] = other.weight + square * other.inertia;
            result.other_rod_hinge_moment[n - 1 - i] = other.weight - square * other.inertia;
            moment_error.take(difference(other, state.moment), grid.angle[i]);
        }
    }
    if (exact) {
        const auto errors = [&](double phi) {
            const double s = std::sin(phi);
            const double c = std::cos(phi);
            const auto series = rod_angle_series(mechanism.lambda, s, c);
            const auto rod = rod_angle_exact(mechanism.lambda, s, c);
            return std::pair(std::abs(series.cos_psi - rod.cos_psi),
                             difference(moment_of(series, s, c), moment_of(rod, s, c)));
        };
        cosine_error.sharpen([&](double phi) { return errors(phi).first; }, grid.angle[1]);
        moment_error.sharpen([&](double phi) { return errors(phi).second; }, grid.angle[1]);
        result.series_moment_error = moment_error.value;
    }
    result.series_error = cosine_error.value;
    result.series_error_angle = cosine_error.place;
}

void find_side_forces(const Input& input, const Design& design, Result& result) {
    const std::vector<double>& angles = design.grid().angle;
    const double omega = input.angular_speed;
    const double mean = design.rod_hinge_mean();
    const double lever = design.mechanism().lambda / design.mechanism().crank_radius;
    const auto cosine = [&](double phi) {
        return rod_angle(input.kinematics, design.mechanism().lambda, std::sin(phi), std::cos(phi))
            .cos_psi;
    };
    const auto moment = [&](double phi) { return design.rod_moment(std::sin(phi), std::cos(phi)); };
    result.largest_side_force_without =
        largest(result.curves.side_force_without_hinge, angles, [&](double phi) {
            const auto at = moment(phi);
            return (at.weight + omega * omega * at.true_inertia) * lever / cosine(phi);
        });
    result.largest_side_force_with =
        largest(result.curves.side_force_with_hinge, angles,
                [&](double phi) { return mean * lever / cosine(phi); });
    if (!design.has_exact_kinematics()) {
        return;
    }
    if (input.kinematics == Kinematics::exact &&
        (design.mechanism().counterweight_mass == 0.0 ||
         design.mechanism().counterweight_inertia == CounterweightInertia::newton_euler)) {
        result.side_force_true = result.curves.side_force_with_hinge;
        result.largest_side_force_true = result.largest_side_force_with;
        return;
    }
    const auto by_newton_euler = [&](double phi, double hinge_moment) {
        return side_force(design.mechanism(), phi, omega, 0.0, hinge_moment);
    };
    for (std::size_t i = 0; i < angles.size(); ++i) {
        result.side_force_true.push_back(
            by_newton_euler(angles[i], result.curves.rod_hinge_moment_potential[i]));
    }
    result.largest_side_force_true = largest(result.side_force_true, angles, [&](double phi) {
        return by_newton_euler(phi, moment(phi).value(omega) - mean);
    });
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
    const bool with_moments = options.with_rod_guides || options.with_curves ||
                              options.with_profiles || !options.speeds.empty();
    result.design = std::make_shared<const Design>(input, options.with_rod_guides, with_moments,
                                                   options.samples);
    const Design& design = *result.design;
    const Mechanism<double>& mechanism = design.mechanism();
    result.crank_angle_deg = design.grid().angle_deg;
    result.rod_hinge_integral = design.rod_hinge_integral();
    result.has_counterweight = input.rod_counterweight.has_value();
    result.counterweight_mass = mechanism.counterweight_mass;
    result.balancing_mass = result.has_counterweight ? mechanism.balancing_mass() : 0.0;
    if (!std::isfinite(design.rod_hinge_mean()) || !std::isfinite(result.balancing_mass)) {
        reject_extreme();
    }
    if (options.with_curves) {
        result.curves = curves_at_speed(design, input.angular_speed);
        compare_kinematics(input, design, result);
        find_side_forces(input, design, result);
    }
    for (const double speed : options.speeds) {
        result.by_speed.push_back({speed, curves_at_speed(design, speed)});
    }
    for (const double lambda : options.lambdas) {
        if (lambda < 1.0 || input.kinematics == Kinematics::series) {
            result.by_lambda.push_back({lambda, curves_at_lambda(input, lambda, design.grid())});
        }
    }
    if (!all_finite(result.side_force_true)) {
        reject_extreme();
    }
    result.crank_guide =
        make_guide(result.design, Hinge::crank, input.spring, input, options.with_profiles);
    check_finite(result.crank_guide);
    if (options.with_rod_guides) {
        const auto& rod_spring = input.rod_hinge_spring ? input.rod_hinge_spring : input.spring;
        result.crank_guide_with_rod =
            make_guide(result.design, Hinge::crank_with_rod, input.spring, input, true);
        result.rod_guide = make_guide(result.design, Hinge::rod, rod_spring, input, true);
        check_finite(result.crank_guide_with_rod);
        check_finite(result.rod_guide);
    }
    if (input.guide_search) {
        result.proposal = search_guide(result.design, input, result.crank_guide.branch);
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
