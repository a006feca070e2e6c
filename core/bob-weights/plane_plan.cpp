#include "bob-weights/plane_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "shop/balance_grade.h"
#include "shop/sentences.h"

namespace ravnoves::bob_weights {

namespace {

using Vector = std::complex<double>;

/// Whether a slug adds next to nothing, for its hole takes off nearly as much.
bool is_light(double slug_density, double density) {
    constexpr double minimum = 1.1;
    return slug_density < minimum * density;
}

/// Why holes and slugs together leave too much.
Shortfall shortfall_of_both(Shortfall holes, Shortfall slugs) {
    if (holes == Shortfall::outside_sector || holes == Shortfall::beside_sector) {
        return slugs == Shortfall::outside_sector || slugs == Shortfall::too_little_room ? holes
                                                                                         : slugs;
    }
    // Where no slug may lie there is still what the holes left.
    return slugs == Shortfall::outside_sector ? Shortfall::too_little_room : slugs;
}

/// What is planned for a plane.
struct Planned {
    Metal metal;
    Shortfall shortfall = Shortfall::none;
};

/// Plans holes and slugs of one plane.
class PlanePlanner {
  public:
    /// @param before  what was drilled there and pressed in after earlier runs
    PlanePlanner(const Plane& plane, const Correction& correction,
                 const std::optional<double>& permissible, const Metal& before)
        : correction_(correction),
          tolerance_(permissible.value_or(-1.0)),
          enough_(correction.aim == Aim::zero ? -1.0 : tolerance_),
          cut_{*plane.radius, correction.drill.density, correction.drill.point_angle},
          into_(cut_),
          limits_{correction.drill.maximum_depth.value_or(std::numeric_limits<double>::infinity()),
                  correction.drill.depth_step,
                  correction.drill.minimum_wall,
                  correction.drill.maximum_holes,
                  correction.drill.maximum_angle,
                  std::nullopt},
          is_drilled_(!before.empty()) {
        const auto& slug = correction.slug;
        has_slugs_ = slug && slug->diameter && slug->density;
        if (has_slugs_) {
            into_.slug_density = slug->density;
            if (slug->direction == SlugDirection::axial) {
                into_.axial_wall = limits_.minimum_wall;
            }
        }
        limits_.smallest_depth = correction.smallest_depth;
        limits_.sector = plane.sector();
        for (const double diameter : correction.drill.diameters_mm) {
            diameters_.push_back(diameter * units::mm);
        }
        for (const Hole& slug_before : before.slugs) {
            Cut cut = cut_;
            if (slug_before.is_axial) {
                cut.axial_wall = limits_.minimum_wall;
            }
            take(slug_before, cut, limits_);
        }
        for (const Hole& hole : before.holes) {
            keep_deepest(hole);
        }
    }

    /// Why more is left than may be, and what helps.
    /// @param left  by the plan
    Message reason(const Planned& planned, Vector left) const {
        const Message cause = cause_of(planned.shortfall);
        if (planned.shortfall == Shortfall::none || planned.shortfall == Shortfall::nothing_fits ||
            planned.shortfall == Shortfall::rounding) {
            return cause;
        }
        const double opposite = turn_of(std::arg(left) + pi);
        const bool can_press = limits_.allows(opposite);
        // Across the holes no depth helps.
        constexpr double maximum = 60.0 * degree;
        const bool can_deepen = std::ranges::any_of(planned.metal.holes, [&](const Hole& hole) {
            return std::abs(std::remainder(hole.angle - std::arg(left), 2.0 * pi)) < maximum;
        });
        const Message remains{Text::tr("Residual: %1 at the drilling radius at %2."),
                              shop::in_grams(std::abs(left) / cut_.radius),
                              Number{turn_of(std::arg(left)) / degree, units::degree, -1}};
        // By its angle: "that side" was read as the heavy one.
        Message remedy{Text::tr("As a last resort weld an equal mass at %1."),
                       Number{opposite / degree, units::degree, -1}};
        if (!can_press || !has_slugs_) {
            remedy = shop::two_sentences(
                !can_press && !can_deepen
                    ? Text::tr("The opposite side is outside the sector too: widen the sector if "
                               "there is metal.")
                : !can_press ? Text::tr("The opposite side is outside the sector too: drill "
                                        "deeper or wider.")
                : can_deepen ? Text::tr("Press in heavy metal opposite, or drill deeper or wider.")
                             : Text::tr("Press in heavy metal opposite."),
                remedy);
        }
        if (const Message no_slug = why_no_slug(opposite, planned); can_press && !no_slug.empty()) {
            remedy = shop::two_sentences(no_slug, remedy);
        }
        return {Text{"%1 %2 %3"}, cause, remains, remedy};
    }

