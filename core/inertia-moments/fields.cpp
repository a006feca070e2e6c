#include "inertia-moments/fields.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>
#include <vector>

#include "case-file/field_visitor.h"
#include "case-file/input_error.h"
#include "case-file/object_reader.h"
#include "inertia-moments/layouts.h"

namespace ravnoves::inertia_moments {

namespace {

std::span<const Word> layout_words() {
    static const std::vector<Word> words = [] {
        std::vector<Word> list;
        for (const LayoutSpec& spec : layout_library()) {
            list.push_back({spec.name, spec.title});
        }
        return list;
    }();
    return words;
}

}  // namespace

const Field field::layout_name{
    .key = "name",
    .label = Text::tr("Layout"),
    .hint = Text::tr("Name in the library, for example i4, v6-60, v8-cross-plane."),
    .words = layout_words()};

namespace {

using Written = FieldVisitor::Written;
using field::LayoutType;

/// True where the input, as far as it is read, takes the key; in a table of all fields always.
bool takes(FieldVisitor& visitor, const Field& field, bool now) {
    return visitor.is_reading() ? now : visitor.has(field.key, now);
}

/// A layout of the library with its usual sizes.
Layout library_layout(const std::string& name, double crank_radius, const std::string& parent) {
    if (const LayoutSpec* spec = find_layout(name)) {
        return usual_layout(*spec, crank_radius);
    }
    std::vector<std::string> names;
    for (const LayoutSpec& known : layout_library()) {
        names.emplace_back(known.name);
    }
    const auto near = nearest_word(name, names);
    throw InputError(parent + "/name",
                     near ? Message(Text::tr("must be a layout of the library (the nearest is %1)"),
                                    quoted_list({*near}))
                          : Message(Text::tr("must be a layout of the library")),
                     quoted_list({name}));
}

void visit_layout(FieldVisitor& visitor, Layout& layout, double crank_radius) {
    auto type = layout.name == "vr" ? LayoutType::vr : LayoutType::library;
    visitor.choice(field::layout_type, type);
    const bool vr = type == LayoutType::vr;
    if (takes(visitor, field::layout_cylinders, vr)) {
        visitor.integer(field::layout_cylinders, layout.cylinders);
    }
    if (takes(visitor, field::layout_name, !vr)) {
        visitor.text(field::layout_name, layout.name);
        if (visitor.is_reading()) {
            layout = library_layout(layout.name, crank_radius, visitor.pointer());
        }
    }
    const auto size = [&](const Field& field, double& si) {
        if (vr) {
            visitor.number(field, si);
        } else {
            visitor.number(field, si, si, Written::always);
        }
    };
    size(field::included_angle, layout.bank_angle);
    size(field::layout_offset, layout.offset);
    size(field::spacing, layout.spacing);
    if (takes(visitor, field::stagger, !vr)) {
        size(field::stagger, layout.stagger);
    }
    if (vr || visitor.has(field::firing_order.key, true)) {
        visitor.integers(field::firing_order, layout.firing_order);
    }
    visitor.number(field::first_position, layout.first_position);
    if (visitor.is_reading() && layout.first_position == centred_position(layout)) {
        layout.first_position.reset();  // as older cases have it: it follows the spacing
    }
}

/// The mass of one cylinder or that of one throw.
void visit_rotating_mass(FieldVisitor& visitor, Input& input) {
    const bool of_throw =
        visitor.has(field::rotating_mass_per_throw.key, input.rotating_mass_of_throw);
    const bool of_cylinder = visitor.has(field::rotating_mass.key, !input.rotating_mass_of_throw);
    if (visitor.is_reading()) {
        if (of_throw && of_cylinder) {
            throw InputError(
                visitor.pointer() + "/" + std::string(field::rotating_mass_per_throw.key),
                {Text::tr("must be left out if %1 is given"), field::rotating_mass.key});
        }
        input.rotating_mass_of_throw = of_throw;
    }
    if (of_cylinder || !of_throw) {
        visitor.number(field::rotating_mass, input.rotating_mass, 0.0, Written::always);
    }
    if (of_throw) {
        visitor.number(field::rotating_mass_per_throw, input.rotating_mass);
    }
}

/// λ or the rod's length.
void visit_rod_length(FieldVisitor& visitor, Input& input) {
    const int which =
        visitor.one_of({field::lambda.key, field::rod_length.key}, input.given_rod_length ? 1 : 0);
    if (which != 1) {
        visitor.number(field::lambda, input.lambda);
    }
    if (which != 0) {
        double length = input.given_rod_length.value_or(0.0);
        visitor.number(field::rod_length, length);
        if (which == 1) {
            input.given_rod_length = length;
        }
    }
}

}  // namespace

void visit_fields(FieldVisitor& visitor, ArticulatedRod& rod) {
    visitor.number(field::knuckle_radius, rod.knuckle_radius);
    visitor.number(field::knuckle_angle, rod.knuckle_angle);
    visitor.number(field::articulated_length, rod.rod_length);
    visitor.integer(field::master, rod.master, 0);
    visitor.number(field::knuckle_mass, rod.knuckle_mass, 0.0);
}

void visit_fields(FieldVisitor& visitor, Cylinder& cylinder) {
    visitor.number(field::axial_position, cylinder.axial_position);
    visitor.number(field::bank_angle, cylinder.bank_angle);
    visitor.number(field::offset, cylinder.offset);
    visitor.number(field::crankpin_angle, cylinder.crankpin_angle);
    visitor.object(field::articulated, cylinder.articulated);
}

void visit_fields(FieldVisitor& visitor, RigidRod& rod) {
    visitor.number(field::rod_mass, rod.mass);
    visitor.number(field::rod_centre, rod.centre_from_big_end);
    visitor.number(field::rod_inertia, rod.inertia);
}

void visit_fields(FieldVisitor& visitor, Shaft& shaft) {
    visitor.integer(field::shaft_order, shaft.order);
    visitor.choice(field::shaft_direction, shaft.direction);
    visitor.choice(field::shaft_task, shaft.balances, Balances::moment, Written::always);
    const bool moment = shaft.balances == Balances::moment;
    if (takes(visitor, field::weight_distance, moment)) {
        visitor.number(field::weight_distance, shaft.weight_distance);
    }
    if (takes(visitor, field::shaft_position, !moment)) {
        visitor.number(field::shaft_position, shaft.axial_position);
    }
    visitor.number(field::weight_radius, shaft.weight_radius);
    visitor.number(field::phase_error, shaft.phase_error, 0.0, Written::always);
    visitor.flag(field::shaft_enabled, shaft.enabled, true, Written::always);
}

void visit_fields(FieldVisitor& visitor, EndWebs& webs) {
    visitor.number(field::front_position, webs.front_position);
    visitor.number(field::rear_position, webs.rear_position);
    visitor.number(field::front_radius, webs.front_radius);
    visitor.number(field::rear_radius, webs.rear_radius);
    visitor.number(field::first_order_share, webs.first_order_share, 0.0, Written::always);
    visitor.flag(field::webs_enabled, webs.enabled, true, Written::always);
}

void visit_fields(FieldVisitor& visitor, Input& input) {
    visitor.number(field::crank_radius, input.crank_radius);
    visit_rod_length(visitor, input);
    visitor.number(field::speed, input.angular_speed);
    visitor.number(field::reciprocating_mass, input.reciprocating_mass);
    visit_rotating_mass(visitor, input);
    visitor.number(field::reference_position, input.reference_position, 0.0, Written::always);
    const int which =
        visitor.one_of({field::cylinders.key, field::layout.key}, input.layout ? 1 : 0);
    if (which != 0) {
        visitor.object_of(field::layout, true, true, [&] {
            Layout absent;
            if (visitor.is_reading()) {
                input.layout.emplace();
            }
            visit_layout(visitor, input.layout ? *input.layout : absent, input.crank_radius);
        });
    }
    if (which != 1) {
        visitor.list(field::cylinders, input.cylinders);
        if (visitor.has(field::firing_order.key, !input.firing_order.empty())) {
            visitor.integers(field::firing_order, input.firing_order);
        }
    }
    visitor.integer(field::strokes, input.strokes, 4);
    visitor.object(field::rod, input.rod);
    if (visitor.has(field::shafts.key, !input.shafts.empty())) {
        visitor.list(field::shafts, input.shafts);
    }
    visitor.choice(field::shaft_basis, input.shaft_basis, DesignBasis::exact);
    visitor.object(field::end_webs, input.end_webs);
    visitor.number(field::step, input.step);
}

}  // namespace ravnoves::inertia_moments
