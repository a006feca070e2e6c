#include "elastic-hinge/results.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <utility>

#include "case-file/decimal.h"
#include "elastic-hinge/result_fields.h"
#include "elastic-hinge/solver.h"

namespace ravnoves::elastic_hinge {

namespace {

using ravnoves::result_field::feasible;
using ravnoves::result_field::notes;
using ravnoves::result_field::reason;
namespace key = result_field;

/// Of the hinge's moment: what a profile error may take from a guide that can be made.
constexpr double max_relative_error = 0.05;

std::string_view word_of(Branch branch) {
    return branch == Branch::compressed ? "compressed" : "stretched";
}

std::string_view word_of(MotionEnd end) {
    switch (end) {
        case MotionEnd::completed:
            return "completed";
        case MotionEnd::reversed:
            return "reversed";
        case MotionEnd::too_slow:
            return "too-slow";
        case MotionEnd::cancelled:
            break;
    }
    return "cancelled";
}

std::optional<double> when(bool there, double value) {
    return there ? std::optional(value) : std::nullopt;
}

void visit_branch(ResultVisitor& visitor, const ResultField& field, const BranchSummary& branch) {
    visitor.object_or_null(field, branch.exists, [&] {
        visitor.number(key::min_radius, branch.min_radius);
        visitor.number(key::max_radius, branch.max_radius);
        visitor.number(key::smallest_curvature_radius, branch.smallest_curvature_radius);
        visitor.number(key::largest_roller_radius, branch.largest_roller_radius);
        visitor.flag(key::undercut, branch.undercut);
        visitor.number(key::profile_min_radius, branch.profile_min_radius);
        visitor.number(key::profile_max_radius, branch.profile_max_radius);
        visitor.number(key::max_pressure_angle, branch.max_pressure_angle);
    });
}

void visit_guide(ResultVisitor& visitor, const Guide& guide) {
    const bool known = guide.shape != nullptr;
    const bool made = guide.feasible;
    visitor.flag(feasible, guide.feasible);
    visitor.text(reason, guide.reason);
    visitor.number(key::preload, when(known, guide.preload));
    visitor.number(key::minimum_preload, when(known, guide.minimum_preload));
    visitor.number(key::minimum_stiffness, known ? guide.minimum_stiffness : std::nullopt);
    visitor.number(
        key::first_missing_crank_angle,
        when(guide.problem == GuideProblem::preload_too_small, guide.first_missing_angle));
    visitor.number(key::worst_crank_angle, when(known, guide.worst_angle));
    visitor.word(key::branch, known ? word_of(guide.branch) : "");
    visitor.number(key::relief, when(made, guide.relief));
    visitor.number(key::spring_travel, when(made, guide.spring_travel));
    visitor.number(key::largest_spring_force, when(made, guide.largest_spring_force));
    visitor.number(key::smallest_spring_force, when(made, guide.smallest_spring_force));
    visitor.number(key::largest_moment, when(known, guide.largest_moment));
    visit_branch(visitor, key::compressed, guide.compressed);
    visit_branch(visitor, key::stretched, guide.stretched);
    visitor.object_or_null(key::profile_error, made, [&] {
        visitor.number(key::amplitude, guide.error.amplitude);
        visitor.integer(key::waves, guide.error.waves);
        visitor.number(key::error_torque, guide.error.torque);
        visitor.number(key::relative_torque, guide.error.relative);
        visitor.number(key::error_energy, guide.error.energy);
    });
}

void visit_proposal(ResultVisitor& visitor, const GuideProposal& proposal) {
    visitor.flag(feasible, proposal.found);
    visitor.text(reason, proposal.reason);
    if (!proposal.found) {
        return;
    }
    visitor.word(key::branch, word_of(proposal.branch));
    visitor.object(key::spring, [&] {
        visitor.number(key::stiffness, proposal.spring.stiffness);
        visitor.number(key::free_length, proposal.spring.free_length);
        visitor.number(key::guide_radius_at_zero, proposal.spring.guide_radius_at_zero);
    });
    visitor.number(key::relief, proposal.relief);
    visitor.number(key::outer_diameter, proposal.outer_diameter);
    visitor.number(key::smallest_spring_length, proposal.smallest_spring_length);
    visitor.number(key::largest_spring_force, proposal.largest_spring_force);
    visitor.number(key::largest_spring_energy, proposal.largest_spring_energy);
}

void visit_motion(ResultVisitor& visitor, const Motion& motion) {
    visitor.flag(feasible, true);
    visitor.word(key::end, word_of(motion.end));
    visitor.text(reason, motion.reason);
    visitor.number(key::time, motion.time.back());
    visitor.number(key::end_crank_angle, motion.crank_angle.back());
    visitor.number(key::speed, motion.speed.back());
    visitor.number(key::mean_speed, motion.mean_speed);
    visitor.number(key::min_speed, motion.min_speed);
    visitor.number(key::max_speed, motion.max_speed);
    visitor.number(key::speed_ripple, motion.ripple);
    visitor.number(key::energy_drift, motion.energy_drift);
    visitor.integer(key::steps, motion.steps);
}

/// Without and, where their guides exist, with hinges.
void visit_motions(ResultVisitor& visitor, const Input& input, const Result& result) {
    const std::array<std::pair<const ResultField*, HingeSet>, 3> sets{
        {{&key::without_hinge, HingeSet::none},
         {&key::with_crank_hinge, HingeSet::crank},
         {&key::with_both_hinges, HingeSet::crank_and_rod}}};
    for (const auto& [field, hinges] : sets) {
        visitor.object(*field, [&, hinges = hinges] {
            const Guide& guide = hinges == HingeSet::crank_and_rod ? result.crank_guide_with_rod
                                                                   : result.crank_guide;
            if (!result.design->has_exact_kinematics()) {
                visitor.flag(feasible, false);
                visitor.text(reason,
                             CORE_TEXT("elastic-hinge", "at lambda = 1 the mechanism locks"));
            } else if (hinges != HingeSet::none && !guide.feasible) {
                visitor.flag(feasible, false);
                visitor.text(reason, guide.reason);
            } else {
                visit_motion(visitor, simulate(input, result, hinges));
            }
        });
    }
}

}  // namespace

void visit_results(ResultVisitor& visitor, const Input& input, const Result& result) {
    const double g = result.design->mechanism().gravity;
    visit_verdict(visitor, [&] { return verdict(input, result); });
    visitor.number(key::rod_hinge_moment_integral, result.rod_hinge_integral);
    if (result.has_counterweight) {
        visitor.number(key::counterweight_weight, result.counterweight_mass * g);
        visitor.number(key::counterweight_mass, result.counterweight_mass);
        visitor.number(key::balancing_weight, result.balancing_mass * g);
    }
    visitor.object(key::guide, [&] { visit_guide(visitor, result.crank_guide); });
    visitor.object(key::guide_beside_rod_hinge,
                   [&] { visit_guide(visitor, result.crank_guide_with_rod); });
    visitor.object(key::rod_hinge_guide, [&] {
        visit_guide(visitor, result.rod_guide);
        visitor.numbers(key::hinge_angle, result.rod_guide.polar_angle);
        visitor.numbers(key::guide_radius_compressed, result.rod_guide.radius_compressed);
        visitor.numbers(key::guide_radius_stretched, result.rod_guide.radius_stretched);
    });
    if (input.guide_search) {
        visitor.object(key::guide_search, [&] {
            GuideProposal none;
            none.reason = CORE_TEXT("elastic-hinge", "no spring is given: enter its free length");
            visit_proposal(visitor, result.proposal.value_or(none));
        });
    }
    visitor.object(key::side_force, [&] {
        const double with = result.largest_side_force_with;
        const double without = result.largest_side_force_without;
        visitor.number(key::largest_without_hinge, without);
        visitor.number(key::largest_with_hinge, with);
        visitor.number(key::largest_by_newton_euler,
                       when(!result.side_force_true.empty(), result.largest_side_force_true));
        visitor.number(key::reduction_factor, when(with > 0.0, without / with));
    });
    visitor.object(key::series, [&] {
        visitor.number(key::largest_cos_psi_error, result.series_error);
        visitor.number(key::at_crank_angle, result.series_error_angle);
        visitor.number(key::largest_rod_hinge_moment_error, result.series_moment_error);
    });
    if (input.motion) {
        visitor.object(key::motion, [&] { visit_motions(visitor, input, result); });
    }
    visitor.texts(notes, [&] {
        std::vector<Message> said = result.doubts;
        said.insert(said.end(), result.notes.begin(), result.notes.end());
        said.insert(said.end(), result.guide_notes.begin(), result.guide_notes.end());
        return said;
    });
    visitor.object(key::curves, [&] {
        const MechanismCurves& curves = result.curves;
        visitor.numbers(key::crank_angle, result.crank_angle_deg);
        visitor.numbers(key::reduced_inertia, curves.reduced_inertia);
        visitor.numbers(key::crank_moment, curves.crank_moment);
        visitor.numbers(key::rod_hinge_moment, curves.rod_hinge_moment);
        visitor.numbers(key::rod_hinge_moment_potential, curves.rod_hinge_moment_potential);
        visitor.numbers(key::side_force_without_hinge, curves.side_force_without_hinge);
        visitor.numbers(key::side_force_with_hinge, curves.side_force_with_hinge);
        visitor.numbers(key::crank_moment_with_rod_hinge, curves.crank_moment_with_rod_hinge);
        visitor.numbers(key::guide_radius_compressed, result.crank_guide.radius_compressed);
        visitor.numbers(key::guide_radius_stretched, result.crank_guide.radius_stretched);
    });
}

void visit_results(ResultVisitor& visitor, const Input& input) {
    const auto wants_any = [&](std::initializer_list<std::string_view> keys) {
        return std::any_of(keys.begin(), keys.end(),
                           [&](std::string_view each) { return visitor.wants(each); });
    };
    SolveOptions options;
    options.with_curves = wants_any({ravnoves::result_field::verdict.key, key::side_force.key,
                                     key::series.key, notes.key, key::curves.key});
    options.with_rod_guides =
        wants_any({key::guide_beside_rod_hinge.key, key::rod_hinge_guide.key, key::motion.key});
    const auto wants_of_guide = [&](const ResultField& field) {
        return visitor.wants(std::string(key::guide.key) + "/" + std::string(field.key));
    };
    options.with_profiles = options.with_curves || options.with_rod_guides ||
                            wants_of_guide(key::largest_moment) ||
                            wants_of_guide(key::compressed) || wants_of_guide(key::stretched) ||
                            wants_of_guide(key::profile_error);
    visit_results(visitor, input, solve(input, options));
}

namespace {

/// Without the warnings.
Verdict guide_verdict(const Input& input, const Guide& guide) {
    if (!guide.feasible) {
        return {Severity::error, Message(CORE_TEXT("elastic-hinge", "No guide: %1."), guide.reason),
                guide.problem == GuideProblem::preload_too_small ? minimum_preload_act : ""};
    }
    if (guide.summary().undercut) {
        return {Severity::error,
                Message(CORE_TEXT("elastic-hinge",
                                  "A roller of radius %1 undercuts the guide; the maximum is %2."),
                        Number{input.roller_radius / units::mm, units::mm, 5},
                        Number{*guide.summary().largest_roller_radius / units::mm, units::mm, -2})};
    }
    const Number relief{guide.relief / units::mm, units::mm, -3};
    const Number error{guide.error.amplitude / units::micrometre, units::micrometre, 3};
    const Number spoilt{rounded_to_decimals(guide.error.relative / units::percent, 1),
                        units::percent};
    if (guide.error.relative > max_relative_error) {
        return {Severity::warning,
                Message(CORE_TEXT("elastic-hinge",
                                  "The guide cannot be made: its relief is %1, and a profile "
                                  "error of %2 changes the moment by up to %3."),
                        relief, error, spoilt)};
    }
    return {Severity::good,
            Message(CORE_TEXT("elastic-hinge",
                              "The guide is feasible: relief %1; a profile error of %2 changes "
                              "the moment by up to %3."),
                    relief, error, spoilt)};
}

}  // namespace

Verdict verdict(const Input& input, const Result& result) {
    const Guide& guide = result.crank_guide;
    Verdict verdict = guide_verdict(input, guide);
    for (const auto* warnings : {&result.doubts, &result.notes}) {
        for (const Message& warning : *warnings) {
            verdict.warn(warning);
        }
    }
    if (!guide.feasible) {
        return verdict;
    }
    if (input.guide_sign == GuideSign::as_printed) {
        verdict.warn(
            CORE_TEXT("elastic-hinge",
                      "The sign is as printed in the paper: the crank does not keep its speed."));
    }
    const double margin = guide.preload - guide.minimum_preload;
    if (guide.minimum_preload > 0.0 && margin < min_preload_margin) {
        verdict.warn(
            {CORE_TEXT("elastic-hinge", "The preload exceeds the minimum by only %1 of %2."),
             Number{margin / units::mm, units::mm, -2},
             Number{guide.preload / units::mm, units::mm, -2}});
    }
    if (input.roller_radius == 0.0) {
        verdict.warn(CORE_TEXT("elastic-hinge",
                               "The roller radius is 0: the guide is the path of the roller's "
                               "centre."));
    }
    return verdict;
}

}  // namespace ravnoves::elastic_hinge
