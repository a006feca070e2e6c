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

    double rod_hinge_integral = 0.0;  ///< ∮ M₁₂ dφ, J
    double counterweight_mass = 0.0;  ///< P₄/g, kg; 0 without one
    bool has_counterweight = false;
    /// The counterweight's mass by (10) at the given distance, kg; 0 without one.
    double balancing_mass = 0.0;

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

}  // namespace ravnoves::elastic_hinge
