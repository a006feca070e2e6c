#include "inertia-moments/pose.h"

#include <cmath>

namespace ravnoves::inertia_moments {

std::vector<CylinderPose> engine_pose(const Engine& engine, double crank_angle) {
    std::vector<CylinderPose> poses;
    poses.reserve(engine.cylinders.size());
    const double radius = engine.crank_radius;
    for (std::size_t i = 0; i < engine.cylinders.size(); ++i) {
        const Cylinder& cylinder = engine.cylinders[i];
        const ArticulatedCrank crank = engine.crank(i);
        const double theta = crank_angle + engine.crank_phase(cylinder);
        const ArticulatedMotion motion = crank.at(std::sin(theta), std::cos(theta));
        CylinderPose pose;
        pose.axis_direction = {-std::sin(cylinder.bank_angle), std::cos(cylinder.bank_angle)};
        // The offset's side is the axis turned by +90°.
        pose.axis_foot = pose.axis_direction * Complex(0.0, cylinder.offset);
        pose.crankpin = pose.axis_direction * std::polar(radius, theta);
        pose.rod_foot = pose.crankpin + pose.axis_direction * radius * motion.arm;
        pose.articulated = cylinder.articulated.has_value();
        pose.piston_pin = pose.axis_foot + pose.axis_direction * radius * motion.piston.s;
        const auto place = [&](double angle) {
            return radius * crank.at(std::sin(angle), std::cos(angle)).piston.s;
        };
        pose.top = place(crank.top_dead_centre());
        pose.bottom = place(crank.bottom_dead_centre());
        poses.push_back(pose);
    }
    return poses;
}

}  // namespace ravnoves::inertia_moments
