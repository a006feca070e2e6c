#pragma once

#include <vector>

#include "balance-shaft/angle_search.h"
#include "balance-shaft/envelope.h"
#include "case-file/message.h"

namespace ravnoves::balance_shaft {

/// Obstacle that excludes a place; `none` where the shaft fits.
enum class Obstacle { none, crank, cylinder, rod, gears, limits };

/// Free space between the swing circle of the balance shaft and its obstacles, m; negative where
/// they overlap. In the front view: parts behind one another overlap there too.
struct ShaftClearance {
    double crank = 0.0;     ///< swing circle of the crank
    double cylinder = 0.0;  ///< the cylinder with its wall
    double rod = 0.0;       ///< all that the rod sweeps over a turn
};

/// Of a place in the front view from the cylinder with its wall, m; negative inside.
double distance_from_cylinder(const FrontView& view, double x, double y);

/// @param shaft_angle  α, rad, any
ShaftClearance shaft_clearance(const FrontView& view, double shaft_angle);

/// How far a place of the shaft's axis may move and stay within the limits, m; negative outside.
double margin_within(const PlaceLimits& limits, double x, double y);

/// Of the angles within the limits, rad: up to a whole turn. They go over 0 where the last is less
/// than the first.
double angle_span(const PlaceLimits& limits);

/// Names the limits where a minimum is above its maximum; else empty.
Message contradiction(const PlaceLimits& limits);

/// The feasible angles of the shaft: every clearance is at least the view's, the gears mesh (the
/// tip circle reaches the pitch circle, and not the other gear's root circle, 1.25 modules below
/// its pitch circle), and the axis is within its limits.
struct BuildableAngles {
    std::vector<AngleStretch> stretches;  ///< ascending and apart; empty where nothing fits
    Message reason;                       ///< why not, as a sentence; else empty

    /// @param shaft_angle  α, rad, any
    bool contains(double shaft_angle) const;
    /// The gaps between them, ascending within 0…2π: the whole circle where nothing fits.
    std::vector<AngleStretch> gaps() const;
};

/// The angle itself, where it is in a stretch, or else the end of one that is next to it round the
/// turn, rad.
double nearest_angle(const std::vector<AngleStretch>& stretches, double angle);

/// The ends are exact but for rounding, on the feasible side. A stretch or gap of less than 0.02°
/// may be missed.
BuildableAngles buildable_angles(const FrontView& view, const PlaceLimits& limits = {});

}  // namespace ravnoves::balance_shaft
