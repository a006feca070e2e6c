#include "elastic-hinge/results.h"

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "case-file/decimal.h"
#include "elastic-hinge/motion.h"
#include "elastic-hinge/result.h"

namespace ravnoves::elastic_hinge {

namespace {

using ravnoves::result_field::feasible;
using ravnoves::result_field::notes;
using ravnoves::result_field::reason;
namespace key {
constexpr ResultField guide{"guide", guide_names[0]};
constexpr ResultField guide_beside_rod_hinge{"guide_beside_rod_hinge", guide_names[1]};
constexpr ResultField rod_hinge_guide{"rod_hinge_guide", guide_names[2]};
constexpr ResultField side_force{"side_force", Text::tr("Side force")};
constexpr ResultField series{"series", Text::tr("Series against exact")};
constexpr ResultField motion{"motion", Text::tr("Motion")};
constexpr ResultField curves{"curves", Text::tr("Curves")};
constexpr ResultField branch{"branch", Text::tr("Branch")};
constexpr ResultField relief{"relief_mm", Text::tr("Relief of the guide"), 4,
                             Text::tr("Maximum minus minimum radius of the guide.")};
constexpr ResultField largest_spring_force{"largest_spring_force_N",
                                           Text::tr("Maximum spring force"), 1,
                                           Text::tr("c |ℓ − ℓ₀|, maximum over a turn.")};
constexpr ResultField largest_moment{"largest_moment_Nm", Text::tr("Maximum moment")};
constexpr ResultField compressed{"compressed", Text::tr("Spring compressed")};
constexpr ResultField stretched{"stretched", Text::tr("Spring stretched")};
constexpr ResultField profile_error{"profile_error", Text::tr("Profile error")};
constexpr ResultField guide_radius_compressed{"guide_radius_compressed_mm",
                                              Text::tr("ρ, spring compressed")};
constexpr ResultField guide_radius_stretched{"guide_radius_stretched_mm",
                                             Text::tr("ρ, spring stretched")};
}  // namespace key

/// Of the hinge's moment: what a profile error may take from a guide that can be made.
constexpr double max_relative_error = 0.05;

std::string_view word_of(Branch branch) {
    return branch == Branch::compressed ? "compressed" : "stretched";
}

std::string_view word_of(MotionEnd end) {
    constexpr std::string_view words[] = {"completed", "reversed", "too-slow", "cancelled"};
    return words[static_cast<int>(end)];
}

/// The counterweight balances the rod's hinge alone.
bool designs_rod_hinge(const Input& input) {
    return input.rod_counterweight || input.rod_hinge_spring;
}

std::optional<double> when(bool there, double value) {
    return there ? std::optional(value) : std::nullopt;
}

void visit_branch(ResultVisitor& visitor, const ResultField& field, const BranchSummary& branch) {
    visitor.object_or_null(field, branch.exists, [&] {
        visitor.number({"min_radius_mm", Text::tr("Minimum ρ")}, branch.min_radius);
        visitor.number({"max_radius_mm", Text::tr("Maximum ρ")}, branch.max_radius);
        visitor.number({"smallest_curvature_radius_mm", Text::tr("Minimum curvature radius"), 2,
                        Text::tr("Radius of curvature of the guide; a cutter must be smaller.")},
                       branch.smallest_curvature_radius);
        visitor.number({"largest_roller_radius_mm", Text::tr("Maximum roller radius"), 2,
                        Text::tr("Maximum radius of a roller that touches the whole guide.")},
                       branch.largest_roller_radius);
        visitor.flag({"undercut", Text::tr("Undercut")}, branch.undercut);
        visitor.number({"profile_min_radius_mm", Text::tr("Minimum profile radius")},
                       branch.profile_min_radius);
        visitor.number({"profile_max_radius_mm", Text::tr("Maximum profile radius")},
                       branch.profile_max_radius);
        visitor.number({"max_pressure_angle_deg", Text::tr("Maximum pressure angle"), 2},
                       branch.max_pressure_angle);
    });
}

void visit_guide(ResultVisitor& visitor, const Guide& guide) {
    const bool known = guide.shape != nullptr;
    const bool made = guide.feasible;
    visitor.flag(feasible, guide.feasible);
    visitor.text(reason, guide.reason);
    visitor.number({"preload_mm", Text::tr("Preload"), 2, Text::tr("|ℓ₀/2 − ρ₀| of the spring.")},
                   when(known, guide.preload));
    visitor.number({"minimum_preload_mm", Text::tr("Minimum preload"), 2,
                    Text::tr("Minimum |ℓ₀/2 − ρ₀| to store the energy.")},
                   when(known, guide.minimum_preload));
    visitor.number({"minimum_stiffness_N_m", Text::tr("Minimum stiffness"), 0},
                   known ? guide.minimum_stiffness : std::nullopt);
    visitor.number({"first_missing_crank_angle_deg", Text::tr("Guide ends at φ"), 1},
                   when(guide.lacks_preload, guide.first_missing_angle));
    visitor.number({"worst_crank_angle_deg", Text::tr("φ of the maximum energy"), 1},
                   when(known, guide.worst_angle));
    visitor.word(key::branch, known ? word_of(guide.branch) : "");
    visitor.number(key::relief, when(made, guide.relief));
    visitor.number({"spring_travel_mm", Text::tr("Spring travel"), 3,
                    Text::tr("Maximum minus minimum length of the spring over a turn.")},
                   when(made, 2.0 * guide.relief));
    visitor.number(key::largest_spring_force, when(made, guide.largest_spring_force));
    visitor.number({"smallest_spring_force_N", Text::tr("Minimum spring force"), 1},
                   when(made, guide.smallest_spring_force));
    visitor.number(key::largest_moment, when(known, guide.largest_moment));
    visit_branch(visitor, key::compressed, guide.compressed);
    visit_branch(visitor, key::stretched, guide.stretched);
    visitor.object_or_null(key::profile_error, made, [&] {
        visitor.number({"amplitude_um", Text::tr("Amplitude")}, guide.error.amplitude);
        visitor.integer({"waves", Text::tr("Waves")}, guide.error.waves);
        visitor.number({"torque_Nm", Text::tr("Moment error"), 2,
                        Text::tr("Maximum error of the hinge's moment at this profile error.")},
                       guide.error.torque);
        visitor.number({"relative_torque", Text::tr("Moment error, share"), 3,
                        Text::tr("Moment error over the hinge's maximum moment.")},
                       guide.error.relative);
        visitor.number({"energy_J", Text::tr("Energy error")}, guide.error.energy);
    });
}

void visit_proposal(ResultVisitor& visitor, const GuideProposal& proposal) {
    visitor.flag(feasible, proposal.found);
    visitor.text(reason, proposal.reason);
    if (!proposal.found) {
        return;
    }
    visitor.word(key::branch, word_of(proposal.branch));
    visitor.object({"spring", Text::tr("Spring")}, [&] {
        visitor.number({"stiffness_N_m", Text::tr("Stiffness c"), 0}, proposal.spring.stiffness);
        visitor.number({"free_length_mm", Text::tr("Free length ℓ₀")}, proposal.spring.free_length);
        visitor.number({"guide_radius_at_zero_mm", Text::tr("Guide radius ρ₀")},
                       proposal.spring.guide_radius_at_zero);
    });
    visitor.number(key::relief, proposal.relief);
    visitor.number({"outer_diameter_mm", Text::tr("Outer diameter"), 1}, proposal.outer_diameter);
    visitor.number({"smallest_spring_length_mm", Text::tr("Minimum spring length"), 1},
                   proposal.smallest_spring_length);
    visitor.number(key::largest_spring_force, proposal.largest_spring_force);
    visitor.number({"largest_spring_energy_J", Text::tr("Maximum spring energy")},
                   proposal.largest_spring_energy);
}

void visit_motion(ResultVisitor& visitor, const Motion& motion) {
    visitor.flag(feasible, true);
    visitor.word({"end", Text::tr("End of the motion")}, word_of(motion.end));
    visitor.text(reason, motion.reason);
    visitor.number({"time_s", Text::tr("Time")}, motion.time.back());
    visitor.number(ResultField{"crank_angle_deg", Text::tr("Crank angle φ"), 1}.with(Period::none),
                   motion.crank_angle.back());
    visitor.number({"speed_rad_s", Text::tr("Speed")}, motion.speed.back());
    visitor.number({"mean_speed_rad_s", Text::tr("Mean speed")}, motion.mean_speed);
    visitor.number({"min_speed_rad_s", Text::tr("Minimum speed")}, motion.min_speed);
    visitor.number({"max_speed_rad_s", Text::tr("Maximum speed")}, motion.max_speed);
    visitor.number({"speed_ripple", Text::tr("Speed ripple"), 5,
                    Text::tr("(ω_max − ω_min) / mean ω of the free motion.")},
                   motion.ripple);
    visitor.number({"energy_drift", Text::tr("Energy drift")}, motion.energy_drift);
    visitor.integer({"steps", Text::tr("Steps")}, motion.time.size() - 1);
}

/// Without and, where their guides exist, with hinges.
void visit_motions(ResultVisitor& visitor, const Input& input, const Result& result) {
    const auto visit = [&](const ResultField& field, HingeSet hinges) {
        visitor.object(field, [&] {
            const Guide& guide = hinges == HingeSet::crank_and_rod ? result.crank_guide_with_rod
                                                                   : result.crank_guide;
            const bool locks = !result.design->has_exact_kinematics();
            if (locks || (hinges != HingeSet::none && !guide.feasible)) {
                visitor.flag(feasible, false);
                visitor.text(reason,
                             locks ? Text::tr("at lambda = 1 the mechanism locks") : guide.reason);
            } else {
                visit_motion(visitor, simulate(input, result, hinges));
            }
        });
    };
    visit({"without_hinge", Text::tr("Without hinge")}, HingeSet::none);
    visit({"with_crank_hinge", Text::tr("Crank hinge")}, HingeSet::crank);
    visit({"with_both_hinges", Text::tr("Both hinges")}, HingeSet::crank_and_rod);
}

}  // namespace

void visit_results(ResultVisitor& visitor, const Input& input, const Result& result) {
    const Mechanism<double>& mechanism = result.design->mechanism();
    const double g = mechanism.gravity;
    visit_verdict(visitor, [&] { return verdict(input, result); });
    visitor.number(
        {"rod_hinge_moment_integral_J", Text::tr("∮ M₁₂ dφ"), 3,
         Text::tr("Work of the rod hinge's moment over a turn; 0 if a spring can supply it.")},
        result.design->rod_hinge_integral());
    if (mechanism.has_counterweight()) {
        visitor.number({"counterweight_weight_N", Text::tr("Counterweight P₄"), 3,
                        Text::tr("Weight on the rod for ∮ M₁₂ dφ = 0, or as entered.")},
                       mechanism.counterweight_mass * g);
        visitor.number({"counterweight_mass_kg", Text::tr("Counterweight P₄"), 4,
                        Text::tr("Weight on the rod for ∮ M₁₂ dφ = 0, or as entered.")},
                       mechanism.counterweight_mass);
        visitor.number({"balancing_weight_N", Text::tr("Balancing weight")},
                       mechanism.balancing_mass() * g);
    }
    visitor.object(key::guide, [&] { visit_guide(visitor, result.crank_guide); });
    visitor.object(key::guide_beside_rod_hinge,
                   [&] { visit_guide(visitor, result.crank_guide_with_rod); });
    visitor.object(key::rod_hinge_guide, [&] {
        visit_guide(visitor, result.rod_guide);
        visitor.numbers({"hinge_angle_deg", Text::tr("Hinge angle θ")},
                        result.rod_guide.polar_angle);
        visitor.numbers(key::guide_radius_compressed, result.rod_guide.radius_compressed);
        visitor.numbers(key::guide_radius_stretched, result.rod_guide.radius_stretched);
    });
    if (result.proposal) {
        visitor.object({"guide_search", Text::tr("Proposed guide")},
                       [&] { visit_proposal(visitor, *result.proposal); });
    }
    visitor.object(key::side_force, [&] {
        const double with = result.largest_side_force_with;
        const double without = result.largest_side_force_without;
        visitor.number({"largest_without_hinge_N", Text::tr("Side force, no hinge"), 1,
                        Text::tr("Maximum force of the slider on its guide.")},
                       without);
        visitor.number({"largest_with_hinge_N", Text::tr("Side force, rod hinge"), 2,
                        Text::tr("Maximum force of the slider on its guide with the rod hinge.")},
                       with);
        visitor.number({"largest_by_newton_euler_N", Text::tr("Side force by Newton–Euler"), 2},
                       result.largest_side_force_true);
        visitor.number({"reduction_factor", Text::tr("Side force, reduction factor"), 1},
                       when(with > 0.0, without / with));
    });
    visitor.object(key::series, [&] {
        visitor.number({"largest_cos_psi_error", Text::tr("Maximum error of cos ψ"), 6},
                       result.series_error);
        visitor.number({"at_crank_angle_deg", Text::tr("φ of the maximum error"), 1},
                       result.series_error_angle);
        visitor.number({"largest_rod_hinge_moment_error_Nm", Text::tr("Maximum error of M₁₂")},
                       result.series_moment_error);
    });
    if (input.motion) {
        visitor.object(key::motion, [&] { visit_motions(visitor, input, result); });
    }
    visitor.texts(notes, [&] {
        std::vector<Message> said = result.notes;
        said.insert(said.end(), result.guide_notes.begin(), result.guide_notes.end());
        return said;
    });
    visitor.object(key::curves, [&] {
        const MechanismCurves& curves = result.curves;
        visitor.numbers({"crank_angle_deg", Text::tr("Crank angle φ"), 3, {}, units::none},
                        result.crank_angle_deg);
        visitor.numbers({"reduced_inertia_kg_m2", Text::tr("Reduced inertia")},
                        curves.reduced_inertia);
        visitor.numbers({"crank_moment_Nm", Text::tr("Crank hinge moment M")}, curves.crank_moment);
        visitor.numbers({"rod_hinge_moment_Nm", Text::tr("Rod hinge moment M₁₂")},
                        curves.rod_hinge_moment);
        visitor.numbers(
            {"rod_hinge_moment_potential_Nm", Text::tr("Rod hinge moment, potential part")},
            curves.rod_hinge_moment_potential);
        visitor.numbers({"side_force_without_hinge_N", Text::tr("Side force without hinge")},
                        curves.side_force_without_hinge);
        visitor.numbers({"side_force_with_hinge_N", Text::tr("Side force with hinge")},
                        curves.side_force_with_hinge);
        visitor.numbers(
            {"crank_moment_with_rod_hinge_Nm", Text::tr("Crank hinge moment with the rod hinge")},
            curves.crank_moment_with_rod_hinge);
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
    options.with_curves =
        wants_any({ravnoves::result_field::verdict.key, key::side_force.key, key::series.key,
                   notes.key, key::curves.key, "guide/largest_moment_Nm", "guide/compressed",
                   "guide/stretched", "guide/profile_error"});
    options.with_rod_guides =
        wants_any({key::guide_beside_rod_hinge.key, key::rod_hinge_guide.key, key::motion.key}) ||
        (designs_rod_hinge(input) && visitor.wants(ravnoves::result_field::verdict.key));
    visit_results(visitor, input, solve(input, options));
}

namespace {

/// Whether a compressed spring gets shorter than a length.
bool is_shorter(const Guide& guide, double length) {
    return 2.0 * guide.compressed.min_radius < (1.0 - 1e-9) * length;
}

/// Without the warnings.
Verdict guide_verdict(const Input& input, const Guide& guide, const ResultField& named) {
    const Message name(named.label);
    if (!guide.feasible) {
        return {Severity::error, Message(Text::tr("%1: none, because %2."), name, guide.reason),
                guide.lacks_preload ? "minimum-preload" : ""};
    }
    if (guide.summary().undercut) {
        return {Severity::error,
                Message(Text::tr("%1: a roller of radius %2 undercuts it; the maximum is %3."),
                        name, Number{input.roller_radius / units::mm, units::mm, 5},
                        Number{*guide.summary().largest_roller_radius / units::mm, units::mm, -2})};
    }
    const bool has_own_spring = guide.hinge == Hinge::rod && input.rod_hinge_spring;
    const double free_length =
        (has_own_spring ? input.rod_hinge_spring : input.spring)->free_length;
    const double solid = input.guide_search.value_or(GuideWish{}).solid(free_length);
    if (guide.branch == Branch::compressed && is_shorter(guide, solid)) {
        return {Severity::error,
                Message(Text::tr("%1: the spring cannot be compressed from %2 to %3; minimum "
                                 "length: %4."),
                        name, in_mm(free_length), in_mm(2.0 * guide.compressed.min_radius),
                        in_mm(solid))};
    }
    const bool is_good = !(guide.error.relative > max_relative_error);
    return {is_good ? Severity::good : Severity::warning,
            Message(is_good ? Text::tr("%1: feasible, relief %2; a profile error of %3 changes the "
                                       "moment by up to %4.")
                            : Text::tr("%1: cannot be made, its relief is %2, and a profile error "
                                       "of %3 changes the moment by up to %4."),
                    name, Number{guide.relief / units::mm, units::mm, -3},
                    Number{guide.error.amplitude / units::micrometre, units::micrometre, 3},
                    Number{rounded_to_decimals(guide.error.relative / units::percent, 1),
                           units::percent})};
}

}  // namespace

Verdict verdict(const Input& input, const Result& result) {
    const Guide& guide = result.crank_guide;
    std::vector<Verdict> guides{guide_verdict(input, guide, key::guide)};
    if (guide.feasible && designs_rod_hinge(input)) {
        for (const auto& [beside, name] :
             {std::pair(&result.crank_guide_with_rod, key::guide_beside_rod_hinge),
              std::pair(&result.rod_guide, key::rod_hinge_guide)}) {
            if (Verdict of = guide_verdict(input, *beside, name); of.severity != Severity::good) {
                of.act = {};  // it is for the crank's guide
                guides.push_back(of);
            }
        }
        std::ranges::stable_sort(guides, std::greater<>(), &Verdict::severity);
    }
    Verdict verdict = guides.front();
    for (auto next = guides.begin() + 1; next != guides.end(); ++next) {
        verdict.warn(next->text);
    }
    for (const Message& note : result.notes) {
        verdict.warn(note);
    }
    if (!guide.feasible) {
        return verdict;
    }
    if (input.guide_sign == GuideSign::as_printed) {
        verdict.warn(
            Text::tr("The sign is as printed in the paper: the crank does not keep its speed."));
    }
    const double margin = guide.preload - guide.minimum_preload;
    if (guide.minimum_preload > 0.0 && margin < min_preload_margin) {
        verdict.warn({Text::tr("The preload exceeds the minimum by only %1 of %2."),
                      Number{margin / units::mm, units::mm, -2},
                      Number{guide.preload / units::mm, units::mm, -2}});
    }
    if (guide.branch == Branch::compressed) {
        const double free_length = input.spring->free_length;
        const GuideWish wish = input.guide_search.value_or(GuideWish{});
        const double shortest = wish.shortest(free_length);
        if (is_shorter(guide, shortest) && !is_shorter(guide, wish.solid(free_length))) {
            verdict.warn({Text::tr("The spring is compressed from %1 to %2; minimum length: "
                                   "%3."),
                          in_mm(free_length), in_mm(2.0 * guide.compressed.min_radius),
                          in_mm(shortest)});
        }
    }
    verdict.warn(overlap_note(guide.hinge, guide.summary(), input.roller_radius));
    if (input.roller_radius == 0.0) {
        verdict.warn(
            Text::tr("The roller radius is 0: the guide is the path of the roller's "
                     "centre."));
    }
    return verdict;
}

}  // namespace ravnoves::elastic_hinge
