#include "inertia-moments/orders.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "case-file/input_error.h"
#include "inertia-moments/cylinder_orders.h"
#include "inertia-moments/fields.h"

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

/// Samples beyond which a transform for an articulated rod does not grow.
constexpr std::size_t longest_transform = 1U << 14U;

/// The force of a mass at the knuckle pin instead of the crankpin, its moment about the crank axis
/// and its torque on the crank, in units of m_k and R: −m a of the pin's own motion, less what the
/// mass would do at the crankpin, whose force turns with the crank and has neither moment nor
/// torque.
struct KnuckleLoad {
    Complex force;  ///< along the cylinder's axis + i across it
    double roll;
    double torque;
};

KnuckleLoad knuckle_load(const ArticulatedMotion& motion, double sin_theta, double cos_theta) {
    const Complex place = Complex(cos_theta, sin_theta) + motion.arm;
    const Complex rate = Complex(-sin_theta, cos_theta) + motion.darm;
    const Complex acceleration = motion.d2arm - Complex(cos_theta, sin_theta);
    return {-motion.d2arm, place.imag() * acceleration.real() - place.real() * acceleration.imag(),
            -(acceleration.real() * rate.real() + acceleration.imag() * rate.imag())};
}

/// Orders of a cylinder with an articulated rod from its motion at the nodes of the transform.
template <typename MotionAt>
ArticulatedOrders articulated_orders(const MotionAt& motion_at, int max_order,
                                     const UniformTransform<double>& transform) {
    const std::size_t n = transform.size();
    std::array<std::vector<double>, 6> values;
    for (auto& list : values) {
        list.resize(n);
    }
    for (std::size_t j = 0; j < n; ++j) {
        const double sin_theta = transform.node_sin()[j];
        const double cos_theta = transform.node_cos()[j];
        const ArticulatedMotion motion = motion_at(sin_theta, cos_theta);
        const KnuckleLoad load = knuckle_load(motion, sin_theta, cos_theta);
        values[0][j] = -motion.piston.d2s;
        values[1][j] = -motion.piston.d2s * motion.piston.ds;
        values[2][j] = load.force.real();
        values[3][j] = load.force.imag();
        values[4][j] = load.roll;
        values[5][j] = load.torque;
    }
    ArticulatedOrders result;
    result.force = transform.orders(values[0], max_order);
    result.torque = transform.orders(values[1], max_order);
    result.knuckle_along = transform.orders(values[2], max_order);
    result.knuckle_across = transform.orders(values[3], max_order);
    result.knuckle_roll = transform.orders(values[4], max_order);
    result.knuckle_torque = transform.orders(values[5], max_order);
    return result;
}

/// The largest difference of any order of force and torque, over the largest order (at least 1).
double relative_difference(const CylinderOrders<double>& a, const CylinderOrders<double>& b) {
    double largest = 1.0;
    double difference = 0.0;
    const auto compare_lists = [&](const auto& left, const auto& right) {
        for (std::size_t k = 0; k < left.size(); ++k) {
            largest = std::max(largest, amplitude(left[k]));
            difference = std::max(
                difference, std::hypot(left[k].cos - right[k].cos, left[k].sin - right[k].sin));
        }
    };
    compare_lists(a.force, b.force);
    compare_lists(a.torque, b.torque);
    return difference / largest;
}

/// Exact orders of a cylinder with an articulated rod: the transform is doubled until that changes
/// nothing.
/// @param transforms  of so many samples, twice, four times…; grows as needed
/// @return none where that accuracy is not reached
std::optional<ArticulatedOrders> exact_articulated_orders(
    const ArticulatedCrank& crank, int max_order, double accuracy,
    std::vector<UniformTransform<double>>& transforms) {
    const auto motion_at = [&](double sin_theta, double cos_theta) {
        return crank.at(sin_theta, cos_theta);
    };
    ArticulatedOrders orders;
    for (std::size_t i = 0;; ++i) {
        if (i == transforms.size()) {
            transforms.emplace_back(i == 0 ? 2 * static_cast<std::size_t>(max_order) + 8
                                           : 2 * transforms.back().size());
        }
        ArticulatedOrders finer = articulated_orders(motion_at, max_order, transforms[i]);
        const bool settled = i > 0 && relative_difference(finer, orders) <= accuracy;
        orders = std::move(finer);
        if (settled) {
            return orders;
        }
        if (transforms[i].size() >= longest_transform) {
            return std::nullopt;
        }
    }
}

