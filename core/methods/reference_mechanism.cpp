#include "methods/reference_mechanism.h"

namespace ravnoves::methods {

PistonMotion<Real50> reference_piston(const SliderCrank<double>& crank, const Real50& theta) {
    const Real50 R(crank.crank_radius);
    const Real50 L(crank.rod_length);
    const Real50 x = R * cos(theta);
    const Real50 y = R * sin(theta) - Real50(crank.offset);
    const Real50 dx = -R * sin(theta);
    const Real50 ahead = sqrt(Real50(L * L - y * y));                    // s − x
    const Real50 dahead = -y * x / ahead;                                // y′ = x
    const Real50 d2ahead = -(x * x + y * dx + dahead * dahead) / ahead;  // y″ = x′
    return {x + ahead, dx + dahead, -x + d2ahead};
}

std::vector<Sweep<SliderCrank<double>>> slider_crank_sweeps(double nearest, double scene_nearest) {
    constexpr double lambda = 0.265;
    constexpr double offset = 12.5 / 45.0;
    return {
        {{"locking", Text::tr("distance from locking, 1 − λ"), units::none, nearest, 0.99,
          Spacing::logarithmic, scene_nearest, 0.99, 1.0 - lambda},
         [](double gap) {
             return SliderCrank<double>{1.0, 1.0 / (1.0 - gap), 0.0};
         }},
        {{"offset", Text::tr("distance from locking by the offset, 1 − λ(1 + K), λ = 0.265"),
          units::none, nearest, 1.0 - lambda, Spacing::logarithmic, scene_nearest, 1.0 - lambda,
          1.0 - lambda * (1.0 + offset)},
         [](double gap) {
             return SliderCrank<double>{1.0, 1.0 / lambda, (1.0 - gap) / lambda - 1.0};
         }},
    };
}

ReferenceBars::ReferenceBars(const elastic_hinge::Input& input)
    : crank_mass_(input.crank_mass),
      rod_mass_(input.rod_mass),
      slider_mass_(input.slider_mass),
      gravity_(input.gravity),
      radius_(input.crank_radius),
      length_(radius_ / Real50(input.lambda)) {}

Real50 ReferenceBars::inertia(const Real50& phi) const {
    // Crankpin A, slider pin B, the rod's middle between them.
    const Real50 ax = radius_ * cos(phi);
    const Real50 ay = radius_ * sin(phi);
    const Real50 along = sqrt(Real50(length_ * length_ - ay * ay));  // B − A on the slider's line
    const Real50 bx_speed = -ay - ay * ax / along;
    const Real50 middle_x = (bx_speed - ay) / 2;
    const Real50 middle_y = ax / 2;
    const Real50 turning = ax / along;  // cos ψ ψ′ = y′/ℓ
    return crank_mass_ * radius_ * radius_ / 3 + slider_mass_ * bx_speed * bx_speed +
           rod_mass_ * (middle_x * middle_x + middle_y * middle_y +
                        length_ * length_ * turning * turning / 12);
}

Real50 ReferenceBars::potential(const Real50& phi) const {
    return gravity_ * (crank_mass_ + rod_mass_) * radius_ * sin(phi) / 2;
}

}  // namespace ravnoves::methods
