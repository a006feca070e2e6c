#pragma once

#include "elastic-hinge/input.h"
#include "elastic-hinge/result.h"

namespace ravnoves::elastic_hinge {

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
