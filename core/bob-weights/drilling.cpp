#include "bob-weights/drilling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "numerics/constants.h"

namespace ravnoves::bob_weights {

namespace {

bool is_inside(double angle, const std::pair<double, double>& sector) {
    constexpr double rounding = 1e-9;
    const double width = turn_of(sector.second - sector.first);
    const double place = turn_of(angle - sector.first + rounding);
    // From 0 to 360 is all round, as from 10 to 10 is.
    return width < rounding || place <= width + 2.0 * rounding;
}

struct Pattern {
    int count = 0;
    double diameter = 0.0;
    double depth = 0.0;
    double left = 0.0;   // of the target
    double metal = 0.0;  // kg
};

class Planner {
  public:
    /// @param whole  the holes' edges lie in the sector, too
    Planner(double target, double angle, const Cut& cut, const HoleLimits& limits, bool whole)
        : target_(target), angle_(angle), cut_(cut), limits_(limits), whole_(whole) {}

    double deepest(double diameter) const {
        const double room = cut_.radius - cut_.cone(diameter);
        return stepped(std::min(limits_.maximum_depth, room));
    }

    /// Whether n holes of that depth have room.
    bool fits(int n, double diameter, double depth) const {
        return place(n, diameter, depth, [](double) {});
    }

    /// n holes that take off the target, or as much as they can; nothing where they have no room
    /// or one alone would take off too much.
    std::optional<Pattern> pattern(int n, double diameter) const {
        const double most = deepest(diameter);
        if (most < 0.0 || !fits(n, diameter, 0.0)) {
            return std::nullopt;
        }
        // What n holes take off grows with the depth: their unbalance does, and where the spacing
        // grows it costs less than the depth brings as long as the holes are above the axis. It
        // falls alone where a hole has to leap over one of an earlier run.
        const double room = roomy(n, diameter, most);
        constexpr int steps = 32;
        double depth = 0.0;
        double low = 0.0;
        double high = 0.0;
        double best = taken(n, diameter, 0.0);
        bool reaches = best > target_;
        for (int i = 1; i <= steps && !reaches; ++i) {
            low = high;
            high = room * i / steps;
            const double there = taken(n, diameter, high);
            reaches = there > target_;
            if (there > best) {
                best = there;
                depth = high;
            }
        }
        if (!reaches) {
            depth = depth < room ? stepped(depth) : room;
        } else {
            for (int i = 0; i < 100 && high - low > 1e-12; ++i) {
                const double middle = 0.5 * (low + high);
                (taken(n, diameter, middle) > target_ ? high : low) = middle;
            }
            depth = rounded(n, diameter, 0.5 * (low + high), most);
        }
        const Removed one = cut_.removed(diameter, depth);
        return Pattern{n, diameter, depth, target_ - taken(n, diameter, depth), n * one.mass};
    }

    std::vector<Hole> holes(const Pattern& pattern) const {
        std::vector<Hole> list;
        const Removed one = cut_.removed(pattern.diameter, pattern.depth);
        std::vector<double> places;
        place(pattern.count, pattern.diameter, pattern.depth,
              [&](double offset) { places.push_back(offset); });
        std::sort(places.begin(), places.end());
        for (const double offset : places) {
            list.push_back({pattern.diameter, pattern.depth, turn_of(angle_ + offset), one.mass,
                            one.unbalance, one.slug});
        }
        return list;
    }

  private:
    /// Down to a step.
    double stepped(double depth) const {
        return limits_.depth_step > 0.0
                   ? limits_.depth_step * std::floor(depth / limits_.depth_step + 1e-9)
                   : depth;
    }

    double taken(int n, double diameter, double depth) const {
        double cosines = 0.0;
        place(n, diameter, depth, [&](double offset) { cosines += std::cos(offset); });
        return cut_.removed(diameter, depth).unbalance * cosines;
    }

    /// Visits the angles from the middle to each of n holes.
    /// @return whether all have room
    bool place(int n, double diameter, double depth, auto&& visit) const {
        const auto half = half_width(cut_, diameter, depth, limits_.minimum_wall);
        if (!half && (n > 1 || !limits_.taken.empty())) {
            return false;
        }
        const auto may_lie = [&](double angle) {
            return limits_.allows(angle) &&
                   (!whole_ ||
                    edge_beyond(cut_, *limits_.sector, {diameter, depth, angle, 0.0, 0.0}) == 0.0);
        };
        double offset = half.value_or(0.0);
        if (n % 2 == 1) {
            if (!may_lie(angle_) || clear_of_taken(0.0, offset) != 0.0) {
                return false;
            }
            visit(0.0);
            offset *= 2.0;
        }
        for (int pair = 0; pair < n / 2; ++pair) {
            const auto clear = clear_of_taken(offset, *half);
            if (!clear || *clear > limits_.maximum_angle || !may_lie(angle_ - *clear) ||
                !may_lie(angle_ + *clear)) {
                return false;
            }
            visit(-*clear);
            visit(*clear);
            offset = *clear + 2.0 * *half;
        }
        return true;
    }

