#include "balance-shaft/crank_balance.h"

#include <algorithm>
#include <cmath>

#include "numerics/constants.h"

namespace ravnoves::balance_shaft {

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
    balance.dead_centre = solver.moments().top;
    balance.lag = first_order.lag;
    balance.largest = std::max(std::abs(balance.along), balance.across);
    balance.counterweight_moment = balance.share * input.reciprocating_mass() * input.crank_radius;
    balance.with_shaft =
        std::abs(balance.first_order - 2.0 * solver.moments().forces.counterweight_force);
    balance.second_order = centred * input.crank_radius / input.effective_rod_length();
    return balance;
}

ForceLocus force_locus(const CrankBalance& balance, double across, double along,
                       double second_order) {
    ForceLocus curve;
    constexpr int points = 181;
    for (int i = 0; i < points; ++i) {
        const double theta = 360.0 * i / (points - 1) * degree + balance.dead_centre;
        curve.x.push_back(-across * std::sin(theta - balance.lag));
        curve.y.push_back(along * std::cos(theta - balance.lag) +
                          second_order * std::cos(2.0 * theta));
    }
    return curve;
}

}  // namespace ravnoves::balance_shaft
