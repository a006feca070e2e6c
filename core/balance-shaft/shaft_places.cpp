#include "balance-shaft/shaft_places.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "balance-shaft/clearance.h"
#include "numerics/constants.h"

namespace ravnoves::balance_shaft {

ShaftPlaces::ShaftPlaces(const FrontView& view, const PlaceLimits& limits)
    : view_(view),
      limits_(limits),
      rods_(view),
      needed_(view.shaft_swing_radius + view.clearance),
      needed_rod_(needed_ + view.rod_width / 2.0),
      needed_crank_(needed_ + view.crank_swing_radius),
      gears_max_(std::numeric_limits<double>::infinity()),
      rounding_(1e-12 * (needed_crank_ + view.cylinder_top)) {
    if (!view.tip_follows_distance) {
        // l/2 ≤ tip radius ≤ l/2 + 1.25 l/z
        gears_min_ = view.gear_tip_radius / (0.5 + 1.25 / view.gear_teeth);
        gears_max_ = 2.0 * view.gear_tip_radius;
    }
}

bool ShaftPlaces::is_in_limits(double x, double y, double l) const {
    const auto within = [&](double value, const std::optional<double>& from,
                            const std::optional<double>& to) {
        return (!from || value >= *from - rounding_) && (!to || value <= *to + rounding_);
    };
    if (!within(l, limits_.centre_distance_min, limits_.centre_distance_max) ||
        !within(x, limits_.left, limits_.right) || !within(y, limits_.bottom, limits_.top)) {
        return false;
    }
    if (!limits_.shaft_angle_from && !limits_.shaft_angle_to) {
        return true;
    }
    const double from = limits_.shaft_angle_from.value_or(0.0);
    const double span = limits_.shaft_angle_to.value_or(two_pi) - from;
    const double after = std::atan2(x, y) - from;
    const double wrapped = after - two_pi * std::floor(after / two_pi);
    const double slack = l > 0.0 ? rounding_ / l + 1e-15 : two_pi;
    return wrapped <= span + slack || wrapped >= two_pi - slack;
}

Obstacle ShaftPlaces::obstacle(double x, double y) const {
    const double l = std::hypot(x, y);
    if (l < needed_crank_ - rounding_) {
        return Obstacle::crank;
    }
    if (distance_from_cylinder(view_, x, y) < needed_ - rounding_) {
        return Obstacle::cylinder;
    }
    if (l < gears_min_ - rounding_ || l > gears_max_ + rounding_) {
        return Obstacle::gears;
    }
    if (!is_in_limits(x, y, l)) {
        return Obstacle::limits;
    }
    return rods_.is_clear(x, y, needed_rod_ - rounding_) ? Obstacle::none : Obstacle::rod;
}

Message ShaftPlaces::reason(Obstacle obstacle, double x, double y) const {
    const auto millimetres = [](double metres) { return Number{metres / units::mm, units::mm, 4}; };
    const Number swing = millimetres(view_.shaft_swing_radius);
    const Number gap = millimetres(view_.clearance);
    switch (obstacle) {
        case Obstacle::none:
            break;
        case Obstacle::crank:
            return {
                CORE_TEXT("balance-shaft",
                          "The shaft's swing circle (radius %1, gap %2) meets that of the crank: "
                          "the centre distance must be at least %3, and it is %4."),
                swing, gap, millimetres(needed_crank_), millimetres(std::hypot(x, y))};
        case Obstacle::cylinder:
            return {CORE_TEXT("balance-shaft",
                              "The shaft's swing circle (radius %1, gap %2) meets the cylinder."),
                    swing, gap};
        case Obstacle::rod:
            return {CORE_TEXT("balance-shaft",
                              "The shaft's swing circle (radius %1, gap %2) meets what the rod "
                              "sweeps."),
                    swing, gap};
        case Obstacle::gears:
            return {CORE_TEXT("balance-shaft",
                              "The gears do not mesh: with their tip radius %1 the centre distance "
                              "must be from %2 to %3, and it is %4."),
                    millimetres(view_.gear_tip_radius), millimetres(gears_min_),
                    millimetres(gears_max_), millimetres(std::hypot(x, y))};
        case Obstacle::limits:
            return CORE_TEXT("balance-shaft", "The place is outside the limits given.");
    }
    return {};
}

double ShaftPlaces::size(double x, double y) const {
    const Envelope box = envelope(view_.at_distance(std::hypot(x, y)), x, y);
    return box.width() * box.height();
}

}  // namespace ravnoves::balance_shaft
