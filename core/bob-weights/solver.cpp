#include "bob-weights/solver.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "bob-weights/fields.h"
#include "bob-weights/matching.h"
#include "case-file/input_error.h"
#include "shop/balance_grade.h"
#include "shop/kilograms.h"

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

/// Of one rod on a crankpin: the cylinder alone; of two by the numbering of the sheet.
std::array<std::size_t, 2> cylinders_of(const Input& input, std::size_t pin) {
    if (input.weigh_in->numbering == shop::CylinderNumbering::alternating) {
        return {2 * pin, 2 * pin + 1};
    }
    return {pin, pin + static_cast<std::size_t>(input.engine.crankpins())};
}

/// Each crankpin's bob weight of its own parts.
std::vector<double> crankpins_of(const Input& input, const WeighIn& sheet, double factor,
                                 const std::vector<Line>& lines) {
    const Engine& engine = input.engine;
    std::vector<double> crankpins;
    for (int pin = 0; pin < engine.crankpins(); ++pin) {
        const auto cylinders = cylinders_of(input, static_cast<std::size_t>(pin));
        double sum = 0.0;
        for (const Line& line : lines) {
            const auto& column = line.part->column;
            if (!column || !sheet[*column].is_weighed()) {
                sum += line.product();
                continue;
            }
            const auto& masses = sheet[*column].mass;
            const int rods = engine.rods_on_crankpin();
            const double each = factor_of(*line.part, engine, factor) / rods;
            for (int rod = 0; rod < rods; ++rod) {
                const std::size_t cylinder = rods == 1 ? static_cast<std::size_t>(pin)
                                                       : cylinders[static_cast<std::size_t>(rod)];
                sum += each * *masses.at(cylinder);
            }
        }
        crankpins.push_back(sum);
    }
    return crankpins;
}

