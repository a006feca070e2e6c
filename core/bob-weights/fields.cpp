#include "bob-weights/fields.h"

#include <array>

#include "case-file/field_visitor.h"

namespace ravnoves::bob_weights {

namespace {

using shop::Part;

constexpr Field part(std::string_view key, Text label, Text hint, Text placeholder = {"0"}) {
    return {.key = key,
            .unit = units::gram,
            .range = Range::between(0, 1'000'000),
            .label = label,
            .hint = hint,
            .placeholder = placeholder};
}

constexpr std::array<PartField, 8> parts_of_a_card{{
    {part("piston", Text::tr("One &piston"), Text::tr("One piston without pin and rings."),
          Text::tr("required")),
     &Parts::piston, PartKind::reciprocating, Part::piston},
    {part("pin", Text::tr("One p&in"), Text::tr("One piston pin.")), &Parts::pin,
     PartKind::reciprocating, Part::pin},
    {part("rings", Text::tr("Rin&gs of one piston"), Text::tr("All rings of one piston.")),
     &Parts::rings, PartKind::reciprocating, Part::rings},
    {part("locks", Text::tr("Loc&ks of one pin"),
          Text::tr("The locks of one pin; 0 for a pressed pin.")),
     &Parts::locks, PartKind::reciprocating, std::nullopt},
    {part("small_end", Text::tr("S&mall end of one rod"),
          Text::tr("Small end of one rod, with the big end supported at the same level.")),
     &Parts::small_end, PartKind::reciprocating, Part::rod_small_end},
    {part("big_end", Text::tr("&Big end of one rod"),
          Text::tr("Big end of one rod with its bolts, without shells."), Text::tr("required")),
     &Parts::big_end, PartKind::rotating, Part::rod_big_end},
    {part("shells", Text::tr("S&hells of one rod"),
          Text::tr("Both shells of one rod, not of the whole crankpin; each rod adds its own.")),
     &Parts::shells, PartKind::rotating, Part::shells},
    {part("oil", Text::tr("&Oil of one crankpin"),
          Text::tr("Oil in and around one crankpin, once for all its rods; usually 4 g.")),
     &Parts::oil, PartKind::crankpin, std::nullopt},
}};

}  // namespace

std::span<const PartField> part_fields() {
    return parts_of_a_card;
}

void visit_fields(FieldVisitor& visitor, Engine& engine) {
    constexpr auto always = FieldVisitor::Written::always;
    visitor.choice(field::type, engine.type);
    visitor.integer(field::cylinders, engine.cylinders);
    visitor.number(field::bank_angle, engine.bank_angle);
    visitor.integer(field::rods_per_pin, engine.rods_per_pin, engine.type == EngineType::v ? 2 : 1,
                    always);
    visitor.number(field::pin_split, engine.pin_split, 0.0);
}

void visit_fields(FieldVisitor& visitor, Factor& factor) {
    visitor.number(field::reciprocating_percent, factor.reciprocating);
    visitor.number(field::overbalance_percent, factor.overbalance, 0.0);
}

void visit_fields(FieldVisitor& visitor, Parts& parts) {
    for (const PartField& each : part_fields()) {
        visitor.number(each.field, parts.*each.member);
    }
}

void visit_fields(FieldVisitor& visitor, Plane& plane) {
    visitor.required(field::plane_position, plane.position);
    visitor.required(field::plane_radius, plane.radius);
    visitor.number(field::from_angle, plane.from_angle);
    visitor.number(field::to_angle, plane.to_angle);
}

namespace {

/// But for its position.
void visit_reading(FieldVisitor& visitor, Reading& reading) {
    visitor.number(field::unbalance, reading.unbalance);
    visitor.number(field::angle, reading.angle);
    visitor.number(field::bob_weight_then, reading.bob_weight);
    visitor.object_with_defaults(shop::field::read_shaft, reading.shaft);
}

void visit_hole(FieldVisitor& visitor, DrilledHole& hole) {
    visitor.choice(field::drilled_plane, hole.plane);
    visitor.number(field::drilled_diameter, hole.diameter);
    visitor.number(field::drilled_depth, hole.depth);
    visitor.number(field::drilled_from_depth, hole.from_depth, 0.0);
    visitor.number(field::drilled_angle, hole.angle);
    visitor.number(field::drilled_mass, hole.mass);
    visitor.number(field::drilled_unbalance, hole.unbalance);
    visitor.number(field::drilled_slug, hole.slug);
    visitor.choice(field::drilled_direction, hole.direction, SlugDirection::radial);
    visitor.choice(field::drilled_state, hole.state, HoleState::as_planned);
}

/// @param drilled  describes the list of holes
void visit_record(FieldVisitor& visitor, const Field& drilled, DrillingRecord& record) {
    if (visitor.has(drilled.key, record.drilled.has_value())) {
        if (!record.drilled && (visitor.is_reading() || visitor.creates_objects())) {
            record.drilled.emplace();
        }
        std::vector<DrilledHole> absent;
        visitor.list(drilled, record.drilled ? *record.drilled : absent,
                     [&](DrilledHole& hole) { visit_hole(visitor, hole); });
    }
    if (visitor.has(field::drilled_by.key, !record.drilled_by.empty())) {
        visitor.list(field::drilled_by, record.drilled_by,
                     [&](Reading& reading) { visit_reading(visitor, reading); });
    }
    visitor.flag(field::counted_otherwise, record.counted_otherwise, false);
}

/// A list that may be left out.
void visit_list(FieldVisitor& visitor, const Field& field, auto& list, const auto& visit) {
    if (visitor.has(field.key, !list.empty())) {
        visitor.list(field, list, visit);
    } else if (visitor.is_reading()) {
        list.clear();
    }
}

void visit_drill(FieldVisitor& visitor, Drill& drill) {
    const Drill usual;
    if (visitor.has(field::diameters.key, !drill.diameters_mm.empty())) {
        visitor.numbers(field::diameters, drill.diameters_mm);
    }
    visitor.number(field::density, drill.density, usual.density);
    visitor.required(field::maximum_depth, drill.maximum_depth);
    visitor.number(field::point_angle, drill.point_angle, usual.point_angle);
    visitor.number(field::depth_step, drill.depth_step, usual.depth_step);
    visitor.number(field::minimum_wall, drill.minimum_wall, usual.minimum_wall);
    visitor.integer(field::maximum_holes, drill.maximum_holes, usual.maximum_holes);
    visitor.number(field::maximum_angle, drill.maximum_angle, usual.maximum_angle);
}

void visit_correction(FieldVisitor& visitor, Correction& correction) {
    visit_list(visitor, field::planes, correction.planes,
               [&](Plane& plane) { visit_fields(visitor, plane); });
    visit_list(visitor, field::readings, correction.readings, [&](Reading& reading) {
        visitor.number(field::reading_position, reading.position);
        visit_reading(visitor, reading);
    });
    visit_record(visitor, field::drilled_after_newest, correction.record);
    visitor.object_of(field::planned, false, correction.planned.drilled.has_value(),
                      [&] { visit_record(visitor, field::planned_holes, correction.planned); });
    visit_list(visitor, field::earlier_runs, correction.earlier_runs, [&](EarlierRun& run) {
        // Holes that were there before have no readings.
        visit_list(visitor, field::run_readings, run.readings,
                   [&](Reading& reading) { visit_reading(visitor, reading); });
        visit_record(visitor, field::drilled, run);
    });
    visitor.number(field::smallest_depth, correction.smallest_depth, Correction().smallest_depth);
    visitor.choice(field::aim, correction.aim, Aim::zero);
    visitor.object_of(field::drill, false, !(correction.drill == Drill{}),
                      [&] { visit_drill(visitor, correction.drill); });
    visitor.object(field::slug, correction.slug, [&](Slug& slug) {
        visitor.required(field::slug_diameter, slug.diameter);
        visitor.required(field::slug_density, slug.density);
        visitor.choice(field::slug_direction, slug.direction, SlugDirection::axial);
    });
}

void visit_tolerance(FieldVisitor& visitor, Tolerance& tolerance) {
    const int given =
        visitor.one_of({field::grade.key, field::plane_tolerance.key}, tolerance.by_grade ? 0 : 1);
    if (visitor.is_reading()) {
        tolerance.by_grade = given == 0;
    }
    if (given <= 0) {
        visitor.required(field::grade, tolerance.grade);
        visitor.required(field::rotor_mass, tolerance.rotor_mass);
        visitor.required(field::service_speed, tolerance.service_speed);
    }
    if (given != 0) {
        visitor.required(field::plane_tolerance, tolerance.plane);
    }
    if (given <= 0) {
        visitor.number(field::centre_of_mass, tolerance.centre_of_mass);
        visitor.number(field::front_bearing, tolerance.front_bearing);
        visitor.number(field::rear_bearing, tolerance.rear_bearing);
        visitor.number(field::front_share, tolerance.front_share, 0.5);
    }
}

}  // namespace

void visit_fields(FieldVisitor& visitor, Input& input) {
    visitor.object(field::engine, input.engine);
    visitor.object_with_defaults(field::factor, input.factor);
    visitor.object_with_defaults(field::parts, input.parts);
    visitor.object(field::weigh_in, input.weigh_in, [&](WeighIn& sheet) {
        if (visitor.is_reading() || visitor.creates_objects()) {
            sheet.fit(static_cast<std::size_t>(input.engine.cylinders));
        }
        shop::visit_sheet(visitor, sheet, false);
    });
    visitor.choice(field::balance, input.balance, Balance::internal);
    visitor.object(field::correction, input.correction,
                   [&](Correction& correction) { visit_correction(visitor, correction); });
    visitor.object(field::tolerance, input.tolerance,
                   [&](Tolerance& tolerance) { visit_tolerance(visitor, tolerance); });
    visitor.object_with_defaults(field::job, input.job);
}

}  // namespace ravnoves::bob_weights
