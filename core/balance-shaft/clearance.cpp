#include "balance-shaft/clearance.h"

#include <algorithm>
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

#include "balance-shaft/rod_sweep.h"
#include "numerics/angle.h"

namespace ravnoves::balance_shaft {

namespace {

ShaftClearance clearance_of(const FrontView& view, const RodSweep& rods, double alpha) {
    const double x = view.centre_distance * std::sin(alpha);
    const double y = view.centre_distance * std::cos(alpha);
    ShaftClearance free;
    free.crank = view.centre_distance - view.crank_swing_radius - view.shaft_swing_radius;
    free.cylinder = distance_from_cylinder(view, x, y) - view.shaft_swing_radius;
    free.rod = rods.distance(x, y) - view.rod_width / 2.0 - view.shaft_swing_radius;
    return free;
}

Number millimetres(double metres) {
    return {metres / units::mm, units::mm, 4};
}

/// What α does not change; empty where nothing is wrong with it.
Message reason_at_every_angle(const FrontView& view, const PlaceLimits& limits) {
    const double rounding = 1e-12 * view.centre_distance;
    const double least_tip = view.gear_pitch_radius;
    const double largest_tip = view.gear_pitch_radius + 1.25 * view.gear_module;
    if (view.gear_tip_radius < least_tip - rounding ||
        view.gear_tip_radius > largest_tip + rounding) {
        return {CORE_TEXT("balance-shaft",
                          "The gears do not mesh: at the centre distance %1 their tip radius must "
                          "be from %2 to %3, and it is %4."),
                millimetres(view.centre_distance), millimetres(least_tip), millimetres(largest_tip),
                millimetres(view.gear_tip_radius)};
    }
    const double needed = view.crank_swing_radius + view.shaft_swing_radius + view.clearance;
    if (view.centre_distance < needed - rounding) {
        return {CORE_TEXT("balance-shaft",
                          "The swing circles of crank (radius %1) and shaft (%2) with a gap of %3 "
                          "need a centre distance of %4, and it is %5."),
                millimetres(view.crank_swing_radius),
                millimetres(view.shaft_swing_radius),
                millimetres(view.clearance),
                millimetres(needed),
                millimetres(view.centre_distance)};
    }
    if (limits.centre_distance_min &&
        view.centre_distance < *limits.centre_distance_min - rounding) {
        return {CORE_TEXT("balance-shaft",
                          "The limits on the shaft's axis ask for a centre distance of at least "
                          "%1, and it is %2."),
                millimetres(*limits.centre_distance_min), millimetres(view.centre_distance)};
    }
    if (limits.centre_distance_max &&
        view.centre_distance > *limits.centre_distance_max + rounding) {
        return {CORE_TEXT("balance-shaft",
                          "The limits on the shaft's axis ask for a centre distance of at most "
                          "%1, and it is %2."),
                millimetres(*limits.centre_distance_max), millimetres(view.centre_distance)};
    }
    return {};
}

/// Where the circle of radius l about the crank's axis crosses the limits, rad, within 0…2π.
std::vector<double> limit_angles(const PlaceLimits& limits, double l) {
    std::vector<double> angles;
    for (const auto& x : {limits.left, limits.right}) {
        if (x && std::abs(*x) < l) {
            const double alpha = std::asin(*x / l);
            angles.push_back(wrap_turn(alpha));
            angles.push_back(wrap_turn(pi - alpha));
        }
    }
    for (const auto& y : {limits.bottom, limits.top}) {
        if (y && std::abs(*y) < l) {
            const double alpha = std::acos(*y / l);
            angles.push_back(wrap_turn(alpha));
            angles.push_back(wrap_turn(-alpha));
        }
    }
    if (limits.shaft_angle_from || limits.shaft_angle_to) {
        angles.push_back(wrap_turn(limits.shaft_angle_from.value_or(0.0)));
        angles.push_back(wrap_turn(limits.shaft_angle_to.value_or(two_pi)));
    }
    return angles;
}

/// What is left of the stretches within the limits: between two of the angles where the circle
/// crosses them it is on one side of them all.
std::vector<AngleStretch> within_limits(const std::vector<AngleStretch>& stretches,
                                        const PlaceLimits& limits, double l) {
    std::vector<AngleStretch> left;
    const std::vector<double> angles = limit_angles(limits, l);
    for (const AngleStretch& stretch : stretches) {
        std::vector<double> cuts{stretch.from, stretch.to};
        for (const double angle : angles) {
            for (const double cut : {angle, angle + two_pi}) {
                if (cut > stretch.from && cut < stretch.to) {
                    cuts.push_back(cut);
                }
            }
        }
        std::sort(cuts.begin(), cuts.end());
        const std::size_t first = left.size();
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
            const double middle = (cuts[i] + cuts[i + 1]) / 2.0;
            if (!(cuts[i] < cuts[i + 1]) ||
                !is_within(limits, l * std::sin(middle), l * std::cos(middle), 0.0)) {
                continue;
            }
            if (left.size() > first && left.back().to == cuts[i]) {
                left.back().to = cuts[i + 1];
            } else {
                left.push_back({cuts[i], cuts[i + 1]});
            }
        }
        // The ends of the whole turn are one angle.
        if (stretch.is_whole_turn() && left.size() > first + 1 &&
            left[first].from == stretch.from && left.back().to == stretch.to) {
            left.back().to += left[first].to - left[first].from;
            left.erase(left.begin() + static_cast<std::ptrdiff_t>(first));
        }
    }
    for (AngleStretch& stretch : left) {
        if (stretch.from >= two_pi) {
            stretch = {stretch.from - two_pi, stretch.to - two_pi};
        }
    }
    std::sort(left.begin(), left.end(),
              [](const AngleStretch& a, const AngleStretch& b) { return a.from < b.from; });
    return left;
}

/// What the front view allows.
BuildableAngles clear_angles(const FrontView& view) {
    BuildableAngles answer;
    const RodSweep rods(view);
    const double rounding = 1e-12 * view.centre_distance;
    const auto spare = [&](double alpha) {
        const ShaftClearance free = clearance_of(view, rods, alpha);
        return std::min(free.cylinder, free.rod) - view.clearance + rounding;
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
        if (!changes &&
            std::abs(left.spare) + std::abs(next.spare) > view.centre_distance * width) {
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
        if (at_zero) {
            answer.stretches.emplace_back();
        } else {
            answer.reason = {
                CORE_TEXT("balance-shaft",
                          "At every angle the shaft's swing circle (radius %1, gap %2) meets the "
                          "cylinder or what the rod sweeps."),
                millimetres(view.shaft_swing_radius), millimetres(view.clearance)};
        }
        return answer;
    }
    if (at_zero) {  // the last stretch goes on over 0
        std::rotate(ends.begin(), ends.begin() + 1, ends.end());
        ends.back() += two_pi;
    }
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
        answer.stretches.push_back({ends[i], ends[i + 1]});
    }
    return answer;
}
}  // namespace

