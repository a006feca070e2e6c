#include "balance-shaft/clearance.h"

#include <algorithm>
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "balance-shaft/fields.h"
#include "balance-shaft/shaft_places.h"
#include "numerics/angle.h"

namespace ravnoves::balance_shaft {

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// All that are given: "Minimum x 80 mm, Maximum l 70 mm".
Message named(const PlaceLimits& limits) {
    const std::pair<const Field&, const std::optional<double>&> all[] = {
        {field::centre_distance_min, limits.centre_distance_min},
        {field::centre_distance_max, limits.centre_distance_max},
        {field::shaft_angle_from, limits.shaft_angle_from},
        {field::shaft_angle_to, limits.shaft_angle_to},
        {field::place_left, limits.left},
        {field::place_right, limits.right},
        {field::place_bottom, limits.bottom},
        {field::place_top, limits.top}};
    Message names;
    for (const auto& [field, limit] : all) {
        if (limit) {
            const Message name(Text{"%1 %2"}, field.label,
                               Number{from_si(field, *limit), field.unit, 6});
            names = names.empty() ? name : joined(names, name);
        }
    }
    return names;
}

}  // namespace

double angle_span(const PlaceLimits& limits) {
    const double span =
        limits.shaft_angle_to.value_or(two_pi) - limits.shaft_angle_from.value_or(0.0);
    return span > 0.0 ? span : two_pi - wrap_turn(-span);
}

double margin_within(const PlaceLimits& limits, double x, double y) {
    const double l = std::hypot(x, y);
    double margin = unlimited;
    const auto keep = [&](double value, const std::optional<double>& from,
                          const std::optional<double>& to) {
        margin = std::min({margin, from ? value - *from : margin, to ? *to - value : margin});
    };
    keep(l, limits.centre_distance_min, limits.centre_distance_max);
    keep(x, limits.left, limits.right);
    keep(y, limits.bottom, limits.top);
    if (limits.shaft_angle_from || limits.shaft_angle_to) {
        const double half = angle_span(limits) / 2.0;
        const double middle = limits.shaft_angle_from.value_or(0.0) + half;
        const double away = std::abs(std::remainder(std::atan2(x, y) - middle, two_pi));
        margin = std::min(margin, l * (half - away));
    }
    return margin;
}

Message contradiction(const PlaceLimits& limits) {
    using Limit = std::optional<double> PlaceLimits::*;
    constexpr std::pair<Limit, Limit> pairs[] = {
        {&PlaceLimits::centre_distance_min, &PlaceLimits::centre_distance_max},
        {&PlaceLimits::left, &PlaceLimits::right},
        {&PlaceLimits::bottom, &PlaceLimits::top}};
    for (const auto& [from, to] : pairs) {
        if (limits.*from && limits.*to && *(limits.*from) > *(limits.*to)) {
            PlaceLimits crossed;
            crossed.*from = limits.*from;
            crossed.*to = limits.*to;
            return {Text::tr("The limits contradict each other: %1."), named(crossed)};
        }
    }
    return {};
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
            RodSweep(view).distance({x, y}) - view.rod_width / 2.0 - view.shaft_swing_radius};
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
        answer.reason = contradiction(limits);
    }
    if (answer.stretches.empty() && answer.reason.empty()) {
        answer.reason =
            clear_angles(ShaftPlaces(view, {}), distance).empty()
                ? Message(Text::tr("At every angle the shaft's swing circle (radius %1, clearance "
                                   "%2) meets the cylinder or the rod."),
                          in_mm(view.shaft_swing_radius), in_mm(view.clearance))
                : Message(Text::tr("At the centre distance %1 no angle clears cylinder and rod "
                                   "within the limits: %2."),
                          in_mm(distance), named(others));
    }
    return answer;
}

}  // namespace ravnoves::balance_shaft
