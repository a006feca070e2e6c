#include "methods/hinge_mechanism.h"

namespace ravnoves::methods {

namespace {

struct Body {
    Real50 x, y, angle;  ///< centre of mass, m, and direction, rad
};

std::array<Body, 3> bodies_at(const elastic_hinge::Input& input, const Real50& phi) {
    const Real50 r(input.crank_radius);
    const Real50 l = r / Real50(input.lambda);
    const Real50 ax = r * cos(phi);
    const Real50 ay = r * sin(phi);
    const Real50 bx = ax + sqrt(Real50(l * l - ay * ay));  // the slider, on y = 0
    return {Body{ax / 2, ay / 2, phi}, Body{(ax + bx) / 2, ay / 2, asin(Real50(-ay / l))},
            Body{bx, Real50(0), Real50(0)}};
}

}  // namespace

Real50 energy_of_bars(const elastic_hinge::Input& input, const Real50& phi, const Real50& omega) {
    const Real50 r(input.crank_radius);
    const Real50 l = r / Real50(input.lambda);
    const std::array<Real50, 3> mass{Real50(input.crank_mass), Real50(input.rod_mass),
                                     Real50(input.slider_mass)};
    const std::array<Real50, 3> length{r, l, Real50(0)};
    const Real50 h("1e-16");
    const auto here = bodies_at(input, phi);
    const auto ahead = bodies_at(input, phi + h);
    const auto behind = bodies_at(input, phi - h);
    Real50 energy(0);
    for (std::size_t i = 0; i < here.size(); ++i) {
        const auto speed = [&](const Real50& a, const Real50& b) {
            return Real50((b - a) / (2 * h) * omega);
        };
        const Real50 vx = speed(behind[i].x, ahead[i].x);
        const Real50 vy = speed(behind[i].y, ahead[i].y);
        const Real50 turning = speed(behind[i].angle, ahead[i].angle);
        const Real50 inertia = mass[i] * length[i] * length[i] / 12;
        energy += mass[i] * (vx * vx + vy * vy) / 2 + inertia * turning * turning / 2;
        energy += mass[i] * Real50(input.gravity) * here[i].y;
    }
    return energy;
}

}  // namespace ravnoves::methods
