#pragma once

#include "balance-shaft/input.h"

namespace ravnoves::balance_shaft {

/// Bounding box of the front view (crank and shaft circles with gears, cylinder), m.
struct Envelope {
    double left = 0.0;    ///< x, m
    double right = 0.0;   ///< x, m
    double bottom = 0.0;  ///< y, m
    double top = 0.0;     ///< y, m
    double width() const { return right - left; }
    double height() const { return top - bottom; }
};

/// The sizes of the front view with all defaults filled in, m.
struct FrontView {
    double crank_radius;
    double rod_length;
    double counterweight_radius;
    double centre_distance;
    double cylinder_bore;
    double cylinder_top;
    double crank_swing_radius;
    double shaft_swing_radius;
    double gear_pitch_radius;  ///< l/2
    double gear_tip_radius;
    double wall;
};

/// The sizes of an input, what it leaves out by default.
FrontView front_view(const Input& input);

/// @param shaft_angle  α, rad, any
Envelope envelope(const FrontView& view, double shaft_angle);

}  // namespace ravnoves::balance_shaft
