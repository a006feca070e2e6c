#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "balance-shaft/method_choices.h"
#include "methods/definition.h"
#include "methods/torque_cycle.h"
#include "methods/torque_reference.h"
#include "numerics/constants.h"

namespace ravnoves::methods {

namespace {

constexpr double cycle_deg = 720.0;

/// Mean and RMS about the mean of M_ups, from a table to the two numbers.
struct MeanCase : TorqueCycle {
    std::size_t outputs() const { return 2; }
    double evaluations() const { return 1.0; }
};

/// M_ups between the rows.
class Moment {
  public:
    explicit Moment(const TorqueCycle& cycle)
        : pieces_(cycle.interpolant<double>()), amplitude_(cycle.amplitude), alpha_(cycle.alpha) {}
    double operator()(double angle_deg) const {
        return pieces_(angle_deg) + amplitude_ * std::sin(angle_deg * degree + alpha_);
    }

  private:
    PeriodicPiecewise pieces_;
    double amplitude_;
    double alpha_;
};

double node_operations(const TorqueCycle& cycle) {
    // Find the piece by halves, its polynomial, the sine, two sums.
    return 2.0 * std::log2(static_cast<double>(cycle.moment.size())) + 6.0 + 15.0 + 6.0;
}

void put_moments(double sum, double sum_of_squares, double weight, std::span<double> out) {
    const double mean = sum / weight;
    out[0] = mean;
    out[1] = std::sqrt(std::max(sum_of_squares / weight - mean * mean, 0.0));
}

/// A rule of equally spaced nodes: weight(i) of node i = 0…n.
template <typename Weight>
Method<MeanCase> node_rule(MethodInfo info, const Weight& weight) {
    Method<MeanCase> method;
    method.info = std::move(info);
    method.info.settings = {counted(CORE_TEXT("methods", "%1 steps"), 12),
                            {CORE_TEXT("methods", "24 steps"), 24},
                            counted(CORE_TEXT("methods", "%1 steps"), 48),
                            {CORE_TEXT("methods", "144 steps"), 144},
                            counted(CORE_TEXT("methods", "%1 steps"), 720),
                            counted(CORE_TEXT("methods", "%1 steps"), 7200)};
    method.info.has_order = true;
    method.prepare = [weight](const MeanCase& cycle, const Setting& setting) -> Run {
        return
            [&cycle, weight, n = static_cast<std::size_t>(setting.value)](std::span<double> out) {
                const Moment moment(cycle);
                double sum = 0.0;
                double squares = 0.0;
                double weights = 0.0;
                for (std::size_t i = 0; i <= n; ++i) {
                    const double w = weight(i, n);
                    const double value =
                        moment(cycle_deg * static_cast<double>(i) / static_cast<double>(n));
                    sum += w * value;
                    squares += w * value * value;
                    weights += w;
                }
                put_moments(sum, squares, weights, out);
                return Message();
            };
    };
    method.operations = [](const MeanCase& cycle, const Setting& setting) {
        return (setting.value + 1.0) * node_operations(cycle);
    };
    return method;
}

using Panel = boost::math::quadrature::gauss<double, 10>;

Method<MeanCase> gauss_legendre() {
    Method<MeanCase> method;
    method.info = {
        "gauss-legendre",
        CORE_TEXT("methods", "Gauss-Legendre, 10 points a panel"),
        CORE_TEXT("methods",
                  "converges slowly over the kinks at the rows; a peak inside one panel is lost"),
        {{CORE_TEXT("methods", "1 panel"), 1},
         {CORE_TEXT("methods", "4 panels"), 4},
         counted(CORE_TEXT("methods", "%1 panels"), 16),
         {CORE_TEXT("methods", "72 panels"), 72},
         counted(CORE_TEXT("methods", "%1 panels"), 720)},
        true};
    method.prepare = [](const MeanCase& cycle, const Setting& setting) -> Run {
        return [&cycle, panels = static_cast<int>(setting.value)](std::span<double> out) {
            const Moment moment(cycle);
            double sum = 0.0;
            double squares = 0.0;
            for (int k = 0; k < panels; ++k) {
                const double from = cycle_deg * k / panels;
                const double to = cycle_deg * (k + 1) / panels;
                sum += Panel::integrate(moment, from, to);
                squares += Panel::integrate(
                    [&](double a) {
                        const double value = moment(a);
                        return value * value;
                    },
                    from, to);
            }
            put_moments(sum, squares, cycle_deg, out);
            return Message();
        };
    };
    method.operations = [](const MeanCase& cycle, const Setting& setting) {
        return 20.0 * setting.value * node_operations(cycle);
    };
    return method;
}

/// As the scene computes them: integrals of the pieces, and the shaft's moment in closed form.
template <typename Scalar>
void exact_moments(const BasicPeriodicPiecewise<Scalar>& moment, const Scalar& amplitude,
                   const Scalar& alpha, Scalar& mean, Scalar& rms) {
    using std::cos;
    using std::sin;
    using std::sqrt;
    const auto order = moment.fourier(boost::math::constants::degree<Scalar>());
    const Scalar variance = moment.variance() + amplitude * (amplitude / 2 + sin(alpha) * order.a +
                                                             cos(alpha) * order.b);
    mean = moment.mean();
    rms = variance > 0 ? Scalar(sqrt(variance)) : Scalar(0);
}

Method<MeanCase> exact() {
    Method<MeanCase> method;
    method.info = {"exact",
                   CORE_TEXT("methods", "exact integral of the interpolant"),
                   CORE_TEXT("methods",
                             "exact for the table as it is read; what the engine did between the "
                             "rows is not in the table"),
                   {{CORE_TEXT("methods", "pieces"), 0}},
                   false};
    method.prepare = [](const MeanCase& cycle, const Setting&) -> Run {
        return [&cycle](std::span<double> out) {
            exact_moments(cycle.interpolant<double>(), cycle.amplitude, cycle.alpha, out[0],
                          out[1]);
            return Message();
        };
    };
    method.operations = [](const MeanCase& cycle, const Setting&) {
        // Seven nodes of the square, the mean, the first order with its sine and cosine.
        return static_cast<double>(cycle.moment.size() - 1) * (7.0 * 9.0 + 10.0 + 80.0);
    };
    return method;
}

std::vector<Expected> reference(const MeanCase& cycle) {
    const TorqueReference exact(cycle);
    return {{0, exact.mean(), cycle.size()}, {1, exact.rms(), cycle.size()}};
}

/// The method in use, run in 50 digits: it integrates piece by piece.
std::optional<double> check(const MeanCase& cycle, const std::vector<Expected>& reference) {
    Real50 mean;
    Real50 rms;
    exact_moments(cycle.interpolant<Real50>(), Real50(cycle.amplitude), Real50(cycle.alpha), mean,
                  rms);
    const Real50 gap = std::max(Real50(abs(Real50(mean - reference[0].value))),
                                Real50(abs(Real50(rms - reference[1].value))));
    return static_cast<double>(gap) / cycle.size();
}

}  // namespace

Kernel cycle_mean_kernel() {
    Definition<MeanCase> definition;
    Kernel& kernel = definition.kernel;
    kernel.id = "cycle-mean";
    kernel.title = CORE_TEXT("methods", "Cycle mean and RMS");
    kernel.quantity = CORE_TEXT("methods", "mean of M_ups and its RMS about the mean");
    kernel.error_measure = CORE_TEXT("methods", "part of the largest torque of the table + A");
    kernel.evaluation = CORE_TEXT("methods", "both numbers, from the table");
    kernel.check_text = CORE_TEXT(
        "methods", "jumps at the rows after integrating by parts, against the method in use");
    kernel.check_tolerance = 1e-40;
    kernel.choice = balance_shaft::cycle_mean_choice;
    definition.methods = {
        node_rule({"nodes-end-twice",
                   CORE_TEXT("methods", "node mean, end counted twice"),
                   CORE_TEXT("methods",
                             "never: 720° is 0° once more, so a pure sine gets a mean of A sin α / "
                             "nodes (17.2 N·m in the paper)"),
                   {},
                   true},
                  [](std::size_t, std::size_t) { return 1.0; }),
        node_rule({"trapezoid",
                   CORE_TEXT("methods", "trapezoid rule"),
                   CORE_TEXT("methods",
                             "a peak narrower than the step is seen or missed by chance; the kinks "
                             "at the rows leave order 2"),
                   {},
                   true},
                  [](std::size_t i, std::size_t n) { return i == 0 || i == n ? 0.5 : 1.0; }),
        node_rule({"simpson",
                   CORE_TEXT("methods", "Simpson's rule"),
                   CORE_TEXT("methods",
                             "on a periodic function its alternate weights make it a trapezoid "
                             "rule of half the nodes and worse"),
                   {},
                   true},
                  [](std::size_t i, std::size_t n) {
                      return i == 0 || i == n ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
                  }),
        gauss_legendre(),
        exact(),
    };
    const TorqueCycle paper = paper_cycle();
    definition.sweeps = {
        {{"shaft-angle", CORE_TEXT("methods", "shaft angle α, the paper's engine"), units::degree,
          0.0, 360.0, Spacing::linear, 0.0, 0.0, 360.0, paper.alpha / degree},
         [paper](double alpha) {
             MeanCase cycle{paper};
             cycle.alpha = alpha * degree;
             return cycle;
         }},
        {{"pure-sine", CORE_TEXT("methods", "shaft angle α, no torque but the shaft's"),
          units::degree, 0.0, 360.0, Spacing::linear, 0.0, 0.0, 360.0, 90.0},
         [](double alpha) { return MeanCase{pure_sine_cycle(alpha)}; }},
        {{"peak-width", CORE_TEXT("methods", "width of the combustion peak"), units::degree, 0.05,
          60.0, Spacing::logarithmic, 0.0, 0.05, 60.0, 15.0},
         [](double width) { return MeanCase{peak_cycle(width)}; }},
        {{"spline-rows", CORE_TEXT("methods", "rows of a table read by the spline"), units::none,
          8.0, 160.0, Spacing::logarithmic, 0.0, 8.0, 160.0, 48.0},
         [](double rows) { return MeanCase{spline_cycle(rows)}; }},
        {{"irregular-rows", CORE_TEXT("methods", "rows of an irregular table"), units::none, 6.0,
          400.0, Spacing::logarithmic, 0.0, 6.0, 400.0, 48.0},
         [](double rows) { return MeanCase{irregular_cycle(rows)}; }},
    };
    definition.reference = reference;
    definition.check = check;
    return make_kernel(std::move(definition));
}

}  // namespace ravnoves::methods
