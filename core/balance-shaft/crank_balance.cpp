#include "balance-shaft/crank_balance.h"

#include <algorithm>
#include <cmath>

#include "balance-shaft/engine_torque.h"
#include "numerics/constants.h"

namespace ravnoves::balance_shaft {

namespace {

/// Samples a force over one turn: x and y half-axes of the first order, second order along y.
ForceLocus locus(const CrankBalance& balance, double across, double along, double second,
                 int points) {
    ForceLocus curve;
    points = std::max(points, 2);
    for (int i = 0; i < points; ++i) {
        const double angle = 360.0 * i / (points - 1);
        const double theta = angle * degree + balance.dead_centre;
        curve.crank_angle_deg.push_back(angle);
        curve.x.push_back(-across * std::sin(theta - balance.lag));
        curve.y.push_back(along * std::cos(theta - balance.lag) + second * std::cos(2.0 * theta));
    }
    return curve;
}

}  // namespace

CrankBalance crank_balance(const Solver& solver) {
    const Input& input = solver.input();
    const double omega2 = input.angular_speed * input.angular_speed;
    CrankBalance balance;
    balance.share = input.crank_share;
    const double centred = input.reciprocating_mass() * input.crank_radius * omega2;
    const PistonFirstOrder& first_order = solver.moments().piston_1;
    balance.first_order = input.reciprocating_mass() * first_order.radius * omega2;
    balance.across = balance.share * centred;
    balance.along = balance.first_order - balance.across;
    balance.dead_centre = slider_crank(input).top_dead_centre();
    balance.lag = first_order.lag;
    balance.largest = std::max(std::abs(balance.along), balance.across);
    balance.counterweight_moment = balance.share * input.reciprocating_mass() * input.crank_radius;
    balance.with_shaft =
        std::abs(balance.first_order - 2.0 * solver.moments().forces.counterweight_force);
    balance.second_order = centred * input.crank_radius / input.effective_rod_length();
    return balance;
}

ForceLocus crank_only_locus(const CrankBalance& balance, int points) {
    return locus(balance, balance.across, balance.along, 0.0, points);
}

ForceLocus crank_only_locus_with_second_order(const CrankBalance& balance, int points) {
    return locus(balance, balance.across, balance.along, balance.second_order, points);
}

ForceLocus shaft_locus(const CrankBalance& balance, int points) {
    return locus(balance, 0.0, balance.with_shaft, balance.second_order, points);
}

}  // namespace ravnoves::balance_shaft
