#include "inertia-moments/orders.h"

#include <algorithm>
#include <cmath>

#include "case-file/input_error.h"
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
/// @throws InputError where that accuracy is not reached
CylinderOrders exact_articulated_orders(const Engine& engine, std::size_t cylinder, int max_order,
                                        std::vector<UniformTransform<double>>& transforms) {
    const CylinderParts parts = parts_of(engine, cylinder);
    CylinderOrders orders;
    for (std::size_t i = 0; i == 0 || transforms[i - 1].size() < longest_transform; ++i) {
        if (i == transforms.size()) {
            transforms.emplace_back(i == 0 ? 2 * static_cast<std::size_t>(max_order) + 8
                                           : 2 * transforms.back().size());
        }
        CylinderOrders finer = cylinder_orders(parts, DesignBasis::exact, max_order, transforms[i]);
        if (i > 0 && relative_difference(finer, orders) <= order_accuracy) {
            return finer;
        }
        orders = std::move(finer);
    }
    throw InputError(
        rod_pointer(cylinder, field::knuckle_radius),
        Text::tr("must keep the articulated rod farther from locking: its exact orders are not "
                 "accurate enough"),
        Number{from_si(field::knuckle_radius,
                       engine.cylinders[cylinder].articulated->knuckle_radius)});
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

CylinderOrders cylinder_orders(const CylinderParts& parts, DesignBasis form, int max_order,
                               const UniformTransform<double>& transform) {
    const std::size_t n = transform.size();
    std::vector<double> along(n);
    std::vector<double> across(n);
    std::vector<double> spin(n);
    std::vector<double> energy(n);
    for (std::size_t j = 0; j < n; ++j) {
        const double sine = transform.node_sin()[j];
        const double cosine = transform.node_cos()[j];
        const ArticulatedMotion motion = form == DesignBasis::exact
                                             ? parts.crank.at(sine, cosine)
                                             : parts.crank.two_term_at(sine, cosine);
        const double rate = motion.piston.ds;
        const double swing =
            parts.couple != 0.0 ? parts.crank.master.rod_at(sine, cosine).dpsi : 0.0;
        // Less what the knuckle's mass would have at the crankpin, whose force turns with the crank
        // and has neither moment nor torque.
        const Complex pin = Complex(cosine, sine) + motion.arm;
        const Complex pin_rate = Complex(-sine, cosine) + motion.darm;
        along[j] = rate + parts.knuckle * motion.darm.real();
        across[j] = parts.knuckle * motion.darm.imag();
        spin[j] = parts.couple * swing - parts.crank.offset * rate +
                  parts.knuckle * (std::conj(pin) * pin_rate).imag();
        energy[j] = 0.5 * (rate * rate + parts.couple * swing * swing +
                           parts.knuckle * std::norm(pin_rate));
    }
    const auto lost = [&](const std::vector<double>& values) {
        auto orders = transform.orders(values, max_order);
        double k = 0.0;
        for (Harmonic<double>& order : orders) {
            order = {-k * order.sin, k * order.cos};
            k += 1.0;
        }
        return orders;
    };
    return {lost(along), parts.knuckle > 0.0 ? lost(across) : std::vector<Harmonic<double>>(),
            lost(spin), lost(energy)};
}

CylinderOrders two_term_cylinder_orders(double lambda, double relative_offset, double couple) {
    const double k = relative_offset;
    const double p = k * lambda;
    // The torque: −(cos θ + p sin θ + λ cos 2θ)(sin θ − p cos θ + λ/2 sin 2θ), product by product.
    return {{{}, {1.0, p}, {lambda, 0.0}, {}, {}},
            {},
            {{}, {-k, -k * p - couple * lambda}, {-k * lambda, 0.0}, {}, {}},
            {{},
             {0.25 * p * lambda, 0.25 * lambda},
             {p, -0.5 * (1.0 - p * p) + 0.5 * couple * lambda * lambda},
             {0.75 * p * lambda, -0.75 * lambda},
             {0.0, -0.25 * lambda * lambda}}};
}

EngineOrders exact_orders(const Engine& engine, int max_order) {
    std::optional<UniformTransform<double>> transform;
    std::vector<UniformTransform<double>> doubling;  // for articulated rods
    return add_up(engine, max_order, [&](std::size_t i) {
        if (engine.cylinders[i].articulated) {
            return exact_articulated_orders(engine, i, max_order, doubling);
        }
        const CylinderParts parts = parts_of(engine, i);
        const std::size_t samples =
            transform_length(parts.crank.master.harmonic_decay(), max_order, order_accuracy);
        if (!transform || transform->size() < samples) {
            transform.emplace(samples);
        }
        return cylinder_orders(parts, DesignBasis::exact, max_order, *transform);
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
        CylinderOrders orders =
            cylinder_orders(parts, DesignBasis::two_term, highest_two_term_order, four_orders);
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

std::array<Harmonic<double>, 5> components(const EngineOrder& order) {
    return {order.force.horizontal(), order.force.vertical(), order.moment.horizontal(),
            order.moment.vertical(), order.roll()};
}

std::vector<Difference> compare(const EngineOrders& exact, const EngineOrders& two_term) {
    constexpr double warning = 0.05;     // of a component, an error warns…
    constexpr double negligible = 0.01;  // …unless it is less of the quantity's largest one…
    constexpr double balanced = 0.02;  // …or of all cylinders in phase, as a balanced engine has
    // A quantity's size: what its cylinders would reach in phase is the floor under rounding.
    std::array<double, 3> largest{};
    std::array<double, 3> scale{};
    for (const EngineOrder& order : exact.orders) {
        const auto values = components(order);
        for (std::size_t c = 0; c < values.size(); ++c) {
            largest[c / 2] = std::max(largest[c / 2], amplitude(values[c]));
        }
        scale[0] = std::max(scale[0], order.force_scale);
        scale[1] = std::max(scale[1], order.moment_scale);
        scale[2] = std::max(scale[2], order.roll_scale);
    }
    std::vector<Difference> differences;
    for (const EngineOrder& order : exact.orders) {
        const auto values = components(order);
        const bool has_short = order.order <= static_cast<int>(two_term.orders.size());
        const auto short_forms =
            components(has_short ? two_term.order(order.order) : EngineOrder());
        for (std::size_t c = 0; c < values.size(); ++c) {
            const std::size_t q = c / 2;
            const Harmonic<double>& right = values[c];
            Harmonic<double> short_form = short_forms[c];
            Difference d;
            d.order = order.order;
            d.component = c;
            d.exact = amplitude(right);
            const double floor = zero_share * scale[q];
            d.two_term = amplitude(short_form);
            if (!(d.two_term > std::max(floor, zero_share * largest[q]))) {
                d.two_term = 0.0;  // what rounding leaves
                short_form = {};
            }
            d.error = std::hypot(right.cos - short_form.cos, right.sin - short_form.sin);
            const double reference = std::max(largest[q], balanced * scale[q]);
            if (reference > 0.0) {
                d.of_largest = d.error / reference;
            }
            if (d.exact > std::max(floor, zero_share * largest[q])) {
                d.relative = d.error / d.exact;
                d.warning = *d.relative > warning && d.of_largest > negligible;
            }
            differences.push_back(d);
        }
    }
    return differences;
}

Message describe(const Difference& difference) {
    constexpr Text quantities[] = {Text::tr("order %1 force"), Text::tr("order %1 moment"),
                                   Text::tr("order %1 roll moment")};
    constexpr Text planes[] = {Text::tr("%1, horizontal plane"), Text::tr("%1, vertical plane")};
    Message component(quantities[difference.component / 2], difference.order);
    if (difference.component < 4) {
        component = Message(planes[difference.component % 2], component);
    }
    const auto percent = [](double share) {
        return Number{share / units::percent, units::none, -1};
    };
    if (difference.two_term == 0.0) {
        return {Text::tr("%1: not in the two-term form, %2 % of the maximum order"), component,
                percent(difference.of_largest)};
    }
    return {Text::tr("%1: error of the two-term form %2 %"), component,
            percent(difference.relative.value_or(0.0))};
}

}  // namespace ravnoves::inertia_moments
