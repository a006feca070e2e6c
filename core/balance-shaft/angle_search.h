#pragma once

#include <cmath>
#include <functional>
#include <span>
#include <vector>

#include "balance-shaft/moment_plane.h"
#include "numerics/constants.h"

namespace ravnoves::balance_shaft {

/// constant + p cos α + q sin α
struct Sinusoid {
    double constant = 0.0;
    double p = 0.0;
    double q = 0.0;

    double operator()(double alpha) const {
        return constant + p * std::cos(alpha) + q * std::sin(alpha);
    }
};

/// Angles from one to another, rad: 0 ≤ from < 2π, from ≤ to ≤ from + 2π.
struct AngleStretch {
    double from = 0.0;
    double to = two_pi;

    bool operator==(const AngleStretch&) const = default;
};

inline std::vector<AngleStretch> whole_turn() {
    return {AngleStretch{}};
}

/// Each of them later by an angle, rad.
std::vector<AngleStretch> turned(std::vector<AngleStretch> stretches, double by);

/// An evaluated angle with a lower bound of the function everywhere that touches it there.
struct Cut {
    double alpha = 0.0;
    double value = 0.0;
    Sinusoid bound;
};

/// The minimum of a function of α and its bound.
struct AngleMinimum {
    double alpha = 0.0;  ///< rad, 0…2π
    double value = 0.0;
    double worst = 0.0;  ///< the largest value met on the way
    double gap = 0.0;    ///< no α has a value below value − gap
};

/// The global minimum over α of a function of period 2π, by cutting planes: every evaluated angle
/// gives a sinusoid below the function everywhere. Between two evaluated angles the larger of their
/// two sinusoids bounds it; the interval is split at that bound's minimum until no bound is under
/// the best value. Kinks and several minima need no care, since the bounds are global. Of angles at
/// the ends that are equal but for rounding, the smallest is returned.
/// @param size      scale of its rounding, also its values
/// @param within    the angles to choose from, one stretch at least; default: all
AngleMinimum minimise_over_angle(const std::function<Cut(double)>& evaluate, double size,
                                 const std::vector<AngleStretch>& within = whole_turn());

/// The shaft's moment A sin(φ + α) = A sin α cos φ + A cos α sin φ.
inline MomentPlane::Moment shaft_at(double amplitude, double alpha) {
    return {amplitude * std::sin(alpha), amplitude * std::cos(alpha)};
}

/// Ranges and RMS with A sin(φ + α) at many angles, cheaper where neighbours in the list are near
/// each other.
void sweep(const MomentPlane& plane, double amplitude, std::span<const double> alpha,
           std::span<double> range, std::span<double> rms);

/// The range R(α) = max − min of M(φ) + A sin(φ + α) with its bound: with the extrema at φ₊ and φ₋,
/// h(α) = M(φ₊) − M(φ₋) + A sin(φ₊ + α) − A sin(φ₋ + α) touches R there and is below it elsewhere
/// (a range is at least the difference of any two of its values).
Cut range_cut(const MomentPlane& plane, double amplitude, double alpha);

/// The smallest range over α, by minimise_over_angle().
AngleMinimum minimise_range(const MomentPlane& plane, double amplitude,
                            const std::vector<AngleStretch>& within = whole_turn());

}  // namespace ravnoves::balance_shaft