/// Adds the cylinders' orders up.
/// @param orders_of  those of a cylinder by its index
template <typename OrdersOf>
std::vector<EngineOrder> add_up(const Engine& engine, int max_order, OrdersOf&& orders_of) {
    std::vector<EngineOrder> result(static_cast<std::size_t>(max_order));
    for (std::size_t k = 0; k < result.size(); ++k) {
        result[k].order = static_cast<int>(k) + 1;
    }
    constexpr double minimum = order_accuracy / zero_share;
    const double force_unit = engine.force_unit();
    const double torque_unit = force_unit * engine.crank_radius;
    const double couple_unit =
        engine.rod_couple_inertia * engine.angular_speed * engine.angular_speed;
    for (std::size_t i = 0; i < engine.cylinders.size(); ++i) {
        const Cylinder& cylinder = engine.cylinders[i];
        const ArticulatedOrders own = orders_of(i);
        const Complex u = axis_direction(cylinder);
        const double lever = cylinder.axial_position - engine.reference_position;
        const double phase = engine.crank_phase(cylinder);
        for (std::size_t k = 1; k <= result.size(); ++k) {
            EngineOrder& order = result[k - 1];
            const Complex turn = std::polar(1.0, static_cast<double>(k) * phase);
            const Complex force = force_unit * coefficient(own.force[k]) * turn;
            const RotatingPair pair = RotatingPair::of(u, force);
            order.force += pair;
            order.moment += {pair.forward * lever, pair.backward * lever};
            const double scale = std::max(std::abs(force), minimum * force_unit);
            order.force_scale += scale;
            order.moment_scale += scale * std::abs(lever);
            Complex roll = -cylinder.offset * force;
            Complex torque = torque_unit * coefficient(own.torque[k]) * turn;
            if (couple_unit != 0.0) {
                roll += couple_unit * coefficient(own.rod_roll[k]) * turn;
                torque += couple_unit * coefficient(own.rod_torque[k]) * turn;
            }
            if (engine.knuckles[i] && engine.knuckles[i]->knuckle_mass > 0.0) {
                const double share = engine.knuckles[i]->knuckle_mass / engine.reciprocating_mass;
                const Complex along = share * force_unit * coefficient(own.knuckle_along[k]) * turn;
                const Complex across =
                    share * force_unit * coefficient(own.knuckle_across[k]) * turn;
                RotatingPair knuckle = RotatingPair::of(u, along);
                knuckle += RotatingPair::of(u * Complex(0.0, 1.0), across);
                order.force += knuckle;
                order.moment += {knuckle.forward * lever, knuckle.backward * lever};
                order.force_scale += std::abs(along) + std::abs(across);
                order.moment_scale += (std::abs(along) + std::abs(across)) * std::abs(lever);
                roll += share * torque_unit * coefficient(own.knuckle_roll[k]) * turn;
                torque += share * torque_unit * coefficient(own.knuckle_torque[k]) * turn;
            }
            order.inertia_roll += roll;
            order.reaction_torque += -torque;
            order.roll_scale += std::max(std::abs(roll) + std::abs(torque), minimum * torque_unit);
        }
    }
    return result;
}

/// What the mechanisms of an engine need at every φ.
struct Prepared {
    std::vector<Complex> axes;
    std::vector<SliderCrank<double>> mechanisms;
    std::vector<std::optional<ArticulatedCrank>> articulated;
    std::vector<Complex> phases;

    explicit Prepared(const Engine& engine) : articulated(engine.cylinders.size()) {
        for (std::size_t i = 0; i < engine.cylinders.size(); ++i) {
            const Cylinder& cylinder = engine.cylinders[i];
            axes.push_back(axis_direction(cylinder));
            mechanisms.push_back(engine.mechanism(cylinder));
            phases.push_back(std::polar(1.0, engine.crank_phase(cylinder)));
            if (engine.knuckles[i]) {
                articulated[i] = engine.articulated(i);
            }
        }
    }
};

