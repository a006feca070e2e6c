#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "balance-shaft/method_choices.h"
#include "methods/definition.h"
#include "methods/torque_cycle.h"
#include "methods/torque_reference.h"
#include "numerics/constants.h"

namespace ravnoves::methods {

namespace {

/// Mean of M_ups, its RMS about the mean, and the first order of M_up, a cos φ + b sin φ: with it
/// the RMS at every other α follows from the one at this.
struct MeanCase : TorqueCycle {
    std::size_t outputs() const { return 4; }
    double evaluations() const { return 1.0; }
};

/// Sums over weighted values of M_ups and M_up.
struct Sums {
    double weight = 0.0, mean = 0.0, square = 0.0, cosine = 0.0, sine = 0.0;

    void add(double w, double table, double shaft, double cos_phi, double sin_phi) {
        const double value = table + shaft;
        weight += w;
        mean += w * value;
        square += w * value * value;
        cosine += w * table * cos_phi;
        sine += w * table * sin_phi;
    }
    void put(std::span<double> out) const {
        const double centre = mean / weight;
        out[0] = centre;
        out[1] = std::sqrt(std::max(square / weight - centre * centre, 0.0));
        out[2] = 2.0 * cosine / weight;
        out[3] = 2.0 * sine / weight;
    }
};

/// Takes values of a cycle at any angle into sums.
class Nodes {
  public:
    explicit Nodes(const TorqueCycle& cycle)
        : x_(cycle.amplitude * std::sin(cycle.alpha)),
          y_(cycle.amplitude * std::cos(cycle.alpha)) {}
    void add(double weight, double angle_deg, double table, Sums& sums) const {
        const double c = std::cos(angle_deg * degree);
        const double s = std::sin(angle_deg * degree);
        sums.add(weight, table, x_ * c + y_ * s, c, s);
    }

  private:
    double x_;  ///< A sin α
    double y_;  ///< A cos α
};

constexpr double node_operations = 6.0 + 1.0 + 30.0 + 3.0 + 11.0;  // cubic, sines, shaft, sums

/// Find the piece by halves.
double search_operations(const TorqueCycle& cycle) {
    return 2.0 * std::log2(static_cast<double>(cycle.moment.size()));
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
        return [&cycle, weight,
                n = static_cast<std::size_t>(setting.value)](std::span<double> out) {
            const auto moment = cycle.interpolant<double>();
            const Nodes nodes(cycle);
            Sums sums;
            for (std::size_t i = 0; i <= n; ++i) {
                const double angle = cycle_deg * static_cast<double>(i) / static_cast<double>(n);
                nodes.add(weight(i, n), angle, moment(angle), sums);
            }
            sums.put(out);
            return Message();
        };
    };
    method.operations = [](const MeanCase& cycle, const Setting& setting) {
        return (setting.value + 1.0) * (node_operations + search_operations(cycle));
    };
    return method;
}

/// Both halves of a Gauss-Legendre rule on −1…1.
struct Rule {
    std::vector<double> x, w;
};

template <unsigned N>
Rule gauss_rule() {
    using Gauss = boost::math::quadrature::gauss<double, N>;
    Rule rule;
    for (std::size_t k = 0; k < Gauss::abscissa().size(); ++k) {
        const double x = Gauss::abscissa()[k];
        for (const double sign : {-1.0, 1.0}) {
            if (sign > 0.0 || x > 0.0) {
                rule.x.push_back(sign * x);
                rule.w.push_back(Gauss::weights()[k]);
            }
        }
    }
    return rule;
}

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
        return [&cycle, rule = gauss_rule<10>(), panels = setting.value](std::span<double> out) {
            const auto moment = cycle.interpolant<double>();
            const Nodes nodes(cycle);
            Sums sums;
            const double half = cycle_deg / panels / 2.0;
            for (double k = 0.0; k < panels; ++k) {
                for (std::size_t i = 0; i < rule.x.size(); ++i) {
                    const double angle = half * (2.0 * k + 1.0 + rule.x[i]);
                    nodes.add(rule.w[i], angle, moment(angle), sums);
                }
            }
            sums.put(out);
            return Message();
        };
    };
    method.operations = [](const MeanCase& cycle, const Setting& setting) {
        return 10.0 * setting.value * (node_operations + search_operations(cycle));
    };
    return method;
}

/// Points of Gauss-Legendre and the longest stretch that they are laid over; 0: any piece.
struct Plan {
    unsigned points;
    double longest_deg;
};
constexpr Plan plans[] = {{2, 0.0}, {3, 0.0}, {4, 0.0}, {3, 15.0}, {4, 30.0}, {7, 90.0}};

Rule rule_of(const Plan& plan) {
    switch (plan.points) {
        case 2:
            return gauss_rule<2>();
        case 3:
            return gauss_rule<3>();
        case 4:
            return gauss_rule<4>();
        default:
            return gauss_rule<7>();
    }
}

double parts_of(const Plan& plan, double width_deg) {
    return plan.longest_deg > 0.0 ? std::ceil(width_deg / plan.longest_deg) : 1.0;
}

