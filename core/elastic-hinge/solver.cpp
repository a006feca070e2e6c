#include "elastic-hinge/result.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

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

/// @throws InputError where one is not finite: 0 times it is not 0
void check_finite(std::span<const double> values) {
    double sum = 0.0;
    for (const double value : values) {
        sum += value * 0.0;
    }
    if (sum != 0.0) {
        throw InputError("/input", Text::tr("has values whose result exceeds the range of numbers; "
                                            "enter realistic values"));
    }
}

/// Where the paper's series and the exact kinematics part.
void compare_kinematics(const Input& input, const Design& design, Result& result) {
    const double lambda = design.mechanism().lambda;
    const AngleGrid& grid = design.grid();
    const double omega = input.angular_speed;
    const auto moment_of = [&](const RodAngle<double>& rod, double s, double c) {
        return rod_hinge_moment(design.mechanism(), design.static_moment(), s, c, rod);
    };
    const auto difference = [&](const RodHingeMoment<double>& a, const RodHingeMoment<double>& b) {
        // At φ or at −φ, whichever is worse.
        return std::abs(a.weight - b.weight) + omega * omega * std::abs(a.inertia - b.inertia);
    };
    const auto errors = [&](double phi) {
        const double s = std::sin(phi);
        const double c = std::cos(phi);
        const auto series = rod_angle_series(lambda, s, c);
        const auto rod = rod_angle_exact(lambda, s, c);
        return std::pair(std::abs(series.cos_psi - rod.cos_psi),
                         difference(moment_of(series, s, c), moment_of(rod, s, c)));
    };
    const bool has_exact = design.has_exact_kinematics();
    const std::size_t n = grid.size();
    result.other_rod_hinge_moment.resize(has_exact ? n : 0);
    Maximum cosine_error;
    Maximum moment_error;
    for (std::size_t i = 0; 2 * i < n; ++i) {
        const double s = grid.sin_phi[i];
        const double c = grid.cos_phi[i];
        const AngleState& state = design.states()[i];
        const auto series = rod_angle_series(lambda, s, c);
        const double cos_psi = has_exact ? state.exact.cos_psi : std::abs(c);
        cosine_error.take(std::abs(series.cos_psi - cos_psi), grid.angle[i]);
        if (has_exact) {
            const auto other =
                moment_of(input.kinematics == Kinematics::exact ? series : state.exact, s, c);
            moment_error.take(difference(other, state.moment), grid.angle[i]);
            // Of −φ the weight's part is the same, the inertia's the opposite.
            result.other_rod_hinge_moment[n - 1 - i] = other.weight - omega * omega * other.inertia;
            result.other_rod_hinge_moment[i] = other.value(omega);
        }
    }
    cosine_error.sharpen([&](double phi) { return errors(phi).first; }, grid.angle[1]);
    result.series_error = cosine_error.value;
    result.series_error_angle = cosine_error.place;
    if (has_exact) {
        moment_error.value = errors(moment_error.place).second;
        moment_error.sharpen([&](double phi) { return errors(phi).second; }, grid.angle[1]);
        result.series_moment_error = moment_error.value;
    }
}

