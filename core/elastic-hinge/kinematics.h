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

}  // namespace ravnoves::elastic_hinge
