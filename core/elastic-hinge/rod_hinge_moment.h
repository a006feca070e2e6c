#pragma once

#include <boost/math/special_functions/ellint_2.hpp>

#include "elastic-hinge/kinematics.h"
#include "elastic-hinge/mechanism.h"
#include "numerics/constants.h"

namespace ravnoves::elastic_hinge {

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

/// ∮ M₁₂ dφ, J: the inertia part is odd in φ, the weights leave g × static moment × ∮ cos ψ dφ,
/// which is 4 E(λ) exactly and 2π (1 − λ²/4) for the series. Independent of ω.
inline double rod_hinge_integral(const Mechanism<double>& m, double static_moment,
                                 Kinematics kinematics) {
    const double cosine = kinematics == Kinematics::exact
                              ? 4.0 * boost::math::ellint_2(m.lambda)
                              : two_pi * (1.0 - 0.25 * m.lambda * m.lambda);
    return m.gravity * static_moment * cosine;
}

}  // namespace ravnoves::elastic_hinge
