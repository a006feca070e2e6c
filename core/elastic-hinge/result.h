#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "elastic-hinge/design.h"
#include "elastic-hinge/guide.h"
#include "elastic-hinge/guide_search.h"

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

/// Everything that the page shows and that the command line prints, but for the motion.
struct Result {
    std::vector<double> crank_angle_deg;  ///< 0…360
    MechanismCurves curves;

    double largest_side_force_without = 0.0;  ///< N, over the continuous turn
    double largest_side_force_with = 0.0;
    /// What the slider's guide bears when a hinge with M₁₂'s potential part is built, by
    /// Newton–Euler: other than with the hinge for a counterweight after (9) as printed and for the
    /// series. N; empty where λ = 1.
    std::optional<double> largest_side_force_true;

    /// Largest |cos ψ of the series − exact cos ψ| over the turn, and its place.
    double series_error = 0.0;
    double series_error_angle = 0.0;  ///< rad
    /// M₁₂ by the kinematics that the input does not choose, N·m; empty where λ = 1.
    std::vector<double> other_rod_hinge_moment;
    /// Largest |M₁₂ of the series − exact|, N·m; empty where λ = 1.
    std::optional<double> series_moment_error;

    Guide crank_guide;                      ///< for M
    Guide crank_guide_with_rod;             ///< for M₁, beside the rod's hinge
    Guide rod_guide;                        ///< for M₁₂'s potential part, over θ
    std::optional<GuideProposal> proposal;  ///< for the crank's guide, where the input asks

    std::vector<Message> notes;        ///< sentences the user should read
    std::vector<Message> guide_notes;  ///< of the guides

    std::shared_ptr<const Design> design;
};

/// What solve() is to compute beside the result proper.
struct SolveOptions {
    int samples = 721;  ///< crank angles, both ends of the turn included; at least 13
    /// With side forces, what the series differs by, and what guides need angle by angle: a guide
    /// of a spring that suffices follows else from the demand's range alone.
    bool with_curves = true;
    bool with_rod_guides = true;  ///< the guides of the rod's hinge and of the crank's beside it
};

/// Solves the scene.
/// @throws InputError as check_input(), and for inputs whose results leave the range of numbers
Result solve(const Input& input, const SolveOptions& options = {});

/// The curves of a design with moments at any crank speed, rad/s.
MechanismCurves curves_at(const Design& design, double omega);

/// Where the parts are at one crank angle, for the picture; m.
struct MechanismPose {
    PlanePoint crankpin;
    PlanePoint slider;
    PlanePoint counterweight;  ///< at the crankpin without one
    double rod_angle = 0.0;    ///< of the rod against +x, counter-clockwise, rad: −ψ
};

/// @param phi  rad, any; λ ≤ 1 (at λ = 1 the slider stays at 0 on the far side)
MechanismPose mechanism_pose(const Result& result, double phi);

}  // namespace ravnoves::elastic_hinge