    /// The least angle from `offset` on at which a hole on either side keeps clear of what is
    /// taken; nothing where none does.
    std::optional<double> clear_of_taken(double offset, double half) const {
        constexpr double rounding = 1e-12;
        for (bool moves = true; moves;) {
            moves = false;
            for (const Taken& taken : limits_.taken) {
                if (!taken.half_width) {
                    return std::nullopt;
                }
                const double apart = half + *taken.half_width;
                for (const double side : {1.0, -1.0}) {
                    // Outwards it grows.
                    const double beyond =
                        side * std::remainder(angle_ + side * offset - taken.angle, 2.0 * pi);
                    if (std::abs(beyond) < apart - rounding) {
                        offset += apart - beyond;
                        moves = true;
                    }
                }
                if (offset > pi) {
                    return std::nullopt;
                }
            }
        }
        return offset;
    }

    /// The deepest that n holes have room for; depth 0 has.
    double roomy(int n, double diameter, double most) const {
        if (fits(n, diameter, most)) {
            return most;
        }
        double low = 0.0;
        double high = most;
        for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * (low + high);
            (fits(n, diameter, middle) ? low : high) = middle;
        }
        return stepped(low);
    }

    double rounded(int n, double diameter, double depth, double most) const {
        if (limits_.depth_step <= 0.0) {
            return depth;
        }
        const double below = stepped(depth);
        const double above = below + limits_.depth_step;
        const bool can = above <= most + 1e-12 && fits(n, diameter, above);
        return can && std::abs(taken(n, diameter, above) - target_) <
                           std::abs(taken(n, diameter, below) - target_)
                   ? above
                   : below;
    }

    double target_;
    double angle_;
    const Cut& cut_;
    const HoleLimits& limits_;
    bool whole_;
};

HolePlan plan_where(double target, double angle, const Cut& cut, std::span<const double> diameters,
                    const HoleLimits& limits, double tolerance, bool whole) {
    const Planner planner(target, angle, cut, limits, whole);
    if (target <= tolerance || target <= 0.0) {
        return {{}, target, Shortfall::none};
    }
    if (!limits.allows(angle)) {
        return {{}, target, Shortfall::outside_sector};
    }
    // What the rounding of a depth may leave: a step counts most at the rim.
    const auto rounding = [&](const Pattern& pattern) {
        return pattern.count * (cut.removed(pattern.diameter, limits.depth_step).unbalance -
                                cut.removed(pattern.diameter, 0.0).unbalance) +
               1e-12;
    };
    std::optional<Pattern> nearest;  // whatever it leaves
    for (int n = 1; n <= limits.maximum_holes; ++n) {
        std::optional<Pattern> best;
        bool best_is_exact = false;
        for (const double diameter : diameters) {
            const auto found = planner.pattern(n, diameter);
            if (!found) {
                continue;
            }
            const double left = std::abs(found->left);
            if (!nearest || left < std::abs(nearest->left) - 1e-15) {
                nearest = found;
            }
            const bool exact = left <= rounding(*found);
            if (tolerance < 0.0 ? !exact : left > tolerance) {
                continue;
            }
            if (!best || (exact && !best_is_exact) ||
                (exact == best_is_exact && found->metal < best->metal)) {
                best = found;
                best_is_exact = exact;
            }
        }
        if (best) {
            return {planner.holes(*best), best->left, Shortfall::none};
        }
    }
    if (!nearest && !limits.taken.empty()) {
        return {{}, target, Shortfall::too_little_room};
    }
    if (!nearest) {
        return {{}, target, Shortfall::nothing_fits};
    }
    const Shortfall why = std::abs(nearest->left) <= rounding(*nearest) ? Shortfall::rounding
                          : nearest->left > 0.0                         ? Shortfall::too_little_room
                                                                        : Shortfall::nothing_fits;
    if (std::abs(nearest->left) >= target) {
        // A slug that is too short to outweigh the cone of its hole brings less than nothing.
        return {{}, target, nearest->left > target ? why : Shortfall::nothing_fits};
    }
    return {planner.holes(*nearest), nearest->left, why};
}

}  // namespace

bool HoleLimits::allows(double angle) const {
    return !sector || is_inside(angle, *sector);
}

double Cut::cone(double diameter) const {
    return point_angle < pi ? 0.5 * diameter / std::tan(0.5 * point_angle) : 0.0;
}

Removed Cut::removed(double diameter, double depth) const {
    const double area = 0.25 * pi * diameter * diameter;
    const double point = cone(diameter);
    const double cylinder = area * depth;
    const double tip = area * point / 3.0;
    const double lever = radius - 0.5 * depth;
    const double mass = density * (cylinder + tip);
    const double unbalance = density * (cylinder * lever + tip * (radius - depth - 0.25 * point));
    if (!slug_density) {
        return {mass, unbalance};
    }
    const double slug = *slug_density * cylinder;
    return {slug - mass, slug * lever - unbalance, slug};
}