    TriedRoom room_for(const Hole& hole) const {
        HoleLimits limits = limits_;
        limits.depth_step = 0.0;
        double from_depth = 0.0;
        double angle = hole.angle;
        for (const Hole& there : there_) {
            if (there.depth < hole.depth && are_one_hole(there, hole, cut_.radius)) {
                from_depth = there.depth;
                angle = there.angle;
            } else {
                take(there, cut_, limits);
            }
        }
        return {room_at(angle, cut_, hole.diameter, hole.depth, limits),
                deepest_hole(hole.diameter, cut_, limits), from_depth, angle};
    }

    Planned plan(Vector unbalance) const {
        // What is within its limit needs no hole, whatever the aim.
        if (std::abs(unbalance) <= std::max(tolerance_, 0.0)) {
            return {};
        }
        // Another hole is worth its while where more than half of the limit would be left, to be
        // deepened where it is more than a tenth.
        const bool to_zero = correction_.aim == Aim::zero;
        std::vector<Hole> at_hand;  // holes with a drill to deepen them
        HoleLimits beside_others = limits_;
        for (const Hole& hole : there_) {
            if (correction_.deepens && has_drill(hole.diameter)) {
                at_hand.push_back(hole);
            } else {
                take(hole, cut_, beside_others);
            }
        }
        const HolePlan deeper = plan_deepening(
            unbalance, at_hand, cut_, beside_others, to_zero ? 0.1 * tolerance_ : tolerance_,
            has_limit() ? tolerance_ : std::numeric_limits<double>::infinity());
        const double good = std::max(to_zero ? 0.5 * tolerance_ : tolerance_, 0.0);
        if (deeper.shortfall == Shortfall::none || deeper.left <= good) {
            return {{deeper.holes, {}}, Shortfall::none};
        }
        const HoleLimits limits = beside_all();
        // What the deepened holes leave is elsewhere, the heavy spot is not.
        HoleLimits beside = limits;
        beside.heavy_spot = std::arg(unbalance);
        for (const Hole& hole : deeper.holes) {
            take(hole, cut_, beside);
        }
        const Planned fresh = plan_new(unbalance, limits);
        if (deeper.holes.empty()) {
            return fresh;
        }
        Planned both = plan_new(unbalance + effect_of({deeper.holes, {}}), beside);
        both.metal.holes.insert(both.metal.holes.begin(), deeper.holes.begin(), deeper.holes.end());
        return is_better(fresh, both, unbalance, good) ? fresh : both;
    }

    double beyond_sector(const Metal& metal) const {
        double maximum = 0.0;
        for (const auto& [holes, cut] :
             {std::pair(&metal.holes, &cut_), std::pair(&metal.slugs, &into_)}) {
            for (const Hole& hole : *holes) {
                maximum = limits_.sector
                              ? std::max(maximum, edge_beyond(*cut, *limits_.sector, hole))
                              : 0.0;
            }
        }
        return maximum;
    }

  private:
    Message cause_of(Shortfall shortfall) const {
        static constexpr Text causes[] = {
            {},
            Text::tr(
                "The smallest hole takes off too much: use a smaller drill or a flatter point."),
            Text::tr("There is too little room for the holes."),
            Text::tr("Rounding of the depths leaves more than the limit: use a finer step or a "
                     "smaller drill."),
            Text::tr("The heavy spot is outside the drilling sector."),
            Text::tr("The heavy spot is outside the drilling sector; holes at its edge take off "
                     "only a part."),
            Text::tr(
                "Slugs of %1 are hardly heavier than the crankshaft metal (%2) of their holes: "
                "none are planned."),
            Text::tr("A slug of %1 of maximum depth is lighter than the crankshaft metal (%2) of "
                     "its hole with the cone: none are planned.")};  // as Shortfall
        if (shortfall == Shortfall::too_little_room && is_drilled_) {
            return Text::tr("There is too little room next to the holes of earlier runs.");
        }
        const auto density = [](double of) { return Number{of / units::kg_m3, units::kg_m3}; };
        return {causes[static_cast<std::size_t>(shortfall)],
                density(into_.slug_density.value_or(0.0)), density(cut_.density)};
    }

