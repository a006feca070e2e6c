#include "bob-weights/drilling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "numerics/constants.h"
#include "numerics/units.h"

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

/// Down to a step.
double stepped(double depth, const HoleLimits& limits) {
    return limits.depth_step > 0.0
               ? limits.depth_step * std::floor(depth / limits.depth_step + 1e-9)
               : depth;
}

class Planner {
  public:
    Planner(double target, double angle, const Cut& cut, const HoleLimits& limits)
        : target_(target),
          angle_(angle),
          cut_(cut),
          limits_(limits),
          minimum_(smallest_hole(limits)),
          reach_(limits.maximum_angle -
                 std::abs(std::remainder(angle - limits.heavy_spot.value_or(angle), 2.0 * pi))) {}

    double deepest(double diameter) const { return deepest_hole(diameter, cut_, limits_); }

    /// n holes that take off the target, or as much as they can; nothing where they have no room
    /// or one alone would take off too much.
    std::optional<Pattern> pattern(int n, double diameter) const {
        const double maximum = deepest(diameter);
        const auto smallest = maximum < minimum_ ? std::nullopt : taken(n, diameter, minimum_);
        if (!smallest) {
            return std::nullopt;
        }
        // What n holes take off grows with the depth: their unbalance does, and where the spacing
        // grows it costs less than the depth brings as long as the holes are above the axis. It
        // falls alone where a hole has to leap over one of an earlier run.
        const auto may_be_deeper = [&](double depth) {
            const auto there = taken(n, diameter, depth);
            return there && *there <= target_;
        };
        constexpr int steps = 32;
        double depth = minimum_;
        double low = minimum_;
        double best = *smallest;
        for (int i = 1; i <= steps && best <= target_; ++i) {
            double high = minimum_ + (maximum - minimum_) * i / steps;
            const auto there = taken(n, diameter, high);
            if (there && *there <= target_) {
                depth = *there > best ? high : depth;
                best = std::max(best, *there);
                low = high;
                continue;
            }
            for (int k = 0; k < 100 && high - low > 1e-12; ++k) {
                const double middle = 0.5 * (low + high);
                (may_be_deeper(middle) ? low : high) = middle;
            }
            depth = there || *taken(n, diameter, low) > best ? low : depth;
            break;
        }
        depth = rounded(n, diameter, depth, maximum);
        const Removed one = cut_.removed(diameter, depth);
        return Pattern{n, diameter, depth, target_ - *taken(n, diameter, depth), n * one.mass};
    }

    NoRoom room_for_one(double diameter, double depth) const {
        constexpr double rounding = 1e-12;
        if (depth > deepest(diameter) + rounding) {
            return NoRoom::too_deep;
        }
        const bool has_room = taken(1, diameter, depth).has_value();
        // A hole that is alone in the rim may reach the axis.
        if (!half_width(cut_, diameter, depth, limits_.minimum_wall) &&
            (cut_.axial_wall || !has_room)) {
            return NoRoom::behind_wall;
        }
        return !may_lie(angle_, diameter, depth) ? NoRoom::in_sector
               : has_room                        ? NoRoom::none
                                                 : NoRoom::beside_hole;
    }

    std::vector<Hole> holes(const Pattern& pattern) const {
        std::vector<Hole> list;
        const Removed one = cut_.removed(pattern.diameter, pattern.depth);
        const double lever = cut_.lever(pattern.diameter, pattern.depth);
        std::vector<double> places;
        place(pattern.count, pattern.diameter, pattern.depth,
              [&](double offset) { places.push_back(offset); });
        std::sort(places.begin(), places.end());
        for (const double offset : places) {
            list.push_back({pattern.diameter, pattern.depth, turn_of(angle_ + offset), one.mass,
                            one.unbalance, one.slug, lever});
        }
        return list;
    }

  private:
    /// What n holes of a depth take off along the angle; nothing where they have no room.
    std::optional<double> taken(int n, double diameter, double depth) const {
        double cosines = 0.0;
        const bool fit =
            place(n, diameter, depth, [&](double offset) { cosines += std::cos(offset); });
        return fit ? std::optional(cut_.removed(diameter, depth).unbalance * cosines)
                   : std::nullopt;
    }

    bool may_lie(double angle, double diameter, double depth) const {
        return !limits_.sector ||
               (limits_.allows(angle) &&
                edge_beyond(cut_, *limits_.sector, {diameter, depth, angle, 0.0, 0.0}) == 0.0);
    }

