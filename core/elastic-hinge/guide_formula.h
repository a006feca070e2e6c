#pragma once

#include <cmath>

namespace ravnoves::elastic_hinge {

/// On which side of its free length the spring works.
enum class Branch {
    compressed,  ///< ρ < ℓ₀/2: minus in (3); the guide is outside the rollers
    stretched,   ///< ρ > ℓ₀/2: plus in (3); the guide is inside the rollers
};

/// Spring and start of a guide.
template <typename Scalar>
struct GuideSpring {
    Scalar stiffness;       ///< c, N/m, > 0
    Scalar free_length;     ///< ℓ₀, m, > 0
    Scalar radius_at_zero;  ///< ρ₀ at φ = 0, m

    /// |ℓ₀/2 − ρ₀|, m
    Scalar preload() const {
        const Scalar d = free_length / 2 - radius_at_zero;
        return d < 0 ? Scalar(-d) : d;
    }
    /// Radius at φ = 0 on a branch, m.
    Scalar start_radius(Branch branch) const {
        const bool given = (radius_at_zero < free_length / 2) == (branch == Branch::compressed);
        return given ? radius_at_zero : Scalar(free_length - radius_at_zero);
    }
};

/// Half the change of the spring's length, |ℓ₀/2 − ρ| = √(d₀² − q), m.
/// @param q  energy that the spring gives out since φ = 0, divided by 2c, m²; at most d₀², else the
/// guide does not exist there (not a number)
template <typename Scalar>
Scalar guide_deflection(const GuideSpring<Scalar>& spring, const Scalar& q) {
    using std::sqrt;
    const Scalar d0 = spring.preload();
    return sqrt(d0 * d0 - q);
}

/// (3), ρ = ℓ₀/2 ∓ √(ℓ₀²/4 − B) with B = ℓ₀ρ₀ − ρ₀² + q, without cancellation:
/// ρ = ρ₀ ± q / (d₀ + √(d₀² − q)).
/// @param q  as above
template <typename Scalar>
Scalar guide_radius(const GuideSpring<Scalar>& spring, Branch branch, const Scalar& q) {
    Scalar start = spring.start_radius(branch);
    if (q == 0) {
        return start;
    }
    const Scalar change = q / (spring.preload() + guide_deflection(spring, q));
    return branch == Branch::compressed ? Scalar(start + change) : Scalar(start - change);
}

}  // namespace ravnoves::elastic_hinge
