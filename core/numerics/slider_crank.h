#pragma once

#include <cmath>

namespace ravnoves {

/// Piston position and its derivatives by the crank angle.
template <typename Scalar>
struct PistonMotion {
    Scalar s;    ///< distance of the piston pin from the crank axis along the cylinder axis, m
    Scalar ds;   ///< ds/dθ, m
    Scalar d2s;  ///< d²s/dθ², m
};

/// Slider-crank mechanism with an offset cylinder axis.
///
/// s(θ) = R cos θ + √(L² − (R sin θ − e)²), θ from the cylinder axis, positive in the direction of
/// rotation; e is positive on the side to which the crankpin moves first. Source: Chainov and
/// Vallejo Maldonado 2020 (exact position of the piston pin); e = 0 is the centred mechanism.
///
/// A template so that the 50-digit references run the same code.
template <typename Scalar>
struct SliderCrank {
    Scalar crank_radius;        ///< R, m, > 0
    Scalar rod_length;          ///< L, m, > R + |e| (else the mechanism locks)
    Scalar offset = Scalar(0);  ///< e, m

    Scalar lambda() const { return crank_radius / rod_length; }
    Scalar relative_offset() const { return offset / crank_radius; }  ///< K = e/R

    /// Position and derivatives from sin θ and cos θ.
    PistonMotion<Scalar> at(const Scalar& sin_theta, const Scalar& cos_theta) const {
        using std::sqrt;
        const Scalar x = crank_radius * cos_theta;           // along the cylinder axis
        const Scalar y = crank_radius * sin_theta - offset;  // across it
        const Scalar root = sqrt((rod_length - y) * (rod_length + y));
        const Scalar t = y / root;  // tangent of the rod's angle
        // root' = −y y'/root with y' = x; root'' by differentiating once more, y'' = −R sin θ.
        const Scalar dy = x;
        const Scalar d2y = -crank_radius * sin_theta;
        const Scalar droot = -t * dy;
        const Scalar d2root = -(dy * dy * (Scalar(1) + t * t) / root + t * d2y);
        return {x + root, -crank_radius * sin_theta + droot, -x + d2root};
    }

    PistonMotion<Scalar> at(const Scalar& theta) const {
        using std::cos;
        using std::sin;
        return at(Scalar(sin(theta)), Scalar(cos(theta)));
    }
};

}  // namespace ravnoves
