#include "balance-shaft/shaft_places.h"

#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>

namespace ravnoves::balance_shaft {

RodSweep::RodSweep(const FrontView& view) : crank_(view.crank()) {
    const double length2 = crank_.rod_length * crank_.rod_length;
    per_length2_ = length2 > 0.0 ? 1.0 / length2 : 0.0;
    for (Eigen::Index i = 0; i < samples; ++i) {
        const double theta = step * static_cast<double>(i);
        x_[i] = crank_.crank_radius * std::sin(theta);
        y_[i] = crank_.crank_radius * std::cos(theta);
        along_x_[i] = crank_.offset - x_[i];
        along_y_[i] = crank_.at(theta).s - y_[i];
    }
    // |s'| between the samples: a bound from r and the steepest rod.
    const double across = crank_.crank_radius + std::abs(crank_.offset);
    const double upright2 = length2 - across * across;
    const double tangent =
        upright2 > 0.0 ? across / std::sqrt(upright2) : std::numeric_limits<double>::infinity();
    motion_ = crank_.crank_radius * std::hypot(1.0, tangent) * step;
}

Eigen::Vector2d RodSweep::on_rod(double theta, const Eigen::Vector2d& place) const {
    const Eigen::Vector2d crankpin =
        crank_.crank_radius * Eigen::Vector2d(std::sin(theta), std::cos(theta));
    const Eigen::Vector2d along = Eigen::Vector2d(crank_.offset, crank_.at(theta).s) - crankpin;
    return crankpin + std::clamp((place - crankpin).dot(along) * per_length2_, 0.0, 1.0) * along;
}

double RodSweep::distance(const Eigen::Vector2d& place) const {
    return nearer_than(place, std::numeric_limits<double>::infinity()).value().distance;
}

std::optional<RodSweep::Nearest> RodSweep::nearer_than(const Eigen::Vector2d& place,
                                                       double needed) const {
    const Column to_x = place.x() - x_;
    const Column to_y = place.y() - y_;
    const Column t = ((to_x * along_x_ + to_y * along_y_) * per_length2_).max(0.0).min(1.0);
    const Column square = (to_x - t * along_x_).square() + (to_y - t * along_y_).square();
    const double minimum = square.minCoeff();
    if (std::sqrt(minimum) - motion_ / 2.0 >= needed) {
        return std::nullopt;
    }
    // A minimum between samples is below them by no more than the rod moves.
    const double reach = std::sqrt(minimum) + motion_;
    const double candidate = reach * reach * (1.0 + 1e-12);
    double best = std::numeric_limits<double>::infinity();
    double theta = 0.0;
    const auto take = [&](double at, double value) {
        if (value < best) {
            best = value;
            theta = at;
        }
    };
    for (Eigen::Index i = 0; i < samples; ++i) {
        if (square[i] > candidate) {
            continue;
        }
        const double at = step * static_cast<double>(i);
        if (square[i] <= square[i == 0 ? samples - 1 : i - 1] &&
            square[i] <= square[i + 1 == samples ? 0 : i + 1]) {
            // It is flat at its minimum, so half of a double's digits of the angle are enough.
            constexpr int bits = 26;
            const auto lowest = boost::math::tools::brent_find_minima(
                [&](double angle) { return (place - on_rod(angle, place)).squaredNorm(); },
                at - step, at + step, bits);
            take(lowest.first, lowest.second);
        }
        take(at, square[i]);
    }
    const Nearest found{std::sqrt(best), on_rod(theta, place)};
    return found.distance < needed ? std::optional(found) : std::nullopt;
}

PlacePolygon::PlacePolygon(const Eigen::AlignedBox2d& rectangle) {
    using Box = Eigen::AlignedBox2d;
    for (const auto corner : {Box::BottomLeft, Box::BottomRight, Box::TopRight, Box::TopLeft}) {
        corners_.push_back(rectangle.corner(corner));
    }
}

void PlacePolygon::cut(const HalfPlane& by) {
    decltype(corners_) kept;
    for (std::size_t i = 0; i < size(); ++i) {
        const Eigen::Vector2d& from = corners_[i];
        const Eigen::Vector2d& to = corners_[i + 1 < size() ? i + 1 : 0];
        const double here = by.normal.dot(from) - by.minimum;
        const double there = by.normal.dot(to) - by.minimum;
        if (here >= 0.0) {
            kept.push_back(from);
        }
        if ((here >= 0.0) != (there >= 0.0)) {
            kept.push_back(from + (to - from) * (here / (here - there)));
        }
    }
    if (kept.size() <= maximum) {
        corners_ = kept;
    }
}

Eigen::AlignedBox2d PlacePolygon::box() const {
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& corner : corners_) {
        box.extend(corner);
    }
    return box;
}

