#pragma once

#include <cmath>

#include "elastic-hinge/mechanism.h"

namespace ravnoves::elastic_hinge {

/// The rod's angle ψ (sin ψ = λ sin φ) and its derivatives by the crank angle φ.
///
/// With the paper's series the cosine and its derivatives are the series', and ψ′, ψ″ are the
/// paper's expressions with that cosine.
template <typename Scalar>
struct RodAngle {
    Scalar sin_psi;
    Scalar cos_psi;
    Scalar dcos;   ///< d cos ψ / dφ
    Scalar d2cos;  ///< d² cos ψ / dφ²
    Scalar d3cos;  ///< d³ cos ψ / dφ³
    Scalar dpsi;   ///< dψ/dφ = λ cos φ / cos ψ
    Scalar d2psi;  ///< d²ψ/dφ² = −λ sin φ (1 − ψ′²) / cos ψ  (ε₂ = −ψ″ ω²)
    Scalar d3psi;  ///< derivative of d2psi
};

/// Exact kinematics at one crank angle.
/// @param lambda  r/ℓ, 0 < λ < 1; at λ = 1 the cosine vanishes at φ = 90° and the mechanism locks
template <typename Scalar>
RodAngle<Scalar> rod_angle_exact(const Scalar& lambda, const Scalar& sin_phi,
                                 const Scalar& cos_phi) {
    using std::sqrt;
    RodAngle<Scalar> rod;
    const Scalar one(1);
    rod.sin_psi = lambda * sin_phi;
    // The product keeps its digits where λ sin φ is near 1; 1 − x² would not.
    rod.cos_psi = sqrt((one - rod.sin_psi) * (one + rod.sin_psi));
    const Scalar inverse = one / rod.cos_psi;
    const Scalar tan_psi = rod.sin_psi * inverse;
    const Scalar p = lambda * cos_phi * inverse;
    // 1 − ψ′² = (1 − λ²) / cos² ψ: free of cancellation.
    const Scalar rest = (one - lambda) * (one + lambda) * inverse * inverse;
    const Scalar p2 = -tan_psi * rest;
    // (tan ψ)′ = ψ′ / cos² ψ and rest′ = 2 rest tan ψ ψ′.
    const Scalar p3 = -rest * p * (inverse * inverse + 2 * tan_psi * tan_psi);
    rod.dpsi = p;
    rod.d2psi = p2;
    rod.d3psi = p3;
    rod.dcos = -rod.sin_psi * p;
    rod.d2cos = -(rod.cos_psi * p * p + rod.sin_psi * p2);
    rod.d3cos = rod.sin_psi * p * p * p - 3 * rod.cos_psi * p * p2 - rod.sin_psi * p3;
    return rod;
}

/// The paper's series at one crank angle; finite for λ ≤ 1.
template <typename Scalar>
RodAngle<Scalar> rod_angle_series(const Scalar& lambda, const Scalar& sin_phi,
                                  const Scalar& cos_phi) {
    RodAngle<Scalar> rod;
    const Scalar one(1);
    const Scalar square = lambda * lambda;
    rod.sin_psi = lambda * sin_phi;
    rod.cos_psi = one - square * sin_phi * sin_phi / 2;  // = 1 − λ²/4 + (λ²/4) cos 2φ
    rod.dcos = -square * sin_phi * cos_phi;
    rod.d2cos = -square * (cos_phi - sin_phi) * (cos_phi + sin_phi);
    rod.d3cos = 4 * square * sin_phi * cos_phi;
    const Scalar inverse = one / rod.cos_psi;
    const Scalar p = lambda * cos_phi * inverse;
    const Scalar dp = -rod.sin_psi * inverse - p * rod.dcos * inverse;
    const Scalar rest = (one - p) * (one + p);
    rod.dpsi = p;
    rod.d2psi = -rod.sin_psi * rest * inverse;
    rod.d3psi = -(lambda * cos_phi * rest - 2 * rod.sin_psi * p * dp) * inverse -
                rod.d2psi * rod.dcos * inverse;
    return rod;
}

template <typename Scalar>
RodAngle<Scalar> rod_angle(Kinematics kinematics, const Scalar& lambda, const Scalar& sin_phi,
                           const Scalar& cos_phi) {
    return kinematics == Kinematics::exact ? rod_angle_exact(lambda, sin_phi, cos_phi)
                                           : rod_angle_series(lambda, sin_phi, cos_phi);
}

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
    const Scalar by_p =
        2 * slider * (one + p) + rod_part * (one + p / 2) - 2 * weight * arm * (r - arm * p);
    const Scalar J1 = by_p * p1 - rod_turn * dsecant;
    const Scalar J2 = by_p * p2 + (2 * slider + rod_part / 2 + 2 * weight * arm * arm) * p1 * p1 -
                      rod_turn * d2secant;

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

/// M₁₂ = weight + ω² inertia: the moment on the rod, counter-clockwise, that makes the side force
/// on the slider zero; the crank gets −M₁₂. Source: (4), with a counterweight (9).
template <typename Scalar>
struct RodHingeMoment {
    Scalar weight;   ///< N·m
    Scalar inertia;  ///< N·m·s²
    /// The same by Newton–Euler, whatever the signs at the counterweight: of the side force without
    /// hinge.
    Scalar true_inertia;
    Scalar dweight;  ///< derivatives by φ
    Scalar dinertia;

