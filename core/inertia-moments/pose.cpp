#include "inertia-moments/pose.h"

#include <cmath>

namespace ravnoves::inertia_moments {

std::vector<CylinderPose> engine_pose(const Engine& engine, double crank_angle) {
    std::vector<CylinderPose> poses;
    poses.reserve(engine.cylinders.size());
    const double radius = engine.crank_radius;
    for (const Cylinder& cylinder : engine.cylinders) {
        const SliderCrank<double> mechanism = engine.mechanism(cylinder);
        const double theta = crank_angle + engine.crank_phase(cylinder);
        CylinderPose pose;
        pose.axis_direction = {-std::sin(cylinder.bank_angle), std::cos(cylinder.bank_angle)};
        // The offset's side is the axis turned by +90°.
        pose.axis_foot = pose.axis_direction * Complex(0.0, cylinder.offset);
        pose.crankpin = pose.axis_direction * std::polar(radius, theta);
        pose.piston_pin = pose.axis_foot + pose.axis_direction * (radius * mechanism.at(theta).s);
        pose.top = radius * mechanism.at(mechanism.top_dead_centre()).s;
        pose.bottom = radius * mechanism.at(mechanism.bottom_dead_centre()).s;
        poses.push_back(pose);
    }
    return poses;
}

}  // namespace ravnoves::inertia_moments
