#pragma once

#include <vector>

#include "numerics/harmonics.h"
#include "numerics/slider_crank.h"

namespace ravnoves::inertia_moments {

/// Orders of what the moving parts of one cylinder do, by its own crank angle θ, in units of m_j R
/// ω² (forces) and m_j R² ω² (moments). [k] is order k; [0] the mean.
struct CylinderOrders {
    std::vector<Harmonic<double>> along;   ///< force along the cylinder's axis, −s″/R
    std::vector<Harmonic<double>> across;  ///< counter-clockwise; empty on a rod on the crankpin
    std::vector<Harmonic<double>> roll;    ///< moment about the crank axis
    std::vector<Harmonic<double>> torque;  ///< on the crank
};

inline std::vector<Harmonic<double>> scaled(std::vector<Harmonic<double>> orders, double factor) {
    for (Harmonic<double>& order : orders) {
        order = {factor * order.cos, factor * order.sin};
    }
    return orders;
}

/// Exact orders of a cylinder with a rod on the crankpin, by a discrete Fourier transform.
///
/// Forces and moments are what momentum, spin and energy lose by θ: −m_j s̈, its moment by the
/// offset, its torque by virtual work, F ds/dφ; the same of the rod's couple with its angle ψ. The
/// samples are of those: they are finite up to locking, where s″ is not.
/// @param crank     in units of R: {1, 1/λ, K}; must not lock
/// @param couple    of the rod, in units of m_j R²
/// @param transform its length by transform_length(crank.harmonic_decay(), …)
inline CylinderOrders exact_cylinder_orders(const SliderCrank<double>& crank, double couple,
                                            int max_order,
                                            const UniformTransform<double>& transform) {
    const std::size_t n = transform.size();
    std::vector<double> momentum(n);
    std::vector<double> spin(n);
    std::vector<double> energy(n);
    for (std::size_t j = 0; j < n; ++j) {
        const double sine = transform.node_sin()[j];
        const double cosine = transform.node_cos()[j];
        const double rate = crank.at(sine, cosine).ds;
        const double swing = couple != 0.0 ? crank.rod_at(sine, cosine).dpsi : 0.0;
        momentum[j] = rate;
        spin[j] = couple * swing - crank.offset * rate;
        energy[j] = 0.5 * (rate * rate + couple * swing * swing);
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
    CylinderOrders result{lost(momentum), {}, {}, lost(energy)};
    result.roll = couple != 0.0 ? lost(spin) : scaled(result.along, -crank.offset);
    return result;
}

/// The paper's two-term force cos θ + Kλ sin θ + λ cos 2θ, with the torque that belongs to it: the
/// product with its own integral (orders 1…4, mean 0). The rod's angle to the same order is
/// ψ = λ(K − sin θ).
inline CylinderOrders two_term_cylinder_orders(double lambda, double relative_offset,
                                               double couple) {
    const double p = relative_offset * lambda;
    CylinderOrders result;
    result.along = {{0.0, 0.0}, {1.0, p}, {lambda, 0.0}, {0.0, 0.0}, {0.0, 0.0}};
    result.roll = scaled(result.along, -relative_offset);
    result.roll[1].sin -= couple * lambda;
    // −(cos θ + p sin θ + λ cos 2θ)(sin θ − p cos θ + λ/2 sin 2θ), product by product.
    result.torque = {{0.0, 0.0},
                     {0.25 * p * lambda, 0.25 * lambda},
                     {p, -0.5 * (1.0 - p * p) + 0.5 * couple * lambda * lambda},
                     {0.75 * p * lambda, -0.75 * lambda},
                     {0.0, -0.25 * lambda * lambda}};
    return result;
}

}  // namespace ravnoves::inertia_moments