    /// Why no slug is pressed in at an angle; empty where one is planned, none is set up, or its
    /// metal is the reason.
    Message why_no_slug(double angle, const Planned& planned) const {
        if (!has_slugs_ || !planned.metal.slugs.empty() ||
            planned.shortfall == Shortfall::light_slugs ||
            planned.shortfall == Shortfall::short_slugs) {
            return {};
        }
        const HoleLimits limits = beside_all();
        const double diameter = *correction_.slug->diameter;
        const Number size{diameter / units::mm, units::mm, -2};
        const NoRoom missing = room_at(angle, into_, diameter, smallest_hole(limits), limits);
        if (missing == NoRoom::none) {
            return {Text::tr("Even the shortest slug of ⌀ %1 adds too much."), size};
        }
        return shop::two_sentences({Text::tr("No slug of ⌀ %1 fits at %2."), size,
                                    Number{angle / degree, units::degree, -1}},
                                   describe(missing, limits.maximum_depth));
    }

    /// Clear of all that is there.
    HoleLimits beside_all() const {
        HoleLimits limits = limits_;
        for (const Hole& hole : there_) {
            take(hole, cut_, limits);
        }
        return limits;
    }
    void take(const Hole& hole, const Cut& cut, HoleLimits& limits) const {
        limits.taken.push_back(
            {hole.angle, half_width(cut, hole.diameter, hole.depth, limits.minimum_wall)});
    }

    /// A hole that was deepened is in the record more than once.
    void keep_deepest(const Hole& hole) {
        for (Hole& there : there_) {
            if (are_one_hole(there, hole, cut_.radius)) {
                there = there.depth >= hole.depth ? there : hole;
                return;
            }
        }
        there_.push_back(hole);
    }

    /// Whether new holes alone are better than they are beside deepened ones: enough where the
    /// others are not, or with fewer holes, or what is left is less.
    static bool is_better(const Planned& fresh, const Planned& both, Vector unbalance,
                          double good) {
        const auto count = [](const Planned& planned) {
            return planned.metal.holes.size() + planned.metal.slugs.size();
        };
        const auto left = [&](const Planned& planned) {
            return std::abs(unbalance + effect_of(planned.metal));
        };
        const auto is_enough = [&](const Planned& planned) {
            return planned.shortfall == Shortfall::none || left(planned) <= good;
        };
        if (is_enough(fresh) != is_enough(both)) {
            return is_enough(fresh);
        }
        return is_enough(fresh) ? count(fresh) < count(both) : left(fresh) < left(both);
    }

    bool has_drill(double diameter) const {
        constexpr double rounding = 0.01 * units::mm;
        return std::ranges::any_of(
            diameters_, [&](double each) { return std::abs(each - diameter) < rounding; });
    }
    bool has_limit() const { return tolerance_ >= 0.0; }

    /// The plan by the aim; where the steps of its depths leave more than the limit, by the limit.
    /// @param plan  of what may be left
    HolePlan within_limit(const auto& plan) const {
        HolePlan found = plan(enough_);
        return enough_ < 0.0 && has_limit() && std::abs(found.left) > tolerance_ ? plan(tolerance_)
                                                                                 : found;
    }

    /// Slugs opposite what the holes leave.
    void press_slugs(Vector unbalance, Planned& planned, HoleLimits limits) const {
        limits.heavy_spot.reset();  // a slug is opposite
        const Vector rest = unbalance + effect_of(planned.metal);
        const double target = std::abs(rest);
        if (!has_slugs_ || target <= std::max(tolerance_, 0.0)) {
            return;
        }
        const double angle = turn_of(std::arg(rest) + pi);
        const double size[] = {*correction_.slug->diameter};
        HolePlan slugs{{}, target, Shortfall::light_slugs};
        if (!limits.allows(angle) || !is_light(*into_.slug_density, correction_.drill.density)) {
            slugs = within_limit([&](double enough) {
                return plan_holes(target, angle, into_, size, limits, enough);
            });
        }
        for (Hole& hole : slugs.holes) {
            hole.is_axial = into_.axial_wall.has_value();
        }
        const double deepest = limits.maximum_depth;
        if (slugs.holes.empty() && limits.allows(angle) && deepest > 0.0 &&
            slugs.shortfall != Shortfall::light_slugs && into_.lever(size[0], deepest) > 0.0 &&
            into_.removed(size[0], deepest).unbalance <= 0.0) {
            slugs.shortfall = Shortfall::short_slugs;
        }
        planned.metal.slugs = std::move(slugs.holes);
        planned.shortfall = shortfall_of_both(planned.shortfall, slugs.shortfall);
    }