void solve_weigh_in(const Input& input, double factor, Result& result) {
    if (!input.weigh_in) {
        return;
    }
    for (const PartField& part : part_fields()) {
        if (!part.column) {
            continue;
        }
        const auto& column = (*input.weigh_in)[*part.column];
        const auto found = shop::statistics(column);
        if (!found) {
            continue;
        }
        result.matching.push_back({&part, *found, shop::take_off(column.mass)});
    }
    if (result.matching.empty() || input.engine.cylinders % input.engine.rods_per_pin != 0) {
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

/// @param can_press  the sector has a place opposite what is left
/// @param beside     holes of earlier runs are in that plane
Message describe(Shortfall shortfall, double left, double angle, const Plane& plane,
                 const Correction& correction, bool has_slugs, bool can_press, bool beside) {
    const Number grams{std::abs(left) / *plane.radius / units::gram, units::gram, -2};
    const Number at{turn_of(angle) / degree, units::degree, -1};
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
            if (!can_press) {
                return {CORE_TEXT("bob-weights",
                                  "The heavy spot lies outside the sector that may be drilled: "
                                  "with holes at the edge beside it %1 at the radius remain at %2, "
                                  "and the side opposite that lies outside, too. As a last resort "
                                  "weld that much on there."),
                        grams, at};
            }
            return {has_slugs ? CORE_TEXT("bob-weights",
                                          "The heavy spot lies outside the sector that may be "
                                          "drilled: with holes at the edge beside it and slugs %1 "
                                          "at the radius remain at %2. As a last resort weld that "
                                          "much on opposite.")
                              : CORE_TEXT("bob-weights",
                                          "The heavy spot lies outside the sector that may be "
                                          "drilled: with holes at the edge beside it %1 at the "
                                          "radius remain at %2. Press heavy metal in opposite, or "
                                          "as a last resort weld that much on there."),
                    grams, at};
        case Shortfall::outside_sector:
            if (!can_press) {
                return {
                    CORE_TEXT("bob-weights",
                              "Both the heavy spot and the side opposite it lie outside the "
                              "sector that may be drilled: no hole and no slug has a place, and "
                              "%1 at the radius remain at %2. As a last resort weld that much on "
                              "opposite."),
                    grams, at};
            }
            return {has_slugs ? CORE_TEXT("bob-weights",
                                          "The heavy spot lies outside the sector that may be "
                                          "drilled, and slugs opposite it leave %1 at the radius "
                                          "at %2. As a last resort weld that much on opposite.")
                              : CORE_TEXT("bob-weights",
                                          "The heavy spot lies outside the sector that may be "
                                          "drilled: %1 at the radius are too much at %2. Press "
                                          "heavy metal in opposite, or as a last resort weld that "
                                          "much on there."),
                    grams, at};
        case Shortfall::light_slugs:
            return {CORE_TEXT("bob-weights",
                              "Slugs of %1 hardly outweigh the %2 of the crankshaft that their "
                              "holes take off: none is planned, and %3 at the radius remain at %4. "
                              "Heavier metal, or as a last resort as much welded on opposite."),
                    density_of(correction.slug->density.value()),
                    density_of(correction.drill.density), grams, at};
        case Shortfall::short_slugs:
            return {CORE_TEXT("bob-weights",
                              "A slug of %1 as long as the deepest hole may be does not outweigh "
                              "the %2 of the crankshaft that its hole takes off with the cone "
                              "beneath it: none is planned, and %3 at the radius remain at %4. "
                              "Deeper holes or a flatter point, or as a last resort as much welded "
                              "on opposite."),
                    density_of(correction.slug->density.value()),
                    density_of(correction.drill.density), grams, at};
        case Shortfall::too_little_room:
            if (!can_press) {
                return {beside ? CORE_TEXT("bob-weights",
                                           "Beside the holes of earlier runs equal holes to both "
                                           "sides have too little room, and the side opposite lies "
                                           "outside the sector that may be drilled: %1 at the "
                                           "radius remain at %2. Unequal ones by hand, deeper or "
                                           "wider holes, or as a last resort as much welded on "
                                           "opposite.")
                               : CORE_TEXT("bob-weights",
                                           "The holes have too little room, and the side opposite "
                                           "lies outside the sector that may be drilled: %1 at the "
                                           "radius remain at %2. Deeper or wider holes, or as a "
                                           "last resort as much welded on opposite."),
                        grams, at};
            }
            if (beside) {
                return {has_slugs ? CORE_TEXT("bob-weights",
                                              "Beside those of earlier runs equal holes or slugs "
                                              "to both sides have too little room: %1 at the "
                                              "radius remain at %2. As a last resort weld that "
                                              "much on opposite.")
                                  : CORE_TEXT("bob-weights",
                                              "Beside the holes of earlier runs equal holes to "
                                              "both sides have too little room: %1 at the radius "
                                              "remain at %2. Unequal ones by hand, deeper or "
                                              "wider holes, heavy metal pressed in opposite, or "
                                              "as a last resort as much welded on there."),
                        grams, at};
            }
            return {has_slugs
                        ? CORE_TEXT("bob-weights",
                                    "Holes and slugs have too little room: %1 at the radius remain "
                                    "at %2. As a last resort weld that much on opposite.")
                        : CORE_TEXT("bob-weights",
                                    "The holes have too little room: %1 at the radius remain at "
                                    "%2. Deeper or wider holes, heavy metal pressed in opposite, "
                                    "or as a last resort as much welded on there."),
                    grams, at};
    }
    return {};
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

/// @param before  what was drilled there and pressed in after earlier runs
PlaneResult correct(Vector unbalance, const Plane& plane, const Correction& correction,
                    const std::optional<double>& permissible, const Metal& before) {
    const Drill& drill = correction.drill;
    PlaneResult result{};
    result.unbalance = std::abs(unbalance);
    result.angle = turn_of(std::arg(unbalance));
    result.grams_at_radius = result.unbalance / *plane.radius;

    const Cut cut{*plane.radius, drill.density, drill.point_angle};
    HoleLimits limits{*drill.maximum_depth, drill.depth_step,    drill.minimum_wall,
                      drill.maximum_holes,  drill.maximum_angle, std::nullopt};
    const auto take = [&](const std::vector<Hole>& holes) {
        for (const Hole& hole : holes) {
            limits.taken.push_back(
                {hole.angle, half_width(cut, hole.diameter, hole.depth, drill.minimum_wall)});
        }
    };
    take(before.holes);
    take(before.slugs);
    if (plane.from_angle && plane.to_angle) {
        limits.sector = {*plane.from_angle, *plane.to_angle};
    }
    std::vector<double> diameters;
    for (const double diameter : drill.diameters_mm) {
        diameters.push_back(diameter * units::mm);
    }
    const double tolerance = permissible.value_or(-1.0);
    const auto& slug = correction.slug;
    const bool has_slugs = slug && slug->diameter && slug->density;
    const auto plan_slugs = [&](double target, double angle) -> HolePlan {
        if (!limits.allows(angle)) {
            return {{}, target, Shortfall::outside_sector};
        }
        if (is_light(*slug->density, drill.density)) {
            return {{}, target, Shortfall::light_slugs};
        }
        const double size[] = {*slug->diameter};
        const Cut into{*plane.radius, drill.density, drill.point_angle, slug->density};
        HolePlan slugs = plan_holes(target, angle, into, size, limits, tolerance);
        const double deepest =
            std::min(limits.maximum_depth, *plane.radius - into.cone(*slug->diameter));
        if (slugs.holes.empty() && deepest > 0.0 &&
            into.removed(*slug->diameter, deepest).unbalance <= 0.0) {
            slugs.shortfall = Shortfall::short_slugs;
        }
        return slugs;
    };
    HolePlan plan = plan_holes(result.unbalance, result.angle, cut, diameters, limits, tolerance);
    Metal metal{std::move(plan.holes), {}};
    const auto is_left = [&] {
        return plan.left > std::max(tolerance, 0.0) &&
               (plan.shortfall == Shortfall::too_little_room ||
                plan.shortfall == Shortfall::outside_sector);
    };
    if (has_slugs && is_left()) {
        HolePlan slugs = plan_slugs(plan.left, turn_of(result.angle + pi));
        metal.slugs = std::move(slugs.holes);
        plan.shortfall = shortfall_of_both(plan.shortfall, slugs.shortfall);
    }
    if (!limits.allows(result.angle) && plan.shortfall != Shortfall::none) {
        HolePlan beside =
            plan_beside_sector(result.unbalance, result.angle, cut, diameters, limits, tolerance);
        Metal other{std::move(beside.holes), {}};
        const Vector rest = unbalance + effect_of(other);
        if (has_slugs && !other.holes.empty() && beside.shortfall != Shortfall::none) {
            take(other.holes);
            HolePlan slugs = plan_slugs(std::abs(rest), turn_of(std::arg(rest) + pi));
            other.slugs = std::move(slugs.holes);
            beside.shortfall = shortfall_of_both(beside.shortfall, slugs.shortfall);
        }
        // Where welding remains anyway a hole is to save some of it.
        constexpr double worth = 0.9;
        const double without = std::abs(unbalance + effect_of(metal));
        const double with = std::abs(unbalance + effect_of(other));
        if (with < (beside.shortfall == Shortfall::none ? 1.0 : worth) * without) {
            metal = std::move(other);
            plan.shortfall = beside.shortfall;
        }
    }
    const Vector left = unbalance + effect_of(metal);
    result.holes = std::move(metal.holes);
    result.slugs = std::move(metal.slugs);
    if (limits.sector) {
        for (const auto* holes : {&result.holes, &result.slugs}) {
            for (const Hole& hole : *holes) {
                result.beyond_sector =
                    std::max(result.beyond_sector, edge_beyond(cut, *limits.sector, hole));
            }
        }
    }
    result.remaining = std::abs(left);
    result.remaining_angle = turn_of(std::arg(left));
    result.measured_within = is_within(result.unbalance, permissible);
    result.within_tolerance = is_within(result.remaining, permissible);
    if (result.within_tolerance != true) {
        result.reason = describe(
            plan.shortfall, result.remaining, result.remaining_angle, plane, correction, has_slugs,
            limits.allows(turn_of(result.remaining_angle + pi)), !before.empty());
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

/// What the case says was drilled and pressed in after a run.
std::array<Metal, 2> recorded(const std::vector<DrilledHole>& holes, const Correction& correction) {
    std::array<Metal, 2> drilled;
    for (const DrilledHole& hole : holes) {
        const auto plane = static_cast<std::size_t>(hole.plane);
        const auto radius = correction.planes.at(plane).radius;
        const auto lever = [&](double point_angle) {
            if (!radius) {
                return 0.0;
            }
            const Removed unit = Cut{*radius, 1.0, point_angle}.removed(hole.diameter, hole.depth);
            return unit.mass > 0.0 ? unit.unbalance / unit.mass : *radius;
        };
        const double angle = turn_of(hole.angle);
        if (!hole.slug && hole.mass >= 0.0) {
            drilled[plane].holes.push_back({hole.diameter, hole.depth, angle, hole.mass,
                                            hole.mass * lever(correction.drill.point_angle)});
            continue;
        }
        // Where the slug's own mass is not known, it is taken to fill its hole.
        const double added = -hole.mass;
        const double slug = hole.slug.value_or(added);
        drilled[plane].slugs.push_back(
            {hole.diameter, hole.depth, angle, added,
             slug * lever(pi) - (slug - added) * lever(correction.drill.point_angle),
             hole.slug.value_or(0.0)});
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

void solve_correction(const Input& input, Result& result) {
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
                       limit(i), before[i]);
    };
    for (const EarlierRun& earlier : correction.earlier_runs) {
        add_run(earlier.readings);
        RunResult& run = result.runs.back();
        // Holes of another crankshaft are not in this one; after readings of another bob weight
        // those alone that were drilled before it changed.
        if (earlier.drilled && !run.read_on && correction.planes.size() == 2) {
            run.drilled = recorded(*earlier.drilled, correction);
        } else if (!earlier.drilled && run.planes && run.holds() && can_drill(correction)) {
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

std::optional<bool> RunResult::passes() const {
    return planes ? both((*planes)[0].within_tolerance, (*planes)[1].within_tolerance)
                  : std::nullopt;
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
                list.push_back({plane, hole.diameter, hole.depth, hole.angle, sign * hole.mass,
                                hole.slug > 0.0 ? std::optional(hole.slug) : std::nullopt});
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
    if (!positions || (*positions)[0] == (*positions)[1]) {
        return std::array{0.5 * *whole, 0.5 * *whole};
    }
    const auto& [first, second] = *positions;
    const bool has_bearings = tolerance.front_bearing && tolerance.rear_bearing &&
                              *tolerance.front_bearing != *tolerance.rear_bearing;
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

Result solve(const Input& given, bool places_parts) {
    const Input input = fitted(given);
    Result result;
    result.theory_factor = theory_factor(input.engine);
    result.factor = input.factor.reciprocating.value_or(result.theory_factor);
    const double factor = result.factor + input.factor.overbalance;
    solve_bob_weight(input, factor, result);
    if (places_parts) {
        solve_weigh_in(input, factor, result);
    }
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
    solve_correction(input, result);
    leave_out_contradictory(input, result);
    return result;
}

}  // namespace ravnoves::bob_weights
