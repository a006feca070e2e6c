#include "inertia-moments/input.h"

#include <algorithm>
#include <cmath>

#include "case-file/field_reader.h"
#include "case-file/field_visitor.h"
#include "case-file/field_writer.h"
#include "case-file/input_error.h"
#include "inertia-moments/engine.h"
#include "inertia-moments/fields.h"
#include "inertia-moments/layouts.h"

namespace ravnoves::inertia_moments {

namespace {

/// Forces, moments and torques outside these bounds (N, N·m), or the balancing masses that follow
/// from them by division by ω², would leave the range of numbers.
constexpr double largest_effect = 1e100;
constexpr double smallest_effect = 1e-100;

void check_firing_order(const std::vector<int>& order, int count, const std::string& pointer) {
    if (const Message trouble = firing_order_trouble(order, count); !trouble.empty()) {
        throw InputError(pointer, trouble, firing_order_text(order));
    }
}

void check_layout(const Layout& layout) {
    if (layout.name != "vr" && find_layout(layout.name) == nullptr) {
        throw InputError("/input/layout/name", Text::tr("must be a layout of the library"),
                         layout.name);
    }
    check_firing_order(layout.firing_order, cylinder_count(layout), "/input/layout/firing_order");
}

void check_table(const Input& input) {
    if (input.cylinders.empty() ||
        input.cylinders.size() > static_cast<std::size_t>(max_cylinders)) {
        throw InputError("/input/cylinders",
                         {Text::tr("must list from 1 to %1 cylinders"), max_cylinders},
                         Number{static_cast<double>(input.cylinders.size())});
    }
    if (!input.firing_order.empty()) {
        check_firing_order(input.firing_order, static_cast<int>(input.cylinders.size()),
                           "/input/firing_order");
    }
}

/// Of a cylinder whose rod runs on the crankpin.
/// @param pointer  of its offset
void check_locking(const Input& input, double cylinder_offset, std::size_t cylinder,
                   const std::string& pointer) {
    const Message locking =
        locking_of({1.0, 1.0 / input.ratio(), cylinder_offset / input.crank_radius}, cylinder);
    if (locking.empty()) {
        return;
    }
    const double limit =  // of |e|
        (input.rod_length() * (1.0 - nearest_to_locking) - input.crank_radius) / units::mm;
    if (!(limit > 0.0) && input.given_rod_length) {
        throw InputError(
            "/input/rod_length_mm",
            {Text::tr("must be greater than the crank radius, %1; %2"),
             bound(from_si(field::crank_radius, input.crank_radius / (1.0 - nearest_to_locking)),
                   from_si(field::rod_length, input.rod_length()), units::mm),
             locking},
            Number{from_si(field::rod_length, input.rod_length())});
    }
    if (!(limit > 0.0)) {
        throw InputError("/input/lambda",
                         {Text::tr("must be at most %1; %2"),
                          Number{.value = 1.0 - nearest_to_locking, .digits = 9}, locking},
                         Number{input.lambda});
    }
    const double offset = cylinder_offset / units::mm;
    throw InputError(
        pointer,
        {Text::tr("must be less than %1 in magnitude (rod length minus crank radius); %2"),
         bound(limit, offset, units::mm), locking},
        bound(offset, limit, units::mm));
}

/// What joins articulated rods with the rest: a rod as a rigid body, the rotating mass, locking.
void check_articulated(const Input& input, const Engine& engine) {
    for (std::size_t i = 0; i < engine.cylinders.size(); ++i) {
        if (!engine.cylinders[i].articulated) {
            continue;
        }
        if (input.rod) {
            throw InputError(
                "/input/rod",
                {Text::tr("must be left out with articulated rods (cylinder %1): master and "
                          "articulated rods differ in mass, so enter their shares in the masses"),
                 i + 1});
        }
        const double mass = engine.cylinders[i].articulated->knuckle_mass;
        if (!(mass <= engine.rotating_mass)) {
            throw InputError(rod_pointer(i, field::knuckle_mass),
                             {Text::tr("must be at most %1, the rotating mass of one cylinder"),
                              Number{.value = engine.rotating_mass, .digits = 6}},
                             Number{mass});
        }
        const ArticulatedCrank crank = engine.crank(i);
        constexpr double margin = 1e-12;  // nearer, rounding decides whether the crank passes
        const double reach = crank.reach();
        if (!(crank.rod_length - reach > margin * crank.rod_length)) {
            const bool given = input.cylinders[i].articulated->rod_length.has_value();
            const Field& field = given ? field::articulated_length : field::knuckle_radius;
            const ArticulatedRod& rod = *engine.cylinders[i].articulated;
            throw InputError(
                rod_pointer(i, field),
                {Text::tr("must leave the articulated rod longer than %1, the distance of its "
                          "knuckle pin from the cylinder's axis"),
                 Number{.value = reach * engine.crank_radius / units::mm, .digits = 6}},
                Number{.value = from_si(field, given ? *rod.rod_length : rod.knuckle_radius),
                       .digits = 6});
        }
    }
}

void check_end_webs(const EndWebs& webs) {
    constexpr double min_distance = 1e-6;  // m
    const double size = std::max(std::abs(webs.front_position), std::abs(webs.rear_position));
    if (!(std::abs(webs.front_position - webs.rear_position) >
          std::max(1e-9 * size, min_distance))) {
        throw InputError("/input/counterweights/rear_position_mm",
                         {Text::tr("must differ from %1 by more than %2"),
                          field::front_position.key, min_distance / units::mm},
                         Number{from_si(field::rear_position, webs.rear_position)});
    }
}

void check_throws(const Input& input, const Engine& engine) {
    const auto kinds = kinds_of_throw(engine.throws);
    if (input.rotating_mass_of_throw && kinds.size() != 1) {
        throw InputError("/input/rotating_mass_per_throw_kg",
                         {Text::tr("must be given for one cylinder (%1) if the throws carry "
                                   "different numbers of rods"),
                          field::rotating_mass.key},
                         {Text::tr("throws with %1 and with %2 rods"), kinds.begin()->first,
                          kinds.rbegin()->first});
    }
}

void check_size(const Input& input, const Engine& engine) {
    if (input.rod && !(engine.reciprocating_mass > 0.0 && engine.rotating_mass >= 0.0)) {
        throw InputError("/input/rod/centre_from_big_end_mm",
                         Text::tr("must give both ends of the rod a mass of at least 0"),
                         Number{.value = input.rod->centre_from_big_end / units::mm, .digits = 6});
    }
    double lever = engine.crank_radius;
    for (const Cylinder& cylinder : engine.cylinders) {
        lever = std::max({lever, std::abs(cylinder.axial_position),
                          std::abs(cylinder.axial_position - engine.reference_position),
                          std::abs(cylinder.offset)});
    }
    if (input.end_webs) {
        lever = std::max({lever, std::abs(input.end_webs->front_position),
                          std::abs(input.end_webs->rear_position)});
    }
    const double omega_2 = engine.angular_speed * engine.angular_speed;
    const double force =
        std::max(engine.reciprocating_mass, engine.rotating_mass) * engine.crank_radius * omega_2;
    const double couple = std::abs(engine.rod_couple_inertia) * omega_2;
    for (const double effect : {engine.force_unit(), force, force * lever, couple}) {
        if (!(effect <= largest_effect)) {
            throw InputError("/input",
                             Text::tr("sizes, masses and speed together must keep forces and "
                                      "moments under 1e100 N and N·m"),
                             Number{.value = effect, .digits = 6});
        }
    }
    const double smallest =
        std::min({engine.force_unit(), engine.force_unit() * engine.crank_radius, omega_2,
                  engine.crank_radius});
    if (!(smallest >= smallest_effect)) {
        throw InputError("/input",
                         Text::tr("sizes, masses and speed together must keep m R ω² over 1e-100 "
                                  "N"),
                         Number{.value = engine.force_unit(), .digits = 6});
    }
}

}  // namespace

RigidRod usual_rod(const Input& input) {
    const double length = input.rod_length();
    const double mass = 0.8 * input.reciprocating_mass;
    return {mass, length / 3.0, mass * length * length * 2.0 / 9.0};
}

Engine make_engine(const Input& input) {
    check_fields(input);
    // The rod, R/λ, must have a length; field::lambda allows all that is greater than 0.
    if (constexpr Range ratios = Range::at_least(1e-9); !ratios.contains(input.ratio())) {
        if (input.given_rod_length) {
            throw InputError("/input/rod_length_mm",
                             {Text::tr("must be at most %1, 1e9 times the crank radius"),
                              from_si(field::crank_radius, input.crank_radius) / 1e-9},
                             Number{from_si(field::rod_length, input.rod_length())});
        }
        throw InputError("/input/lambda", ratios.message(), Number{input.lambda});
    }
    if (input.layout) {
        check_layout(*input.layout);
        check_locking(input, input.layout->offset, 0, "/input/layout/offset_mm");
    } else {
        check_table(input);
        for (std::size_t each = 0; each < input.cylinders.size(); ++each) {
            if (!input.cylinders[each].articulated) {
                check_locking(input, input.cylinders[each].offset, each,
                              "/input/cylinders/" + std::to_string(each) + "/offset_mm");
            }
        }
    }
    if (input.shafts.size() > static_cast<std::size_t>(max_shafts)) {
        throw InputError("/input/balance_shafts",
                         {Text::tr("must list at most %1 shafts"), max_shafts},
                         Number{static_cast<double>(input.shafts.size())});
    }
    if (input.end_webs) {
        check_end_webs(*input.end_webs);
    }
    Engine engine = reduce(input);
    check_throws(input, engine);
    check_articulated(input, engine);
    check_size(input, engine);
    return engine;
}

void check_input(const Input& input) {
    make_engine(input);
}

Input read_input(const Json& json) {
    Input input = read_fields<Input>(json);
    check_input(input);
    return input;
}

Json write_input(const Input& input) {
    return write_fields(input);
}

}  // namespace ravnoves::inertia_moments
