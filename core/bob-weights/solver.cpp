#include "bob-weights/solver.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "bob-weights/fields.h"
#include "bob-weights/matching.h"
#include "case-file/input_error.h"
#include "shop/balance_grade.h"
#include "shop/kilograms.h"
#include "shop/sentences.h"

namespace ravnoves::bob_weights {

namespace {

using Vector = std::complex<double>;

std::optional<double> permissible_of_rotor(const Tolerance& tolerance) {
    if (!tolerance.grade || !tolerance.rotor_mass || !tolerance.service_speed) {
        return std::nullopt;
    }
    return shop::permissible_unbalance(*tolerance.rotor_mass, *tolerance.grade,
                                       *tolerance.service_speed);
}

/// Shares of two places in what acts at `centre`, as the standard keeps them.
std::array<double, 2> shares(const std::array<double, 2>& places, double centre) {
    const double first = std::clamp((places[1] - centre) / (places[1] - places[0]), 0.3, 0.7);
    return {first, 1.0 - first};
}

/// How many times the part counts.
double factor_of(const PartField& part, const Engine& engine, double factor) {
    switch (part.kind) {
        case PartKind::reciprocating:
            return engine.rods_on_crankpin() * factor;
        case PartKind::rotating:
            return engine.rods_on_crankpin();
        case PartKind::crankpin:
            return 1.0;
    }
    return 0.0;
}

void solve_bob_weight(const Input& input, double factor, Result& result) {
    const std::vector<const Field*> missing = missing_for_bob_weight(input);
    const bool known = missing.empty();
    double reciprocating = 0.0;
    double rotating = 0.0;
    double sum = 0.0;
    for (const PartField& part : part_fields()) {
        const auto mass = mass_of(input, part);
        if (!mass) {
            if (std::find(missing.begin(), missing.end(), &part.field) == missing.end()) {
                result.not_given.push_back(&part);
            }
            continue;
        }
        const Line line{&part, factor_of(part, input.engine, factor), *mass};
        result.lines.push_back(line);
        sum += line.product();
        reciprocating += part.kind == PartKind::reciprocating ? *mass : 0.0;
        rotating += part.kind == PartKind::rotating ? *mass : 0.0;
    }
    if (known) {
        result.reciprocating = reciprocating;
        result.rotating = rotating;
        result.bob_weight = sum;
        result.first_order = first_order(input.engine, factor, reciprocating);
        result.first_order_bare = first_order(input.engine, 0.0, reciprocating);
    }
}

/// Masses that would be grams if they were typed in kilograms.
void look_for_kilograms(const Input& input, Result& result) {
    constexpr double least_other = 0.05 * units::gram;  // of locks and oil
    for (const PartField& part : part_fields()) {
        const auto& typed = input.parts.*part.member;
        std::optional<double> found;
        if (!part.column) {
            found = typed && *typed > 0.0 && *typed < least_other ? typed : std::nullopt;
        } else {
            const shop::Weighed alone[] = {typed};
            found = shop::mass_in_kilograms(*part.column, std::nullopt, alone);
            if (!found && input.weigh_in) {
                const auto& column = (*input.weigh_in)[*part.column];
                found = shop::mass_in_kilograms(*part.column, column.nominal, column.mass);
            }
        }
        if (found) {
            result.in_kilograms.emplace_back(&part, *found);
        }
    }
}

/// Each crankpin's bob weight of its own parts.
std::vector<double> crankpins_of(const Input& input, const WeighIn& sheet, double factor,
                                 const std::vector<Line>& lines) {
    const Engine& engine = input.engine;
    const auto places = shop::places_of(crank_of(input));
    std::vector<double> crankpins(static_cast<std::size_t>(engine.crankpins()));
    for (const Line& line : lines) {
        const auto& column = line.part->column;
        if (!column || !sheet[*column].is_weighed()) {
            for (double& sum : crankpins) {
                sum += line.product();
            }
            continue;
        }
        const double each = factor_of(*line.part, engine, factor) / engine.rods_on_crankpin();
        for (std::size_t i = 0; i < places.size(); ++i) {
            crankpins.at(static_cast<std::size_t>(places[i].crankpin)) +=
                each * *sheet[*column].mass.at(i);
        }
    }
    return crankpins;
}

void solve_weigh_in(const Input& input, double factor, bool places_parts, Result& result) {
    if (!input.weigh_in || !places_parts || input.weigh_in->is_empty() ||
        input.engine.cylinders % input.engine.rods_per_pin != 0) {
        return;
    }
    result.placing = shop::match(matching_task(input, factor), input.weigh_in->matching);
    if (result.bob_weight) {
        result.crankpins = crankpins_of(input, *input.weigh_in, factor, result.lines);
        if (result.placing) {
            WeighIn moved = *input.weigh_in;
            move_sets(moved, result.placing->pistons, result.placing->rods);
            result.placed_crankpins = crankpins_of(input, moved, factor, result.lines);
        }
    }
}

/// Planes and drills with all that a plan needs; false while something is missing.
bool can_drill(const Correction& correction) {
    return std::all_of(correction.planes.begin(), correction.planes.end(),
                       [](const Plane& plane) { return plane.radius.has_value(); }) &&
           !correction.drill.diameters_mm.empty() && correction.drill.maximum_depth;
}

/// Whether an unbalance is within its limit; nothing where there is none.
std::optional<bool> is_within(double unbalance, const std::optional<double>& permissible) {
    return permissible ? std::optional(shop::is_within(unbalance, *permissible)) : std::nullopt;
}

std::optional<bool> both(const std::optional<bool>& first, const std::optional<bool>& second) {
    return first && second ? std::optional(*first && *second) : std::nullopt;
}

/// Whether a slug adds next to nothing, for its hole takes off nearly as much.
bool is_light(double slug_density, double density) {
    constexpr double least = 1.1;
    return slug_density < least * density;
}

/// Why so much is left.
Message cause_of(Shortfall shortfall, const Correction& correction, bool beside) {
    const auto density_of = [](double density) {
        return Number{density / units::kg_m3, units::kg_m3};
    };
    switch (shortfall) {
        case Shortfall::none:
            return {};
        case Shortfall::nothing_fits:
            return CORE_TEXT("bob-weights",
                             "The smallest hole takes off more than is to go: use a thinner drill "
                             "or one with a flatter point.");
        case Shortfall::rounding:
            return CORE_TEXT("bob-weights",
                             "The rounding of the depths leaves more than the limit: take a finer "
                             "step or a thinner drill.");
        case Shortfall::beside_sector:
            return CORE_TEXT("bob-weights",
                             "The heavy spot lies outside the sector that may be drilled, and "
                             "holes at its edge take off only a part.");
        case Shortfall::outside_sector:
            return CORE_TEXT("bob-weights",
                             "The heavy spot lies outside the sector that may be drilled.");
        case Shortfall::light_slugs:
            return {CORE_TEXT("bob-weights",
                              "Slugs of %1 hardly outweigh the %2 of the crankshaft that their "
                              "holes take off: none is planned."),
                    density_of(correction.slug->density.value()),
                    density_of(correction.drill.density)};
        case Shortfall::short_slugs:
            return {CORE_TEXT("bob-weights",
                              "A slug of %1 as long as the deepest hole may be does not outweigh "
                              "the %2 of the crankshaft that its hole takes off with the cone "
                              "beneath it: none is planned."),
                    density_of(correction.slug->density.value()),
                    density_of(correction.drill.density)};
        case Shortfall::too_little_room:
            return beside ? CORE_TEXT("bob-weights",
                                      "The holes have too little room beside those of earlier "
                                      "runs.")
                          : CORE_TEXT("bob-weights", "The holes have too little room.");
    }
    return {};
}

/// @param can_press  the sector has a place opposite what is left
/// @param beside     holes of earlier runs are in that plane
Message describe(Shortfall shortfall, double left, double angle, const Plane& plane,
                 const Correction& correction, bool has_slugs, bool can_press, bool beside) {
    const Message cause = cause_of(shortfall, correction, beside);
    if (shortfall == Shortfall::none || shortfall == Shortfall::nothing_fits ||
        shortfall == Shortfall::rounding) {
        return cause;
    }
    const Message remains{CORE_TEXT("bob-weights", "%1 at the radius remain at %2."),
                          shop::in_grams(std::abs(left) / *plane.radius),
                          Number{turn_of(angle) / degree, units::degree, -1}};
    const Message remedy =
        !can_press ? CORE_TEXT("bob-weights",
                               "The side opposite lies outside the sector, too: drill deeper or "
                               "wider, or as a last resort weld that much on opposite.")
        : has_slugs
            ? CORE_TEXT("bob-weights", "As a last resort weld that much on opposite.")
            : CORE_TEXT("bob-weights",
                        "Press heavy metal in opposite, drill deeper or wider, or as a last resort "
                        "weld that much on opposite.");
    return {Text{"", "%1 %2 %3"}, cause, remains, remedy};
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

/// What the metal of a plane adds to its unbalance.
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

/// Whether two holes of a plane are one: an angle that was measured is not quite the one planned.
bool are_one_hole(const Hole& a, const Hole& b, double radius) {
    return a.diameter == b.diameter &&
           radius * std::abs(std::remainder(a.angle - b.angle, 2.0 * pi)) < 0.5 * a.diameter;
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
                 const std::optional<double>& permissible, const Metal& before, Format format)
        : correction_(correction),
          tolerance_(permissible.value_or(-1.0)),
          enough_(correction.aim == Aim::zero ? -1.0 : tolerance_),
          cut_{*plane.radius, correction.drill.density, correction.drill.point_angle},
          into_(cut_),
          limits_{*correction.drill.maximum_depth, correction.drill.depth_step,
                  correction.drill.minimum_wall,   correction.drill.maximum_holes,
                  correction.drill.maximum_angle,  std::nullopt},
          deepens_(format == Format::workshop) {
        const auto& slug = correction.slug;
        has_slugs_ = slug && slug->diameter && slug->density;
        if (has_slugs_) {
            into_.slug_density = slug->density;
            if (slug->direction == SlugDirection::axial) {
                into_.axial_wall = limits_.minimum_wall;
            }
        }
        limits_.smallest_depth = correction.smallest_depth;
        if (plane.from_angle && plane.to_angle) {
            limits_.sector = {*plane.from_angle, *plane.to_angle};
        }
        for (const double diameter : correction.drill.diameters_mm) {
            diameters_.push_back(diameter * units::mm);
        }
        for (const Hole& slug_before : before.slugs) {
            Cut cut = cut_;
            if (slug_before.is_axial) {
                cut.axial_wall = limits_.minimum_wall;
            }
            take(slug_before, cut);
        }
        for (const Hole& hole : before.holes) {
            keep_deepest(hole);
        }
    }

    bool has_slugs() const { return has_slugs_; }
    bool can_press_against(double angle) const { return limits_.allows(turn_of(angle + pi)); }

    Planned plan(Vector unbalance) const {
        // What is within its limit needs no hole, whatever the aim.
        if (std::abs(unbalance) <= std::max(tolerance_, 0.0)) {
            return {};
        }
        // Another hole is worth its while where more than half of the limit would be left, to be
        // deepened where it is more than a tenth.
        const bool to_zero = correction_.aim == Aim::zero;
        const DeepeningPlan deeper =
            deepens_
                ? plan_deepening(unbalance, there_, cut_, limits_,
                                 to_zero ? 0.1 * tolerance_ : tolerance_,
                                 has_limit() ? tolerance_ : std::numeric_limits<double>::infinity())
                : DeepeningPlan{};
        const double good = std::max(to_zero ? 0.5 * tolerance_ : tolerance_, 0.0);
        if (deeper.is_enough || std::abs(unbalance + effect_of({deeper.holes, {}})) <= good) {
            return {{deeper.holes, {}}, Shortfall::none};
        }
        HoleLimits limits = limits_;
        for (const Hole& hole : there_) {
            const bool is_deepened =
                std::any_of(deeper.holes.begin(), deeper.holes.end(),
                            [&](const Hole& each) { return each.deepens == hole.deepens; });
            if (!is_deepened) {
                take(hole, cut_, limits);
            }
        }
        HoleLimits beside = limits;
        for (const Hole& hole : deeper.holes) {
            take(hole, cut_, beside);
            take(at_depth_before(hole), cut_, limits);
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
        double most = 0.0;
        for (const auto& [holes, cut] :
             {std::pair(&metal.holes, &cut_), std::pair(&metal.slugs, &into_)}) {
            for (const Hole& hole : *holes) {
                most =
                    limits_.sector ? std::max(most, edge_beyond(*cut, *limits_.sector, hole)) : 0.0;
            }
        }
        return most;
    }

  private:
    static Hole at_depth_before(Hole hole) {
        hole.depth = hole.from_depth;
        return hole;
    }
    void take(const Hole& hole, const Cut& cut, HoleLimits& limits) const {
        limits.taken.push_back(
            {hole.angle, half_width(cut, hole.diameter, hole.depth, limits.minimum_wall)});
    }
    void take(const Hole& hole, const Cut& cut) { take(hole, cut, limits_); }

    /// A hole that was deepened stands in the record more than once.
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

    bool has_limit() const { return tolerance_ >= 0.0; }

    /// The plan by the aim; where the steps of its depths leave more than the limit, by the limit.
    /// @param plan  of what may be left
    HolePlan within_limit(const auto& plan) const {
        HolePlan found = plan(enough_);
        return enough_ < 0.0 && has_limit() && std::abs(found.left) > tolerance_ ? plan(tolerance_)
                                                                                 : found;
    }

    HolePlan plan_slugs(double target, double angle, const HoleLimits& limits) const {
        const Slug& slug = *correction_.slug;
        if (!limits.allows(angle)) {
            return {{}, target, Shortfall::outside_sector};
        }
        if (is_light(*slug.density, correction_.drill.density)) {
            return {{}, target, Shortfall::light_slugs};
        }
        const double size[] = {*slug.diameter};
        HolePlan slugs = within_limit(
            [&](double enough) { return plan_holes(target, angle, into_, size, limits, enough); });
        for (Hole& hole : slugs.holes) {
            hole.is_axial = into_.axial_wall.has_value();
        }
        const double deepest =
            into_.axial_wall
                ? limits.maximum_depth
                : std::min(limits.maximum_depth, into_.radius - into_.cone(*slug.diameter));
        if (slugs.holes.empty() && deepest > 0.0 &&
            into_.removed(*slug.diameter, deepest).unbalance <= 0.0) {
            slugs.shortfall = Shortfall::short_slugs;
        }
        return slugs;
    }

    Planned plan_new(Vector unbalance, HoleLimits limits) const {
        const double target = std::abs(unbalance);
        const double angle = turn_of(std::arg(unbalance));
        HolePlan plan = within_limit([&](double enough) {
            return plan_holes(target, angle, cut_, diameters_, limits, enough);
        });
        Planned planned{{std::move(plan.holes), {}}, plan.shortfall};
        const bool is_left = plan.left > std::max(tolerance_, 0.0) &&
                             (plan.shortfall == Shortfall::too_little_room ||
                              plan.shortfall == Shortfall::outside_sector);
        if (has_slugs_ && is_left) {
            HolePlan slugs = plan_slugs(plan.left, turn_of(angle + pi), limits);
            planned.metal.slugs = std::move(slugs.holes);
            planned.shortfall = shortfall_of_both(plan.shortfall, slugs.shortfall);
        }
        if (limits.allows(angle) || planned.shortfall == Shortfall::none) {
            return planned;
        }
        HolePlan beside = within_limit([&](double enough) {
            return plan_beside_sector(target, angle, cut_, diameters_, limits, enough);
        });
        Metal other{std::move(beside.holes), {}};
        const Vector rest = unbalance + effect_of(other);
        if (has_slugs_ && !other.holes.empty() && beside.shortfall != Shortfall::none &&
            std::abs(rest) > std::max(tolerance_, 0.0)) {
            for (const Hole& hole : other.holes) {
                take(hole, cut_, limits);
            }
            HolePlan slugs = plan_slugs(std::abs(rest), turn_of(std::arg(rest) + pi), limits);
            other.slugs = std::move(slugs.holes);
            beside.shortfall = shortfall_of_both(beside.shortfall, slugs.shortfall);
        }
        // Where welding remains anyway a hole is to save some of it.
        constexpr double worth = 0.9;
        const double without = std::abs(unbalance + effect_of(planned.metal));
        const double with = std::abs(unbalance + effect_of(other));
        if (with < (beside.shortfall == Shortfall::none ? 1.0 : worth) * without) {
            planned = {std::move(other), beside.shortfall};
        }
        return planned;
    }

    const Correction& correction_;
    double tolerance_;
    double enough_;
    Cut cut_;
    Cut into_;  ///< of slugs
    HoleLimits limits_;
    bool deepens_;
    bool has_slugs_ = false;
    std::vector<double> diameters_;
    std::vector<Hole> there_;  ///< that can be deepened
};

PlaneResult correct(Vector unbalance, const Plane& plane, const Correction& correction,
                    const std::optional<double>& permissible, const Metal& before, Format format) {
    PlaneResult result{};
    result.unbalance = std::abs(unbalance);
    result.angle = turn_of(std::arg(unbalance));
    result.grams_at_radius = result.unbalance / *plane.radius;
    const PlanePlanner planner(plane, correction, permissible, before, format);
    Planned planned = planner.plan(unbalance);
    const Vector left = unbalance + effect_of(planned.metal);
    result.beyond_sector = planner.beyond_sector(planned.metal);
    result.holes = std::move(planned.metal.holes);
    result.slugs = std::move(planned.metal.slugs);
    result.remaining = std::abs(left);
    result.remaining_angle = turn_of(std::arg(left));
    result.measured_within = is_within(result.unbalance, permissible);
    result.within_tolerance = is_within(result.remaining, permissible);
    if (result.within_tolerance != true) {
        result.reason =
            describe(planned.shortfall, result.remaining, result.remaining_angle, plane, correction,
                     planner.has_slugs(), planner.can_press_against(result.remaining_angle),
                     !before.empty());
    }
    return result;
}

/// Where the machine reads, and where it is corrected; nothing while that is not known.
struct Places {
    std::array<double, 2> from;
    std::array<double, 2> to;
};
std::optional<Places> places_of(const Correction& correction) {
    if (correction.planes.size() != 2 || correction.readings.size() != 2 ||
        !correction.planes[0].position || !correction.planes[1].position) {
        return std::nullopt;
    }
    Places places{};
    for (std::size_t i = 0; i < 2; ++i) {
        places.to[i] = *correction.planes[i].position;
        places.from[i] = correction.readings[i].position.value_or(places.to[i]);
    }
    const bool are_apart = places.from[0] != places.from[1] && places.to[0] != places.to[1];
    return are_apart ? std::optional(places) : std::nullopt;
}

/// The two vectors of a run; Reading and EarlierReading have them alike.
std::optional<std::array<Vector, 2>> vectors_of(const auto& readings) {
    std::array<Vector, 2> read;
    for (std::size_t i = 0; i < 2; ++i) {
        if (readings.size() != 2 || !is_read(readings[i])) {
            return std::nullopt;
        }
        read[i] = std::polar(*readings[i].unbalance, readings[i].angle.value_or(0.0));
    }
    return read;
}

/// What the case says is drilled and pressed in after a run.
/// @param run     its place among the earlier runs
/// @param before  what was drilled there and pressed in after those before it
std::array<Metal, 2> recorded(const std::vector<DrilledHole>& holes, const Correction& correction,
                              std::size_t run, const std::array<Metal, 2>& before) {
    std::array<Metal, 2> drilled;
    for (std::size_t i = 0; i < holes.size(); ++i) {
        const DrilledHole& hole = holes[i];
        if (hole.state == HoleState::not_drilled || !hole.depths_agree()) {
            continue;
        }
        const auto plane = static_cast<std::size_t>(hole.plane);
        const double radius = correction.planes.at(plane).radius.value_or(0.0);
        const Drill& drill = correction.drill;
        const bool is_axial = hole.is_slug() && hole.direction == SlugDirection::axial;
        const auto cut_with = [&](double point_angle) {
            return Cut{radius, drill.density, point_angle, std::nullopt,
                       is_axial ? std::optional(drill.minimum_wall) : std::nullopt};
        };
        const bool is_measured = hole.state == HoleState::measured;
        const bool is_opposite = hole.state == HoleState::wrong_side;
        const double angle = turn_of(hole.angle + (is_opposite ? pi : 0.0));
        Hole made{hole.diameter, hole.depth, angle, 0.0, 0.0};
        // Elsewhere than the hole that it was to deepen it is a new one, gone in all its depth.
        const auto& there = before[plane].holes;
        const bool is_elsewhere =
            is_opposite || (is_measured && !there.empty() &&
                            std::none_of(there.begin(), there.end(), [&](const Hole& each) {
                                return are_one_hole(each, made, radius);
                            }));
        made.from_depth = is_elsewhere ? 0.0 : hole.from_depth;
        // What the hole alone took off, by its sizes.
        const Cut cut = cut_with(drill.point_angle);
        Removed removed = cut.removed(hole.diameter, hole.depth);
        if (made.from_depth > 0.0) {
            const Removed shallow = cut.removed(hole.diameter, made.from_depth);
            removed = {removed.mass - shallow.mass, removed.unbalance - shallow.unbalance};
        }
        const double lever =
            radius > 0.0 && removed.mass > 0.0 ? removed.unbalance / removed.mass : radius;
        const bool by_sizes = !hole.mass || is_measured || made.from_depth != hole.from_depth;
        made.deepens = Hole::Place{run, i};
        made.is_axial = is_axial;
        if (!hole.is_slug()) {
            made.mass = by_sizes ? removed.mass : *hole.mass;
            made.unbalance = made.mass * lever;
            drilled[plane].holes.push_back(made);
            continue;
        }
        // Where the slug's own mass is not known, it is taken to fill its hole.
        const double added = hole.slug && by_sizes ? *hole.slug - removed.mass : -*hole.mass;
        const double slug = hole.slug.value_or(added);
        made.mass = added;
        made.slug = hole.slug.value_or(0.0);
        made.slug_radius = cut_with(pi).lever(hole.diameter, hole.depth);
        made.unbalance = radius > 0.0 ? slug * made.slug_radius - (slug - added) * lever : 0.0;
        drilled[plane].slugs.push_back(made);
    }
    return drilled;
}

/// Whether the run after says that what was drilled did something else than it was to: by more than
/// half of that and by more than the limit, beyond which it is still.
std::optional<OtherEffect> other_effect(const RunResult& before, const RunResult& after,
                                        std::size_t plane,
                                        const std::optional<double>& permissible) {
    const Vector meant = effect_of(before.drilled[plane]);
    if (!before.planes || !after.planes || !before.holds() || !after.holds() || meant == 0.0) {
        return std::nullopt;
    }
    const auto vector = [plane](const RunResult& run) {
        return std::polar((*run.planes)[plane].unbalance, (*run.planes)[plane].angle);
    };
    const Vector expected = vector(before) + meant;
    const double off = std::abs(vector(after) - expected);
    if (off <= std::max(0.5 * std::abs(meant), permissible.value_or(0.0)) ||
        std::abs(vector(after)) <= permissible.value_or(0.0)) {
        return std::nullopt;
    }
    const double along = std::real((vector(after) - vector(before)) / meant);
    const bool has_grown = std::abs(vector(after)) > std::abs(vector(before));
    return OtherEffect{std::abs(expected), turn_of(std::arg(expected)), along < -0.5 && has_grown};
}

void solve_correction(const Input& input, Format format, Result& result) {
    if (!input.correction) {
        return;
    }
    const Correction& correction = *input.correction;
    const auto places = places_of(correction);
    const auto limit = [&](std::size_t i) {
        return result.permissible ? std::optional((*result.permissible)[i]) : std::nullopt;
    };
    const auto add_run = [&](const auto& readings) {
        RunResult run;
        const auto read = vectors_of(readings);
        const bool stand_alone = format == Format::workshop && reads_in_planes(correction);
        for (std::size_t i = 0; stand_alone && i < readings.size() && i < 2; ++i) {
            if (const auto& unbalance = readings[i].unbalance) {
                run.alone[i] = {*unbalance, is_within(*unbalance, limit(i))};
            }
        }
        if (read && places) {
            const auto there = carried_over(*read, places->from, places->to);
            run.planes.emplace();
            for (std::size_t i = 0; i < 2; ++i) {
                const double unbalance = std::abs(there[i]);
                (*run.planes)[i] = {unbalance, turn_of(std::arg(there[i])),
                                    is_within(unbalance, limit(i))};
            }
        }
        for (const auto& reading : readings) {
            if (!reading.unbalance) {
                continue;
            }
            if (!run.read_with &&
                shop::is_other_bob_weight(reading.bob_weight, result.bob_weight)) {
                run.read_with = reading.bob_weight;
            }
            if (!run.read_on) {
                run.read_on = shop::other_shaft(reading.shaft, input.job);
            }
        }
        for (std::size_t i = 0; i < 2 && !result.runs.empty(); ++i) {
            run.other_effect[i] = other_effect(result.runs.back(), run, i, limit(i));
        }
        result.runs.push_back(std::move(run));
    };
    std::array<Metal, 2> before;
    const auto in_plane = [&](const RunResult& run, std::size_t i) {
        const RunResult::InPlane& read = (*run.planes)[i];
        return correct(std::polar(read.unbalance, read.angle), correction.planes[i], correction,
                       limit(i), before[i], format);
    };
    for (std::size_t at = 0; at < correction.earlier_runs.size(); ++at) {
        const EarlierRun& earlier = correction.earlier_runs[at];
        add_run(earlier.readings);
        RunResult& run = result.runs.back();
        // Holes of another crankshaft are not in this one; after readings of another bob weight
        // those alone that were drilled before it changed.
        if (earlier.drilled && !run.read_on && correction.planes.size() == 2) {
            run.drilled = recorded(*earlier.drilled, correction, at, before);
        } else if (format == Format::bob_weights && !earlier.drilled && run.planes && run.holds() &&
                   can_drill(correction)) {
            for (std::size_t i = 0; i < 2; ++i) {
                PlaneResult planned = in_plane(run, i);
                run.drilled[i] = {std::move(planned.holes), std::move(planned.slugs)};
            }
        }
        for (std::size_t i = 0; i < 2; ++i) {
            const auto join = [](std::vector<Hole>& all, const std::vector<Hole>& more) {
                all.insert(all.end(), more.begin(), more.end());
            };
            join(before[i].holes, run.drilled[i].holes);
            join(before[i].slugs, run.drilled[i].slugs);
        }
    }
    add_run(correction.readings);
    if (!places) {
        return;
    }
    double worst = 0.0;
    for (std::size_t plane = 0; plane < 2; ++plane) {
        // Errors of unit size at the worst phases.
        double sum = 0.0;
        for (const double at : places->from) {
            const double share = (at - places->to[0]) / (places->to[1] - places->to[0]);
            sum += std::abs(plane == 0 ? 1.0 - share : share);
        }
        worst = std::max(worst, sum);
    }
    result.amplification = worst;
    const RunResult& newest = result.runs.back();
    if (newest.planes && can_drill(correction)) {
        result.correction = {in_plane(newest, 0), in_plane(newest, 1)};
    }
}

/// Where engine and factor contradict each other there is no bob weight, nor what needs one.
void leave_out_contradictory(const Input& input, Result& result) {
    try {
        check_bob_weight(input);
    } catch (const InputError&) {
        result.lines.clear();
        result.bob_weight.reset();
        result.first_order.reset();
        result.first_order_bare.reset();
        result.crankpins.clear();
        result.correction.reset();
        for (auto& run : result.runs) {
            run.read_with.reset();  // there is no weight that it could be compared with
        }
    }
}

}  // namespace

std::array<std::optional<double>, 2> RunResult::unbalances() const {
    std::array<std::optional<double>, 2> list;
    for (std::size_t i = 0; i < 2; ++i) {
        if (planes) {
            list[i] = (*planes)[i].unbalance;
        } else if (alone[i]) {
            list[i] = alone[i]->unbalance;
        }
    }
    return list;
}

bool reads_in_planes(const Correction& correction) {
    const auto places = places_of(correction);
    return !places || places->from == places->to;
}

std::optional<bool> RunResult::within(std::size_t plane) const {
    return planes         ? (*planes)[plane].within_tolerance
           : alone[plane] ? alone[plane]->within_tolerance
                          : std::nullopt;
}

std::optional<bool> RunResult::passes() const {
    return within(0) == false || within(1) == false ? std::optional(false)
                                                    : both(within(0), within(1));
}

std::optional<bool> Result::passes_after() const {
    return correction && newest()->acted_as_meant()
               ? both((*correction)[0].within_tolerance, (*correction)[1].within_tolerance)
               : std::nullopt;
}

namespace {

/// @param planes  two of Metal or PlaneResult
std::vector<DrilledHole> record_of(const auto& planes) {
    std::vector<DrilledHole> list;
    for (const PlaneName plane : {PlaneName::front, PlaneName::rear}) {
        const auto& metal = planes[static_cast<std::size_t>(plane)];
        const auto add = [&](const std::vector<Hole>& holes, double sign) {
            for (const Hole& hole : holes) {
                list.push_back({plane, hole.diameter, hole.depth, hole.from_depth, hole.angle,
                                sign * hole.mass,
                                hole.slug > 0.0 ? std::optional(hole.slug) : std::nullopt,
                                hole.is_axial ? SlugDirection::axial : SlugDirection::radial});
            }
        };
        add(metal.holes, 1.0);
        add(metal.slugs, -1.0);
    }
    return list;
}

}  // namespace

std::optional<std::vector<DrilledHole>> planned_holes(const Result& result) {
    return result.correction && result.holds() ? std::optional(record_of(*result.correction))
                                               : std::nullopt;
}

std::optional<std::vector<DrilledHole>> drilled_holes(const RunResult& run) {
    return run.is_drilled() ? std::optional(record_of(run.drilled)) : std::nullopt;
}

std::vector<const Field*> missing_for_bob_weight(const Input& input) {
    std::vector<const Field*> missing;
    if (input.engine.type == EngineType::v && !input.engine.bank_angle) {
        missing.push_back(&field::bank_angle);
    }
    for (const PartField& part : part_fields()) {
        const bool needed = part.member == &Parts::piston || part.member == &Parts::big_end;
        if (needed && !mass_of(input, part)) {
            missing.push_back(&part.field);
        }
    }
    return missing;
}

std::optional<std::array<double, 2>> plane_limits(
    const Tolerance& tolerance, const std::optional<std::array<double, 2>>& positions) {
    if (!tolerance.by_grade) {
        return tolerance.plane ? std::optional(std::array{*tolerance.plane, *tolerance.plane})
                               : std::nullopt;
    }
    const auto whole = permissible_of_rotor(tolerance);
    if (!whole) {
        return std::nullopt;
    }
    const bool has_bearings = tolerance.front_bearing && tolerance.rear_bearing &&
                              *tolerance.front_bearing != *tolerance.rear_bearing;
    if (!positions || (*positions)[0] == (*positions)[1] ||
        (!has_bearings && !tolerance.centre_of_mass)) {
        return std::array{tolerance.front_share * *whole, (1.0 - tolerance.front_share) * *whole};
    }
    const auto& [first, second] = *positions;
    const std::array<double, 2> bearings{tolerance.front_bearing.value_or(first),
                                         tolerance.rear_bearing.value_or(second)};
    const double centre = tolerance.centre_of_mass.value_or(
        has_bearings ? 0.5 * (bearings[0] + bearings[1]) : 0.5 * (first + second));
    const std::array<double, 2> share = shares(*positions, centre);
    if (!has_bearings) {
        return std::array{*whole * share[0], *whole * share[1]};
    }
    const std::array<double, 2> at_bearing = shares(bearings, centre);
    double scale = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 2; ++i) {
        // What a unit in each plane is at this bearing, at the worst phase.
        double worst = 0.0;
        for (std::size_t k = 0; k < 2; ++k) {
            const double far = ((*positions)[k] - bearings[0]) / (bearings[1] - bearings[0]);
            worst += share[k] * std::abs(i == 0 ? 1.0 - far : far);
        }
        scale = std::min(scale, at_bearing[i] / worst);
    }
    return std::array{*whole * share[0] * scale, *whole * share[1] * scale};
}

namespace {

/// @param known     the bob weight, where it does not follow from the masses of the parts
/// @param by_parts  false: without that it is not known at all
Result solve(const Input& input, Format format, const std::optional<KnownWeight>& known,
             bool by_parts, bool places_parts) {
    Result result;
    result.theory_factor = theory_factor(input.engine);
    result.factor = input.factor.reciprocating.value_or(result.theory_factor);
    const double factor = result.factor + input.factor.overbalance;
    if (known) {
        result.lines = known->lines;
        result.reciprocating = known->reciprocating;
        result.rotating = known->rotating;
        result.bob_weight = known->sum;
        result.first_order = first_order(input.engine, factor, known->reciprocating);
        result.first_order_bare = first_order(input.engine, 0.0, known->reciprocating);
    } else if (by_parts) {
        solve_bob_weight(input, factor, result);
    }
    solve_weigh_in(input, factor, places_parts && by_parts, result);
    look_for_kilograms(input, result);
    if (input.tolerance) {
        std::optional<std::array<double, 2>> positions;
        if (input.correction && input.correction->planes.size() == 2 &&
            input.correction->planes[0].position && input.correction->planes[1].position) {
            positions = {*input.correction->planes[0].position,
                         *input.correction->planes[1].position};
        }
        if (input.tolerance->by_grade) {
            result.permissible_whole = permissible_of_rotor(*input.tolerance);
        }
        result.permissible = plane_limits(*input.tolerance, positions);
    }
    solve_correction(input, format, result);
    leave_out_contradictory(input, result);
    return result;
}

}  // namespace

Result solve(const Input& given, bool places_parts) {
    Input input = fitted(given);
    if (input.correction) {
        // The format knows of no other way.
        input.correction->aim = Aim::tolerance;
        input.correction->smallest_depth = 0.0;
        if (input.correction->slug) {
            input.correction->slug->direction = SlugDirection::radial;
        }
    }
    return solve(input, Format::bob_weights, std::nullopt, true, places_parts);
}

std::optional<Remaining> what_if(const Input& input, const Result& result, PlaneName plane,
                                 double diameter, double depth, double angle) {
    const auto i = static_cast<std::size_t>(plane);
    const RunResult* newest = result.newest();
    if (newest == nullptr || !newest->planes || !input.correction ||
        i >= input.correction->planes.size() || !input.correction->planes[i].radius) {
        return std::nullopt;
    }
    const Drill& drill = input.correction->drill;
    const Cut cut{*input.correction->planes[i].radius, drill.density, drill.point_angle};
    bool touches = false;
    for (const RunResult& run : result.runs) {
        for (const Hole& hole : run.drilled[i].holes) {
            const double away = std::abs(std::remainder(hole.angle - angle, 2.0 * pi));
            touches = touches ||
                      away * cut.radius < 0.5 * (diameter + hole.diameter) + drill.minimum_wall;
        }
    }
    const double taken = cut.removed(diameter, depth).unbalance;
    const RunResult::InPlane& read = (*newest->planes)[i];
    const Vector left = std::polar(read.unbalance, read.angle) - std::polar(taken, angle);
    return Remaining{
        std::abs(left), turn_of(std::arg(left)),
        is_within(std::abs(left),
                  result.permissible ? std::optional((*result.permissible)[i]) : std::nullopt),
        touches};
}

Result solve_job(const Input& given, bool places_parts) {
    return solve(fitted(given), Format::workshop, std::nullopt, true, places_parts);
}

Result solve_job_with_weight(const Input& given, const std::optional<KnownWeight>& known) {
    return solve(fitted(given), Format::workshop, known, false, false);
}

}  // namespace ravnoves::bob_weights
