#pragma once

#include <Eigen/Core>
#include <cmath>

#include "balance-shaft/input.h"
#include "numerics/slider_crank.h"

namespace ravnoves::balance_shaft {

/// Bounding box of the front view (crank and shaft circles with gears, cylinder), m. Width and
/// height are convex functions of the shaft's place, with a gradient of each.
struct Envelope {
    double left = 0.0;    ///< x, m
    double right = 0.0;   ///< x, m
    double bottom = 0.0;  ///< y, m
    double top = 0.0;     ///< y, m
    double width() const { return right - left; }
    double height() const { return top - bottom; }
    double area() const { return width() * height(); }  ///< m²

    Eigen::Vector2d by_width{0.0, 0.0};
    Eigen::Vector2d by_height{0.0, 0.0};
    Eigen::Vector2d by_area() const { return width() * by_height + height() * by_width; }
};

/// The sizes of the front view with all defaults filled in, m.
struct FrontView {
    double crank_radius;
    double rod_length;
    double offset;  ///< e of the cylinder axis, to the right
    double counterweight_radius;
    double centre_distance;
    double cylinder_bore;
    double cylinder_wall;
    double cylinder_top;
    double cylinder_bottom;
    double rod_width;
    double crank_swing_radius;
    double shaft_swing_radius;
    double gear_pitch_radius;  ///< l/2
    double gear_tip_radius;
    double clearance;
    double wall;
    int gear_teeth;
    bool tip_follows_distance;  ///< the gears' tip radius is not given
    bool operator==(const FrontView&) const = default;

    SliderCrank<double> crank() const { return {crank_radius, rod_length, offset}; }
    /// Half of what the cylinder with its wall takes across.
    double cylinder_half_width() const { return cylinder_bore / 2.0 + cylinder_wall; }
};

/// The sizes of an input, defaults where it gives none. The counterweights' circle follows from
/// their unbalance: a half disc of steel (7850 kg/m³) of radius R and as long as the bore b has the
/// unbalance (2/3) ρ b R³, so m₁ ρ₁ needs R = (3 m₁ ρ₁ / (2 ρ b))^⅓. A relieved shaft of the input
/// sweeps the circle of its bar instead. The crank's circle also contains the crankpin with half
/// the rod's width.
FrontView front_view(const Input& input);

/// The sizes of the relieved shaft from the input, else of a bar of the swing radius of
/// front_view(): as long as the bore, longer where milling one half away requires it.
RelievedShaftSizes relieved_shaft_sizes(const Input& input);

/// Names the decisive sizes that are defaults, with their values; empty where all are given.
Message assumed_sizes(const Input& input);

/// @param shaft  its axis, m
Envelope envelope(const FrontView& view, const Eigen::Vector2d& shaft);
/// @param shaft_angle  α, rad, any
inline Envelope envelope(const FrontView& view, double shaft_angle) {
    return envelope(
        view, view.centre_distance * Eigen::Vector2d(std::sin(shaft_angle), std::cos(shaft_angle)));
}

}  // namespace ravnoves::balance_shaft