bool is_within(const PlaceLimits& limits, double x, double y, double rounding) {
    const double l = std::hypot(x, y);
    const auto between = [&](double value, const std::optional<double>& from,
                             const std::optional<double>& to) {
        return (!from || value >= *from - rounding) && (!to || value <= *to + rounding);
    };
    if (!between(l, limits.centre_distance_min, limits.centre_distance_max) ||
        !between(x, limits.left, limits.right) || !between(y, limits.bottom, limits.top)) {
        return false;
    }
    if (!limits.shaft_angle_from && !limits.shaft_angle_to) {
        return true;
    }
    const double from = limits.shaft_angle_from.value_or(0.0);
    const double span = limits.shaft_angle_to.value_or(two_pi) - from;
    const double wrapped = wrap_turn(std::atan2(x, y) - from);
    const double slack = l > 0.0 ? rounding / l + 1e-15 : two_pi;
    return wrapped <= span + slack || wrapped >= two_pi - slack;
}

double distance_from_cylinder(const FrontView& view, double x, double y) {
    const double beside = std::abs(x - view.offset) - view.cylinder_half_width();
    const double above = std::max(y - view.cylinder_top, view.cylinder_bottom - y);
    const double outside = std::hypot(std::max(beside, 0.0), std::max(above, 0.0));
    return outside > 0.0 ? outside : std::max(beside, above);
}

double nearest_angle(const std::vector<AngleStretch>& stretches, double angle) {
    double found = angle;
    double least = std::numeric_limits<double>::infinity();
    for (const AngleStretch& stretch : stretches) {
        if (wrap_turn(angle - stretch.from) <= stretch.to - stretch.from) {
            return angle;
        }
        for (const double end : {stretch.from, stretch.to}) {
            const double away = std::abs(std::remainder(end - angle, two_pi));
            if (away < least) {
                least = away;
                found = end;
            }
        }
    }
    return found;
}

double ShaftClearance::least() const {
    return std::min({crank, cylinder, rod});
}

ShaftClearance shaft_clearance(const FrontView& view, double shaft_angle) {
    return clearance_of(view, RodSweep(view), shaft_angle);
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

BuildableAngles buildable_angles(const FrontView& view, const PlaceLimits& limits) {
    BuildableAngles answer;
    answer.reason = reason_at_every_angle(view, limits);
    if (!answer.reason.empty()) {
        return answer;
    }
    answer = clear_angles(view);
    // Those of the distance hold here, up to rounding.
    PlaceLimits others = limits;
    others.centre_distance_min.reset();
    others.centre_distance_max.reset();
    if (answer.stretches.empty() || others == PlaceLimits{}) {
        return answer;
    }
    answer.stretches = within_limits(answer.stretches, others, view.centre_distance);
    if (answer.stretches.empty()) {
        answer.reason = {CORE_TEXT("balance-shaft",
                                   "At the centre distance %1 no angle that clears cylinder and "
                                   "rod is within the limits on the shaft's axis."),
                         millimetres(view.centre_distance)};
    }
    return answer;
}

}  // namespace ravnoves::balance_shaft
