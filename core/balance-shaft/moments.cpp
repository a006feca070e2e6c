#include "balance-shaft/moments.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ravnoves::balance_shaft {

namespace {

/// M_id over the cycle, as given or computed.
PeriodicPiecewise engine_torque(const Input& input, const std::optional<CylinderGas>& gas) {
    return gas ? torque_parts(input, *gas).at(input.angular_speed)
               : torque_curve(input.torque.table, input.interpolation);
}

Forces forces_of(const Input& input) {
    const double mass = input.reciprocating_mass();
    const double speed2 = input.angular_speed * input.angular_speed;
    Forces forces;
    forces.inertia_force_1_max = mass * input.crank_radius * speed2;
    forces.counterweight_mass = input.counterweight();
    forces.counterweight_force = forces.counterweight_mass * input.counterweight_radius * speed2;
    forces.moment_amplitude = forces.counterweight_force * input.centre_distance;
    return forces;
}

MomentMetrics metrics_of(const MomentPlane& plane, const MomentPlane::Moment& shaft) {
    const MomentPlane::Extrema extrema = plane(shaft);
    MomentMetrics metrics;
    metrics.mean = plane.mean();
    metrics.max = extrema.max.value;
    metrics.min = extrema.min.value;
    metrics.range = metrics.max - metrics.min;
    metrics.rms = plane.rms(shaft);
    metrics.max_angle = extrema.max.angle_deg * degree;
    metrics.min_angle = extrema.min.angle_deg * degree;
    return metrics;
}

double size_of(const MomentMetrics& moment) {
    return std::max(std::abs(moment.max), std::abs(moment.min));
}

constexpr double flat_share = 1e-9;  ///< of a criterion: less makes no angle the best

constexpr Text makes_no_moment = Text::tr("The shaft has no moment: its angle has no effect.");

/// Of A sin(φ + angle).
MomentMetrics metrics_of_sine(double amplitude, double angle) {
    MomentMetrics metrics;
    metrics.mean = 0.0;  // of a sine over whole periods
    metrics.max = amplitude;
    metrics.min = -amplitude;
    metrics.range = 2.0 * amplitude;
    metrics.rms = amplitude / std::numbers::sqrt2;
    metrics.max_angle = wrap_turn(pi / 2.0 - angle);
    metrics.min_angle = wrap_turn(3.0 * pi / 2.0 - angle);
    return metrics;
}

Optimum best_range(const Moments& moments, const MomentMetrics& tipping) {
    if (moments.forces.moment_amplitude == 0.0) {
        return {std::nullopt, tipping.range, makes_no_moment};
    }
    const AngleMinimum best = minimise_range(moments.plane, moments.forces.moment_amplitude);
    if (best.worst - best.value > flat_share * best.worst) {
        return {wrap_turn(best.alpha - moments.phase), best.value, flat_note(moments, best)};
    }
    return {std::nullopt, best.value,
            Text::tr("The angle of the shaft does not affect the range.")};
}

Optimum best_rms(const Moments& moments, const MomentMetrics& tipping) {
    if (moments.forces.moment_amplitude == 0.0) {
        return {std::nullopt, tipping.rms, makes_no_moment};
    }
    // The variance is smallest where the shaft's moment opposes M_up's first order.
    const MomentPlane::Moment& opposed = moments.plane.opposed();
    if (opposed.norm() > flat_share * size_of(tipping)) {
        const double angle = wrap_turn(std::atan2(opposed.x(), opposed.y()) - moments.phase);
        return {angle, moments.plane.rms(moments.shaft_moment(angle)), {}};
    }
    return {std::nullopt, moments.plane.rms(moments.shaft_moment(0.0)),
            Text::tr("The tipping moment has no first order: the angle of the shaft does not "
                     "affect the RMS.")};
}

}  // namespace

Moments::Moments(const Input& checked)
    : gas(cylinder_gas(checked)),
      torque(engine_torque(checked, gas)),
      moment(with_offset_term(
          torque.negated(), slider_crank(checked),
          checked.reciprocating_mass() * checked.angular_speed * checked.angular_speed)),
      plane(moment) {
    follow(checked);
}

Message flat_note(const Moments& moments, const AngleMinimum& best) {
    // What cannot be built may have a smaller one.
    const auto is_as_good = [&](double alpha) {
        const auto shaft = shaft_at(moments.forces.moment_amplitude, alpha);
        return std::abs(moments.plane.range(shaft) - best.value) <= flat_share * best.worst;
    };
    const auto end = [&](double side) {  // of the angles as good as the best, from it
        double away = 0.0;
        for (const double step : {degree, 0.1 * degree}) {
            while (away < two_pi && is_as_good(best.alpha + side * (away + step))) {
                away += step;
            }
        }
        return Number{wrap_turn(best.alpha + side * away - moments.phase) / degree, units::degree,
                      -1};
    };
    const Number from = end(-1.0);
    const Number to = end(1.0);
    return from.value != to.value
               ? Message(Text::tr("The range is the same at least from %1 to %2."), from, to)
               : Message();
}

bool have_same_tipping_moment(const Input& one, const Input& other) {
    if (one.strokes != other.strokes || one.interpolation != other.interpolation ||
        one.torque != other.torque) {
        return false;
    }
    if (!one.torque.is_computed() && one.cylinder.offset == 0.0 && other.cylinder.offset == 0.0) {
        return true;
    }
    return one.crank_radius == other.crank_radius && one.cylinder == other.cylinder &&
           one.angular_speed == other.angular_speed &&
           one.reciprocating_mass() == other.reciprocating_mass();
}

void Moments::follow(const Input& checked) {
    crank = slider_crank(checked);
    top = crank.top_dead_centre();
    piston_1 = piston_first_order(crank);
    phase = top - piston_1.lag;
    forces = forces_of(checked);
}

void Moments::fill(const Input& input, bool optima, Result& result) const {
    result.angular_speed = input.angular_speed;
    result.reciprocating_mass = input.reciprocating_mass();
    static_cast<Forces&>(result) = forces;
    result.M_up = metrics_of(plane, {0.0, 0.0});
    result.order_1_amplitude = plane.opposed().norm();
    result.order_1_phase = std::atan2(-plane.opposed().x(), -plane.opposed().y());
    const double variance = plane.variance({0.0, 0.0});
    if (result.M_up.range > rounding_share * size_of(result.M_up) && variance > 0.0) {
        result.order_1_share =
            std::min(result.order_1_amplitude * result.order_1_amplitude / (2.0 * variance), 1.0);
    }
    result.dead_centre = top;
    result.counterweight_lag = piston_1.lag;
    if (optima) {
        result.best_range = best_range(*this, result.M_up);
        result.best_rms = best_rms(*this, result.M_up);
    }
    move_shaft(wrap_turn(input.shaft_angle), result);
}

void Moments::move_shaft(double alpha, Result& result) const {
    result.shaft_angle = alpha;
    result.M_s = metrics_of_sine(forces.moment_amplitude, alpha + phase);
    result.M_ups = metrics_of(plane, shaft_moment(alpha));
    if (result.order_1_share) {
        result.range_change = relative_change(result.M_up.range, result.M_ups.range);
        result.rms_change = relative_change(result.M_up.rms, result.M_ups.rms);
    }
}

}  // namespace ravnoves::balance_shaft
