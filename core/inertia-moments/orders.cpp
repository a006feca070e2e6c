#include "inertia-moments/orders.h"

#include <algorithm>
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

/// What the moving parts of a cylinder do, in units of m_j R ω² and m_j R² ω².
struct Load {
    Complex force;  ///< along the cylinder's axis + i across it
    double roll;    ///< moment about the crank axis
    double torque;  ///< on the crank
};

Load load_of(const CylinderParts& parts, double sin_theta, double cos_theta) {
    const ArticulatedMotion motion = parts.crank.at(sin_theta, cos_theta);
    const double force = -motion.piston.d2s;
    Load load{force, -parts.crank.offset * force, force * motion.piston.ds};
    if (parts.knuckle > 0.0) {
        // −m a of the pin's own motion, less that at the crankpin, as in cylinder_orders().
        const Complex place = Complex(cos_theta, sin_theta) + motion.arm;
        const Complex rate = Complex(-sin_theta, cos_theta) + motion.darm;
        const Complex acceleration = motion.d2arm - Complex(cos_theta, sin_theta);
        load.force -= parts.knuckle * motion.d2arm;
        load.roll -= parts.knuckle * (std::conj(place) * acceleration).imag();
        load.torque -= parts.knuckle * (std::conj(rate) * acceleration).real();
    }
    if (parts.couple != 0.0) {
        const RodSwing<double> swing = parts.crank.master.rod_at(sin_theta, cos_theta);
        load.roll -= parts.couple * swing.d2psi;
        load.torque -= parts.couple * swing.d2psi * swing.dpsi;
    }
    return load;
}

CylinderParts parts_of(const Engine& engine, std::size_t cylinder) {
    const auto& rod = engine.cylinders[cylinder].articulated;
    return {engine.crank(cylinder), rod ? rod->knuckle_mass / engine.reciprocating_mass : 0.0,
            engine.rod_couple_inertia /
                (engine.reciprocating_mass * engine.crank_radius * engine.crank_radius)};
}

/// The largest difference of any order of force and torque, over the largest order (at least 1).
double relative_difference(const CylinderOrders& a, const CylinderOrders& b) {
    double largest = 1.0;
    double difference = 0.0;
    for (const auto list : {&CylinderOrders::along, &CylinderOrders::torque}) {
        for (std::size_t k = 0; k < (a.*list).size(); ++k) {
            const Harmonic<double>& left = (a.*list)[k];
            const Harmonic<double>& right = (b.*list)[k];
            largest = std::max(largest, amplitude(left));
            difference =
                std::max(difference, std::hypot(left.cos - right.cos, left.sin - right.sin));
        }
    }
    return difference / largest;
}

