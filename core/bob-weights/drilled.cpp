#include "bob-weights/drilled.h"

#include <algorithm>
#include <cmath>

#include "bob-weights/fields.h"
#include "bob-weights/plane_plan.h"

namespace ravnoves::bob_weights {

double DrilledHole::turned(double value) const {
    return state == HoleState::wrong_side ? turn_of(value + pi) : value;
}

std::array<Metal, 2> recorded(const std::vector<DrilledHole>& holes, const Correction& correction,
                              std::size_t run, const std::array<Metal, 2>& before) {
    std::array<Metal, 2> drilled;
    const Drill& drill = correction.drill;
    const bool is_recorded = !before[0].holes.empty() || !before[1].holes.empty();
    for (std::size_t i = 0; i < holes.size(); ++i) {
        const DrilledHole& hole = holes[i];
        if (hole.state == HoleState::not_drilled) {
            continue;
        }
        const auto plane = static_cast<std::size_t>(hole.plane);
        const double radius = correction.planes.at(plane).radius.value_or(0.0);
        const bool is_measured = hole.state == HoleState::measured;
        Hole made{hole.diameter, hole.depth, turn_of(hole.turned(hole.angle)), 0.0, 0.0};
        made.deepens = Hole::Place{run, i};
        made.is_axial = hole.is_slug() && hole.direction == SlugDirection::axial;
        const Cut cut{radius, drill.density, drill.point_angle, std::nullopt,
                      made.is_axial ? std::optional(drill.minimum_wall) : std::nullopt};
        // By the record, which may have been corrected since it was planned.
        std::optional<double> there;
        const Metal* const all[] = {&before[plane], &drilled[plane]};
        for (const Metal* metal : all) {
            for (const Hole& each : metal->holes) {
                if (are_one_hole(each, made, radius)) {
                    there = std::max(there.value_or(0.0), each.depth);
                }
            }
        }
        // Elsewhere than the hole that it was to deepen it is a new one, gone in all its depth.
        // Where no hole is recorded there was one all the same.
        const bool is_elsewhere =
            hole.state == HoleState::wrong_side || (is_measured && is_recorded && !there);
        const bool is_deeper = hole.from_depth > 0.0 && !is_elsewhere;
        made.from_depth = is_deeper ? there.value_or(hole.from_depth) : 0.0;
        if (is_deeper && made.depth <= made.from_depth) {
            continue;
        }
        // What the hole alone took off, by its sizes.
        Removed removed = cut.removed(hole.diameter, hole.depth);
        if (made.from_depth > 0.0) {
            const Removed shallow = cut.removed(hole.diameter, made.from_depth);
            removed = {removed.mass - shallow.mass, removed.unbalance - shallow.unbalance};
        }
        const double lever =
            radius > 0.0 && removed.mass > 0.0 ? removed.unbalance / removed.mass : radius;
        const bool by_sizes = !hole.mass || is_measured || made.from_depth != hole.from_depth;
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
        made.slug_radius = cut.lever(hole.diameter, hole.depth);
        made.unbalance = radius > 0.0 ? slug * made.slug_radius - (slug - added) * lever : 0.0;
        drilled[plane].slugs.push_back(made);
    }
    return drilled;
}

std::optional<std::vector<DrilledHole>> planned_holes(const Result& result) {
    if (!result.correction || !result.holds()) {
        return std::nullopt;
    }
    std::vector<DrilledHole> list;
    for (const PlaneName plane : {PlaneName::front, PlaneName::rear}) {
        const PlaneResult& metal = (*result.correction)[static_cast<std::size_t>(plane)];
        const auto add = [&](const std::vector<Hole>& holes, double sign) {
            for (const Hole& hole : holes) {
                constexpr int digits = 6;
                list.push_back({plane, hole.diameter, hole.depth, hole.from_depth, hole.angle,
                                sign * hole.mass,
                                sign > 0.0 ? std::optional(rounded(
                                                 hole.unbalance, field::drilled_unbalance, digits))
                                           : std::nullopt,
                                hole.slug > 0.0 ? std::optional(hole.slug) : std::nullopt,
                                hole.is_axial ? SlugDirection::axial : SlugDirection::radial});
            }
        };
        add(metal.holes, 1.0);
        add(metal.slugs, -1.0);
    }
    return list;
}

bool is_other_plan(const Correction& correction, const Result& result) {
    const auto now = planned_holes(result);
    if (!correction.planned.drilled || correction.record.is_drilled() || !now) {
        return false;
    }
    // As the card shows them.
    constexpr double length = 0.05 * units::mm;
    constexpr double angle = 0.05 * degree;
    return !std::ranges::equal(
        *correction.planned.drilled, *now, [](const DrilledHole& a, const DrilledHole& b) {
            return a.plane == b.plane && a.is_slug() == b.is_slug() && a.direction == b.direction &&
                   std::abs(a.diameter - b.diameter) < length &&
                   std::abs(a.depth - b.depth) < length &&
                   std::abs(std::remainder(a.angle - b.angle, two_pi)) < angle;
        });
}

}  // namespace ravnoves::bob_weights
