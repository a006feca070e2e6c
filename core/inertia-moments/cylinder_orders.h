#pragma once

#include <complex>
#include <vector>

#include "inertia-moments/articulated_rods.h"
#include "numerics/harmonics.h"

namespace ravnoves::inertia_moments {

/// Orders of what the moving parts of one cylinder do, by its own crank angle θ, in units of m_j R
/// ω² (forces) and m_j R² ω² (moments). [k] is order k; [0] the mean.
struct CylinderOrders {
    std::vector<Harmonic<double>> along;   ///< force along the cylinder's axis
    std::vector<Harmonic<double>> across;  ///< counter-clockwise; empty without a mass at a knuckle
    std::vector<Harmonic<double>> roll;    ///< moment about the crank axis
    std::vector<Harmonic<double>> torque;  ///< on the crank
};

/// The moving parts of a cylinder, in units of m_j and R.
struct CylinderParts {
    ArticulatedCrank crank;
    double knuckle = 0.0;  ///< mass at the knuckle pin instead of the crankpin
    double couple = 0.0;   ///< inertia of a rod on the crankpin above its two masses'
};

/// Orders of a cylinder by a discrete Fourier transform.
///
/// Forces and moments are what momentum, spin and energy lose by θ: −m a of piston and knuckle pin,
/// its moment, its torque by virtual work, F ds/dφ; the same of the rod's couple with its angle ψ.
/// The samples are of those: they are finite up to locking, where s″ is not.
/// @param motion_at  ArticulatedMotion from sin θ and cos θ
/// @param transform  its length on the crankpin by transform_length(crank.harmonic_decay(), …)
template <typename MotionAt>
CylinderOrders cylinder_orders(const CylinderParts& parts, const MotionAt& motion_at, int max_order,
                               const UniformTransform<double>& transform) {
    using Complex = std::complex<double>;
    const std::size_t n = transform.size();
    std::vector<double> along(n);
    std::vector<double> across(n);
    std::vector<double> spin(n);
    std::vector<double> energy(n);
    for (std::size_t j = 0; j < n; ++j) {
        const double sine = transform.node_sin()[j];
        const double cosine = transform.node_cos()[j];
        const ArticulatedMotion motion = motion_at(sine, cosine);
        const double rate = motion.piston.ds;
        const double swing =
            parts.couple != 0.0 ? parts.crank.master.rod_at(sine, cosine).dpsi : 0.0;
        // Less what the knuckle's mass would have at the crankpin, whose force turns with the crank
        // and has neither moment nor torque.
        const Complex pin = Complex(cosine, sine) + motion.arm;
        const Complex pin_rate = Complex(-sine, cosine) + motion.darm;
        along[j] = rate + parts.knuckle * motion.darm.real();
        across[j] = parts.knuckle * motion.darm.imag();
        spin[j] = parts.couple * swing - parts.crank.offset * rate +
                  parts.knuckle * (std::conj(pin) * pin_rate).imag();
        energy[j] = 0.5 * (rate * rate + parts.couple * swing * swing +
                           parts.knuckle * std::norm(pin_rate));
    }
    const auto lost = [&](const std::vector<double>& values) {
        auto orders = transform.orders(values, max_order);
        double k = 0.0;
        for (Harmonic<double>& order : orders) {
            order = {-k * order.sin, k * order.cos};
            k += 1.0;
        }
        return orders;
    };
    return {lost(along), parts.knuckle > 0.0 ? lost(across) : std::vector<Harmonic<double>>(),
            lost(spin), lost(energy)};
}

/// Exact orders of a cylinder.
inline CylinderOrders exact_cylinder_orders(const CylinderParts& parts, int max_order,
                                            const UniformTransform<double>& transform) {
    return cylinder_orders(
        parts, [&](double sine, double cosine) { return parts.crank.at(sine, cosine); }, max_order,
        transform);
}

/// The paper's two-term force cos θ + Kλ sin θ + λ cos 2θ, with the torque that belongs to it: the
/// product with its own integral (orders 1…4, mean 0). The rod's angle to the same order is
/// ψ = λ(K − sin θ).
inline CylinderOrders two_term_cylinder_orders(double lambda, double relative_offset,
                                               double couple) {
    const double k = relative_offset;
    const double p = k * lambda;
    // The torque: −(cos θ + p sin θ + λ cos 2θ)(sin θ − p cos θ + λ/2 sin 2θ), product by product.
    return {{{}, {1.0, p}, {lambda, 0.0}, {}, {}},
            {},
            {{}, {-k, -k * p - couple * lambda}, {-k * lambda, 0.0}, {}, {}},
            {{},
             {0.25 * p * lambda, 0.25 * lambda},
             {p, -0.5 * (1.0 - p * p) + 0.5 * couple * lambda * lambda},
             {0.75 * p * lambda, -0.75 * lambda},
             {0.0, -0.25 * lambda * lambda}}};
}

}  // namespace ravnoves::inertia_moments
