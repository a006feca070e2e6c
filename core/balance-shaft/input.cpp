#include "balance-shaft/input.h"

#include <cmath>

#include "balance-shaft/engine_torque.h"
#include "case-file/input_error.h"

namespace ravnoves::balance_shaft {

namespace {

constexpr const char* root = "/input";
constexpr const char* masses_key = "reciprocating_masses_kg";

std::string pointer(const FieldSpec& field, const char* parent = root) {
    return std::string(parent) + "/" + std::string(field.key);
}

void check(const FieldSpec& field, double si, const char* parent = root) {
    const double value = from_si(field, si);
    if (!field.range.contains(value)) {
        throw InputError(pointer(field, parent), field.range.describe(), format_number(value));
    }
}

void check(const FieldSpec& field, const std::optional<double>& si, const char* parent = root) {
    if (si) {
        check(field, *si, parent);
    }
}

void check_torque(const Input& input) {
    const std::string root_of_torque = std::string(root) + "/torque";
    const TorqueSource& source = input.torque;
    if (!source.is_computed()) {
        check_torque_table(source.table, root_of_torque);
        return;
    }
    const bool traced = source.kind == TorqueSource::Kind::pressure;
    const std::string parent = root_of_torque + (traced ? "/pressure" : "/cycle");
    const auto check_inner = [&](const FieldSpec& field, const auto& value) {
        check(field, value, parent.c_str());
    };
    check_inner(field::bore, source.cylinder.bore);
    check_inner(field::offset, source.cylinder.offset);
    check_inner(field::crankcase_pressure, source.cylinder.crankcase_pressure);
    if (!input.rod_length) {
        throw InputError(pointer(field::rod_length, parent.c_str()), "is required and missing");
    }
    check_inner(field::rod_length, input.rod_length);
    const double offset = std::abs(source.cylinder.offset);
    const SliderCrank<double> crank = slider_crank(input);
    if (!(*input.rod_length > (input.crank_radius + 2.0 * offset) * (1.0 + 1e-9))) {
        throw InputError(
            pointer(field::rod_length, parent.c_str()),
            "must be greater than the crank radius and twice the offset together, " +
                format_number(from_si(field::crank_radius, input.crank_radius + 2.0 * offset)),
            format_number(from_si(field::rod_length, *input.rod_length)));
    }
    // Beyond these no cylinder exists, and pressures and powers of volumes leave double's range.
    constexpr Range displacement_range = Range::between(1e-12, 1e3);
    const double displacement =
        pi / 4.0 * source.cylinder.bore * source.cylinder.bore * crank.stroke();
    if (!displacement_range.contains(displacement)) {
        throw InputError(pointer(field::bore, parent.c_str()),
                         "must make a displacement from 1e-6 cm³ to 1e9 cm³",
                         format_number(displacement * 1e6, 6) + " cm³");
    }
    if (traced) {
        check_pressure_trace(source.trace, parent + "/csv");
        return;
    }
    const GasCycle& cycle = source.cycle;
    check_inner(field::compression_ratio, cycle.compression_ratio);
    check_inner(field::intake_pressure, cycle.intake_pressure);
    check_inner(field::exhaust_pressure, cycle.exhaust_pressure);
    check_inner(field::polytropic_compression, cycle.polytropic_compression);
    check_inner(field::polytropic_expansion, cycle.polytropic_expansion);
    check_inner(field::heat, cycle.heat);
    check_inner(field::imep, cycle.imep);
    if (cycle.heat.has_value() == cycle.imep.has_value()) {
        throw InputError(parent, "must hold either heat_J or indicated_mean_effective_pressure_bar",
                         cycle.heat ? "both" : "neither");
    }
    check_inner(field::combustion_start, cycle.combustion_start);
    check_inner(field::combustion_duration, cycle.combustion_duration);
    check_inner(field::wiebe_m, cycle.wiebe_m);
    const double end = cycle.combustion_start + cycle.combustion_duration;
    const double bottom = two_pi + crank.bottom_dead_centre() - crank.top_dead_centre();
    if (end > bottom) {
        throw InputError(pointer(field::combustion_duration, parent.c_str()),
                         "must end the combustion before the bottom dead centre at " +
                             format_number(bottom / degree, 6) + "°",
                         format_number(end / degree, 6) + "°");
    }
}

}  // namespace

double Input::reciprocating_mass() const {
    double sum = 0.0;
    for (const NamedMass& part : reciprocating_masses) {
        sum += part.mass;
    }
    return sum;
}

double Input::effective_rod_length() const {
    return rod_length.value_or(crank_radius / default_lambda);
}

void check_speed_band(const SpeedBand& band) {
    const std::string parent = std::string(root) + "/speed_band";
    check(field::band_from, band.from, parent.c_str());
    check(field::band_to, band.to, parent.c_str());
    if (band.to < band.from) {
        throw InputError(
            pointer(field::band_to, parent.c_str()),
            "must be at least from_rpm, " + format_number(from_si(field::band_from, band.from)),
            format_number(from_si(field::band_to, band.to)));
    }
    if (band.speeds < 2 || band.speeds > field::most_speeds) {
        throw InputError(parent + "/speeds",
                         "must be a whole number from 2 to " + std::to_string(field::most_speeds),
                         std::to_string(band.speeds));
    }
    constexpr double largest_speed = 1e6;  // rad/s; far above any engine, its square is harmless
    if (!(band.to <= largest_speed)) {
        throw InputError(pointer(field::band_to, parent.c_str()), "must be at most 1e6 rad/s",
                         format_number(band.to) + " rad/s");
    }
}

void check_input(const Input& input) {
    check(input.speed_in_rpm ? field::speed : field::angular_speed, input.angular_speed);
    check(field::crank_radius, input.crank_radius);
    const std::string masses = std::string(root) + "/" + masses_key;
    if (input.reciprocating_masses.size() == 1 && input.reciprocating_masses[0].name.empty()) {
        check(field::reciprocating_mass, input.reciprocating_masses[0].mass);
    } else {
        for (const NamedMass& part : input.reciprocating_masses) {
            if (!field::reciprocating_mass_part.range.contains(part.mass)) {
                throw InputError(masses + "/" + part.name,
                                 field::reciprocating_mass_part.range.describe(),
                                 format_number(part.mass));
            }
        }
        const double sum = input.reciprocating_mass();
        if (!(sum > 0.0) || !std::isfinite(sum)) {
            throw InputError(masses, "must add up to more than 0 and to a finite mass",
                             format_number(sum));
        }
    }
    check(field::counterweight_radius, input.counterweight_radius);
    check(field::counterweight_mass, input.counterweight_mass);
    check(field::centre_distance, input.centre_distance);
    check(field::shaft_angle, input.shaft_angle);
    check_torque(input);
    if (!field::step.range.contains(input.step_deg)) {
        throw InputError(pointer(field::step), field::step.range.describe(),
                         format_number(input.step_deg));
    }
    check(field::rod_length, input.rod_length);
    check(field::rod_mass, input.rod_mass);
    check(field::crank_share, input.crank_share);
    check(field::backlash, input.gears.backlash, "/input/gears");
    if (input.gears.teeth < 6 || input.gears.teeth > field::most_teeth ||
        std::abs(input.gears.shifted_teeth) >= input.gears.teeth) {
        throw InputError("/input/gears/shifted_teeth",
                         "must be less than the teeth, which must be from 6 to " +
                             std::to_string(field::most_teeth),
                         std::to_string(input.gears.shifted_teeth));
    }
    for (const NamedMass& part : input.reciprocating_masses) {
        if (part.name == "rod_small_end" && input.rod_mass && part.mass > *input.rod_mass) {
            throw InputError("/input/reciprocating_masses_kg/rod_small_end",
                             "must be at most rod_mass_kg, " + format_number(*input.rod_mass),
                             format_number(part.mass));
        }
    }
    if (input.rod_length && !(*input.rod_length > input.crank_radius)) {
        throw InputError(pointer(field::rod_length),
                         "must be greater than the crank radius, " +
                             format_number(from_si(field::crank_radius, input.crank_radius)),
                         format_number(from_si(field::rod_length, *input.rod_length)));
    }
    const std::string envelope_pointer = std::string(root) + "/envelope";
    const char* envelope = envelope_pointer.c_str();
    check(field::cylinder_bore, input.envelope.cylinder_bore, envelope);
    check(field::cylinder_top, input.envelope.cylinder_top, envelope);
    check(field::crank_swing_radius, input.envelope.crank_swing_radius, envelope);
    check(field::shaft_swing_radius, input.envelope.shaft_swing_radius, envelope);
    check(field::gear_tip_radius, input.envelope.gear_tip_radius, envelope);
    check(field::wall, input.envelope.wall, envelope);

    if (input.speed_band) {
        check_speed_band(*input.speed_band);
    }
    if (input.relieved_shaft) {
        check_relieved_shaft(*input.relieved_shaft);
    }

    // Each number alone may be fine and their products not.
    constexpr double largest = 1e100;
    const auto check_together = [&](double value, const char* what, const FieldSpec& field) {
        if (!(std::abs(value) <= largest)) {
            throw InputError(pointer(field), std::string("makes ") + what +
                                                 " larger than this program can work with (1e100)"
                                                 " together with the other inputs");
        }
    };
    const double speed = input.angular_speed;
    const double reciprocating = input.reciprocating_mass();
    const double counterweight = input.counterweight_mass.value_or(
        reciprocating * input.crank_radius / (2.0 * input.counterweight_radius));
    check_together(speed * speed, "the square of the speed",
                   input.speed_in_rpm ? field::speed : field::angular_speed);
    check_together(input.crank_radius, "the mechanism", field::crank_radius);
    check_together(reciprocating * input.crank_radius * speed * speed, "the inertia force",
                   field::crank_radius);
    check_together(counterweight, "the counterweight's mass", field::counterweight_radius);
    const double force = counterweight * input.counterweight_radius * speed * speed;
    check_together(input.counterweight_radius, "the mechanism", field::counterweight_radius);
    check_together(force, "the counterweight's force", field::counterweight_radius);
    check_together(input.centre_distance, "the mechanism", field::centre_distance);
    check_together(force * input.centre_distance, "the shaft's moment", field::centre_distance);
    check_together(input.effective_rod_length(), "the mechanism", field::rod_length);
    check_together(reciprocating * input.crank_radius * input.crank_radius * speed * speed,
                   "the inertia torque", field::crank_radius);
    check_together(input.torque.cylinder.bore, "the cylinder", field::bore);
    check_together(input.torque.cylinder.offset, "the cylinder", field::offset);
    check_together(input.envelope.cylinder_bore.value_or(0.0), "the envelope",
                   field::cylinder_bore);
    check_together(input.envelope.cylinder_top.value_or(0.0), "the envelope", field::cylinder_top);
    check_together(input.envelope.crank_swing_radius.value_or(0.0), "the envelope",
                   field::crank_swing_radius);
    check_together(input.envelope.shaft_swing_radius.value_or(0.0), "the envelope",
                   field::shaft_swing_radius);
    check_together(input.envelope.gear_tip_radius.value_or(0.0), "the envelope",
                   field::gear_tip_radius);
    check_together(input.envelope.wall, "the envelope", field::wall);
}

}  // namespace ravnoves::balance_shaft