std::optional<double> half_width(const Cut& cut, double diameter, double depth, double wall) {
    // From a plane through the axis: the edge of the bottom at the radius b = R − h, half a
    // diameter to the side, lies b sin a − d/2 cos a away, the tip of the cone (b − c) sin a.
    const double bottom = cut.radius - depth;
    const double tip = bottom - cut.cone(diameter);
    const double reach = std::hypot(bottom, 0.5 * diameter);
    if (tip <= 0.0 || 0.5 * wall >= reach || 0.5 * wall >= tip) {
        return std::nullopt;
    }
    const double edge = std::asin(0.5 * wall / reach) + std::atan2(0.5 * diameter, bottom);
    return std::max(edge, std::asin(0.5 * wall / tip));
}

double edge_beyond(const Cut& cut, const std::pair<double, double>& sector, const Hole& hole) {
    constexpr double rounding = 1e-9;
    if (turn_of(sector.second - sector.first) < rounding) {
        return 0.0;  // all round
    }
    double most = 0.0;
    for (const double inwards :
         {turn_of(hole.angle - sector.first), turn_of(sector.second - hole.angle)}) {
        // From the plane of the limit, as in half_width(); a limit a quarter turn away bounds
        // nothing here.
        const double angle = inwards > 2.0 * pi - rounding ? 0.0 : inwards;
        if (angle < 0.5 * pi) {
            most = std::max(most, 0.5 * hole.diameter * std::cos(angle) -
                                      (cut.radius - hole.depth) * std::sin(angle));
        }
    }
    return most < rounding ? 0.0 : most;
}

std::optional<double> hole_spacing(const Cut& cut, double diameter, double depth, double wall) {
    const auto half = half_width(cut, diameter, depth, wall);
    return half ? std::optional(2.0 * *half) : std::nullopt;
}

HolePlan plan_holes(double target, double angle, const Cut& cut, std::span<const double> diameters,
                    const HoleLimits& limits, double tolerance) {
    HolePlan plan = plan_where(target, angle, cut, diameters, limits, tolerance, false);
    const bool is_inside_whole =
        !limits.sector || std::all_of(plan.holes.begin(), plan.holes.end(), [&](const Hole& hole) {
            return edge_beyond(cut, *limits.sector, hole) == 0.0;
        });
    if (is_inside_whole) {
        return plan;
    }
    HolePlan whole = plan_where(target, angle, cut, diameters, limits, tolerance, true);
    return whole.shortfall == Shortfall::none || std::abs(whole.left) <= std::abs(plan.left) ? whole
                                                                                             : plan;
}

HolePlan plan_beside_sector(double target, double angle, const Cut& cut,
                            std::span<const double> diameters, const HoleLimits& limits,
                            double tolerance) {
    HolePlan best{{}, target, Shortfall::outside_sector};
    if (limits.allows(angle)) {
        return best;
    }
    const auto [from, to] = *limits.sector;
    const double before = turn_of(from - angle);
    const double behind = turn_of(angle - to);
    const double inwards = before <= behind ? 1.0 : -1.0;
    const double away = std::min(before, behind);
    // At the limit itself one hole lies; where it takes a row, or holes are there, further in.
    constexpr double step = 1.0 * degree;
    const double width = turn_of(to - from);
    for (int i = 0; i * step <= width && away + i * step < 0.5 * pi; ++i) {
        const double apart = away + i * step;
        const double across = target * std::sin(apart);
        if (across >= best.left) {
            break;  // which no hole there takes off, nor further in
        }
        const double along =
            across < tolerance ? std::sqrt(tolerance * tolerance - across * across) : -1.0;
        HolePlan plan = plan_holes(target * std::cos(apart), turn_of(angle + inwards * apart), cut,
                                   diameters, limits, along);
        const double left = std::hypot(across, plan.left);
        if (plan.holes.empty() || left >= best.left) {
            continue;
        }
        const bool is_enough = plan.shortfall == Shortfall::none && across < tolerance;
        best = {std::move(plan.holes), left,
                is_enough ? Shortfall::none : Shortfall::beside_sector};
        if (is_enough) {
            break;
        }
    }
    return best;
}

std::array<std::complex<double>, 2> carried_over(
    const std::array<std::complex<double>, 2>& unbalance, const std::array<double, 2>& from,
    const std::array<double, 2>& to) {
    // Same force, U₁ + U₂ = A + B; same moment, U₁ z₁ + U₂ z₂ = A a + B b.
    const double distance = to[1] - to[0];
    std::array<std::complex<double>, 2> carried{};
    for (std::size_t i = 0; i < 2; ++i) {
        const double share = (from[i] - to[0]) / distance;
        carried[0] += (1.0 - share) * unbalance[i];
        carried[1] += share * unbalance[i];
    }
    return carried;
}

double turn_of(double angle) {
    const double turn = std::fmod(angle, 2.0 * pi);
    const double positive = turn < 0.0 ? turn + 2.0 * pi : turn;
    // What rounding leaves just below a turn is 0.
    return positive > 2.0 * pi - 1e-12 ? 0.0 : positive;
}

}  // namespace ravnoves::bob_weights
