#pragma once

#include "elastic-hinge/kinematics.h"
#include "elastic-hinge/mechanism.h"

namespace ravnoves::elastic_hinge {

/// Reduced moment of inertia of the mechanism at one crank angle: T = ½ I_pr φ̇².
template <typename Scalar>
struct ReducedInertia {
    Scalar value;   ///< I_pr, kg·m²
    Scalar rise;    ///< I_pr(φ) − I_pr(0), kg·m², without cancellation
    Scalar slope;   ///< dI_pr/dφ, kg·m²
    Scalar second;  ///< d²I_pr/dφ², kg·m²
};

/// I_pr(0) = r² (P₁ + P₂) / (3g) + (P₄/g) (r + λ ℓ₂)², kg·m².
template <typename Scalar>
Scalar reduced_inertia_at_zero(const Mechanism<Scalar>& m) {
    const Scalar arm = m.crank_radius + m.lambda * m.counterweight_distance;
    return m.crank_radius * m.crank_radius * (m.crank_mass + m.rod_mass) / 3 +
           m.counterweight_mass * arm * arm;
}

/// Reduced inertia and its derivatives.
///
/// With sin ψ = λ sin φ every part that changes has the factor sin² φ: I_pr = I_pr(0) + sin² φ J,
/// J = m₃ r² (1 + ψ′)² + m₂ r² ((1 + ψ′/2)² − 1/4 − (1 − λ²) / (12 cos² ψ))
///     + m₄ ((r − λ ℓ₂ ψ′)² − (r + λ ℓ₂)²),
/// so that the rise from φ = 0, on which the guides are built, keeps all digits.
/// @param rod  of the exact kinematics
template <typename Scalar>
ReducedInertia<Scalar> reduced_inertia(const Mechanism<Scalar>& m, const Scalar& sin_phi,
                                       const Scalar& cos_phi, const RodAngle<Scalar>& rod) {
    const Scalar one(1);
    const Scalar r = m.crank_radius;
    const Scalar r2 = r * r;
    const Scalar p = rod.dpsi;
    const Scalar p1 = rod.d2psi;
    const Scalar p2 = rod.d3psi;
    const Scalar inverse = one / rod.cos_psi;
    const Scalar tan_psi = rod.sin_psi * inverse;
    const Scalar secant = inverse * inverse;  // 1/cos² ψ and its derivatives by φ
    const Scalar dsecant = 2 * tan_psi * p * secant;
    const Scalar d2secant = 2 * secant * (p * p * (secant + 2 * tan_psi * tan_psi) + tan_psi * p1);

    const Scalar slider = m.slider_mass * r2;
    const Scalar rod_part = m.rod_mass * r2;
    const Scalar rod_turn = rod_part * (one - m.lambda) * (one + m.lambda) / 12;
    const Scalar arm = m.lambda * m.counterweight_distance;
    const Scalar weight = m.counterweight_mass;
    // (r − a ψ′)² − (r + a)² = −a (1 + ψ′) (2 r + a (1 − ψ′))
    const Scalar J = slider * (one + p) * (one + p) + rod_part * ((one + p) * (p + 3) / 4) -
                     rod_turn * secant - weight * arm * (one + p) * (2 * r + arm * (one - p));
    const Scalar J1 =
        (2 * slider * (one + p) + rod_part * (one + p / 2) - 2 * weight * arm * (r - arm * p)) *
            p1 -
        rod_turn * dsecant;
    const Scalar J2 =
        (2 * slider * (one + p) + rod_part * (one + p / 2) - 2 * weight * arm * (r - arm * p)) *
            p2 +
        (2 * slider + rod_part / 2 + 2 * weight * arm * arm) * p1 * p1 - rod_turn * d2secant;

    const Scalar s2 = sin_phi * sin_phi;
    const Scalar sc = sin_phi * cos_phi;
    ReducedInertia<Scalar> inertia;
    inertia.rise = s2 * J;
    inertia.value = reduced_inertia_at_zero(m) + inertia.rise;
    inertia.slope = 2 * sc * J + s2 * J1;
    inertia.second = 2 * (cos_phi - sin_phi) * (cos_phi + sin_phi) * J + 4 * sc * J1 + s2 * J2;
    return inertia;
}

/// Amplitude of the potential energy V = G sin φ, J: G = g (½ r (m₁ + m₂) + m₄ (r + λ ℓ₂)).
template <typename Scalar>
Scalar potential_amplitude(const Mechanism<Scalar>& m) {
    return m.gravity *
           (m.crank_radius * (m.crank_mass + m.rod_mass) / 2 +
            m.counterweight_mass * (m.crank_radius + m.lambda * m.counterweight_distance));
}

/// Energy that the mechanism absorbs at constant crank speed.
template <typename Scalar>
struct EnergyRise {
    Scalar rise;    ///< (T + V)(φ) − (T + V)(0), J
    Scalar slope;   ///< M, the moment on the crank that keeps its speed constant, N·m, [13]
    Scalar second;  ///< dM/dφ, N·m
};

/// @param omega  crank speed, rad/s
template <typename Scalar>
EnergyRise<Scalar> energy_rise(const Mechanism<Scalar>& m, const Scalar& omega,
                               const Scalar& sin_phi, const Scalar& cos_phi,
                               const ReducedInertia<Scalar>& inertia) {
    const Scalar half = omega * omega / 2;
    const Scalar G = potential_amplitude(m);
    return {half * inertia.rise + G * sin_phi, half * inertia.slope + G * cos_phi,
            half * inertia.second - G * sin_phi};
}

}  // namespace ravnoves::elastic_hinge
