#include "inertia-moments/input.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string_view>

#include "case-file/input_error.h"
#include "inertia-moments/engine.h"
#include "inertia-moments/layouts.h"

namespace ravnoves::inertia_moments {

namespace {

/// Forces, moments and torques outside these bounds (N, N·m) would leave the range of numbers.
constexpr double largest_effect = 1e200;
constexpr double smallest_effect = 1e-200;

/// A rounded number for a sentence.
std::string short_number(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.6g", value);
    return text.data();
}

void check_field(double value, const FieldSpec& field, const std::string& parent) {
    const double shown = from_si(field, value);
    if (!field.range.contains(shown)) {
        throw InputError(parent + "/" + std::string(field.key), field.range.describe(),
                         format_number(shown));
    }
}

void check_firing_order(const std::vector<int>& order, int count, const std::string& pointer) {
    if (!is_firing_order(order, count)) {
        std::string found;
        for (const int number : order) {
            if (!found.empty()) {
                found += '-';
            }
            found += std::to_string(number);
        }
        throw InputError(pointer,
                         "must name each cylinder from 1 to " + std::to_string(count) + " once",
                         found.empty() ? "nothing" : found);
    }
}

void check_layout(const Layout& layout) {
    const std::string parent = "/input/layout";
    if (layout.name != "vr" && find_layout(layout.name) == nullptr) {
        throw InputError(parent + "/name", "must be a layout of the library", layout.name);
    }
    if (layout.name == "vr" && (layout.cylinders < 1 || layout.cylinders > most_cylinders)) {
        throw InputError(parent + "/cylinders",
                         "must be a whole number from 1 to " + std::to_string(most_cylinders),
                         std::to_string(layout.cylinders));
    }
    check_field(layout.bank_angle, field::included_angle, parent);
    check_field(layout.offset, field::offset, parent);
    check_field(layout.spacing, field::spacing, parent);
    check_field(layout.stagger, field::stagger, parent);
    check_field(layout.first_position, field::first_position, parent);
    check_firing_order(layout.firing_order, cylinder_count(layout), parent + "/firing_order");
}

void check_table(const Input& input) {
    if (input.cylinders.empty() ||
        input.cylinders.size() > static_cast<std::size_t>(most_cylinders)) {
        throw InputError("/input/cylinders",
                         "must list from 1 to " + std::to_string(most_cylinders) + " cylinders",
                         std::to_string(input.cylinders.size()));
    }
    for (std::size_t i = 0; i < input.cylinders.size(); ++i) {
        const std::string parent = "/input/cylinders/" + std::to_string(i);
        const Cylinder& cylinder = input.cylinders[i];
        check_field(cylinder.axial_position, field::axial_position, parent);
        check_field(cylinder.bank_angle, field::bank_angle, parent);
        check_field(cylinder.offset, field::offset, parent);
        check_field(cylinder.crankpin_angle, field::crankpin_angle, parent);
    }
    if (!input.firing_order.empty()) {
        check_firing_order(input.firing_order, static_cast<int>(input.cylinders.size()),
                           "/input/firing_order");
    }
}

void check_locking(const Input& input, const std::vector<Cylinder>& cylinders) {
    const auto locking = find_locking(input.crank_radius, input.lambda, cylinders);
    if (!locking) {
        return;
    }
    const double limit =
        (input.rod_length() - input.crank_radius) / field::millimetre;  // of |e|, mm
    if (!(limit > 0.0)) {
        throw InputError("/input/lambda", "must be less than 1; " + describe(*locking),
                         format_number(input.lambda));
    }
    const std::string pointer =
        input.layout ? "/input/layout/offset_mm"
                     : "/input/cylinders/" + std::to_string(locking->cylinder) + "/offset_mm";
    throw InputError(pointer,
                     "must be less than " + short_number(limit) +
                         " in size (rod length less crank radius); " + describe(*locking),
                     short_number(cylinders[locking->cylinder].offset / field::millimetre));
}

void check_shafts(const Input& input) {
    if (input.shafts.size() > static_cast<std::size_t>(most_shafts)) {
        throw InputError("/input/balance_shafts",
                         "must list at most " + std::to_string(most_shafts) + " shafts",
                         std::to_string(input.shafts.size()));
    }
    for (std::size_t i = 0; i < input.shafts.size(); ++i) {
        const Shaft& shaft = input.shafts[i];
        const std::string parent = "/input/balance_shafts/" + std::to_string(i);
        if (shaft.order < 1 || shaft.order > highest_order) {
            throw InputError(parent + "/order",
                             "must be a whole number from 1 to " + std::to_string(highest_order),
                             std::to_string(shaft.order));
        }
        check_field(shaft.phase_error, field::phase_error, parent);
        if (shaft.balances == Balances::moment) {
            check_field(shaft.weight_distance, field::weight_distance, parent);
        } else if (shaft.axial_position) {
            check_field(*shaft.axial_position, field::shaft_position, parent);
        }
        if (shaft.weight_radius) {
            check_field(*shaft.weight_radius, field::weight_radius, parent);
        }
    }
}

void check_end_webs(const EndWebs& webs) {
    const std::string parent = "/input/counterweights";
    check_field(webs.front_position, field::front_position, parent);
    check_field(webs.rear_position, field::rear_position, parent);
    check_field(webs.front_radius, field::front_radius, parent);
    check_field(webs.rear_radius, field::rear_radius, parent);
    check_field(webs.first_order_share, field::first_order_share, parent);
    constexpr double least_distance = 1e-6;  // m
    const double size = std::max(std::abs(webs.front_position), std::abs(webs.rear_position));
    if (!(std::abs(webs.front_position - webs.rear_position) >
          std::max(1e-9 * size, least_distance))) {
        throw InputError(parent + "/rear_position_mm",
                         "must differ from front_position_mm by more than 0.001",
                         format_number(webs.rear_position / field::millimetre));
    }
}

void check_size(const Input& input, const Engine& engine) {
    if (input.rod && !(engine.reciprocating_mass > 0.0 && engine.rotating_mass >= 0.0)) {
        throw InputError("/input/rod/centre_from_big_end_mm",
                         "must leave both ends of the rod a mass that is not negative",
                         short_number(input.rod->centre_from_big_end / field::millimetre));
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
                             "sizes, masses and speed together must keep forces and moments under "
                             "1e200 N and N·m",
                             short_number(effect));
        }
    }
    const double smallest =
        std::min({engine.force_unit(), engine.force_unit() * engine.crank_radius, omega_2,
                  engine.crank_radius});
    if (!(smallest >= smallest_effect)) {
        throw InputError("/input",
                         "sizes, masses and speed together must keep m R ω² over 1e-200 N",
                         short_number(engine.force_unit()));
    }
}

}  // namespace

