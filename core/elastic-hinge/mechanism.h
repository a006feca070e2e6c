#pragma once

namespace ravnoves::elastic_hinge {

/// How the rod's angle is computed.
enum class Kinematics {
    exact,   ///< cos ψ = √(1 − λ² sin² φ), λ < 1
    series,  ///< the paper's cos ψ ≈ 1 − λ²/4 + (λ²/4) cos 2φ, good for small λ only
};

/// The signs of the counterweight's inertia forces in M₁₂.
///
/// The counterweight is on the other side of A than the slider, so the moments of its weight and of
/// its inertia force about A both change sign; equation (9) changes only the weight's. With (9) as
/// printed the side force is not zero. A sign of the hinge's moment changes no force without the
/// hinge.
enum class CounterweightInertia {
    as_printed,    ///< (9): + (P₄/g) ẍ₄ h₆ + (P₄/g) ÿ₄ h₅
    newton_euler,  ///< − (P₄/g) ẍ₄ h₆ − (P₄/g) ÿ₄ h₅, as moments about A demand
};

/// Masses and sizes of the slider-crank mechanism; crank and rod are uniform bars.
///
/// A template over the scalar so that references in 50 digits run the same formulas.
template <typename Scalar>
struct Mechanism {
    Scalar crank_mass;                          ///< P₁/g, kg
    Scalar rod_mass;                            ///< P₂/g, kg
    Scalar slider_mass;                         ///< P₃/g, kg
    Scalar gravity;                             ///< g, m/s²
    Scalar crank_radius;                        ///< r, m
    Scalar lambda;                              ///< r/ℓ
    Scalar counterweight_mass = Scalar(0);      ///< P₄/g, kg
    Scalar counterweight_distance = Scalar(0);  ///< ℓ₂ beyond A, m
    CounterweightInertia counterweight_inertia = CounterweightInertia::newton_euler;

    bool has_counterweight() const { return counterweight_distance > 0; }
    Scalar rod_length() const { return crank_radius / lambda; }  ///< ℓ, m
    /// Moment of the weights of rod, slider and counterweight about A at ψ = 0, divided by g, kg·m:
    /// (m₃ + m₂/2) ℓ − m₄ ℓ₂. Equation (10) makes it zero.
    Scalar static_moment() const {
        return (slider_mass + rod_mass / 2) * rod_length() -
               counterweight_mass * counterweight_distance;
    }
    /// (10): the counterweight's mass that makes the integral of M₁₂ zero, kg.
    Scalar balancing_mass() const {
        return (slider_mass + rod_mass / 2) * rod_length() / counterweight_distance;
    }
};

}  // namespace ravnoves::elastic_hinge
