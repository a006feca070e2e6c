#pragma once

#include "balance-shaft/solver.h"

namespace ravnoves::balance_shaft {

/// A point (m) or a force (N) in the front view.
struct Vector2 {
    double x = 0.0;
    double y = 0.0;
};

/// The mechanism at one crank angle, for the picture.
struct MechanismPose {
    Vector2 crankpin;
    Vector2 piston_pin;
    Vector2 crank_counterweight;  ///< its centre of mass
    Vector2 shaft_axis;
    Vector2 shaft_counterweight;  ///< its centre of mass
    Vector2 inertia_force_1;      ///< of the reciprocating mass, first order, at the piston pin
    Vector2 crank_counterweight_force;
    Vector2 shaft_counterweight_force;
};

/// The pose at a crank angle and a shaft angle, both rad, any.
MechanismPose mechanism_pose(const Solver& solver, double crank_angle, double shaft_angle);

}  // namespace ravnoves::balance_shaft
