#include "inertia-moments/orders.h"

#include <algorithm>
#include <cmath>

#include "inertia-moments/cylinder_orders.h"

namespace ravnoves::inertia_moments {

namespace {

/// u = (−sin β, cos β) as a complex number, the direction of a cylinder's axis.
Complex axis_direction(const Cylinder& cylinder) {
    return Complex(-std::sin(cylinder.bank_angle), std::cos(cylinder.bank_angle));
}

/// c of f(θ) = Re(c e^{ikθ}).
Complex coefficient(const Harmonic<double>& h) {
    return {h.cos, -h.sin};
}

Harmonic<double>& operator+=(Harmonic<double>& sum, const Complex& c) {
    sum.cos += c.real();
    sum.sin -= c.imag();
    return sum;
}

/// The orders of one cylinder, kept with the |K| that they were made for: the cylinders of an
/// engine share one or two.
struct CachedOrders {
    double offset;  ///< |K|
    CylinderOrders<double> orders;
};

/// Adds the cylinders' orders up. `orders_of` gives the orders for |K|; a negative offset is the
/// mirror image (force and torque at −θ).
template <typename OrdersOf>
std::vector<EngineOrder> add_up(const Engine& engine, int max_order, OrdersOf&& orders_of) {
    std::vector<EngineOrder> result(static_cast<std::size_t>(max_order));
    for (std::size_t k = 0; k < result.size(); ++k) {
        result[k].order = static_cast<int>(k) + 1;
    }
    constexpr double least = order_accuracy / zero_share;
    const double force_unit = engine.force_unit();
    const double torque_unit = force_unit * engine.crank_radius;
    const double couple_unit =
        engine.rod_couple_inertia * engine.angular_speed * engine.angular_speed;
    for (const Cylinder& cylinder : engine.cylinders) {
        const CylinderOrders<double>& own = orders_of(std::abs(cylinder.offset));
        const bool mirror = cylinder.offset < 0.0;
        // Even functions of (θ, e) keep their cosines, odd ones their sines.
        const auto even = [&](const Harmonic<double>& h) {
            return mirror ? Complex(h.cos, h.sin) : coefficient(h);
        };
        const auto odd = [&](const Harmonic<double>& h) {
            return mirror ? Complex(-h.cos, -h.sin) : coefficient(h);
        };
        const Complex u = axis_direction(cylinder);
        const double lever = cylinder.axial_position - engine.reference_position;
        const double phase = engine.crank_phase(cylinder);
        for (std::size_t k = 1; k <= result.size(); ++k) {
            EngineOrder& order = result[k - 1];
            const Complex turn = std::polar(1.0, static_cast<double>(k) * phase);
            const Complex force = force_unit * even(own.force[k]) * turn;
            const RotatingPair pair = RotatingPair::of(u, force);
            order.force += pair;
            order.moment += {pair.forward * lever, pair.backward * lever};
            const double scale = std::max(std::abs(force), least * force_unit);
            order.force_scale += scale;
            order.moment_scale += scale * std::abs(lever);
            Complex roll = -cylinder.offset * force;
            Complex torque = torque_unit * odd(own.torque[k]) * turn;
            if (couple_unit != 0.0) {
                roll += couple_unit * odd(own.rod_roll[k]) * turn;
                torque += couple_unit * odd(own.rod_torque[k]) * turn;
            }
            order.inertia_roll += roll;
            order.reaction_torque += -torque;
            order.roll_scale += std::max(std::abs(roll) + std::abs(torque), least * torque_unit);
        }
    }
    return result;
}

/// Looks |K| up among the few kept, or makes it.
template <typename Make>
const CylinderOrders<double>& cached(std::vector<CachedOrders>& kept, double offset, Make&& make) {
    const auto found = std::find_if(kept.begin(), kept.end(),
                                    [&](const CachedOrders& c) { return c.offset == offset; });
    if (found != kept.end()) {
        return found->orders;
    }
    return kept.emplace_back(CachedOrders{offset, make()}).orders;
}

/// Dimensionless motion of every cylinder at one φ, added up.
Wrench wrench_at(const Engine& engine, const std::vector<Complex>& axes,
                 const std::vector<SliderCrank<double>>& mechanisms,
                 const std::vector<Complex>& phases, Complex crank) {
    const double force_unit = engine.force_unit();
    const double torque_unit = force_unit * engine.crank_radius;
    const double couple_unit =
        engine.rod_couple_inertia * engine.angular_speed * engine.angular_speed;
    Wrench sum;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const Cylinder& cylinder = engine.cylinders[i];
        // e^{iθ} = e^{iφ} e^{iα}, written out: std::complex's product also checks for infinities.
        const double cos_theta = crank.real() * phases[i].real() - crank.imag() * phases[i].imag();
        const double sin_theta = crank.real() * phases[i].imag() + crank.imag() * phases[i].real();
        const auto motion = mechanisms[i].at(sin_theta, cos_theta);
        const double force = -force_unit * motion.d2s;
        sum.force += force * axes[i];
        sum.moment += force * (cylinder.axial_position - engine.reference_position) * axes[i];
        sum.inertia_roll -= cylinder.offset * force;
        sum.reaction_torque += torque_unit * motion.d2s * motion.ds;
        if (couple_unit != 0.0) {
            const auto swing = mechanisms[i].rod_at(sin_theta, cos_theta);
            sum.inertia_roll -= couple_unit * swing.d2psi;
            sum.reaction_torque += couple_unit * swing.d2psi * swing.dpsi;
        }
    }
    return sum;
}

struct Prepared {
    std::vector<Complex> axes;
    std::vector<SliderCrank<double>> mechanisms;
    std::vector<Complex> phases;

