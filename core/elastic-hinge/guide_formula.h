#pragma once

#include <cmath>

namespace ravnoves::elastic_hinge {

/// On which side of its free length the spring works.
enum class Branch {
    compressed,  ///< ρ < ℓ₀/2: minus in (3); the guide lies outside the rollers
    stretched,   ///< ρ > ℓ₀/2: plus in (3); the guide lies inside the rollers
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

/// (3) as it is printed: ρ = ℓ₀/2 ∓ √(ℓ₀²/4 − B), B = ℓ₀ρ₀ − ρ₀² + q.
///
/// Loses digits where B is small against ℓ₀²/4 and where the spring is little deflected; kept for
/// comparison with guide_radius().
/// @param q  energy that the spring gives out since φ = 0, divided by 2c, m²
template <typename Scalar>
Scalar guide_radius_printed(const GuideSpring<Scalar>& spring, Branch branch, const Scalar& q) {
    using std::sqrt;
    const Scalar l = spring.free_length;
    const Scalar rho = spring.radius_at_zero;
    const Scalar B = l * rho - rho * rho + q;
    const Scalar root = sqrt(l * l / 4 - B);
    return branch == Branch::compressed ? Scalar(l / 2 - root) : Scalar(l / 2 + root);
}

/// Half the change of the spring's length, |ℓ₀/2 − ρ| = √(d₀² − q), m.
/// @param q  as above; at most d₀², else the guide does not exist there (not a number)
template <typename Scalar>
Scalar guide_deflection(const GuideSpring<Scalar>& spring, const Scalar& q) {
    using std::sqrt;
    const Scalar d0 = spring.preload();
    return sqrt(d0 * d0 - q);
}

/// The same radius as (3) without cancellation: ρ = ρ₀ ± q / (d₀ + √(d₀² − q)).
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

/// Right-hand side of (2) as an equation for ρ: dρ/dφ = m / (2c (ℓ₀ − 2ρ)). Singular where
/// ρ → ℓ₀/2.
/// @param moment  of the hinge on the crank, N·m: M for the energy sign, −M as printed
template <typename Scalar>
Scalar guide_slope_ode(const GuideSpring<Scalar>& spring, const Scalar& rho, const Scalar& moment) {
    return moment / (2 * spring.stiffness * (spring.free_length - 2 * rho));
}

}  // namespace ravnoves::elastic_hinge
