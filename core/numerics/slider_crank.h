#pragma once

#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <optional>

namespace ravnoves {

/// Piston position and its derivatives by the crank angle.
template <typename Scalar>
struct PistonMotion {
    Scalar s;    ///< distance of the piston pin from the crank axis along the cylinder axis, m
    Scalar ds;   ///< ds/dθ, m
    Scalar d2s;  ///< d²s/dθ², m
};

/// Angle of the rod against the cylinder axis (from crankpin to piston pin, positive as θ is) and
/// its derivatives by the crank angle.
template <typename Scalar>
struct RodSwing {
    Scalar psi;    ///< ψ, rad
    Scalar dpsi;   ///< dψ/dθ
    Scalar d2psi;  ///< d²ψ/dθ²
};

/// Where a crank that cannot turn round stops, on both sides of top dead centre.
template <typename Scalar>
struct LockingAngles {
    Scalar forward;   ///< first angle that cannot be passed turning in the positive direction, rad
    Scalar backward;  ///< the same turning in the negative direction, rad (below `forward`)
};

/// Slider-crank mechanism with an offset cylinder axis.
///
/// s(θ) = R cos θ + √(L² − (R sin θ − e)²), θ from the cylinder axis, positive in the direction of
/// rotation; e is positive on the side to which the crankpin moves first. Source:
/// [chainov-vallejo-maldonado] (exact position of the piston pin); e = 0 is the centred mechanism.
///
/// Scale-free: lengths in any one unit; SliderCrank{1, 1/λ, K} gives s/R.
template <typename Scalar>
struct SliderCrank {
    Scalar crank_radius;        ///< R, m, > 0
    Scalar rod_length;          ///< L, m, > R + |e| (else the mechanism locks)
    Scalar offset = Scalar(0);  ///< e, m

    Scalar lambda() const { return crank_radius / rod_length; }
    Scalar relative_offset() const { return offset / crank_radius; }  ///< K = e/R

    /// True where the crank cannot turn round: λ(1 + |K|) ≥ 1, that is L ≤ R + |e|. At equality
    /// the crank passes, but s″ is infinite where the rod is across the cylinder.
    bool locks() const {
        using std::abs;
        return !(rod_length > crank_radius + abs(offset));
    }

    /// θ at top dead centre: crank and rod in line, sin θ = e/(R + L) = λK/(1 + λ), by
    /// [chainov-vallejo-maldonado]. Needs |e| ≤ R + L.
    Scalar top_dead_centre() const {
        using std::asin;
        return asin(Scalar(offset / (crank_radius + rod_length)));
    }

    /// θ at bottom dead centre: crank folded over the rod, θ = π + arcsin(e/(L − R)). Needs a
    /// mechanism that does not lock.
    Scalar bottom_dead_centre() const {
        using std::asin;
        return boost::math::constants::pi<Scalar>() +
               asin(Scalar(offset / (rod_length - crank_radius)));
    }

    /// s at top less s at bottom dead centre, √((L + R)² − e²) − √((L − R)² − e²), m; 2R where
    /// e = 0. Needs a mechanism that does not lock.
    Scalar stroke() const {
        using std::sqrt;
        const Scalar top =
            sqrt((rod_length + crank_radius - offset) * (rod_length + crank_radius + offset));
        const Scalar bottom =
            sqrt((rod_length - crank_radius - offset) * (rod_length - crank_radius + offset));
        // The difference of the squares is 4RL: no cancellation for long rods.
        return Scalar(4) * crank_radius * rod_length / (top + bottom);
    }

    /// The angles at which a mechanism that locks() stops with its rod across the cylinder,
    /// |R sin θ − e| = L, on both sides of top dead centre; empty where it does not lock or where
    /// the parts cannot be joined at all (|e| > R + L).
    std::optional<LockingAngles<Scalar>> locking_angles() const {
        using std::abs;
        using std::asin;
        if (!locks() || abs(offset) > crank_radius + rod_length) {
            return std::nullopt;
        }
        const Scalar pi = boost::math::constants::pi<Scalar>();
        // For e ≥ 0; e < 0 is its mirror image. R sin θ rises to e + L (if the crank reaches so
        // far) and falls to e − L.
        const Scalar e = abs(offset);
        const Scalar low = asin(Scalar((e - rod_length) / crank_radius));
        const Scalar reach = (e + rod_length) / crank_radius;
        const Scalar high = reach <= Scalar(1) ? Scalar(asin(reach)) : Scalar(pi - low);
        if (offset < Scalar(0)) {
            return LockingAngles<Scalar>{-low, -high};
        }
        return LockingAngles<Scalar>{high, low};
    }

    /// Distance in the complex plane, |Im θ|, from the real axis to the nearest branch point of
    /// s(θ): arcosh(1/λ − |K|). The Fourier coefficients of s and of its derivatives fall as
    /// exp(−k·decay), so it sets the length of a discrete Fourier transform. 0 where it locks.
    Scalar harmonic_decay() const {
        using std::abs;
        using std::log1p;
        using std::sqrt;
        if (locks()) {
            return Scalar(0);
        }
        // arcosh(1 + m) with m = (L − R − |e|)/R taken directly: exact near locking.
        const Scalar m = ((rod_length - crank_radius) - abs(offset)) / crank_radius;
        return log1p(Scalar(m + sqrt(m * (m + Scalar(2)))));
    }

    /// Position and derivatives from sin θ and cos θ. The mechanism must not lock.
    PistonMotion<Scalar> at(const Scalar& sin_theta, const Scalar& cos_theta) const {
        using std::sqrt;
        const Scalar x = crank_radius * cos_theta;           // along the cylinder axis
        const Scalar y = crank_radius * sin_theta - offset;  // across it
        const Scalar root = sqrt((rod_length - y) * (rod_length + y));
        const Scalar t = y / root;  // tangent of the rod's angle
        // root' = −y y'/root with y' = x; root'' by differentiating once more, y'' = −R sin θ.
        const Scalar& dy = x;
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

    /// Angle of the rod, sin ψ = −(R sin θ − e)/L, and its derivatives from sin θ and cos θ. The
    /// mechanism must not lock.
    RodSwing<Scalar> rod_at(const Scalar& sin_theta, const Scalar& cos_theta) const {
        using std::asin;
        using std::sqrt;
        const Scalar x = crank_radius * cos_theta;
        const Scalar y = crank_radius * sin_theta - offset;
        const Scalar root = sqrt((rod_length - y) * (rod_length + y));
        const Scalar t = y / root;
        const Scalar dpsi = -x / root;
        // d/dθ(−x/root) with x' = −R sin θ and root' = −t x.
        const Scalar d2psi = (crank_radius * sin_theta - x * x * t / root) / root;
        return {-asin(Scalar(y / rod_length)), dpsi, d2psi};
    }

    RodSwing<Scalar> rod_at(const Scalar& theta) const {
        using std::cos;
        using std::sin;
        return rod_at(Scalar(sin(theta)), Scalar(cos(theta)));
    }
};

}  // namespace ravnoves