    /// Visits the angles from the middle to each of n holes.
    /// @return whether all have room
    bool place(int n, double diameter, double depth, auto&& visit) const {
        const auto half = half_width(cut_, diameter, depth, limits_.minimum_wall);
        if (!half && (n > 1 || !limits_.taken.empty())) {
            return false;
        }
        double offset = half.value_or(0.0);
        if (n % 2 == 1) {
            if (reach_ < 0.0 || !may_lie(angle_, diameter, depth) ||
                clear_of_taken(0.0, offset) != 0.0) {
                return false;
            }
            visit(0.0);
            offset *= 2.0;
        }
        for (int pair = 0; pair < n / 2; ++pair) {
            const auto clear = clear_of_taken(offset, *half);
            if (!clear || *clear > reach_ || !may_lie(angle_ - *clear, diameter, depth) ||
                !may_lie(angle_ + *clear, diameter, depth)) {
                return false;
            }
            visit(-*clear);
            visit(*clear);
            offset = *clear + 2.0 * *half;
        }
        return true;
    }

    /// The smallest angle from `offset` on at which a hole on either side keeps clear of what is
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

    /// To the nearer step that has room.
    double rounded(int n, double diameter, double depth, double maximum) const {
        if (limits_.depth_step <= 0.0) {
            return depth;
        }
        const double below = std::max(minimum_, stepped(depth, limits_));
        const double above = below + limits_.depth_step;
        const auto there = above <= maximum + 1e-12 ? taken(n, diameter, above) : std::nullopt;
        return there && std::abs(*there - target_) < std::abs(*taken(n, diameter, below) - target_)
                   ? above
                   : below;
    }

    double target_;
    double angle_;
    const Cut& cut_;
    const HoleLimits& limits_;
    double minimum_;  ///< depth of a hole, m
    double reach_;    ///< from the middle to the last hole, rad
};

}  // namespace

