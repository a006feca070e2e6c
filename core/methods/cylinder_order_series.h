#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "inertia-moments/cylinder_orders.h"

namespace ravnoves::methods {

/// Orders of one cylinder without sampling: √(1 − λ²(sin θ − K)²) as a binomial series whose powers
/// are multiplied out in e^{iθ}.
///
/// Exact in the limit of many terms for λ (1 + |K|) < 1; the terms fall as (λ (1 + |K|))^(2n).
/// @param crank  in units of R
/// @param terms  ≥ 1, powers λ², λ⁴ … λ^(2 terms)
template <typename Scalar>
inertia_moments::CylinderOrders<Scalar> series_cylinder_orders(const SliderCrank<Scalar>& crank,
                                                               int max_order, int terms) {
    const Scalar lambda = crank.lambda();
    const Scalar K = crank.relative_offset();
    // A polynomial in e^{iθ} by orders −top…top. Of a real function: only 0…top are kept, as
    // a_k cos kθ + b_k sin kθ.
    const auto top = 2 * static_cast<std::size_t>(terms);
    std::vector<Scalar> a(top + 3, Scalar(0));
    std::vector<Scalar> b(top + 3, Scalar(0));
    a[0] = Scalar(1);
    std::vector<Scalar> root_cos(top + 3, Scalar(0));
    std::vector<Scalar> root_sin(top + 3, Scalar(0));
    std::vector<Scalar> next_a(top + 3, Scalar(0));
    std::vector<Scalar> next_b(top + 3, Scalar(0));
    Scalar factor(1);
    std::size_t filled = 0;  // highest order so far
    for (int n = 1; n <= terms; ++n) {
        factor *= Scalar(2 * n - 3) / Scalar(2 * n);
        for (int twice = 0; twice < 2; ++twice) {
            // × λ (sin θ − K): sin θ cos kθ = (sin (k+1)θ − sin (k−1)θ)/2 and likewise.
            const Scalar half = lambda / Scalar(2);
            const Scalar shift = -lambda * K;
            for (std::size_t k = 0; k <= filled + 1; ++k) {
                next_a[k] = shift * a[k];
                next_b[k] = shift * b[k];
            }
            next_b[1] += half * a[0] * Scalar(2);
            for (std::size_t k = 1; k <= filled; ++k) {
                next_b[k + 1] += half * a[k];
                next_a[k + 1] -= half * b[k];
                next_a[k - 1] += half * b[k];
                if (k > 1) {
                    next_b[k - 1] -= half * a[k];
                }
            }
            ++filled;
            std::swap(a, next_a);
            std::swap(b, next_b);
        }
        for (std::size_t k = 0; k <= filled; ++k) {
            root_cos[k] += factor * a[k];
            root_sin[k] += factor * b[k];
        }
    }
    // s = cos θ + (1 + root)/λ, derivatives order by order.
    const std::size_t count = top + 1;
    std::vector<Scalar> ds_cos(count, Scalar(0));
    std::vector<Scalar> ds_sin(count, Scalar(0));
    std::vector<Scalar> d2_cos(count, Scalar(0));
    std::vector<Scalar> d2_sin(count, Scalar(0));
    for (std::size_t k = 1; k < count; ++k) {
        const Scalar order(static_cast<int>(k));
        const Scalar c = root_cos[k] / lambda + Scalar(k == 1 ? 1 : 0);
        const Scalar s = root_sin[k] / lambda;
        ds_cos[k] = order * s;
        ds_sin[k] = -order * c;
        d2_cos[k] = -order * order * c;
        d2_sin[k] = -order * order * s;
    }
    inertia_moments::CylinderOrders<Scalar> result;
    const auto wanted = static_cast<std::size_t>(max_order) + 1;
    result.force.resize(wanted);
    result.torque.resize(wanted);
    for (std::size_t k = 0; k < wanted && k < count; ++k) {
        result.force[k] = {-d2_cos[k], -d2_sin[k]};
    }
    // −s″ s′ order by order: products of orders whose sum or difference is k.
    for (std::size_t i = 1; i < count; ++i) {
        const auto add = [&](std::size_t j) {
            if (j < 1 || j >= count) {
                return;
            }
            const Scalar cc = d2_cos[i] * ds_cos[j];
            const Scalar ss = d2_sin[i] * ds_sin[j];
            const Scalar cs = d2_cos[i] * ds_sin[j];
            const Scalar sc = d2_sin[i] * ds_cos[j];
            const std::size_t sum = i + j;
            if (sum < wanted) {
                result.torque[sum].cos -= (cc - ss) / Scalar(2);
                result.torque[sum].sin -= (cs + sc) / Scalar(2);
            }
            const std::size_t difference = i > j ? i - j : j - i;
            if (difference < wanted) {
                result.torque[difference].cos -= (cc + ss) / Scalar(2);
                const Scalar sine = (i > j ? sc - cs : cs - sc) / Scalar(2);
                result.torque[difference].sin -= difference == 0 ? Scalar(0) : sine;
            }
        };
        // Every j whose sum or difference with i is wanted, once.
        const std::size_t from = i + 1 > wanted ? i + 1 - wanted : 1;
        for (std::size_t j = from; j < i + wanted; ++j) {
            add(j);
        }
    }
    return result;
}

}  // namespace ravnoves::methods
