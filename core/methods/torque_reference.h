#pragma once

#include <cstddef>
#include <vector>

#include "methods/torque_cycle.h"

namespace ravnoves::methods {

/// Mean, RMS, range and best angle of a torque with a balance shaft in 50 digits, by ways that
/// share no code with the scene: the references of its kernels.
///
/// The spline is written with its second derivatives, which are found by relaxation. Means are
/// Gauss-Legendre sums. Extrema are looked for in every half degree and polished one by one by
/// Newton's method; the best angle is where the slope of the range changes sign, the best place is
/// found by ellipsoids.
class TorqueReference {
  public:
    explicit TorqueReference(const TorqueCycle& cycle);

    struct Means {
        Real50 mean;                  ///< of M_ups
        Real50 rms;                   ///< of M_ups about its mean
        Real50 first_cos, first_sin;  ///< first order of M_up
    };
    Means means() const;
    /// A range, and how it changes with a and b.
    struct Range {
        Real50 range;
        Real50 by_cos, by_sin;
    };
    /// Of M_up + a cos φ + b sin φ.
    Range range(const Real50& a, const Real50& b) const;
    /// Of M_up + A sin(φ + α).
    Range range(const Real50& alpha) const;
    Real50 min_range() const;         ///< over all α
    Real50 min_range_of_all() const;  ///< over all a and b

  private:
    /// The curve between two rows, by the distance t from the left one in degrees.
    template <typename Scalar>
    struct Piece {
        Scalar start, width;  ///< °
        Scalar y0, y1;        ///< N·m
        Scalar bend0, bend1;  ///< second derivatives, N·m/°²

        Scalar value(const Scalar& t) const;
        Scalar slope(const Scalar& t) const;  ///< N·m/°
        Scalar bend(const Scalar& t) const { return bend0 + (bend1 - bend0) * t / width; }
    };
    /// An end of a part of a piece: two ends a part, no more than half a degree apart.
    struct End {
        std::size_t piece;
        double t;  ///< °
        double value, slope, sine, cosine;
    };
    /// What may be the extremum: a row or a place within a piece.
    struct Candidate {
        std::size_t piece;
        bool interior;
        double t;       ///< °
        double height;  ///< value times the sign of the search, N·m
    };
    /// The places that come within a billionth of the size to the largest of ±(M + a cos + b sin).
    std::vector<Candidate> candidates(double a, double b, double sign) const;
    double plain_range(double alpha) const;

    double amplitude_;
    double size_;  ///< that errors are relative to
    Real50 alpha_;
    std::vector<Piece<double>> pieces_;
    std::vector<Piece<Real50>> exact_;
    std::vector<End> ends_;
};

}  // namespace ravnoves::methods
