#include <cmath>

#include "inertia-moments/cylinder_orders.h"
#include "inertia-moments/engine.h"
#include "inertia-moments/method_choices.h"
#include "methods/cylinder_order_series.h"
#include "methods/definition.h"

namespace ravnoves::methods {

namespace {

using inertia_moments::CylinderOrders;

constexpr int max_order = inertia_moments::highest_order;
constexpr std::size_t stored = max_order + 1;  // the mean among them

/// Orders 0…12 of force and torque of one cylinder, in units of m R ω² and m R² ω².
struct OrdersCase {
    SliderCrank<double> crank{1.0, 1.0, 0.0};  ///< in units of R

    std::size_t outputs() const { return 4 * stored; }
    double evaluations() const { return 1.0; }
};

constexpr double sample_operations = 30.0 + 34.0 + 1.0;  // node, s″ and s′, product

template <typename Scalar>
std::vector<Scalar> flat(const CylinderOrders<Scalar>& orders) {
    std::vector<Scalar> list(4 * stored, Scalar(0));
    for (std::size_t k = 0; k < stored; ++k) {
        if (k < orders.force.size()) {
            list[2 * k] = orders.force[k].cos;
            list[2 * k + 1] = orders.force[k].sin;
        }
        if (k < orders.torque.size()) {
            list[2 * stored + 2 * k] = orders.torque[k].cos;
            list[2 * stored + 2 * k + 1] = orders.torque[k].sin;
        }
    }
    return list;
}

void put(const CylinderOrders<double>& orders, std::span<double> out) {
    const std::vector<double> list = flat(orders);
    std::copy(list.begin(), list.end(), out.begin());
}

Message locks() {
    return CORE_TEXT("methods", "the mechanism locks: the crank cannot turn round");
}

/// Orders that fold onto others are not there; they are left zero.
CylinderOrders<double> transformed(const SliderCrank<double>& crank, std::size_t samples) {
    const UniformTransform<double> transform(samples);
    const int known = std::min(max_order, static_cast<int>(samples) / 2 - 1);
    return inertia_moments::exact_cylinder_orders(crank, known, transform, false);
}

double transform_operations(double samples) {
    return samples * (sample_operations + 2.0 * 4.0 * static_cast<double>(stored));
}

Method<OrdersCase> two_term() {
    Method<OrdersCase> method;
    method.info = {
        "two-term",
        CORE_TEXT("methods", "two-term closed form"),
        CORE_TEXT("methods",
                  "leaves λ³/4 in order 2 and all of the higher orders: three digits at λ = 0.25"),
        {{CORE_TEXT("methods", "closed form"), 0}},
        false};
    method.prepare = [](const OrdersCase& problem, const Setting&) -> Run {
        return [&problem](std::span<double> out) {
            put(inertia_moments::two_term_cylinder_orders(problem.crank.lambda(),
                                                          problem.crank.relative_offset(), false),
                out);
            return Message();
        };
    };
    method.operations = [](const OrdersCase&, const Setting&) { return 20.0; };
    return method;
}

Method<OrdersCase> transform() {
    Method<OrdersCase> method;
    method.info = {"transform",
                   CORE_TEXT("methods", "discrete Fourier transform"),
                   CORE_TEXT("methods",
                             "orders above half the points fold onto the low ones: with large λ or "
                             "K a short transform is wrong"),
                   {counted(CORE_TEXT("methods", "%1 points"), 8),
                    counted(CORE_TEXT("methods", "%1 points"), 16),
                    {CORE_TEXT("methods", "32 points"), 32},
                    {CORE_TEXT("methods", "64 points"), 64},
                    counted(CORE_TEXT("methods", "%1 points"), 128),
                    counted(CORE_TEXT("methods", "%1 points"), 256),
                    counted(CORE_TEXT("methods", "%1 points"), 512)},
                   false};
    method.prepare = [](const OrdersCase& problem, const Setting& setting) -> Run {
        return
            [&problem, samples = static_cast<std::size_t>(setting.value)](std::span<double> out) {
                if (problem.crank.locks()) {
                    return locks();
                }
                put(transformed(problem.crank, samples), out);
                return Message();
            };
    };
    method.operations = [](const OrdersCase&, const Setting& setting) {
        return transform_operations(setting.value);
    };
    return method;
}

Method<OrdersCase> transform_by_accuracy() {
    Method<OrdersCase> method;
    method.info = {"transform-by-accuracy",
                   CORE_TEXT("methods", "Fourier transform as long as needed"),
                   CORE_TEXT("methods",
                             "the number of points grows as 1/√(1 − λ(1 + K)); beyond 65536 points "
                             "it says that the accuracy is not reached"),
                   {{"1e-4", 1e-4}, {"1e-8", 1e-8}, {"1e-13", 1e-13}},
                   false};
    method.prepare = [](const OrdersCase& problem, const Setting& setting) -> Run {
        return [&problem, accuracy = setting.value](std::span<double> out) {
            if (problem.crank.locks()) {
                return locks();
            }
            const TransformLength length =
                transform_length(problem.crank.harmonic_decay(), max_order, accuracy);
            put(transformed(problem.crank, length.samples), out);
            return length.sufficient
                       ? Message()
                       : Message(
                             CORE_TEXT("methods",
                                       "the mechanism is too near locking for the accuracy asked"));
        };
    };
    method.operations = [](const OrdersCase& problem, const Setting& setting) {
        const auto length =
            transform_length(problem.crank.harmonic_decay(), max_order, setting.value);
        return transform_operations(static_cast<double>(length.samples));
    };
    return method;
}

Method<OrdersCase> series() {
    Method<OrdersCase> method;
    method.info = {"series",
                   CORE_TEXT("methods", "exact series"),
                   CORE_TEXT("methods",
                             "terms fall as (λ(1 + K))^2n only: near locking thousands are needed, "
                             "and their number grows into the square of the cost"),
                   {{CORE_TEXT("methods", "2 terms"), 2},
                    {CORE_TEXT("methods", "4 terms"), 4},
                    counted(CORE_TEXT("methods", "%1 terms"), 8),
                    counted(CORE_TEXT("methods", "%1 terms"), 16),
                    {CORE_TEXT("methods", "32 terms"), 32},
                    {CORE_TEXT("methods", "64 terms"), 64},
                    counted(CORE_TEXT("methods", "%1 terms"), 128)},
                   false};
    method.prepare = [](const OrdersCase& problem, const Setting& setting) -> Run {
        return [&problem, terms = static_cast<int>(setting.value)](std::span<double> out) {
            if (problem.crank.locks()) {
                return locks();
            }
            put(series_cylinder_orders(problem.crank, max_order, terms), out);
            return Message();
        };
    };
    method.operations = [](const OrdersCase&, const Setting& setting) {
        // Each power is a product with three coefficients, then the two sums of the torque.
        return setting.value * setting.value * 16.0 + 2.0 * setting.value * stored * 8.0;
    };
    return method;
}

std::vector<Expected> reference(const OrdersCase& problem) {
    if (problem.crank.locks()) {
        return {};
    }
    const SliderCrank<Real50> crank{Real50(problem.crank.crank_radius),
                                    Real50(problem.crank.rod_length), Real50(problem.crank.offset)};
    // Beyond double's digits by ten orders of magnitude: the points are what costs.
    constexpr double accuracy = 1e-26;
    const auto length = transform_length(problem.crank.harmonic_decay(), max_order, accuracy);
    const auto orders = flat(inertia_moments::exact_cylinder_orders(
        crank, max_order, UniformTransform<Real50>(length.samples), false));
    double scale[2] = {1.0, 1.0};
    for (std::size_t i = 0; i < orders.size(); ++i) {
        double& group = scale[i / (2 * stored)];
        group = std::max(group, std::abs(static_cast<double>(orders[i])));
    }
    std::vector<Expected> list;
    for (std::size_t i = 0; i < orders.size(); ++i) {
        list.push_back({i, orders[i], scale[i / (2 * stored)]});
    }
    return list;
}

/// The series in 50 digits: no samples, no sines.
std::optional<double> check(const OrdersCase& problem, const std::vector<Expected>& reference) {
    const double reach = (1.0 + std::abs(problem.crank.relative_offset())) * problem.crank.lambda();
    const double terms = std::ceil(-60.0 / (2.0 * std::log(reach))) + 4.0;  // to e^-60
    constexpr double most_terms = 300.0;
    if (!(reach < 1.0) || terms > most_terms) {
        return std::nullopt;
    }
    const SliderCrank<Real50> crank{Real50(problem.crank.crank_radius),
                                    Real50(problem.crank.rod_length), Real50(problem.crank.offset)};
    const auto orders = flat(series_cylinder_orders(crank, max_order, static_cast<int>(terms)));
    Real50 worst(0);
    for (const Expected& expected : reference) {
        worst = std::max(
            worst, Real50(abs(Real50(orders[expected.index] - expected.value)) / expected.scale));
    }
    return static_cast<double>(worst);
}

}  // namespace

Kernel inertia_orders_kernel() {
    constexpr double vr5_lambda = 0.265;
    constexpr double vr5_offset = 12.5 / 45.0;
    constexpr double limit = 1.0 / vr5_lambda - 1.0;
    Definition<OrdersCase> definition;
    Kernel& kernel = definition.kernel;
    kernel.id = "inertia-orders";
    kernel.title = CORE_TEXT("methods", "Inertia orders");
    kernel.quantity = CORE_TEXT("methods", "orders 0 to 12 of force and torque of one cylinder");
    kernel.error_measure =
        CORE_TEXT("methods", "part of the largest order, or of m R ω² and m R² ω²");
    kernel.evaluation = CORE_TEXT("methods", "all the orders of one cylinder");
    kernel.check_text = CORE_TEXT("methods", "the binomial series of the rod's root, term by term");
    kernel.check_tolerance = 1e-20;
    kernel.choice = inertia_moments::orders_choice;
    definition.methods = {two_term(), transform(), transform_by_accuracy(), series()};
    definition.sweeps = {
        {{"lambda", CORE_TEXT("methods", "crank ratio λ, K = 0"), units::none, 0.01, 1.0,
          Spacing::towards_end, 1e-4, 0.01, 1.0 - 1e-4, vr5_lambda},
         [](double lambda) {
             return OrdersCase{{1.0, 1.0 / lambda, 0.0}};
         }},
        {{"offset", CORE_TEXT("methods", "relative offset K at λ = 0.265"), units::none, 0.0, limit,
          Spacing::towards_end, 1e-4, 0.0, limit * (1.0 - 1e-4), vr5_offset},
         [](double offset) {
             return OrdersCase{{1.0, 1.0 / vr5_lambda, offset}};
         }},
    };
    definition.reference = reference;
    definition.refusal = [](const OrdersCase& problem) {
        const auto locking =
            inertia_moments::find_locking(problem.crank.crank_radius, problem.crank.lambda(),
                                          {{0.0, 0.0, problem.crank.offset, 0.0}});
        return locking ? inertia_moments::describe(*locking) : Message();
    };
    definition.check = check;
    return make_kernel(std::move(definition));
}

}  // namespace ravnoves::methods