/// Dimensionless motion of every cylinder at one φ, added up.
Wrench wrench_at(const Engine& engine, const Prepared& prepared, Complex crank) {
    const double force_unit = engine.force_unit();
    const double torque_unit = force_unit * engine.crank_radius;
    const double couple_unit =
        engine.rod_couple_inertia * engine.angular_speed * engine.angular_speed;
    Wrench sum;
    for (std::size_t i = 0; i < prepared.axes.size(); ++i) {
        const Cylinder& cylinder = engine.cylinders[i];
        const Complex& axis = prepared.axes[i];
        const Complex& phase = prepared.phases[i];
        const double lever = cylinder.axial_position - engine.reference_position;
        // e^{iθ} = e^{iφ} e^{iα}, written out: std::complex's product also checks for infinities.
        const double cos_theta = crank.real() * phase.real() - crank.imag() * phase.imag();
        const double sin_theta = crank.real() * phase.imag() + crank.imag() * phase.real();
        PistonMotion<double> motion{};
        if (prepared.articulated[i]) {
            const ArticulatedMotion hung = prepared.articulated[i]->at(sin_theta, cos_theta);
            motion = hung.piston;
            if (const double mass = engine.knuckles[i]->knuckle_mass; mass > 0.0) {
                const double share = mass / engine.reciprocating_mass;
                const KnuckleLoad load = knuckle_load(hung, sin_theta, cos_theta);
                sum.force += share * force_unit * load.force * axis;
                sum.moment += share * force_unit * lever * load.force * axis;
                sum.inertia_roll += share * torque_unit * load.roll;
                sum.reaction_torque -= share * torque_unit * load.torque;
            }
        } else {
            motion = prepared.mechanisms[i].at(sin_theta, cos_theta);
        }
        const double force = -force_unit * motion.d2s;
        sum.force += force * axis;
        sum.moment += force * lever * axis;
        sum.inertia_roll -= cylinder.offset * force;
        sum.reaction_torque += torque_unit * motion.d2s * motion.ds;
        if (couple_unit != 0.0) {
            const auto swing = prepared.mechanisms[i].rod_at(sin_theta, cos_theta);
            sum.inertia_roll -= couple_unit * swing.d2psi;
            sum.reaction_torque += couple_unit * swing.d2psi * swing.dpsi;
        }
    }
    return sum;
}

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
    std::optional<UniformTransform<double>> transform;
    std::vector<UniformTransform<double>> doubling;  // for articulated rods
    result.orders = add_up(engine, max_order, [&](std::size_t i) {
        if (!engine.knuckles[i]) {
            const SliderCrank<double> crank = engine.mechanism(engine.cylinders[i]);
            const std::size_t samples =
                transform_length(crank.harmonic_decay(), max_order, accuracy);
            if (!transform || transform->size() < samples) {
                transform.emplace(samples);
            }
            return ArticulatedOrders{
                exact_cylinder_orders(crank, max_order, *transform, rod), {}, {}, {}, {}};
        }
        auto orders =
            exact_articulated_orders(engine.articulated(i), max_order, accuracy, doubling);
        if (!orders) {
            throw InputError(
                "/input/cylinders/" + std::to_string(i) + "/articulated/knuckle_radius_mm",
                Text::tr("must keep the articulated rod farther from locking: its exact orders "
                         "are not accurate enough"),
                Number{from_si(field::knuckle_radius, engine.knuckles[i]->knuckle_radius)});
        }
        return *std::move(orders);
    });
    return result;
}

EngineOrders two_term_orders(const Engine& engine) {
    EngineOrders result;
    // A trigonometric polynomial: so many nodes are exact.
    static const UniformTransform<double> four_orders(4 * highest_two_term_order);
    result.orders = add_up(engine, highest_two_term_order, [&](std::size_t i) {
        if (!engine.knuckles[i]) {
            return ArticulatedOrders{
                two_term_cylinder_orders(engine.lambda,
                                         engine.cylinders[i].offset / engine.crank_radius,
                                         engine.rod_couple_inertia != 0.0),
                {},
                {},
                {},
                {}};
        }
        const ArticulatedCrank crank = engine.articulated(i);
        ArticulatedOrders orders = articulated_orders(
            [&](double sin_theta, double cos_theta) {
                return crank.two_term_at(sin_theta, cos_theta);
            },
            highest_two_term_order, four_orders);
        // Forces have two orders; what rounding leaves of the others is nothing.
        for (auto* list : {&orders.force, &orders.knuckle_along, &orders.knuckle_across}) {
            std::fill(list->begin() + 3, list->end(), Harmonic<double>{});
        }
        return orders;
    });
    return result;
}

Wrench exact_wrench(const Engine& engine, double crank_angle) {
    const Prepared prepared(engine);
    return wrench_at(engine, prepared, std::polar(1.0, crank_angle));
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
        store(curves, i, wrench_at(engine, prepared, std::polar(1.0, curves.crank_angle[i])));
    }
    store(curves, intervals, wrench_at(engine, prepared, Complex(1.0, 0.0)));
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
