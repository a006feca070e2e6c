#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "balance-shaft/knot_stretches.h"
#include "numerics/periodic_piecewise.h"

namespace ravnoves::balance_shaft {

/// The exact extrema of M(φ) + a cos φ + b sin φ over the cycle for one M, piecewise linear or
/// cubic with a period of 720° or 360°, and any (a, b): one preparation for the whole plane.
///
/// As in CycleExtrema the revolutions are folded at the union of their knots, and only intervals
/// with an end near the best are searched within; no interval is longer than 15°, so that the sine
/// in it is a short series and Newton's method finds the one place where a concave stretch is flat.
class MomentPlane {
  public:
    explicit MomentPlane(const PeriodicPiecewise& moment);

    /// A place φ of the cycle and what stands there.
    struct Place {
        double value = 0.0;   ///< M(φ) + a cos φ + b sin φ, N·m
        double moment = 0.0;  ///< M(φ), N·m
        double cos = 1.0;     ///< of φ
        double sin = 0.0;
    };
    struct Extrema {
        Place max;
        Place min;
        double range() const { return max.value - min.value; }
    };

    Extrema operator()(double a, double b) const;

    /// The ranges over a grid, element row × columns + column: the column moves by `along`, the row
    /// by `across`. Tile by tile: only knots that can hold an extremum somewhere in a tile are
    /// looked at in it.
    struct Grid {
        std::array<double, 2> origin{}, along{}, across{};  ///< (a, b), N·m
        std::size_t columns = 0, rows = 0;
    };
    std::vector<double> ranges(const Grid& grid) const;

  private:
    /// ±M between two folded knots in one revolution: of the angle from the left knot, rad.
    struct Branch {
        PiecewiseCubic<double> cubic;
        double last = 0.0;   ///< value at the right knot
        double above = 0.0;  ///< most that it lies above its chord
        std::size_t interval = 0;
    };
    /// What the search for the maximum of ±M needs.
    struct Side {
        std::vector<Branch> branches;  ///< of each interval, one for each turn of the cycle
        Eigen::ArrayXd peak;           ///< the higher branch at each knot, padded to whole blocks
        Eigen::ArrayXd above;  ///< most that the intervals beside a knot lie above their chords
        Eigen::ArrayXd block_above;
        std::vector<double> stretch_peak, stretch_above;
    };
    struct Vector {
        double a;
        double b;
        double size;
        double slack;  ///< rounding of a value
    };
    Vector vector(double a, double b) const;

    void prepare(const PeriodicPiecewise& moment);
    Place highest(const Side& side, const Vector& at) const;
    Place highest_of_many(const Side& side, const Vector& at) const;
    double block_top(const Side& side, const Vector& at, Eigen::Index block) const;
    struct Search;
    void search_block(const Side& side, const Vector& at, Eigen::Index block, double block_top,
                      Search& search) const;
    void search_branch(const Branch& branch, const Vector& at, Place& best) const;
    void add_tile(const Side& side, const Grid& grid, std::size_t column, std::size_t row,
                  std::vector<double>& ranges) const;

    std::size_t turns_ = 1;        ///< of the crank in a cycle
    std::size_t count_ = 0;        ///< folded knots
    std::vector<double> knot_;     ///< rad; count_ + 1
    Eigen::ArrayXd cos_, sin_;     ///< of the knots, padded with copies of the first
    std::vector<double> chord_;    ///< h²/8 of each interval: a sine's most above its chord
    Eigen::ArrayXd chord_beside_;  ///< the larger of those beside a knot, padded
    Eigen::ArrayXd block_chord_;
    KnotStretches stretches_;  ///< none where the knots are few
    std::vector<double> stretch_chord_;
    Side up_;
    Side down_;
    double slack_ = 0.0;  ///< rounding of a value of M, N·m
};

}  // namespace ravnoves::balance_shaft
