#pragma once

#include <array>

#include "elastic-hinge/energy.h"
#include "elastic-hinge/input.h"
#include "numerics/real50.h"

namespace ravnoves::methods {

/// The input's mechanism in any scalar, without counterweight. The numbers are those of the
/// doubles.
template <typename Scalar>
elastic_hinge::Mechanism<Scalar> mechanism_in(const elastic_hinge::Input& input) {
    elastic_hinge::Mechanism<Scalar> mechanism{};
    mechanism.crank_mass = Scalar(input.crank_mass);
    mechanism.rod_mass = Scalar(input.rod_mass);
    mechanism.slider_mass = Scalar(input.slider_mass);
    mechanism.gravity = Scalar(input.gravity);
    mechanism.crank_radius = Scalar(input.crank_radius);
    mechanism.lambda = Scalar(input.lambda);
    return mechanism;
}

template <typename Scalar>
elastic_hinge::ReducedInertia<Scalar> inertia_at(const elastic_hinge::Mechanism<Scalar>& mechanism,
                                                 const Scalar& sin_phi, const Scalar& cos_phi) {
    return reduced_inertia(mechanism, sin_phi, cos_phi,
                           elastic_hinge::rod_angle_exact(mechanism.lambda, sin_phi, cos_phi));
}

/// What the mechanism takes up at constant speed from 0 to φ (rad).
template <typename Scalar>
elastic_hinge::EnergyRise<Scalar> energy_rise_at(const elastic_hinge::Mechanism<Scalar>& mechanism,
                                                 const Scalar& omega, const Scalar& phi) {
    using std::cos;
    using std::sin;
    const Scalar s = sin(phi);
    const Scalar c = cos(phi);
    return energy_rise(mechanism, omega, s, c, inertia_at(mechanism, s, c));
}

/// T + V of the three bodies at a crank angle and speed, J, from nothing but where their ends lie:
/// speeds are differences of positions. Shares no formula with energy.h.
Real50 energy_of_bars(const elastic_hinge::Input& input, const Real50& phi, const Real50& omega);

}  // namespace ravnoves::methods