    explicit Prepared(const Engine& engine) {
        for (const Cylinder& cylinder : engine.cylinders) {
            axes.push_back(axis_direction(cylinder));
            mechanisms.push_back(engine.mechanism(cylinder));
            phases.push_back(std::polar(1.0, engine.crank_phase(cylinder)));
        }
    }
};

WrenchCurves sized_curves(std::size_t intervals) {
    const std::size_t points = intervals + 1;
    WrenchCurves curves;
    curves.crank_angle.resize(points);
    for (auto* values : {&curves.force_x, &curves.force_y, &curves.moment_x, &curves.moment_y,
                         &curves.inertia_roll, &curves.reaction_torque, &curves.roll}) {
        values->resize(points);
    }
    for (std::size_t i = 0; i < points; ++i) {
        curves.crank_angle[i] = two_pi * static_cast<double>(i) / static_cast<double>(intervals);
    }
    return curves;
}

void store(WrenchCurves& curves, std::size_t i, const Wrench& wrench) {
    curves.force_x[i] = wrench.force.real();
    curves.force_y[i] = wrench.force.imag();
    curves.moment_x[i] = wrench.moment.real();
    curves.moment_y[i] = wrench.moment.imag();
    curves.inertia_roll[i] = wrench.inertia_roll;
    curves.reaction_torque[i] = wrench.reaction_torque;
    curves.roll[i] = wrench.roll();
}

}  // namespace

EngineOrders exact_orders(const Engine& engine, int max_order, double accuracy) {
    EngineOrders result;
    const bool rod = engine.rod_couple_inertia != 0.0;
    std::vector<CachedOrders> kept;
    kept.reserve(engine.cylinders.size());
    std::optional<UniformTransform<double>> transform;
    result.orders = add_up(
        engine, max_order, [&](double offset) -> const auto& {
            return cached(kept, offset, [&] {
                const SliderCrank<double> crank{1.0, 1.0 / engine.lambda,
                                                offset / engine.crank_radius};
                const TransformLength length =
                    transform_length(crank.harmonic_decay(), max_order, accuracy);
                result.accurate = result.accurate && length.sufficient;
                result.transform_samples = std::max(result.transform_samples, length.samples);
                if (!transform || transform->size() < length.samples) {
                    transform.emplace(length.samples);
                }
                return exact_cylinder_orders(crank, max_order, *transform, rod);
            });
        });
    return result;
}

EngineOrders two_term_orders(const Engine& engine) {
    EngineOrders result;
    std::vector<CachedOrders> kept;
    kept.reserve(engine.cylinders.size());
    result.orders = add_up(
        engine, highest_two_term_order, [&](double offset) -> const auto& {
            return cached(kept, offset, [&] {
                return two_term_cylinder_orders(engine.lambda, offset / engine.crank_radius,
                                                engine.rod_couple_inertia != 0.0);
            });
        });
    return result;
}

Wrench exact_wrench(const Engine& engine, double crank_angle) {
    const Prepared prepared(engine);
    return wrench_at(engine, prepared.axes, prepared.mechanisms, prepared.phases,
                     std::polar(1.0, crank_angle));
}

Wrench sum_of_orders(const EngineOrders& orders, double crank_angle) {
    Wrench sum;
    const Complex turn = std::polar(1.0, crank_angle);
    Complex power(1.0, 0.0);  // e^{ikφ}
    for (const EngineOrder& order : orders.orders) {
        power = Complex(power.real() * turn.real() - power.imag() * turn.imag(),
                        power.real() * turn.imag() + power.imag() * turn.real());
        sum.force += order.force.along(power);
        sum.moment += order.moment.along(power);
        sum.inertia_roll +=
            order.inertia_roll.cos * power.real() + order.inertia_roll.sin * power.imag();
        sum.reaction_torque +=
            order.reaction_torque.cos * power.real() + order.reaction_torque.sin * power.imag();
    }
    return sum;
}

WrenchCurves exact_curves(const Engine& engine, std::size_t intervals) {
    WrenchCurves curves = sized_curves(intervals);
    const Prepared prepared(engine);
    for (std::size_t i = 0; i < intervals; ++i) {
        store(curves, i,
              wrench_at(engine, prepared.axes, prepared.mechanisms, prepared.phases,
                        std::polar(1.0, curves.crank_angle[i])));
    }
    store(
        curves, intervals,
        wrench_at(engine, prepared.axes, prepared.mechanisms, prepared.phases, Complex(1.0, 0.0)));
    return curves;
}

WrenchCurves curves_of_orders(const EngineOrders& orders, std::size_t intervals) {
    WrenchCurves curves = sized_curves(intervals);
    for (std::size_t i = 0; i <= intervals; ++i) {
        store(curves, i, sum_of_orders(orders, i == intervals ? 0.0 : curves.crank_angle[i]));
    }
    return curves;
}

}  // namespace ravnoves::inertia_moments