void check_input(const Input& input) {
    const std::string parent = "/input";
    check_field(input.crank_radius, field::crank_radius, parent);
    check_field(input.lambda, field::lambda, parent);
    check_field(input.angular_speed, field::speed, parent);
    check_field(input.reciprocating_mass, field::reciprocating_mass, parent);
    check_field(input.rotating_mass, field::rotating_mass, parent);
    check_field(input.reference_position, field::reference_position, parent);
    if (input.step) {
        check_field(*input.step, field::step, parent);
    }
    if (input.rod) {
        check_field(input.rod->mass, field::rod_mass, parent + "/rod");
        check_field(input.rod->centre_from_big_end, field::rod_centre, parent + "/rod");
        check_field(input.rod->inertia, field::rod_inertia, parent + "/rod");
    }
    if (input.layout) {
        check_layout(*input.layout);
        // Only the offsets matter for locking; crankpins would need a top dead centre.
        check_locking(input, {Cylinder{0.0, 0.0, input.layout->offset, 0.0}});
    } else {
        check_table(input);
        check_locking(input, input.cylinders);
    }
    check_shafts(input);
    if (input.end_webs) {
        check_end_webs(*input.end_webs);
    }
    check_size(input, reduce(input));
}

}  // namespace ravnoves::inertia_moments
