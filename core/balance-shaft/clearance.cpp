#include "balance-shaft/clearance.h"

#include <algorithm>
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

#include "balance-shaft/fields.h"
#include "balance-shaft/shaft_places.h"
#include "numerics/angle.h"

namespace ravnoves::balance_shaft {

double margin_within(const PlaceLimits& limits, double x, double y) {
    const double l = std::hypot(x, y);
    double margin = std::numeric_limits<double>::infinity();
    const auto keep = [&](double value, const std::optional<double>& from,
                          const std::optional<double>& to) {
        margin = std::min({margin, from ? value - *from : margin, to ? *to - value : margin});
    };
    keep(l, limits.centre_distance_min, limits.centre_distance_max);
    keep(x, limits.left, limits.right);
    keep(y, limits.bottom, limits.top);
    if (limits.shaft_angle_from || limits.shaft_angle_to) {
        const double from = limits.shaft_angle_from.value_or(0.0);
        const double half = (limits.shaft_angle_to.value_or(two_pi) - from) / 2.0;
        const double away = std::abs(std::remainder(std::atan2(x, y) - from - half, two_pi));
        margin = std::min(margin, l * (half - away));
    }
    return margin;
}

namespace {

bool leave_no_place(const PlaceLimits& limits) {
    double size = limits.centre_distance_min.value_or(0.0);
    for (const auto& limit :
         {limits.centre_distance_max, limits.left, limits.right, limits.bottom, limits.top}) {
        size = std::max(size, std::abs(limit.value_or(0.0)));
    }
    const double rounding = 1e-9 * size;
    const double reach = 1e3 * (size + 1.0);
    const Eigen::Vector2d low(limits.left.value_or(-reach), limits.bottom.value_or(-reach));
    const Eigen::Vector2d high(limits.right.value_or(reach), limits.top.value_or(reach));
    const double from = limits.shaft_angle_from.value_or(0.0);
    const double span = limits.shaft_angle_to.value_or(two_pi) - from;
    const int sectors = span < two_pi ? (span > pi ? 2 : 1) : 0;  // each is convex
    for (int i = 0; i < std::max(sectors, 1); ++i) {
        PlacePolygon part({(low + high) / 2.0, (high - low) / 2.0});
        if (sectors > 0) {
            const double start = from + i * span / sectors;
            const double end = start + span / sectors;
            part.cut({{std::cos(start), -std::sin(start)}, -rounding});
            part.cut({{-std::cos(end), std::sin(end)}, -rounding});
        }
        const bool has_crank = low.maxCoeff() <= 0.0 && high.minCoeff() >= 0.0;
        double nearest = has_crank ? 0.0 : std::numeric_limits<double>::infinity();
        double farthest = -1.0;
        for (std::size_t k = 0; k < part.size(); ++k) {
            const Eigen::Vector2d& corner = part[k];
            const Eigen::Vector2d side = part[(k + 1) % part.size()] - corner;
            const double along = -corner.dot(side) / std::max(side.squaredNorm(), 1e-300);
            nearest = std::min(nearest, (corner + std::clamp(along, 0.0, 1.0) * side).norm());
            farthest = std::max(farthest, corner.norm());
        }
        if (farthest >= limits.centre_distance_min.value_or(0.0) - rounding &&
            nearest <= limits.centre_distance_max.value_or(nearest) + rounding) {
            return false;
        }
    }
    return true;
}

/// As few of them as leave no place, which all do.
PlaceLimits needed_to_contradict(PlaceLimits limits) {
    const auto leave_out = [&](auto... members) {
        PlaceLimits others = limits;
        ((others.*members).reset(), ...);
        if (leave_no_place(others)) {
            limits = others;
        }
    };
    leave_out(&PlaceLimits::centre_distance_min);
    leave_out(&PlaceLimits::centre_distance_max);
    leave_out(&PlaceLimits::shaft_angle_from, &PlaceLimits::shaft_angle_to);
    leave_out(&PlaceLimits::left);
    leave_out(&PlaceLimits::right);
    leave_out(&PlaceLimits::bottom);
    leave_out(&PlaceLimits::top);
    return limits;
}

/// "Minimum x 80 mm, Maximum l 70 mm".
Message named(const PlaceLimits& limits) {
    Message names;
    const auto add = [&](const Field& field, const std::optional<double>& limit) {
        if (limit) {
            const Message name(Text{"%1 %2"}, field.label,
                               Number{from_si(field, *limit), field.unit, 6});
            names = names.empty() ? name : joined(names, name);
        }
    };
    add(field::centre_distance_min, limits.centre_distance_min);
    add(field::centre_distance_max, limits.centre_distance_max);
    add(field::shaft_angle_from, limits.shaft_angle_from);
    add(field::shaft_angle_to, limits.shaft_angle_to);
    add(field::place_left, limits.left);
    add(field::place_right, limits.right);
    add(field::place_bottom, limits.bottom);
    add(field::place_top, limits.top);
    return names;
}

/// Why no angle at a centre distance is within the limits; empty where one is.
Message contradiction_at(double distance, PlaceLimits limits) {
    limits.centre_distance_min.reset();
    limits.centre_distance_max.reset();
    if (Message at_any = contradiction(limits); !at_any.empty()) {
        return at_any;
    }
    limits.centre_distance_min = limits.centre_distance_max = distance;
    if (!leave_no_place(limits)) {
        return {};
    }
    limits = needed_to_contradict(limits);
    limits.centre_distance_min.reset();
    limits.centre_distance_max.reset();
    return {Text::tr("At the centre distance %1 no angle is within the limits: %2."),
            in_mm(distance), named(limits)};
}

}  // namespace

Message contradiction(const PlaceLimits& limits) {
    return leave_no_place(limits) ? Message(Text::tr("The limits contradict each other: %1."),
                                            named(needed_to_contradict(limits)))
                                  : Message();
}

double distance_from_cylinder(const FrontView& view, double x, double y) {
    const double beside = std::abs(x - view.offset) - view.cylinder_half_width();
    const double above = std::max(y - view.cylinder_top, view.cylinder_bottom - y);
    const double outside = std::hypot(std::max(beside, 0.0), std::max(above, 0.0));
    return outside > 0.0 ? outside : std::max(beside, above);
}

double nearest_angle(const std::vector<AngleStretch>& stretches, double angle) {
    double found = angle;
    double minimum = std::numeric_limits<double>::infinity();
    for (const AngleStretch& stretch : stretches) {
        if (wrap_turn(angle - stretch.from) <= stretch.to - stretch.from) {
            return angle;
        }
        for (const double end : {stretch.from, stretch.to}) {
            const double away = std::abs(std::remainder(end - angle, two_pi));
            if (away < minimum) {
                minimum = away;
                found = end;
            }
        }
    }
    return found;
}

ShaftClearance shaft_clearance(const FrontView& view, double shaft_angle) {
    const double x = view.centre_distance * std::sin(shaft_angle);
    const double y = view.centre_distance * std::cos(shaft_angle);
    return {view.centre_distance - view.crank_swing_radius - view.shaft_swing_radius,
            distance_from_cylinder(view, x, y) - view.shaft_swing_radius,
            RodSweep(view).distance(x, y) - view.rod_width / 2.0 - view.shaft_swing_radius};
}

bool BuildableAngles::contains(double shaft_angle) const {
    // The ends themselves can be built, and an angle that was rounded on its way here is one.
    constexpr double rounding = 1e-9;
    return std::any_of(stretches.begin(), stretches.end(), [&](const AngleStretch& stretch) {
        const double after = wrap_turn(shaft_angle - stretch.from);
        return after <= stretch.to - stretch.from + rounding || after >= two_pi - rounding;
    });
}

std::vector<AngleStretch> BuildableAngles::gaps() const {
    // A stretch over 0 ends in the next turn; its last part is the first of this one.
    double end = stretches.empty() ? 0.0 : std::max(stretches.back().to - two_pi, 0.0);
    std::vector<AngleStretch> gaps;
    const auto add_up_to = [&](double from) {
        if (from > end) {
            gaps.push_back({end, from});
        }
    };
    for (const AngleStretch& stretch : stretches) {
        add_up_to(stretch.from);
        end = stretch.to;
    }
    add_up_to(two_pi);
    return gaps;
}

namespace {

/// Where the shaft clears cylinder and rod and is within the limits.
std::vector<AngleStretch> clear_angles(const ShaftPlaces& places, double distance) {
    const auto spare = [&](double alpha) {
        return places.spare(distance * std::sin(alpha), distance * std::cos(alpha));
    };
    // The shaft's axis moves by l dα, so a clearance of ±s keeps its sign for s / l.
    struct Sample {
        double alpha;
        double spare;
    };
    constexpr double narrow = two_pi / 16384;
    std::vector<double> ends;  // beginnings and ends of what can be built, by turns
    const auto find_end = [&](Sample left, Sample right) {
        std::uintmax_t tries = 60;
        const auto [before, after] = boost::math::tools::toms748_solve(
            spare, left.alpha, right.alpha, left.spare, right.spare,
            boost::math::tools::eps_tolerance<double>(48), tries);
        ends.push_back(right.spare >= 0.0 ? after : before);
    };
    std::vector<std::array<Sample, 2>> open;
    constexpr int parts = 64;
    Sample right{two_pi, spare(0.0)};
    const bool at_zero = right.spare >= 0.0;
    for (int i = parts; i-- > 0;) {
        const double alpha = two_pi * i / parts;
        const Sample left{alpha, spare(alpha)};
        open.push_back({left, right});
        right = left;
    }
    // `open` holds the turn backwards, so its end is the interval that comes next.
    while (!open.empty()) {
        const auto [left, next] = open.back();
        open.pop_back();
        const double width = next.alpha - left.alpha;
        const bool changes = (left.spare >= 0.0) != (next.spare >= 0.0);
        if (!changes && std::abs(left.spare) + std::abs(next.spare) > distance * width) {
            continue;
        }
        if (width <= narrow) {
            if (changes) {
                find_end(left, next);
            }
            continue;
        }
        const double middle = left.alpha + width / 2.0;
        const Sample between{middle, spare(middle)};
        open.push_back({between, next});
        open.push_back({left, between});
    }
    if (ends.empty()) {
        return at_zero ? whole_turn() : std::vector<AngleStretch>();
    }
    if (at_zero && ends.back() >= two_pi) {  // 0 is the end of a stretch
        std::rotate(ends.begin(), ends.end() - 1, ends.end());
        ends.front() = 0.0;
    } else if (at_zero) {  // the last stretch goes on over 0
        std::rotate(ends.begin(), ends.begin() + 1, ends.end());
        ends.back() += two_pi;
    }
    std::vector<AngleStretch> stretches;
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
        stretches.push_back({ends[i], ends[i + 1]});
    }
    return stretches;
}

}  // namespace

BuildableAngles buildable_angles(const FrontView& view, const PlaceLimits& limits) {
    const ShaftPlaces places(view, limits);
    const double distance = view.centre_distance;
    BuildableAngles answer;
    answer.reason = places.reason(places.obstacle_at_distance(distance), distance);
    if (!answer.reason.empty()) {
        return answer;
    }
    PlaceLimits others = limits;  // that of the distance holds
    others.centre_distance_min.reset();
    others.centre_distance_max.reset();
    answer.stretches = clear_angles(ShaftPlaces(view, others), distance);
    if (answer.stretches.empty()) {
        answer.reason = contradiction_at(distance, limits);
    }
    if (answer.stretches.empty() && answer.reason.empty()) {
        answer.reason =
            clear_angles(ShaftPlaces(view, {}), distance).empty()
                ? Message(Text::tr("At every angle the shaft's swing circle (radius %1, clearance "
                                   "%2) meets the cylinder or the rod."),
                          in_mm(view.shaft_swing_radius), in_mm(view.clearance))
                : Message(Text::tr("At the centre distance %1 no angle within the limits clears "
                                   "cylinder and rod."),
                          in_mm(distance));
    }
    return answer;
}

}  // namespace ravnoves::balance_shaft
