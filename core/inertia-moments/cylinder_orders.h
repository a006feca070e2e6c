#pragma once

#include <complex>
#include <vector>

#include "numerics/harmonics.h"
#include "numerics/slider_crank.h"

namespace ravnoves::inertia_moments {

/// Orders of one cylinder by its own crank angle θ, in units of m_j R ω² (force), m_j R² ω²
/// (torque) and ΔJ ω² (the rod's couple). [k] is order k; [0] the mean.
template <typename Scalar>
struct CylinderOrders {
    std::vector<Harmonic<Scalar>> force;       ///< −s″/R, along the cylinder's axis
    std::vector<Harmonic<Scalar>> torque;      ///< −s″ s′/R², of that force on the crank
    std::vector<Harmonic<Scalar>> rod_roll;    ///< −ψ″, moment of the rod's couple
    std::vector<Harmonic<Scalar>> rod_torque;  ///< −ψ″ ψ′, of that couple on the crank
};

/// For a cylinder with an articulated rod also the orders of a mass at its knuckle pin instead of
/// the crankpin, in units of m_k R ω² and m_k R² ω², without the crankpin's own.
struct ArticulatedOrders : CylinderOrders<double> {
    std::vector<Harmonic<double>> knuckle_along;   ///< along the cylinder's axis
    std::vector<Harmonic<double>> knuckle_across;  ///< across it, counter-clockwise
    std::vector<Harmonic<double>> knuckle_roll;    ///< moment about the crank axis
    std::vector<Harmonic<double>> knuckle_torque;  ///< on the crank
};

/// Exact orders by a discrete Fourier transform.
///
/// The force is −m_j s̈; its torque on the crank follows from virtual work, F ds/dφ. For the couple
/// ΔJ the same with the rod's angle ψ. The samples are s′ and s′²/2, whose derivatives these are:
/// they are finite up to locking, where s″ is not.
/// @param crank     in units of R: {1, 1/λ, K}; must not lock
/// @param transform its length by transform_length(crank.harmonic_decay(), …)
/// @param rod       also the rod's couple; else its two lists stay empty
inline CylinderOrders<double> exact_cylinder_orders(const SliderCrank<double>& crank, int max_order,
                                                    const UniformTransform<double>& transform,
                                                    bool rod) {
    const std::size_t n = transform.size();
    std::vector<double> rate(n);
    std::vector<double> half_square(n);
    const auto minus_derivative = [&](const std::vector<double>& values) {
        auto orders = transform.orders(values, max_order);
        double k = 0.0;
        for (Harmonic<double>& order : orders) {
            order = {-k * order.sin, k * order.cos};
            k += 1.0;
        }
        return orders;
    };
    const auto sample = [&](const auto& rate_at) {
        for (std::size_t j = 0; j < n; ++j) {
            rate[j] = rate_at(transform.node_sin()[j], transform.node_cos()[j]);
            half_square[j] = 0.5 * rate[j] * rate[j];
        }
    };
    CylinderOrders<double> result;
    sample([&](double sine, double cosine) { return crank.at(sine, cosine).ds; });
    result.force = minus_derivative(rate);
    result.torque = minus_derivative(half_square);
    if (rod) {
        sample([&](double sine, double cosine) { return crank.rod_at(sine, cosine).dpsi; });
        result.rod_roll = minus_derivative(rate);
        result.rod_torque = minus_derivative(half_square);
    }
    return result;
}

/// The paper's two-term force cos θ + Kλ sin θ + λ cos 2θ, with the torque that belongs to it: the
/// product with its own integral (orders 1…4, mean 0). The rod's angle to the same order is
/// ψ = λ(K − sin θ).
template <typename Scalar>
CylinderOrders<Scalar> two_term_cylinder_orders(const Scalar& lambda, const Scalar& relative_offset,
                                                bool rod) {
    const Scalar p = relative_offset * lambda;
    const Scalar quarter = Scalar(1) / Scalar(4);
    const Scalar zero(0);
    CylinderOrders<Scalar> result;
    result.force = {{zero, zero}, {Scalar(1), p}, {lambda, zero}, {zero, zero}, {zero, zero}};
    // −(cos θ + p sin θ + λ cos 2θ)(sin θ − p cos θ + λ/2 sin 2θ), product by product.
    result.torque = {{zero, zero},
                     {p * lambda * quarter, lambda * quarter},
                     {p, -(Scalar(1) - p * p) / Scalar(2)},
                     {Scalar(3) * p * lambda * quarter, -Scalar(3) * lambda * quarter},
                     {zero, -lambda * lambda * quarter}};
    if (rod) {
        result.rod_roll = {{zero, zero}, {zero, -lambda}, {zero, zero}, {zero, zero}, {zero, zero}};
        result.rod_torque = {{zero, zero},
                             {zero, zero},
                             {zero, lambda * lambda / Scalar(2)},
                             {zero, zero},
                             {zero, zero}};
    }
    return result;
}

}  // namespace ravnoves::inertia_moments