    Planned plan_new(Vector unbalance, const HoleLimits& limits) const {
        const double target = std::abs(unbalance);
        const double angle = turn_of(std::arg(unbalance));
        HolePlan plan = within_limit([&](double enough) {
            return plan_holes(target, angle, cut_, diameters_, limits, enough);
        });
        Planned planned{{std::move(plan.holes), {}}, plan.shortfall};
        const bool is_cramped = plan.shortfall == Shortfall::too_little_room;
        if (plan.left > std::max(tolerance_, 0.0) &&
            (is_cramped || plan.shortfall == Shortfall::outside_sector)) {
            press_slugs(unbalance, planned, limits);
        }
        const bool is_free = limits.taken.empty() && !is_cramped;
        if (planned.shortfall == Shortfall::none || (limits.allows(angle) && is_free)) {
            return planned;
        }
        HolePlan beside = within_limit([&](double enough) {
            return plan_beside_sector(target, angle, cut_, diameters_, limits, enough);
        });
        Planned other{{std::move(beside.holes), {}}, beside.shortfall};
        if (!other.metal.holes.empty() && other.shortfall != Shortfall::none) {
            HoleLimits clear = limits;
            for (const Hole& hole : other.metal.holes) {
                take(hole, cut_, clear);
            }
            press_slugs(unbalance, other, clear);
        }
        // Where welding remains anyway a hole is to save some of it.
        constexpr double worth = 0.9;
        const double without = std::abs(unbalance + effect_of(planned.metal));
        const double with = std::abs(unbalance + effect_of(other.metal));
        return with < (other.shortfall == Shortfall::none ? 1.0 : worth) * without ? other
                                                                                   : planned;
    }

    const Correction& correction_;
    double tolerance_;
    double enough_;
    Cut cut_;
    Cut into_;  ///< of slugs
    HoleLimits limits_;
    bool is_drilled_;  ///< in earlier runs
    bool has_slugs_ = false;
    std::vector<double> diameters_;
    std::vector<Hole> there_;
};

}  // namespace

Vector effect_of(const Metal& metal) {
    Vector sum;
    for (const Hole& hole : metal.holes) {
        sum -= std::polar(hole.unbalance, hole.angle);
    }
    for (const Hole& slug : metal.slugs) {
        sum += std::polar(slug.unbalance, slug.angle);
    }
    return sum;
}

bool are_one_hole(const Hole& a, const Hole& b, double radius) {
    constexpr double apart = 2.0 * units::mm;  // more than a degree at the rim
    return a.diameter == b.diameter &&
           radius * std::abs(std::remainder(a.angle - b.angle, 2.0 * pi)) < apart;
}

Message describe(NoRoom missing, double maximum_depth) {
    static constexpr Text words[] = {{},
                                     Text::tr("Too deep: the maximum depth is %1."),
                                     Text::tr("Too deep: no wall remains to the other holes."),
                                     Text::tr("The hole is outside the drilling sector."),
                                     Text::tr("Another hole is too near.")};  // as NoRoom
    return {words[static_cast<std::size_t>(missing)],
            Number{maximum_depth / units::mm, units::mm, -2}};
}

TriedRoom room_for(const Hole& hole, const Plane& plane, const Correction& correction,
                   const Metal& before) {
    return PlanePlanner(plane, correction, std::nullopt, before).room_for(hole);
}

PlaneResult plan_plane(Vector unbalance, const Plane& plane, const Correction& correction,
                       const std::optional<double>& permissible, const Metal& before) {
    const PlanePlanner planner(plane, correction, permissible, before);
    Planned planned = planner.plan(unbalance);
    const Vector left = unbalance + effect_of(planned.metal);
    PlaneResult result{std::abs(unbalance),
                       turn_of(std::arg(unbalance)),
                       {},
                       {},
                       planner.beyond_sector(planned.metal),
                       std::abs(left),
                       turn_of(std::arg(left)),
                       shop::is_within(std::abs(left), permissible),
                       {}};
    if (result.within_tolerance != true) {
        result.reason = planner.reason(planned, left);
    }
    result.holes = std::move(planned.metal.holes);
    result.slugs = std::move(planned.metal.slugs);
    return result;
}

}  // namespace ravnoves::bob_weights