ShaftPlaces::ShaftPlaces(const FrontView& view, const PlaceLimits& limits)
    : view_(view),
      limits_(limits),
      rods_(view),
      needed_(view.shaft_swing_radius + view.clearance),
      needed_rod_(needed_ + view.rod_width / 2.0),
      needed_crank_(needed_ + view.crank_swing_radius),
      gears_max_(std::numeric_limits<double>::infinity()),
      rounding_(1e-12 * (needed_crank_ + std::min(view.cylinder_top, 1e3 * needed_crank_))) {
    if (!view.tip_follows_distance) {
        // l/2 ≤ tip radius ≤ l/2 + 1.25 l/z
        gears_min_ = view.gear_tip_radius / (0.5 + 1.25 / view.gear_teeth);
        gears_max_ = 2.0 * view.gear_tip_radius;
    }
}

Obstacle ShaftPlaces::obstacle_at_distance(double l) const {
    if (l < needed_crank_ - rounding_) {
        return Obstacle::crank;
    }
    if (l < gears_min_ - rounding_ || l > gears_max_ + rounding_) {
        return Obstacle::gears;
    }
    return l < limits_.centre_distance_min.value_or(l) - rounding_ ||
                   l > limits_.centre_distance_max.value_or(l) + rounding_
               ? Obstacle::limits
               : Obstacle::none;
}

Obstacle ShaftPlaces::obstacle(double x, double y) const {
    const Obstacle met = obstacle_at_distance(std::hypot(x, y));
    if (met == Obstacle::crank) {
        return met;
    }
    if (distance_from_cylinder(view_, x, y) < needed_ - rounding_) {
        return Obstacle::cylinder;
    }
    if (met != Obstacle::none) {
        return met;
    }
    if (margin_within(limits_, x, y) < -rounding_) {
        return Obstacle::limits;
    }
    return rods_.nearer_than({x, y}, needed_rod_ - rounding_) ? Obstacle::rod : Obstacle::none;
}

double ShaftPlaces::spare(double x, double y) const {
    const double clear = std::min(distance_from_cylinder(view_, x, y) - needed_,
                                  rods_.distance({x, y}) - needed_rod_);
    return std::min(clear + rounding_, margin_within(limits_, x, y));
}

Message ShaftPlaces::reason(Obstacle obstacle, double l) const {
    if (Message none = obstacle != Obstacle::none ? contradiction(limits_) : Message();
        !none.empty()) {
        return none;
    }
    const Number swing = in_mm(view_.shaft_swing_radius);
    const Number gap = in_mm(view_.clearance);
    switch (obstacle) {
        case Obstacle::none:
            break;
        case Obstacle::crank:
            return {Text::tr("The shaft's swing circle (radius %1, clearance %2) meets the crank: "
                             "centre distance %4, minimum %3."),
                    swing, gap, in_mm(needed_crank_), in_mm(l)};
        case Obstacle::cylinder:
            return {
                Text::tr("The shaft's swing circle (radius %1, clearance %2) meets the cylinder."),
                swing, gap};
        case Obstacle::rod:
            return {Text::tr("The shaft's swing circle (radius %1, clearance %2) meets the rod."),
                    swing, gap};
        case Obstacle::gears:
            return {Text::tr("The gears do not mesh: with a tip radius of %1 the centre distance "
                             "must be %2 to %3, not %4."),
                    in_mm(view_.gear_tip_radius), in_mm(gears_min_), in_mm(gears_max_), in_mm(l)};
        case Obstacle::limits:
            if (l < limits_.centre_distance_min.value_or(l)) {
                return {Text::tr("Centre distance %2 is below the minimum of %1."),
                        in_mm(*limits_.centre_distance_min), in_mm(l)};
            }
            if (l > limits_.centre_distance_max.value_or(l)) {
                return {Text::tr("Centre distance %2 is above the maximum of %1."),
                        in_mm(*limits_.centre_distance_max), in_mm(l)};
            }
            return Text::tr("The place is outside the limits.");
    }
    return {};
}

double ShaftPlaces::nearest_allowed() const {
    return std::max({needed_crank_, gears_min_, limits_.centre_distance_min.value_or(0.0)});
}

double ShaftPlaces::farthest() const {
    return std::min(gears_max_,
                    limits_.centre_distance_max.value_or(std::numeric_limits<double>::infinity()));
}