HolePlan plan_holes(double target, double angle, const Cut& cut, std::span<const double> diameters,
                    const HoleLimits& limits, double tolerance) {
    const Planner planner(target, angle, cut, limits);
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
    if (!nearest && (limits.sector || !limits.taken.empty())) {
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

NoRoom room_at(double angle, const Cut& cut, double diameter, double depth,
               const HoleLimits& limits) {
    return Planner(0.0, angle, cut, limits).room_for_one(diameter, depth);
}

double smallest_hole(const HoleLimits& limits) {
    return limits.depth_step > 0.0
               ? limits.depth_step * std::ceil(limits.smallest_depth / limits.depth_step - 1e-9)
               : limits.smallest_depth;
}

double deepest_hole(double diameter, const Cut& cut, const HoleLimits& limits) {
    const double room = cut.axial_wall ? limits.maximum_depth : cut.radius - cut.cone(diameter);
    return stepped(std::min(limits.maximum_depth, room), limits);
}

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
    const double middle = lever(diameter, depth);
    const double tip_radius = axial_wall ? middle : radius - depth - 0.25 * point;
    const double mass = density * (cylinder + tip);
    const double unbalance = density * (cylinder * middle + tip * tip_radius);
    if (!slug_density) {
        return {mass, unbalance};
    }
    const double slug = *slug_density * cylinder;
    return {slug - mass, slug * middle - unbalance, slug};
}

double Cut::lever(double diameter, double depth) const {
    return axial_wall ? radius - *axial_wall - 0.5 * diameter : radius - 0.5 * depth;
}

std::optional<double> half_width(const Cut& cut, double diameter, double depth, double wall) {
    if (cut.axial_wall) {
        const double share = 0.5 * (diameter + wall) / cut.lever(diameter, depth);
        return share > 0.0 && share < 1.0 ? std::optional(std::asin(share)) : std::nullopt;
    }
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
    double maximum = 0.0;
    for (const double inwards :
         {turn_of(hole.angle - sector.first), turn_of(sector.second - hole.angle)}) {
        // From the plane of the limit, as in half_width(); a limit a quarter turn away bounds
        // nothing here.
        const double angle = inwards > 2.0 * pi - rounding ? 0.0 : inwards;
        if (angle < 0.5 * pi) {
            maximum = std::max(
                maximum, cut.axial_wall ? 0.5 * hole.diameter -
                                              cut.lever(hole.diameter, hole.depth) * std::sin(angle)
                                        : 0.5 * hole.diameter * std::cos(angle) -
                                              (cut.radius - hole.depth) * std::sin(angle));
        }
    }
    return maximum < rounding ? 0.0 : maximum;
}

HolePlan plan_beside_sector(double target, double angle, const Cut& cut,
                            std::span<const double> diameters, const HoleLimits& limits,
                            double tolerance) {
    const bool is_inside = limits.allows(angle);
    HolePlan best{{}, target, is_inside ? Shortfall::too_little_room : Shortfall::outside_sector};
    // From an angle in the sector to both sides, first away from its nearer limit; else from that
    // limit inwards.
    const auto [from, to] = limits.sector.value_or(std::pair(0.0, 0.0));
    const double before = is_inside ? turn_of(angle - from) : turn_of(from - angle);
    const double behind = is_inside ? turn_of(to - angle) : turn_of(angle - to);
    const double inwards = before <= behind ? 1.0 : -1.0;
    const double away = is_inside ? 0.0 : std::min(before, behind);
    constexpr double step = 1.0 * degree;
    HoleLimits about = limits;
    about.heavy_spot = limits.heavy_spot.value_or(angle);
    for (double apart = away; apart < 0.5 * pi; apart += step) {
        const double across = target * std::sin(apart);
        const bool is_enough = across < tolerance;
        const double along = is_enough ? std::sqrt(tolerance * tolerance - across * across) : -1.0;
        for (const double side : {inwards, -inwards}) {
            // What no hole there takes off, nor further in, or that is enough.
            if (across >= best.left || best.shortfall == Shortfall::none) {
                return best;
            }
            HolePlan plan = plan_holes(target * std::cos(apart), turn_of(angle + side * apart), cut,
                                       diameters, about, along);
            const double left = std::hypot(across, plan.left);
            if (!plan.holes.empty() && left < best.left) {
                best = {std::move(plan.holes), left,
                        is_enough && plan.shortfall == Shortfall::none ? Shortfall::none
                        : is_inside                                    ? Shortfall::too_little_room
                                                                       : Shortfall::beside_sector};
            }
        }
    }
    return best;
}

namespace {

/// Looks for the depths of holes that are there, on the grid of the depth step.
class Deepener {
  public:
    using Vector = std::complex<double>;

    Deepener(Vector unbalance, const std::vector<Hole>& holes, const Cut& cut,
             const HoleLimits& limits)
        : unbalance_(unbalance), cut_(cut), limits_(limits) {
        for (const Hole& hole : holes) {
            add(hole);
        }
        for (const Taken& taken : limits.taken) {
            Hole hole{};
            hole.angle = taken.angle;
            all_.push_back({hole, std::polar(1.0, taken.angle), {{0.0, 0.0, taken.half_width}}});
        }
    }

    HolePlan plan(double enough, double limit) const {
        const Depths present(all_.size(), 0);
        Depths best = present;
        const auto is_enough = [&] {
            return left(best) <= std::max(enough, std::min(steps_of(best), limit));
        };
        // One hole, two, and then any two of them at a time as long as that helps.
        constexpr int most = 22;
        for (int round = 0; round < most; ++round) {
            Depths found = best_of(round < 2 ? present : best, round > 0);
            const bool helps = left(found) < left(best) - rounding;
            if (helps) {
                best = std::move(found);
            }
            if (round < 2 ? is_enough() : !helps) {
                break;
            }
        }
        return {deepened(best), left(best),
                is_enough() ? Shortfall::none : Shortfall::too_little_room};
    }

  private:
    static constexpr double rounding = 1e-12;  // kg·m
    static constexpr int max_candidates = 12;
    using Depths = std::vector<std::size_t>;  // in steps beyond the present depth

    struct Step {
        double depth;                ///< m
        double taken;                ///< beyond the present depth, kg·m
        std::optional<double> half;  ///< of its width, wall included, rad
    };
    struct Each {
        Hole hole;
        Vector along;
        std::vector<Step> steps;  ///< the present depth alone where it cannot be deepened
    };

    void add(const Hole& hole) {
        const double away = std::abs(std::remainder(hole.angle - std::arg(unbalance_), 2.0 * pi));
        const bool may = away <= limits_.maximum_angle && limits_.allows(hole.angle) &&
                         candidates_ < max_candidates;
        const double maximum = may ? deepest_hole(hole.diameter, cut_, limits_) : 0.0;
        candidates_ += maximum > hole.depth ? 1 : 0;
        Each each{hole, std::polar(1.0, hole.angle), {}};
        const double step = step_to(maximum - hole.depth);
        const double now = cut_.removed(hole.diameter, hole.depth).unbalance;
        double depth = hole.depth;
        while (each.steps.empty() || depth <= maximum + rounding) {
            each.steps.push_back({depth, cut_.removed(hole.diameter, depth).unbalance - now,
                                  half_width(cut_, hole.diameter, depth, limits_.minimum_wall)});
            depth = stepped(hole.depth, limits_) + static_cast<double>(each.steps.size()) * step;
        }
        all_.push_back(std::move(each));
    }

    /// The step of the depths, or so many of them that no more are tried than there is time for.
    double step_to(double span) const {
        constexpr double max_steps = 1000.0;
        const double minimum = span / max_steps;
        return limits_.depth_step > 0.0
                   ? limits_.depth_step * std::max(1.0, std::ceil(minimum / limits_.depth_step))
                   : std::max(0.01e-3, minimum);
    }

    Vector rest(const Depths& depths) const {
        Vector sum = unbalance_;
        for (std::size_t i = 0; i < all_.size(); ++i) {
            sum -= all_[i].steps[depths[i]].taken * all_[i].along;
        }
        return sum;
    }
    double left(const Depths& depths) const { return std::abs(rest(depths)); }

    /// What the rounding of the depths may leave.
    double steps_of(const Depths& depths) const {
        double sum = rounding;
        for (std::size_t i = 0; i < all_.size(); ++i) {
            const auto& steps = all_[i].steps;
            sum += depths[i] > 0 ? steps[depths[i]].taken - steps[depths[i] - 1].taken : 0.0;
        }
        return sum;
    }

    /// Whether a hole keeps its walls to all that one of both is deepened for.
    bool fits(const Depths& depths, std::size_t i) const {
        const auto& own = all_[i].steps[depths[i]].half;
        for (std::size_t k = 0; k < all_.size(); ++k) {
            const auto& other = all_[k].steps[depths[k]].half;
            const double apart =
                std::abs(std::remainder(all_[i].hole.angle - all_[k].hole.angle, 2.0 * pi));
            if (k != i && (depths[i] > 0 || depths[k] > 0) &&
                !(own && other && apart >= *own + *other - rounding)) {
                return false;
            }
        }
        return true;
    }

    /// The best depth of one hole, the others as they are.
    void set_best(Depths& depths, std::size_t i) const {
        depths[i] = 0;
        // What lies along the hole; of the steps beside it the nearer one, as deep as walls allow.
        const double wanted = std::real(rest(depths) * std::conj(all_[i].along));
        const auto& all = all_[i].steps;
        const auto above = std::ranges::lower_bound(all, wanted, {}, &Step::taken) - all.begin();
        auto steps = std::min(static_cast<std::size_t>(above), all.size() - 1);
        if (steps > 0 && wanted - all[steps - 1].taken < std::abs(all[steps].taken - wanted)) {
            --steps;
        }
        const auto may = [&](std::size_t depth) {
            depths[i] = depth;
            return fits(depths, i);
        };
        if (may(steps)) {
            return;
        }
        std::size_t low = 0;
        while (steps - low > 1) {
            const std::size_t middle = (low + steps) / 2;
            (may(middle) ? low : steps) = middle;
        }
        depths[i] = low;
    }

    /// The best depth of one hole, or of two, the others as they are.
    Depths best_of(const Depths& from, bool two) const {
        Depths best = from;
        const auto take = [&](const Depths& found) {
            if (left(found) < left(best) - rounding) {
                best = found;
            }
        };
        for (std::size_t i = 0; i < all_.size(); ++i) {
            if (all_[i].steps.size() == 1) {
                continue;
            }
            Depths depths = from;
            set_best(depths, i);
            take(depths);
            for (std::size_t k = 0; two && k < i; ++k) {
                depths = from;
                for (std::size_t step = 0; all_[k].steps.size() > 1 && step < all_[i].steps.size();
                     ++step) {
                    depths[i] = step;
                    depths[k] = 0;
                    if (!fits(depths, i)) {
                        break;
                    }
                    set_best(depths, k);
                    take(depths);
                }
            }
        }
        return best;
    }

    std::vector<Hole> deepened(const Depths& depths) const {
        std::vector<Hole> list;
        for (std::size_t i = 0; i < all_.size(); ++i) {
            if (depths[i] > 0) {
                Hole hole = all_[i].hole;
                const Step& step = all_[i].steps[depths[i]];
                hole.from_depth = hole.depth;
                hole.depth = step.depth;
                hole.mass = cut_.removed(hole.diameter, hole.depth).mass -
                            cut_.removed(hole.diameter, hole.from_depth).mass;
                hole.unbalance = step.taken;
                list.push_back(hole);
            }
        }
        return list;
    }

    Vector unbalance_;
    Cut cut_;
    HoleLimits limits_;
    std::vector<Each> all_;
    int candidates_ = 0;
};

}  // namespace

HolePlan plan_deepening(std::complex<double> unbalance, const std::vector<Hole>& holes,
                        const Cut& cut, const HoleLimits& limits, double enough, double limit) {
    return Deepener(unbalance, holes, cut, limits).plan(enough, limit);
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

bool is_usual_drill(double diameter) {
    constexpr double rounding = 0.006 * units::mm;
    return std::abs(std::remainder(diameter, 0.05 * units::mm)) < rounding ||
           std::abs(std::remainder(diameter, units::inch.to_si / 64.0)) < rounding;
}

}  // namespace ravnoves::bob_weights
