#pragma once

#include <vector>

#include "inertia-moments/engine.h"
#include "inertia-moments/orders.h"

namespace ravnoves::inertia_moments {

/// One cylinder's mechanism at one crank angle, in the front view (x + iy, m).
struct CylinderPose {
    Complex crankpin;
    Complex piston_pin;
    Complex rod_foot;          ///< where its rod begins: the crankpin, or the knuckle pin
    bool articulated = false;  ///< its rod hangs on a master rod
    Complex axis_foot;         ///< point of the cylinder's axis nearest to the crank axis
    Complex axis_direction;    ///< unit vector outwards
    double top = 0.0;          ///< piston pin at top dead centre, m along the axis from the foot
    double bottom = 0.0;       ///< and at bottom dead centre
};

/// All cylinders at φ (rad), for the picture.
std::vector<CylinderPose> engine_pose(const Engine& engine, double crank_angle);

}  // namespace ravnoves::inertia_moments