void find_side_forces(const Input& input, const Design& design, Result& result) {
    const std::vector<double>& angles = design.grid().angle;
    const double omega = input.angular_speed;
    const double mean = design.rod_hinge_mean();
    const Mechanism<double>& mechanism = design.mechanism();
    const double lever = mechanism.lambda / mechanism.crank_radius;
    const auto cosine = [&](double phi) {
        return rod_angle(input.kinematics, mechanism.lambda, std::sin(phi), std::cos(phi)).cos_psi;
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
    result.largest_side_force_true = result.largest_side_force_with;
    if (input.kinematics == Kinematics::exact &&
        (mechanism.counterweight_mass == 0.0 ||
         mechanism.counterweight_inertia == CounterweightInertia::newton_euler)) {
        return;
    }
    const auto by_newton_euler = [&](double phi) {
        const double s = std::sin(phi);
        const double c = std::cos(phi);
        const auto rod = rod_angle_exact(mechanism.lambda, s, c);
        const auto needed = rod_hinge_moment(mechanism, design.static_moment(), s, c, rod);
        const auto given = moment(phi);
        return (given.weight - needed.weight +
                omega * omega * (given.inertia - needed.true_inertia) - mean) *
               lever / rod.cos_psi;
    };
    std::vector<double> forces;
    for (const double phi : angles) {
        forces.push_back(by_newton_euler(phi));
    }
    check_finite(forces);
    result.largest_side_force_true = largest(forces, angles, by_newton_euler);
}

void add_notes(const Input& input, Result& result) {
    const Guide& guide = result.crank_guide;
    result.notes = unusual_engine_notes({input.angular_speed,
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
        result.design->mechanism().counterweight_mass > 0.0 && result.largest_side_force_true) {
        result.notes.emplace_back(
            Text::tr("Equation (9) as printed has the wrong sign of the counterweight's inertia: "
                     "residual side force up to %1, with Newton–Euler zero."),
            Number{std::round(*result.largest_side_force_true), units::newton});
    }
    for (const auto each :
         {&Result::crank_guide, &Result::crank_guide_with_rod, &Result::rod_guide}) {
        const Guide& of = result.*each;
        if (Message note = overlap_note(of.hinge, of.summary(), input.roller_radius);
            !note.empty()) {
            result.guide_notes.push_back(std::move(note));
        }
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

void check_guide(const Guide& guide) {
    check_finite(std::array{guide.preload, guide.minimum_preload, guide.relief,
                            guide.largest_spring_force, guide.largest_moment, guide.error.torque,
                            guide.error.energy, guide.error.relative, guide.compressed.max_radius,
                            guide.stretched.max_radius, guide.compressed.profile_max_radius,
                            guide.stretched.profile_max_radius});
}

}  // namespace

MechanismCurves curves_at(const Design& design, double omega) {
    const Mechanism<double>& mechanism = design.mechanism();
    const double square = omega * omega;
    const double mean = design.rod_hinge_mean();
    const double lever = mechanism.lambda / mechanism.crank_radius;
    MechanismCurves curves;
    for (std::size_t i = 0; i < design.states().size(); ++i) {
        const AngleState& state = design.states()[i];
        const double moment = state.moment.value(omega);
        const double arm = lever / state.cos_psi;
        curves.rod_hinge_moment.push_back(moment);
        curves.rod_hinge_moment_potential.push_back(moment - mean);
        curves.side_force_without_hinge.push_back(
            -(state.moment.weight + square * state.moment.true_inertia) * arm);
        curves.side_force_with_hinge.push_back(-mean * arm);
        if (design.has_exact_kinematics()) {
            const AngleGrid& grid = design.grid();
            const double crank =
                energy_rise(mechanism, omega, grid.sin_phi[i], grid.cos_phi[i], state.inertia)
                    .slope;
            curves.reduced_inertia.push_back(state.inertia.value);
            curves.crank_moment.push_back(crank);
            curves.crank_moment_with_rod_hinge.push_back(crank + (moment - mean) *
                                                                     (1.0 + state.exact.dpsi));
        }
    }
    return curves;
}

Result solve(const Input& input, const SolveOptions& options) {
    Result result;
    const bool by_angle = options.with_rod_guides || options.with_curves;
    result.design =
        std::make_shared<const Design>(input, options.with_rod_guides, by_angle, options.samples);
    const Design& design = *result.design;
    const Mechanism<double>& mechanism = design.mechanism();
    result.crank_angle_deg = design.grid().angle_deg;
    check_finite(std::array{design.rod_hinge_mean(),
                            mechanism.has_counterweight() ? mechanism.balancing_mass() : 0.0});
    if (options.with_curves) {
        result.curves = curves_at(design, input.angular_speed);
        for (const auto list :
             {&MechanismCurves::reduced_inertia, &MechanismCurves::crank_moment,
              &MechanismCurves::rod_hinge_moment, &MechanismCurves::side_force_without_hinge,
              &MechanismCurves::side_force_with_hinge,
              &MechanismCurves::crank_moment_with_rod_hinge}) {
            check_finite(result.curves.*list);
        }
        compare_kinematics(input, design, result);
        find_side_forces(input, design, result);
    }
    result.crank_guide = make_guide(result.design, Hinge::crank, input.spring, input, by_angle);
    check_guide(result.crank_guide);
    if (options.with_rod_guides) {
        const auto& rod_spring = input.rod_hinge_spring ? input.rod_hinge_spring : input.spring;
        result.crank_guide_with_rod =
            make_guide(result.design, Hinge::crank_with_rod, input.spring, input, true);
        result.rod_guide = make_guide(result.design, Hinge::rod, rod_spring, input, true);
        check_guide(result.crank_guide_with_rod);
        check_guide(result.rod_guide);
    }
    if (input.guide_search) {
        result.proposal = search_guide(result.design, input, result.crank_guide.branch);
    }
    add_notes(input, result);
    return result;
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
    return pose;
}

}  // namespace ravnoves::elastic_hinge
