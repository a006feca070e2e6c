#pragma once

#include <Eigen/Core>

#include "balance-shaft/moment_plane.h"

namespace ravnoves::balance_shaft {

/// The shaft's moment a cos φ + b sin φ with the least range of M + a cos φ + b sin φ.
struct BestMoment {
    Eigen::Vector2d moment{0.0, 0.0};  ///< (a, b), N·m
    double range = 0.0;                ///< N·m
    double gap = 0.0;                  ///< N·m: no moment has a range below range − gap
    int evaluations = 0;
};

/// The global minimum of a convex function by cutting planes: every φ of a maximum met is a plane
/// M(φ) + a cos φ + b sin φ under the largest value, every one of a minimum a plane over the
/// smallest, and the least difference of the two over all (a, b) is a lower bound. With straight
/// lines between the rows the planes of the rows are exact and the end is reached in a few steps.
/// @param start  where to begin, N·m
BestMoment minimise_range(const MomentPlane& plane, const Eigen::Vector2d& start);

}  // namespace ravnoves::balance_shaft
