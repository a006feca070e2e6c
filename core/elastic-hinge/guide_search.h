#pragma once

#include <memory>

#include "case-file/message.h"
#include "elastic-hinge/design.h"
#include "elastic-hinge/guide.h"
#include "elastic-hinge/input.h"

namespace ravnoves::elastic_hinge {

/// A spring whose guide has the wanted relief and fits, or the reason for none.
struct GuideProposal {
    bool found = false;
    Message reason;  ///< why not, as a sentence; empty where found
    Branch branch = Branch::compressed;
    Spring spring;                        ///< the free length that was given, with new c and ρ₀
    double relief = 0.0;                  ///< m
    double outer_diameter = 0.0;          ///< of profile and rollers together, m
    double smallest_spring_length = 0.0;  ///< m
    double largest_spring_force = 0.0;    ///< N
    double largest_spring_energy = 0.0;   ///< J
};

/// Finds c and ρ₀ of the crank's hinge for the relief that the input wishes.
///
/// With d = |ℓ₀/2 − ρ| between d_min and d_min + relief and the energy span ΔE that the hinge has
/// to give out, c = ΔE / (2 relief (2 d_min + relief)): one free number, d_min, is left. The search
/// takes the smallest one (which stores the smallest energy) that keeps a tenth of the relief as
/// preload at the weakest place and the wanted margin of the preload over the smallest one, fits
/// into the outer diameter, keeps the spring longer than its smallest length and lets the roller
/// follow without undercut.
/// @param design  of the input
GuideProposal search_guide(const std::shared_ptr<const Design>& design, const Input& input,
                           Branch branch);

/// Whether the input's guide already meets its wish, to a micrometre.
bool meets_wish(const Guide& guide, const Input& input);

}  // namespace ravnoves::elastic_hinge
