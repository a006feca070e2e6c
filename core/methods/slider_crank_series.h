#pragma once

#include "numerics/slider_crank.h"

namespace ravnoves::methods {

/// The piston's motion with the rod's root as a binomial series:
/// √(1 − w²) ≈ 1 − w²/2 − w⁴/8 − …, w = λ (sin θ − K). Two terms are the form of
/// [chainov-vallejo-maldonado], with the constants that it leaves out of s.
///
/// Converges for λ (1 + |K|) < 1, the slower the nearer; the first term left out is of the order
/// (λ (1 + |K|))^(2 terms).
template <typename Scalar>
struct SeriesSliderCrank {
    SliderCrank<Scalar> crank;
    int terms;  ///< ≥ 2, the constant among them

    PistonMotion<Scalar> at(const Scalar& sin_theta, const Scalar& cos_theta) const {
        const Scalar lambda = crank.lambda();
        const Scalar w = lambda * (sin_theta - crank.relative_offset());
        const Scalar square = w * w;
        // f = Σ b_k w^(2k) with its first and second derivative by w.
        Scalar f(1);
        Scalar df(0);
        Scalar d2f(0);
        Scalar b(1);
        Scalar power(1);  // w^(2k − 2)
        for (int k = 1; k < terms; ++k) {
            b *= Scalar(2 * k - 3) / Scalar(2 * k);
            d2f += b * Scalar(2 * k) * Scalar(2 * k - 1) * power;
            df += b * Scalar(2 * k) * power * w;
            power *= square;
            f += b * power;
        }
        const Scalar r = crank.crank_radius;
        const Scalar dw = lambda * cos_theta;
        const Scalar d2w = -lambda * sin_theta;
        const Scalar l = crank.rod_length;
        return {r * cos_theta + l * f, -r * sin_theta + l * df * dw,
                -r * cos_theta + l * (d2f * dw * dw + df * d2w)};
    }
};

}  // namespace ravnoves::methods
