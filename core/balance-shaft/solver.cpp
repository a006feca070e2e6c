#include "balance-shaft/solver.h"

#include <algorithm>
#include <utility>

#include "balance-shaft/angle_search.h"
#include "balance-shaft/engine_torque.h"
#include "balance-shaft/table_reading.h"
#include "balance-shaft/trace_check.h"
#include "case-file/decimal.h"
#include "case-file/unusual_engine.h"
#include "numerics/angle.h"
#include "numerics/constants.h"
#include "numerics/periodic_piecewise.h"

namespace ravnoves::balance_shaft {

namespace {

/// 0, step, 2 step … and the span itself.
std::vector<double> grid(double span, double step) {
    const auto whole = static_cast<std::size_t>(std::floor(span / step * (1.0 + 1e-12)));
    std::vector<double> values;
    values.reserve(whole + 2);
    for (std::size_t k = 0; k <= whole; ++k) {
        values.push_back(std::min(static_cast<double>(k) * step, span));
    }
    if (span - values.back() > 1e-9 * span) {
        values.push_back(span);
    }
    values.back() = span;
    return values;
}

/// The mean over the paper's 25 nodes, every 30° with both ends: 24 of them cancel, the last
/// repeats φ = 0. A cycle of 360° has 13 such nodes.
double printed_mean_of_shaft_moment(double amplitude, double alpha, int strokes) {
    const double nodes = 6.0 * strokes + 1.0;
    return amplitude * std::sin(alpha) / nodes;
}

/// The mean of M_up over the rows of the table, both ends, as the paper takes it; of a computed
/// torque over every 0.5°.
double printed_mean_of_rows(const Input& input, const PeriodicPiecewise& moment) {
    const std::vector<double> nodes = input.torque.is_computed()
                                          ? grid(input.cycle_deg(), 0.5)
                                          : input.torque.table.crank_angle_deg;
    double sum = 0.0;
    for (const double angle : nodes) {
        sum += moment(angle);
    }
    return sum / static_cast<double>(nodes.size());
}

OrderLine order_line(double order, const FourierPair& pair) {
    return {order, std::hypot(pair.a, pair.b), std::atan2(pair.a, pair.b)};
}

constexpr double usual_bores = 2.0;  ///< of a shaft's length: a crank with its webs takes less

RelievedShaft relieved_shaft(const Input& input, const FrontView& view) {
    RelievedShaft shaft = design_relieved_shaft(relieved_shaft_sizes(input), input.unbalance());
    const auto note_first = [&shaft](const Message& note) {
        shaft.note = shaft.note.empty() ? note : Message(Text{"%1 %2"}, note, shaft.note);
    };
    const double swing = view.shaft_swing_radius;
    constexpr double rounding = 1e-12;
    if (shaft.feasible && swing < shaft.diameter / 2.0 * (1.0 - rounding)) {
        shaft.feasible = false;
        shaft.reason = {
            Text::tr("The bar (radius %1) does not fit in the swing circle (radius %2)."),
            in_mm(shaft.diameter / 2.0), in_mm(swing)};
    }
    if (!shaft.feasible) {
        return shaft;
    }
    if (shaft.length > usual_bores * view.cylinder_bore) {
        note_first({Text::tr("The relief of %1 is longer than two bores: check the length of the "
                             "crankcase."),
                    in_mm(shaft.length)});
    }
    note_first({Text::tr("Same unbalance as %1 at ρ₁ = %2; map and clearances use the swing "
                         "radius %3."),
                Number{rounded_to_digits(input.counterweight(), 4), units::kg},
                in_mm(input.counterweight_radius), in_mm(swing)});
    return shaft;
}

}  // namespace

Solver::Prepared::Prepared(const Input& checked)
    : Moments(checked),
      input(checked),
      places(balance_shaft::front_view(checked), checked.place_limits) {
    fill(input, true, base);
    base.printed_mean_M_up = printed_mean_of_rows(input, moment);
    if (gas) {
        base.indicated = gas->indicated();
        base.indicated_power = base.indicated->work * input.angular_speed / gas->period();
    }
    base.inertia_check = check_inertia(input);
    base.relieved_shaft = relieved_shaft(input, places.view());
    prepare_spectrum();
    prepare_curves();
    base.flywheel =
        flywheel(torque, input.angular_speed, input.flywheel, base.curves.crank_angle_deg);
    prepare_buildable();
    prepare_sweep();
    prepare_notes();
}

void Solver::Prepared::prepare_spectrum() {
    const auto turns = static_cast<std::size_t>(input.strokes / 2);
    const auto of_turns = static_cast<double>(turns);
    const auto series = moment.fourier_series(degree / of_turns, turns * spectrum_orders);
    for (std::size_t k = 0; k < series.size(); ++k) {
        base.spectrum_M_up.push_back(order_line(static_cast<double>(k + 1) / of_turns, series[k]));
    }
    base.spectrum_M_ups = base.spectrum_M_up;
}

void Solver::Prepared::prepare_curves() {
    MomentCurves& curves = base.curves;
    curves.crank_angle_deg = grid(input.cycle_deg(), input.step_deg);
    const std::size_t count = curves.crank_angle_deg.size();
    curves.M_up.reserve(count);
    cos_curve.reserve(count);
    sin_curve.reserve(count);
    for (const double angle : curves.crank_angle_deg) {
        curves.M_up.push_back(moment(angle));
        cos_curve.push_back(std::cos(angle * degree));
        sin_curve.push_back(std::sin(angle * degree));
    }
    curves.M_s.resize(count);
    curves.M_ups.resize(count);
    if (!gas) {
        return;
    }
    for (const double angle : curves.crank_angle_deg) {
        const double theta = angle * degree + top;
        curves.pressure.push_back(gas->pressure(theta));
        curves.volume.push_back(gas->volume(theta));
        const PistonMotion<double> motion = crank.at(theta);
        curves.M_gas.push_back(gas->torque(theta, motion));
        curves.M_inertia.push_back(
            inertia_torque(motion, base.reciprocating_mass, input.angular_speed));
        curves.M_offset.push_back(offset_lever(crank, theta) * base.reciprocating_mass *
                                  input.angular_speed * input.angular_speed);
    }
}

/// The best of what can be built.
void Solver::Prepared::prepare_buildable() {
    base.buildable = buildable_angles(places.view(), input.place_limits);
    const BuildableAngles& buildable = base.buildable;
    Optimum& range = base.best_range_buildable;
    Optimum& rms = base.best_rms_buildable;
    if (buildable.stretches.empty()) {
        range.note = rms.note = buildable.reason;
        return;
    }
    range = base.best_range;
    rms = base.best_rms;
    const auto is_built = [&](const Optimum& best) {
        return !best.shaft_angle || buildable.contains(*best.shaft_angle);
    };
    if (!is_built(range)) {
        const AngleMinimum best =
            minimise_range(plane, forces.moment_amplitude, turned(buildable.stretches, phase));
        range = {wrap_turn(best.alpha - phase), best.value, flat_note(*this, best)};
    }
    if (!is_built(rms)) {
        // A sinusoid of α rises on both sides of its minimum: the nearest end is best.
        const double end = nearest_angle(buildable.stretches, *rms.shaft_angle);
        rms = {wrap_turn(end), plane.rms(shaft_moment(end)), {}};
    }
}

void Solver::Prepared::prepare_sweep() {
    AngleSweep& sweep = base.sweep;
    sweep.shaft_angle_deg = grid(turn_deg, input.step_deg);
    const std::size_t count = sweep.shaft_angle_deg.size();
    sweep.mean_M_s.assign(count, 0.0);
    sweep.mean_M_ups.assign(count, base.M_up.mean);
    sweep.range.resize(count);
    sweep.rms.resize(count);
    std::vector<double> turned;
    turned.reserve(count);
    for (const double angle : sweep.shaft_angle_deg) {
        turned.push_back(angle * degree + phase);
    }
    balance_shaft::sweep(plane, forces.moment_amplitude, turned, sweep.range, sweep.rms);
    for (const double angle : turned) {
        const double printed =
            printed_mean_of_shaft_moment(forces.moment_amplitude, angle, input.strokes);
        sweep.printed_mean_M_s.push_back(printed);
        sweep.printed_mean_M_ups.push_back(printed + base.printed_mean_M_up);
    }
}

void Solver::Prepared::prepare_notes() {
    EngineSizes sizes{
        input.angular_speed, input.crank_radius, input.cylinder.rod_length.value_or(0.0), {}};
    for (const NamedMass& part : input.reciprocating_masses) {
        sizes.masses.push_back(part.mass);
    }
    sizes.masses.push_back(input.rod_mass.value_or(0.0));
    base.doubts = unusual_engine_notes(sizes);
    if (input.torque.kind == TorqueSource::Kind::pressure) {
        Message doubt = check_trace(input, *gas);
        if (!doubt.empty()) {
            base.doubts.push_back(std::move(doubt));
            base.trace_is_a_turn_off = peaks_a_turn_off(input, *base.indicated);
        }
        if (Message coarse = coarse_rows(input.torque.trace); !coarse.empty()) {
            base.doubts.push_back(std::move(coarse));
        }
        if (const PressureTrace& trace = input.torque.trace; !trace.unit_named) {
            base.notes.push_back(assumed_unit_note(trace.unit));
        }
    }
    if (const TorqueSource& torque = input.torque; torque.has_changed()) {
        const bool is_table = torque.kind == TorqueSource::Kind::csv;
        base.notes.push_back(changed_note((is_table ? torque.csv : torque.trace_file).name));
    }
    if (input.relieved_shaft && input.relieved_shaft->had_bending) {
        base.notes.emplace_back(Text::tr(
            "Not used, since bending of the relieved shaft is no longer computed: elastic modulus, "
            "bearing span, allowable stress, deflection, critical-speed ratio, bearing load."));
    }
    if (input.relieved_shaft && !base.relieved_shaft.feasible) {
        base.doubts.emplace_back(Text::tr("Relieved shaft: %1"), base.relieved_shaft.reason);
    }
    const double length = half_disc_length(places.view().shaft_swing_radius, input.unbalance());
    if (!input.relieved_shaft && length > usual_bores * places.view().cylinder_bore) {
        base.doubts.emplace_back(Text::tr("A steel half disc of the shaft swing radius must be "
                                          "%1 long for m₁ ρ₁: more than two bores."),
                                 Number{length / units::mm, units::mm, 3});
    }
    if (!base.inertia_check.warning.empty()) {
        base.notes.push_back(base.inertia_check.text);
    }
    if (forces.moment_amplitude == 0.0) {
        base.notes.push_back(base.best_range.note);
    }
    const auto in_degrees = [](double angle) { return Number{angle / degree, units::degree, -2}; };
    if (crank.offset != 0.0) {
        base.notes.emplace_back(
            Text::tr("Offset cylinder: at the top dead centre (φ = 0) the crank is %1 from the "
                     "cylinder's direction; both counterweights lag by %2."),
            in_degrees(top), in_degrees(piston_1.lag));
    }
    if (base.buildable.stretches.empty()) {
        base.notes.emplace_back(Text::tr("No feasible position: %1"), base.buildable.reason);
    }
    base.assumed_sizes = balance_shaft::assumed_sizes(input);
    const double balanced = 2.0 * forces.counterweight_force / forces.inertia_force_1_max;
    constexpr double noticeable = 1e-3;
    if (input.counterweight_mass && std::abs(balanced - 1.0) > noticeable) {
        base.notes.emplace_back(Text::tr("The counterweight balances %1 % of the first-order "
                                         "inertia force; equation (1) requires %2."),
                                Number{100.0 * balanced, units::none, 4},
                                Number{input.reciprocating_mass() * input.crank_radius /
                                           (2.0 * input.counterweight_radius),
                                       units::kg, 4});
    }
}

Solver::Solver(const Input& input) {
    check_input(input);
    prepared_ = std::make_shared<const Prepared>(input);
}

Result Solver::result() const {
    Result result = prepared_->base;
    move_shaft(prepared_->input.shaft_angle, result);
    return result;
}

void Solver::move_shaft(double shaft_angle, Result& result) const {
    const Prepared& prepared = *prepared_;
    const double alpha = wrap_turn(shaft_angle);
    const double amplitude = prepared.forces.moment_amplitude;
    const double turned = alpha + prepared.phase;
    prepared.Moments::move_shaft(alpha, result);
    result.printed_mean_M_s =
        printed_mean_of_shaft_moment(amplitude, turned, prepared.input.strokes);
    result.printed_mean_M_ups = result.printed_mean_M_s + prepared.base.printed_mean_M_up;
    result.envelope = balance_shaft::envelope(front_view(), alpha);
    const double l = prepared.input.centre_distance;
    result.obstacle = buildable().contains(alpha)
                          ? Obstacle::none
                          : prepared.places.obstacle(l * std::sin(alpha), l * std::cos(alpha));
    result.is_buildable = result.obstacle == Obstacle::none;

    const MomentPlane::Moment shaft = shaft_at(amplitude, turned);
    const MomentPlane::Moment order_1 = shaft - prepared.plane.opposed();
    result.spectrum_M_ups[prepared.input.strokes == 2 ? 0 : 1] =
        order_line(1.0, {order_1.x(), order_1.y()});

    for (std::size_t i = 0; i < prepared.cos_curve.size(); ++i) {
        const double moment = shaft.x() * prepared.cos_curve[i] + shaft.y() * prepared.sin_curve[i];
        result.curves.M_s[i] = moment;
        result.curves.M_ups[i] = prepared.base.curves.M_up[i] + moment;
    }
}

Result solve(const Input& input) {
    return Solver(input).result();
}

MechanismPose mechanism_pose(const Solver& solver, double crank_angle, double shaft_angle) {
    const FrontView& view = solver.front_view();
    const Input& input = solver.input();
    const SliderCrank<double>& crank = solver.moments().crank;
    const double theta = crank_angle + solver.moments().top;
    const double c = std::cos(theta);
    const double s = std::sin(theta);
    const double mass = input.reciprocating_mass();
    const double speed2 = input.angular_speed * input.angular_speed;
    const PistonMotion<double> piston = crank.at(s, c);

    MechanismPose pose;
    pose.crankpin = {view.crank_radius * s, view.crank_radius * c};
    pose.piston_pin = {crank.offset, piston.s};
    const double rho = view.counterweight_radius;
    // The crank turns clockwise in the view, the shaft the other way: their counterweights meet in
    // the vertical component only.
    const PistonFirstOrder& first_order = solver.moments().piston_1;
    const double cos_1 = std::cos(theta - first_order.lag);
    const double sin_1 = std::sin(theta - first_order.lag);
    const Vector2 crank_direction{-sin_1, -cos_1};
    const Vector2 shaft_direction{sin_1, -cos_1};
    pose.crank_counterweight = {rho * crank_direction.x, rho * crank_direction.y};
    pose.shaft_axis = {view.centre_distance * std::sin(shaft_angle),
                       view.centre_distance * std::cos(shaft_angle)};
    pose.shaft_counterweight = {pose.shaft_axis.x + rho * shaft_direction.x,
                                pose.shaft_axis.y + rho * shaft_direction.y};
    pose.inertia_force_1 = {0.0, mass * first_order.radius * speed2 * cos_1};
    const double force = solver.moments().forces.counterweight_force;
    pose.crank_counterweight_force = {force * crank_direction.x, force * crank_direction.y};
    pose.shaft_counterweight_force = {force * shaft_direction.x, force * shaft_direction.y};
    return pose;
}

}  // namespace ravnoves::balance_shaft