/// Exact orders of a cylinder with an articulated rod: the transform is doubled until that changes
/// nothing.
/// @param transforms  of so many samples, twice, four times…; grows as needed
/// @return none where that accuracy is not reached
std::optional<CylinderOrders> exact_articulated_orders(
    const CylinderParts& parts, int max_order, double accuracy,
    std::vector<UniformTransform<double>>& transforms) {
    CylinderOrders orders;
    for (std::size_t i = 0;; ++i) {
        if (i == transforms.size()) {
            transforms.emplace_back(i == 0 ? 2 * static_cast<std::size_t>(max_order) + 8
                                           : 2 * transforms.back().size());
        }
        CylinderOrders finer = exact_cylinder_orders(parts, max_order, transforms[i]);
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
EngineOrders add_up(const Engine& engine, int max_order, OrdersOf&& orders_of) {
    EngineOrders result;
    result.orders.resize(static_cast<std::size_t>(max_order));
    constexpr double minimum = order_accuracy / zero_share;
    const double force_unit = engine.force_unit();
    const double torque_unit = force_unit * engine.crank_radius;
    for (std::size_t i = 0; i < engine.cylinders.size(); ++i) {
        const Cylinder& cylinder = engine.cylinders[i];
        const CylinderOrders own = orders_of(i);
        const Complex u = axis_direction(cylinder);
        const double lever = cylinder.axial_position - engine.reference_position;
        const double phase = engine.crank_phase(cylinder);
        for (std::size_t k = 1; k <= result.orders.size(); ++k) {
            EngineOrder& order = result.orders[k - 1];
            order.order = static_cast<int>(k);
            const Complex turn = std::polar(1.0, static_cast<double>(k) * phase);
            const Complex along = force_unit * coefficient(own.along[k]) * turn;
            RotatingPair pair = RotatingPair::of(u, along);
            double scale = std::max(std::abs(along), minimum * force_unit);
            if (!own.across.empty()) {
                const Complex across = force_unit * coefficient(own.across[k]) * turn;
                pair += RotatingPair::of(u * Complex(0.0, 1.0), across);
                scale += std::abs(across);
            }
            order.force += pair;
            order.moment += {pair.forward * lever, pair.backward * lever};
            order.force_scale += scale;
            order.moment_scale += scale * std::abs(lever);
            const Complex roll = torque_unit * coefficient(own.roll[k]) * turn;
            const Complex torque = torque_unit * coefficient(own.torque[k]) * turn;
            order.inertia_roll += roll;
            order.reaction_torque += -torque;
            order.roll_scale += std::max(std::abs(roll) + std::abs(torque), minimum * torque_unit);
        }
    }
    return result;
}

/// e^{ikφ}; the end of a turn is its beginning.
Complex turned(double angle, int k = 1) {
    return std::polar(1.0, k * std::fmod(angle, two_pi));
}

}  // namespace

EngineOrders exact_orders(const Engine& engine, int max_order, double accuracy) {
    std::optional<UniformTransform<double>> transform;
    std::vector<UniformTransform<double>> doubling;  // for articulated rods
    return add_up(engine, max_order, [&](std::size_t i) {
        const CylinderParts parts = parts_of(engine, i);
        if (!engine.cylinders[i].articulated) {
            const SliderCrank<double>& crank = parts.crank.master;
            const std::size_t samples =
                transform_length(crank.harmonic_decay(), max_order, accuracy);
            if (!transform || transform->size() < samples) {
                transform.emplace(samples);
            }
            return exact_cylinder_orders(parts, max_order, *transform);
        }
        auto orders = exact_articulated_orders(parts, max_order, accuracy, doubling);
        if (!orders) {
            throw InputError(
                "/input/cylinders/" + std::to_string(i) + "/articulated/knuckle_radius_mm",
                Text::tr("must keep the articulated rod farther from locking: its exact orders "
                         "are not accurate enough"),
                Number{from_si(field::knuckle_radius,
                               engine.cylinders[i].articulated->knuckle_radius)});
        }
        return *std::move(orders);
    });
}

EngineOrders two_term_orders(const Engine& engine) {
    // A trigonometric polynomial: so many nodes are exact.
    static const UniformTransform<double> four_orders(4 * highest_two_term_order);
    return add_up(engine, highest_two_term_order, [&](std::size_t i) {
        const CylinderParts parts = parts_of(engine, i);
        if (!engine.cylinders[i].articulated) {
            return two_term_cylinder_orders(engine.lambda, parts.crank.offset, parts.couple);
        }
        CylinderOrders orders = cylinder_orders(
            parts,
            [&](double sin_theta, double cos_theta) {
                return parts.crank.two_term_at(sin_theta, cos_theta);
            },
            highest_two_term_order, four_orders);
        // Forces have two orders; what rounding leaves of the others is nothing.
        for (auto* list : {&orders.along, &orders.across}) {
            for (std::size_t k = 3; k < list->size(); ++k) {
                (*list)[k] = {};
            }
        }
        return orders;
    });
}

WrenchCurves::WrenchCurves(std::vector<double> angles) : crank_angle(std::move(angles)) {
    for (auto* values :
         {&force_x, &force_y, &moment_x, &moment_y, &inertia_roll, &reaction_torque, &roll}) {
        values->resize(crank_angle.size());
    }
}

void WrenchCurves::add(std::size_t i, Complex force, Complex moment, double inertia,
                       double reaction) {
    force_x[i] += force.real();
    force_y[i] += force.imag();
    moment_x[i] += moment.real();
    moment_y[i] += moment.imag();
    inertia_roll[i] += inertia;
    reaction_torque[i] += reaction;
    roll[i] = inertia_roll[i] + reaction_torque[i];
}

WrenchCurves exact_curves(const Engine& engine, std::vector<double> angles) {
    WrenchCurves curves(std::move(angles));
    std::vector<Complex> turns;
    for (const double angle : curves.crank_angle) {
        turns.push_back(turned(angle));
    }
    const double torque_unit = engine.force_unit() * engine.crank_radius;
    for (std::size_t i = 0; i < engine.cylinders.size(); ++i) {
        const Cylinder& cylinder = engine.cylinders[i];
        const CylinderParts parts = parts_of(engine, i);
        const Complex axis = engine.force_unit() * axis_direction(cylinder);
        const double lever = cylinder.axial_position - engine.reference_position;
        const Complex phase = std::polar(1.0, engine.crank_phase(cylinder));
        for (std::size_t j = 0; j < turns.size(); ++j) {
            const Complex own = turns[j] * phase;  // e^{iθ}
            const Load load = load_of(parts, own.imag(), own.real());
            const Complex force = axis * load.force;
            curves.add(j, force, lever * force, torque_unit * load.roll,
                       -torque_unit * load.torque);
        }
    }
    return curves;
}

WrenchCurves with_orders(WrenchCurves curves, const EngineOrders& orders) {
    for (const EngineOrder& order : orders.orders) {
        const double size = order.force.max() + order.moment.max() + amplitude(order.inertia_roll) +
                            amplitude(order.reaction_torque);
        for (std::size_t i = 0; size > 0.0 && i < curves.crank_angle.size(); ++i) {
            const Complex turn = turned(curves.crank_angle[i], order.order);
            const auto value = [&](const Harmonic<double>& h) {
                return h.cos * turn.real() + h.sin * turn.imag();
            };
            curves.add(i, order.force.along(turn), order.moment.along(turn),
                       value(order.inertia_roll), value(order.reaction_torque));
        }
    }
    return curves;
}

}  // namespace ravnoves::inertia_moments
