#pragma once

#include "balance-shaft/envelope.h"
#include "balance-shaft/rod_sweep.h"
#include "case-file/message.h"

namespace ravnoves::balance_shaft {

/// What keeps the shaft from a place; `none` where it can be built.
enum class Obstacle { none, crank, cylinder, rod, gears, limits };

/// Where the shaft's axis can be, as BuildableAngles says of a circle, and within the limits given.
class ShaftPlaces {
  public:
    ShaftPlaces(const FrontView& view, const PlaceLimits& limits);

    /// @param x, y  m
    Obstacle obstacle(double x, double y) const;
    Message reason(Obstacle obstacle, double x, double y) const;  ///< a sentence; empty: none
    /// Width × height of the front view's box with the shaft there, m².
    double size(double x, double y) const;

    const FrontView& view() const { return view_; }

  private:
    bool is_in_limits(double x, double y, double l) const;

    FrontView view_;
    PlaceLimits limits_;
    RodSweep rods_;
    double needed_ = 0.0;        ///< from cylinder, m
    double needed_rod_ = 0.0;    ///< from the rod's centre line
    double needed_crank_ = 0.0;  ///< from the crank's axis
    double gears_min_ = 0.0;     ///< l at which the gears mesh, m
    double gears_max_ = 0.0;
    double rounding_ = 0.0;  ///< m
};

}  // namespace ravnoves::balance_shaft
