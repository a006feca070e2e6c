#include <cmath>

#include "inertia-moments/orders.h"
#include "methods/definition.h"
#include "methods/reference_mechanism.h"

namespace ravnoves::methods {

namespace {

using inertia_moments::CylinderOrders;

constexpr int max_order = inertia_moments::highest_order;
constexpr std::size_t stored = max_order + 1;  // the mean among them

// Orders 0…12 of force and torque of one cylinder, in units of m R ω² and m R² ω², of lengths in
// units of R.
using Crank = SliderCrank<double>;

void put(const CylinderOrders& orders, std::span<double> out) {
    std::fill(out.begin(), out.end(), 0.0);
    for (std::size_t k = 0; k < stored; ++k) {
        if (k < orders.along.size()) {
            out[2 * k] = orders.along[k].cos;
            out[2 * k + 1] = orders.along[k].sin;
        }
        if (k < orders.torque.size()) {
            out[2 * stored + 2 * k] = orders.torque[k].cos;
            out[2 * stored + 2 * k + 1] = orders.torque[k].sin;
        }
    }
}

/// What the scene says where there is nothing to compare with.
Message rejection_of(const Crank& crank) {
    return inertia_moments::locking_of({1.0, 1.0 / crank.lambda(), crank.relative_offset()}, 0);
}

/// Orders that fold onto others are not there; they are left zero.
CylinderOrders transformed(const SliderCrank<double>& crank, std::size_t samples) {
    const UniformTransform<double> transform(samples);
    const int known = std::min(max_order, static_cast<int>(samples) / 2 - 1);
    return inertia_moments::cylinder_orders({{crank, 1.0, 0.0, crank.rod_length, crank.offset}},
                                            inertia_moments::DesignBasis::exact, known, transform);
}

Method<Crank> method_of(MethodInfo info, CylinderOrders (*orders)(const Crank&, double setting)) {
    return {std::move(info), [orders](const Crank& crank, double setting) -> Run {
                return [&crank, orders, setting](std::span<double> out) {
                    Message rejection = rejection_of(crank);
                    if (rejection.empty()) {
                        put(orders(crank, setting), out);
                    }
                    return rejection;
                };
            }};
}

/// −s″ and −s″ s′ times cosines and sines, integrated over both halves of the turn from one of the
/// rod's farthest swings to the other by the double exponential rule: its nodes crowd at the ends
/// of the halves, where a mechanism near locking has its peaks.
std::vector<Expected> reference(const Crank& crank) {
    if (!rejection_of(crank).empty()) {
        return {};
    }
    const Real50& half_pi = boost::math::constants::half_pi<Real50>();
    const Real50 step = Real50(1) / 54;
    constexpr int reach = 216;
    std::vector<Real50> orders(4 * stored, Real50(0));
    for (const int middle : {0, 2}) {
        for (int j = -reach; j <= reach; ++j) {
            const Real50 t = step * j;
            const Real50 inner = half_pi * sinh(t);
            const Real50 spread = cosh(inner);
            const Real50 theta = half_pi * (middle + tanh(inner));
            const Real50 weight = half_pi * half_pi * cosh(t) / (spread * spread) * step;
            const auto motion = reference_piston(crank, theta);
            const Real50 force = -motion.d2s * weight;
            const Real50 torque = force * motion.ds;
            const Real50 c1 = cos(theta);
            const Real50 s1 = sin(theta);
            Real50 c(1);
            Real50 s(0);
            for (std::size_t k = 0; k < stored; ++k) {
                orders[2 * k] += force * c;
                orders[2 * k + 1] += force * s;
                orders[2 * stored + 2 * k] += torque * c;
                orders[2 * stored + 2 * k + 1] += torque * s;
                const Real50 next = c * c1 - s * s1;
                s = s * c1 + c * s1;
                c = next;
            }
        }
    }
    double scale[2] = {1.0, 1.0};
    for (std::size_t i = 0; i < orders.size(); ++i) {
        const bool mean = i % (2 * stored) < 2;
        orders[i] /= mean ? 4 * half_pi : 2 * half_pi;
        double& group = scale[i / (2 * stored)];
        group = std::max(group, std::abs(static_cast<double>(orders[i])));
    }
    std::vector<Expected> list;
    for (std::size_t i = 0; i < orders.size(); ++i) {
        list.push_back({i, orders[i], scale[i / (2 * stored)]});
    }
    return list;
}

}  // namespace

Kernel inertia_orders_kernel() {
    Definition<Crank> definition;
    definition.outputs = 4 * stored;
    Kernel& kernel = definition.kernel;
    kernel.id = "inertia-orders";
    kernel.title = Text::tr("Inertia orders");
    kernel.quantity = Text::tr("orders 0 to 12 of force and torque of one cylinder");
    kernel.error_measure = Text::tr("share of the maximum order, or of m R ω² and m R² ω²");
    kernel.evaluation = Text::tr("all the orders of one cylinder");
    kernel.reference = Text::tr("integrals of s″ over half turns by the double exponential rule");
    kernel.choice = {
        "inertia-moments", "transform-by-accuracy", "1e-13", 1e-11,
        Text::tr(
            "In a balanced layout orders cancel and only rounding may remain: eleven digits. No "
            "fixed number of points suffices for every λ and K; the number follows from the "
            "known decay of the orders.")};
    definition.methods = {
        method_of(
            {"two-term",
             Text::tr("two-term closed form"),
             Text::tr(
                 "leaves λ³/4 in order 2 and all of the higher orders: three digits at λ = 0.25"),
             {{Text::tr("closed form"), 0}}},
            [](const Crank& crank, double) {
                return inertia_moments::two_term_cylinder_orders(crank.lambda(),
                                                                 crank.relative_offset(), 0.0);
            }),
        method_of({"transform",
                   Text::tr("discrete Fourier transform"),
                   Text::tr("orders above half the points fold onto the low ones: with large λ or "
                            "K a short transform is wrong"),
                   {counted(Text::tr("%1 points"), 8),
                    counted(Text::tr("%1 points"), 16),
                    {Text::tr("32 points"), 32},
                    {Text::tr("64 points"), 64},
                    counted(Text::tr("%1 points"), 128),
                    counted(Text::tr("%1 points"), 512)}},
                  [](const Crank& crank, double samples) {
                      return transformed(crank, static_cast<std::size_t>(samples));
                  }),
        method_of(
            {"transform-by-accuracy",
             Text::tr("Fourier transform of sufficient length"),
             Text::tr("the number of points grows as 1/√(1 − λ(1 + K)); nearer to locking than "
                      "4·10⁻⁹ the module rejects the mechanism"),
             {{"1e-4", 1e-4}, {"1e-8", 1e-8}, {"1e-13", 1e-13}}},
            [](const Crank& crank, double accuracy) {
                return transformed(crank,
                                   transform_length(crank.harmonic_decay(), max_order, accuracy));
            }),
    };
    definition.sweeps = slider_crank_sweeps(1e-9, 5e-9);  // beyond what the scene takes
    definition.reference = reference;
    return make_kernel(std::move(definition));
}

}  // namespace ravnoves::methods
