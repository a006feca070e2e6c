#include "balance-shaft/mechanism.h"

#include <cmath>

#include "balance-shaft/engine_torque.h"

namespace ravnoves::balance_shaft {

MechanismPose mechanism_pose(const Solver& solver, double crank_angle, double shaft_angle) {
    const FrontView& view = solver.front_view();
    const Input& input = solver.input();
    const SliderCrank<double> crank = slider_crank(input);
    const double theta = crank_angle + crank.top_dead_centre();
    const double c = std::cos(theta);
    const double s = std::sin(theta);
    const double mass = input.reciprocating_mass();
    const double speed2 = input.angular_speed * input.angular_speed;
    const PistonMotion<double> piston = crank.at(s, c);

    MechanismPose pose;
    pose.crankpin = {view.crank_radius * s, view.crank_radius * c};
    pose.piston_pin = {crank.offset, piston.s};
    const double rho = view.counterweight_radius;
    // The crank turns clockwise in the view, the shaft the other way: their counterweights meet in
    // the vertical component only.
    const PistonFirstOrder& first_order = solver.moments().piston_1;
    const double cos_1 = std::cos(theta - first_order.lag);
    const double sin_1 = std::sin(theta - first_order.lag);
    const Vector2 crank_direction{-sin_1, -cos_1};
    const Vector2 shaft_direction{sin_1, -cos_1};
    pose.crank_counterweight = {rho * crank_direction.x, rho * crank_direction.y};
    pose.shaft_axis = {view.centre_distance * std::sin(shaft_angle),
                       view.centre_distance * std::cos(shaft_angle)};
    pose.shaft_counterweight = {pose.shaft_axis.x + rho * shaft_direction.x,
                                pose.shaft_axis.y + rho * shaft_direction.y};
    pose.inertia_force_1 = {0.0, mass * first_order.radius * speed2 * cos_1};
    const double force = solver.moments().forces.counterweight_force;
    pose.crank_counterweight_force = {force * crank_direction.x, force * crank_direction.y};
    pose.shaft_counterweight_force = {force * shaft_direction.x, force * shaft_direction.y};
    return pose;
}

}  // namespace ravnoves::balance_shaft