double ShaftPlaces::extent() const {
    double extent = nearest_allowed() + needed_rod_ + std::abs(view_.offset) +
                    view_.cylinder_half_width() + std::abs(view_.cylinder_top) +
                    std::abs(view_.cylinder_bottom) + view_.rod_length;
    for (const auto& limit : {limits_.left, limits_.right, limits_.bottom, limits_.top}) {
        extent += std::abs(limit.value_or(0.0));
    }
    return extent;
}

Eigen::AlignedBox2d ShaftPlaces::region(double distance) const {
    return {Eigen::Vector2d(std::max(-distance, limits_.left.value_or(-distance)),
                            std::max(-distance, limits_.bottom.value_or(-distance))),
            Eigen::Vector2d(std::min(distance, limits_.right.value_or(distance)),
                            std::min(distance, limits_.top.value_or(distance)))};
}

Eigen::Vector2d ShaftPlaces::on_cylinder(const Eigen::Vector2d& place) const {
    const double wide = view_.cylinder_half_width();
    return {std::clamp(place.x(), view_.offset - wide, view_.offset + wide),
            std::clamp(place.y(), std::min(view_.cylinder_bottom, view_.cylinder_top),
                       view_.cylinder_top)};
}

std::optional<ShaftPlaces::Cuts> ShaftPlaces::find_cuts(
    const Eigen::AlignedBox2d& rectangle) const {
    const Eigen::Vector2d middle = rectangle.center();
    const Eigen::Vector2d half = rectangle.sizes() / 2.0;
    const double r = half.norm();
    Cuts cuts;
    // Must stay away from the nearest place of an obstacle.
    const auto keep_off = [&](const Eigen::Vector2d& nearest, double needed) {
        const Eigen::Vector2d to = middle - nearest;
        const double away = to.norm();
        if (!(away > 0.0) || away - r >= needed) {
            return;
        }
        const Eigen::Vector2d n = to / away;
        const double minimum = n.dot(middle) + needed - away;
        cuts.inner.push_back({n, minimum});
        cuts.outer.push_back({n, minimum - r * r / (2.0 * away) - rounding_});
    };
    const double l = middle.norm();
    const double min_l = nearest_allowed();
    const double max_l = farthest();
    if (l + r < min_l - rounding_ || l - r > max_l + rounding_) {
        return std::nullopt;
    }
    keep_off({0.0, 0.0}, min_l);
    if (l + r > max_l && l > 0.0) {
        const Eigen::Vector2d n = -middle / l;
        cuts.outer.push_back({n, -max_l - rounding_});
        cuts.inner.push_back({n, -max_l});
    }

    const double from_cylinder = distance_from_cylinder(view_, middle.x(), middle.y());
    if (from_cylinder + r < needed_ - rounding_) {
        return std::nullopt;
    }
    if (view_.cylinder_bottom <= view_.cylinder_top) {
        keep_off(on_cylinder(middle), needed_);
    }

    if (limits_.shaft_angle_from || limits_.shaft_angle_to) {
        const double from = limits_.shaft_angle_from.value_or(0.0);
        const double span = angle_span(limits_);
        if (span < two_pi) {
            const std::array<HalfPlane, 2> edges{
                HalfPlane{{std::cos(from), -std::sin(from)}, -rounding_},
                HalfPlane{{-std::cos(from + span), std::sin(from + span)}, -rounding_}};
            // A sector of more than half a turn has both half planes, not what they share.
            for (std::size_t i = 0; i < 2; ++i) {
                const HalfPlane& other = edges[1 - i];
                if (span <= pi ||
                    other.normal.dot(middle) + other.normal.cwiseAbs().dot(half) < other.minimum) {
                    cuts.outer.push_back(edges[i]);
                    cuts.inner.push_back({edges[i].normal, 0.0});
                }
            }
        }
    }

    if (const auto rod = rods_.nearer_than(middle, needed_rod_ + r)) {
        if (rod->distance + r < needed_rod_ - rounding_) {
            return std::nullopt;
        }
        keep_off(rod->place, needed_rod_);
    }
    return cuts;
}

bool ShaftPlaces::make_feasible(Eigen::Vector2d& place, double within) const {
    const Eigen::Vector2d half(within, within);
    constexpr int tries = 12;
    for (int i = 0; i < tries; ++i) {
        if (obstacle(place.x(), place.y()) == Obstacle::none) {
            return true;
        }
        const auto cuts = find_cuts({place - half, place + half});
        if (!cuts) {
            return false;
        }
        for (const HalfPlane& line : cuts->inner) {
            place += std::max(line.minimum - line.normal.dot(place), 0.0) * line.normal;
        }
    }
    return false;
}

}  // namespace ravnoves::balance_shaft