    Scalar value(const Scalar& omega) const { return weight + omega * omega * inertia; }
    Scalar slope(const Scalar& omega) const { return dweight + omega * omega * dinertia; }
};

/// M₁₂ and its derivative at one crank angle.
/// @param rod  of either kinematics; with the series this is the paper's (4) as computed there
///             (with I₂ of the rod's length ℓ and the minus that ẍ_B lacks in print)
/// @param static_moment  Mechanism::static_moment(), or 0 where (10) is exactly met, kg·m
template <typename Scalar>
RodHingeMoment<Scalar> rod_hinge_moment(const Mechanism<Scalar>& m, const Scalar& static_moment,
                                        const Scalar& sin_phi, const Scalar& cos_phi,
                                        const RodAngle<Scalar>& rod) {
    const Scalar r = m.crank_radius;
    const Scalar l = m.rod_length();
    const Scalar& q = rod.d2cos;
    const Scalar& dq = rod.d3cos;

    // x″ of the slider pin, of the rod's middle and of the counterweight, and derivatives
    const Scalar xb = l * q - r * cos_phi;
    const Scalar dxb = l * dq + r * sin_phi;
    const Scalar xc = l * q / 2 - r * cos_phi;
    const Scalar dxc = l * dq / 2 + r * sin_phi;
    const Scalar l2 = m.counterweight_distance;
    const Scalar arm = m.lambda * l2;
    const Scalar x4 = -l2 * q - r * cos_phi;
    const Scalar dx4 = -l2 * dq + r * sin_phi;
    // sin φ cos ψ, of which y″ h is made, and its derivative
    const Scalar sc = sin_phi * rod.cos_psi;
    const Scalar dsc = cos_phi * rod.cos_psi + sin_phi * rod.dcos;

    const Scalar reach = m.slider_mass * xb + m.rod_mass * xc / 2;
    const Scalar dreach = m.slider_mass * dxb + m.rod_mass * dxc / 2;
    const Scalar rod_inertia = m.rod_mass * l * l / 12;
    const Scalar lift = m.rod_mass * r * l / 4;

    const Scalar sign =
        m.counterweight_inertia == CounterweightInertia::as_printed ? Scalar(1) : Scalar(-1);
    const Scalar fall = (r + arm) * l2;
    const Scalar bars = r * sin_phi * reach - rod_inertia * rod.d2psi - lift * sc;
    const Scalar dbars =
        r * (cos_phi * reach + sin_phi * dreach) - rod_inertia * rod.d3psi - lift * dsc;
    const Scalar fourth = m.counterweight_mass * (x4 * arm * sin_phi - fall * sc);
    const Scalar dfourth =
        m.counterweight_mass * ((dx4 * sin_phi + x4 * cos_phi) * arm - fall * dsc);

    RodHingeMoment<Scalar> moment;
    moment.weight = m.gravity * static_moment * rod.cos_psi;
    moment.dweight = m.gravity * static_moment * rod.dcos;
    moment.inertia = bars + sign * fourth;
    moment.true_inertia = bars - fourth;
    moment.dinertia = dbars + sign * dfourth;
    return moment;
}

}  // namespace ravnoves::elastic_hinge
