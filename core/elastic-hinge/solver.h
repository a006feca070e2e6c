#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "elastic-hinge/design.h"
#include "elastic-hinge/guide.h"
#include "elastic-hinge/guide_search.h"
#include "elastic-hinge/input.h"
#include "elastic-hinge/motion.h"

namespace ravnoves::elastic_hinge {

/// Moments and forces over one turn, at the angles of Result::crank_angle_deg. What needs the exact
/// kinematics is empty where λ = 1.
struct MechanismCurves {
    std::vector<double> reduced_inertia;              ///< I_pr, kg·m²
    std::vector<double> crank_moment;                 ///< M, N·m, [13]
    std::vector<double> rod_hinge_moment;             ///< M₁₂, N·m, (4) or (9)
    std::vector<double> rod_hinge_moment_potential;   ///< N·m, (5)
    std::vector<double> side_force_without_hinge;     ///< of the slider on its guide, up, N, (7)
    std::vector<double> side_force_with_hinge;        ///< N, (6)
    std::vector<double> crank_moment_with_rod_hinge;  ///< M₁ or M₁*, N·m, (8), (11)
};

/// The same at another crank speed or another λ, for families of curves.
struct FamilyMember {
    double parameter = 0.0;  ///< ω (rad/s) or λ
    MechanismCurves curves;
};

/// What solve() is to compute beside the result proper.
struct SolveOptions {
    int samples = 721;           ///< crank angles, both ends of the turn included; at least 13
    std::vector<double> speeds;  ///< members of Result::by_speed, rad/s, ≥ 0
    /// Members of Result::by_lambda, 0 < λ ≤ 1: the rod's moments and side forces only. λ = 1 is
    /// left out with the exact kinematics.
    std::vector<double> lambdas;
    bool with_rod_guides = true;  ///< the guides of the rod's hinge and of the crank's beside it
};

/// Everything that the page shows and that the command line prints, but for the motion.
struct Result {
    std::vector<double> crank_angle_deg;  ///< 0…360
    MechanismCurves curves;
    std::vector<FamilyMember> by_speed;
    std::vector<FamilyMember> by_lambda;

    double rod_hinge_integral = 0.0;  ///< ∮ M₁₂ dφ, J
    double counterweight_mass = 0.0;  ///< P₄/g, kg; 0 without one
    bool has_counterweight = false;
    /// The counterweight's mass that (10) asks for at the given distance, kg; 0 without one.
    double balancing_mass = 0.0;

    double largest_side_force_without = 0.0;  ///< N, over the samples
    double largest_side_force_with = 0.0;
    /// What the slider's guide bears when a hinge with M₁₂'s potential part is built, by
    /// Newton–Euler: equal to side_force_with_hinge but for a counterweight after (9) as printed
    /// and for the series. N; empty where λ = 1.
    std::vector<double> side_force_true;
    double largest_side_force_true = 0.0;

    /// Largest |cos ψ of the series − exact cos ψ| over the turn, and where it stands.
    double series_error = 0.0;
    double series_error_angle = 0.0;  ///< rad
    /// Largest |M₁₂ of the series − exact|, N·m; empty where λ = 1.
    std::optional<double> series_moment_error;

    Guide crank_guide;                      ///< for M
    Guide crank_guide_with_rod;             ///< for M₁, beside the rod's hinge
    Guide rod_guide;                        ///< for M₁₂'s potential part, over θ
    std::optional<GuideProposal> proposal;  ///< for the crank's guide, where the input asks

    std::vector<std::string> notes;  ///< sentences the user should read

    std::shared_ptr<const Design> design;
};

/// Solves the scene.
/// @throws InputError as check_input(), and for inputs whose results leave the range of numbers
Result solve(const Input& input, const SolveOptions& options = {});

/// The motion that the input asks for (or five turns at the design speed), with the result's
/// guides.
/// @throws InputError as simulate() of motion.h
Motion simulate(const Input& input, const Result& result, HingeSet hinges,
                const MotionProgress& progress = {});

/// Where the parts stand at one crank angle, for the picture; m.
struct MechanismPose {
    PlanePoint crankpin;
    PlanePoint slider;
    PlanePoint counterweight;         ///< at the crankpin where there is none
    double rod_angle = 0.0;           ///< of the rod against +x, counter-clockwise, rad: −ψ
    double spring_half_length = 0.0;  ///< ρ at that angle, m; not a number without guide
};

/// @param phi  rad, any; λ ≤ 1 (at λ = 1 the slider stays at 0 on the far side)
MechanismPose mechanism_pose(const Result& result, double phi);

}  // namespace ravnoves::elastic_hinge
