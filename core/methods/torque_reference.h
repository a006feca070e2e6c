#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "methods/torque_cycle.h"

namespace ravnoves::methods {

/// Mean, RMS, range and best angle of a torque with a balance shaft in 50 digits, by ways that
/// share no code with the scene: the references of its kernels.
///
/// The spline is written with its second derivatives, which are found by relaxation. The mean
/// square is that of the pieces' basis functions; the sine's part is integrated by parts until
/// only jumps at the rows are left. Extrema are looked for in every degree and polished one by one
/// by Newton's method. The best angle is where the two branches of the range that rise from it
/// cross, or where the branch that it lies on is flat.
class TorqueReference {
  public:
    explicit TorqueReference(const TorqueCycle& cycle);

    Real50 mean() const;                           ///< of M_ups
    Real50 rms() const;                            ///< of M_ups about its mean, at the cycle's α
    BasicFourierPair<Real50> first_order() const;  ///< of M_up, by cos φ and sin φ
    Real50 range(const Real50& alpha) const;       ///< of M_ups
    Real50 least_range() const;                    ///< over all α
    /// Over all α and all amplitudes. In double by the method of ellipses; then the extrema that
    /// are of one height there and their weights, which hold each other at rest, in 50 digits.
    Real50 least_range_of_all() const;
    /// Of M + a cos φ + b sin φ.
    Real50 range(const Real50& a, const Real50& b) const;

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
    /// A part of a piece no longer than a degree.
    struct Cell {
        std::size_t piece;
        double from, to;   ///< t, °
        double curvature;  ///< largest second derivative of curve and sine, N·m/°²
    };
    /// What may be the extremum: a row or a place within a piece.
    struct Candidate {
        std::size_t piece;
        bool interior;
        double t;       ///< °
        double height;  ///< value times the sign of the search, N·m
    };
    struct Extremum {
        std::size_t piece = 0;
        bool interior = false;
        Real50 t;      ///< °
        Real50 value;  ///< N·m
        Real50 slope;  ///< by α, N·m

        bool is_branch_of(const Extremum& other) const {
            return piece == other.piece && interior == other.interior;
        }
    };
    /// The range at an angle, and the places that make it.
    struct At {
        Real50 alpha;
        Extremum high, low;
        Real50 range() const { return high.value - low.value; }
        Real50 slope() const { return high.slope - low.slope; }
    };

    /// @param margin  how much below the highest one they may be, part of the size
    std::vector<Candidate> candidates(double alpha, double sign, double margin = 1e-9) const;
    void look_within(const Cell& cell, double alpha, double sign, double enough,
                     std::vector<Candidate>& found) const;
    double height(const Cell& cell, double t, double alpha, double sign) const;
    double plain_range(double alpha) const;
    double plain_slope(double alpha) const;
    Extremum extremum(const Real50& alpha, double sign) const;
    /// The same branch at another angle.
    Extremum followed(Extremum extremum, const Real50& alpha) const;
    At at(const Real50& alpha) const;
    At followed(const At& branch, const Real50& alpha) const;
    /// Where the branches of two angles meet, or where a common one is flat.
    Real50 lowest(const At& left, const At& right) const;
    Real50 least_between(double from, double to) const;

    /// The same torque with another shaft.
    void set_amplitude(double amplitude);
    /// Where the maxima and minima at rest with one another, these, have their range: nothing where
    /// they do not hold each other.
    std::optional<Real50> range_at_rest(const std::vector<Candidate>& high,
                                        const std::vector<Candidate>& low, double a,
                                        double b) const;

    bool cubic_;
    double amplitude_;
    double size_;  ///< that errors are relative to
    Real50 alpha_;
    std::vector<Piece<double>> pieces_;
    std::vector<Piece<Real50>> exact_;
    std::vector<Cell> cells_;
    std::vector<double> start_, sine_, cosine_;  ///< of M and of the angle, at each cell's start
};

}  // namespace ravnoves::methods
