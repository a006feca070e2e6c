#pragma once

#include <vector>

#include "elastic-hinge/input.h"
#include "elastic-hinge/motion.h"
#include "elastic-hinge/result.h"

namespace ravnoves::elastic_hinge {

/// What solve() is to compute beside the result proper.
struct SolveOptions {
    int samples = 721;           ///< crank angles, both ends of the turn included; at least 13
    std::vector<double> speeds;  ///< members of Result::by_speed, rad/s, ≥ 0
    /// Members of Result::by_lambda, 0 < λ ≤ 1. λ = 1 is left out with the exact kinematics.
    std::vector<double> lambdas;
    bool with_curves = true;      ///< with side forces, and what the series differs by
    bool with_rod_guides = true;  ///< the guides of the rod's hinge and of the crank's beside it
    bool with_profiles = true;    ///< what guides need angle by angle; a guide of a spring that
                                  ///< suffices follows else from the demand's range alone
};

/// Solves the scene.
/// @throws InputError as check_input(), and for inputs whose results leave the range of numbers
Result solve(const Input& input, const SolveOptions& options = {});

/// The motion of the input (or five turns at the design speed), with the result's guides.
/// @throws InputError as simulate() of motion.h
Motion simulate(const Input& input, const Result& result, HingeSet hinges,
                const MotionProgress& progress = {});

/// Where the parts are at one crank angle, for the picture; m.
struct MechanismPose {
    PlanePoint crankpin;
    PlanePoint slider;
    PlanePoint counterweight;         ///< at the crankpin without one
    double rod_angle = 0.0;           ///< of the rod against +x, counter-clockwise, rad: −ψ
    double spring_half_length = 0.0;  ///< ρ at that angle, m; not a number without guide
};

/// @param phi  rad, any; λ ≤ 1 (at λ = 1 the slider stays at 0 on the far side)
MechanismPose mechanism_pose(const Result& result, double phi);

}  // namespace ravnoves::elastic_hinge