Method<MeanCase> gauss_on_pieces() {
    Method<MeanCase> method;
    method.info = {
        "gauss-pieces",
        CORE_TEXT("methods", "Gauss-Legendre on the table's pieces"),
        CORE_TEXT("methods",
                  "a piece has no kink, so few points are as good as exact where rows are close; "
                  "pieces of a hundred degrees have to be parted for that"),
        {},
        false};
    for (const Plan& plan : plans) {
        const double number = static_cast<double>(&plan - plans);
        method.info.settings.push_back(
            plan.longest_deg > 0.0 ? Setting{{CORE_TEXT("methods", "%1 points, at most %2° apart"),
                                              static_cast<int>(plan.points), plan.longest_deg},
                                             number}
                                   : Setting{{CORE_TEXT("methods", "%1 points a piece"),
                                              static_cast<int>(plan.points)},
                                             number});
    }
    method.prepare = [](const MeanCase& cycle, const Setting& setting) -> Run {
        const Plan plan = plans[static_cast<std::size_t>(setting.value)];
        return [&cycle, plan, rule = rule_of(plan)](std::span<double> out) {
            const auto moment = cycle.interpolant<double>();
            const Nodes nodes(cycle);
            Sums sums;
            for (std::size_t piece = 0; piece < moment.size(); ++piece) {
                const double from = moment.knots()[piece];
                const double width = moment.knots()[piece + 1] - from;
                const double parts = parts_of(plan, width);
                const double half = width / parts / 2.0;
                for (double k = 0.0; k < parts; ++k) {
                    for (std::size_t i = 0; i < rule.x.size(); ++i) {
                        const double t = half * (2.0 * k + 1.0 + rule.x[i]);
                        nodes.add(half * rule.w[i], from + t, moment.pieces()[piece].value(t),
                                  sums);
                    }
                }
            }
            sums.put(out);
            return Message();
        };
    };
    method.operations = [](const MeanCase& cycle, const Setting& setting) {
        const Plan& plan = plans[static_cast<std::size_t>(setting.value)];
        double points = 0.0;
        for (std::size_t row = 0; row + 1 < cycle.angle_deg.size(); ++row) {
            points += plan.points * parts_of(plan, cycle.angle_deg[row + 1] - cycle.angle_deg[row]);
        }
        return points * (node_operations + 4.0);
    };
    return method;
}

/// As the scene computes them: integrals of the pieces, and the shaft's moment in closed form.
template <typename Scalar>
std::array<Scalar, 4> exact_moments(const BasicPeriodicPiecewise<Scalar>& moment,
                                    const Scalar& amplitude, const Scalar& alpha) {
    using std::cos;
    using std::sin;
    using std::sqrt;
    const auto order = moment.fourier(boost::math::constants::degree<Scalar>());
    const Scalar variance = moment.variance() + amplitude * (amplitude / 2 + sin(alpha) * order.a +
                                                             cos(alpha) * order.b);
    return {moment.mean(), variance > 0 ? Scalar(sqrt(variance)) : Scalar(0), order.a, order.b};
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
            const auto found =
                exact_moments(cycle.interpolant<double>(), cycle.amplitude, cycle.alpha);
            std::copy(found.begin(), found.end(), out.begin());
            return Message();
        };
    };
    method.operations = [](const MeanCase& cycle, const Setting&) {
        // Mean, square about it, first order with its sine and cosine; where the rows are uneven a
        // sine and cosine of half the piece as well.
        double sum = 0.0;
        double last = 0.0;
        for (std::size_t row = 0; row + 1 < cycle.angle_deg.size(); ++row) {
            const double width = cycle.angle_deg[row + 1] - cycle.angle_deg[row];
            sum += 10.0 + 29.0 + 67.0 + (width == last ? 0.0 : cycle.cubic ? 240.0 : 36.0);
            last = width;
        }
        return sum;
    };
    return method;
}

std::vector<Expected> reference(const MeanCase& cycle) {
    const TorqueReference exact(cycle);
    const auto order = exact.first_order();
    return {{0, exact.mean(), cycle.size()},
            {1, exact.rms(), cycle.size()},
            {2, order.a, cycle.size()},
            {3, order.b, cycle.size()}};
}

/// The method in use, run in 50 digits: it integrates piece by piece.
std::optional<double> check(const MeanCase& cycle, const std::vector<Expected>& reference) {
    const auto found =
        exact_moments(cycle.interpolant<Real50>(), Real50(cycle.amplitude), Real50(cycle.alpha));
    Real50 gap(0);
    for (const Expected& expected : reference) {
        gap = std::max(gap, Real50(abs(Real50(found[expected.index] - expected.value))));
    }
    return static_cast<double>(gap) / cycle.size();
}

}  // namespace

Kernel cycle_mean_kernel() {
    Definition<MeanCase> definition;
    Kernel& kernel = definition.kernel;
    kernel.id = "cycle-mean";
    kernel.title = CORE_TEXT("methods", "Cycle mean and RMS");
    kernel.quantity = CORE_TEXT("methods",
                                "mean of Mᵤₚₛ, its RMS about the mean, and the first order, which "
                                "gives the RMS at every α");
    kernel.error_measure = CORE_TEXT("methods", "part of the largest torque of the table + A");
    kernel.evaluation = CORE_TEXT("methods", "all of these, from the table");
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
                             "its alternate weights make it up to half as far off again as the "
                             "trapezoid rule of as many steps, as long as kinks lie between its "
                             "even nodes; only where every row is on one does its order 4 show"),
                   {},
                   true},
                  [](std::size_t i, std::size_t n) {
                      return i == 0 || i == n ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
                  }),
        gauss_legendre(),
        gauss_on_pieces(),
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
