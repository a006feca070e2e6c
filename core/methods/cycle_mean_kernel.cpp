#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "methods/definition.h"
#include "methods/torque_cycle.h"
#include "methods/torque_reference.h"
#include "numerics/constants.h"

namespace ravnoves::methods {

namespace {

// Mean of M_ups, its RMS about the mean, and the first order of M_up, a cos φ + b sin φ: with it
// the RMS at every other α follows from the one at this.

/// Sums over weighted values of M_ups and M_up at any angles of a cycle.
class Sums {
  public:
    explicit Sums(const TorqueCycle& cycle)
        : x_(cycle.amplitude * std::sin(cycle.alpha)),
          y_(cycle.amplitude * std::cos(cycle.alpha)) {}

    void add(double weight, double angle_deg, double table) {
        const double c = std::cos(angle_deg * degree);
        const double s = std::sin(angle_deg * degree);
        const double value = table + (x_ * c + y_ * s);
        weight_ += weight;
        mean_ += weight * value;
        square_ += weight * value * value;
        cosine_ += weight * table * c;
        sine_ += weight * table * s;
    }
    void put(std::span<double> out) const {
        const double centre = mean_ / weight_;
        out[0] = centre;
        out[1] = std::sqrt(std::max(square_ / weight_ - centre * centre, 0.0));
        out[2] = 2.0 * cosine_ / weight_;
        out[3] = 2.0 * sine_ / weight_;
    }

  private:
    double x_;  ///< A sin α
    double y_;  ///< A cos α
    double weight_ = 0.0, mean_ = 0.0, square_ = 0.0, cosine_ = 0.0, sine_ = 0.0;
};

/// A rule of equally spaced nodes: weight(i) of node i = 0…n.
template <typename Weight>
Method<TorqueCycle> node_rule(MethodInfo info, const Weight& weight) {
    info.settings = {counted(Text::tr("%1 steps"), 12),  {Text::tr("24 steps"), 24},
                     counted(Text::tr("%1 steps"), 48),  {Text::tr("144 steps"), 144},
                     counted(Text::tr("%1 steps"), 720), counted(Text::tr("%1 steps"), 7200)};
    return {std::move(info), [weight](const TorqueCycle& cycle, double steps) -> Run {
                return
                    [&cycle, weight, n = static_cast<std::size_t>(steps)](std::span<double> out) {
                        const auto moment = cycle.interpolant();
                        Sums sums(cycle);
                        for (std::size_t i = 0; i <= n; ++i) {
                            const double angle =
                                cycle_deg * static_cast<double>(i) / static_cast<double>(n);
                            sums.add(weight(i, n), angle, moment(angle));
                        }
                        sums.put(out);
                        return Message();
                    };
            }};
}

Run gauss_legendre(const TorqueCycle& cycle, double panels) {
    return [&cycle, panels](std::span<double> out) {
        using Gauss = boost::math::quadrature::gauss<double, 10>;
        const auto moment = cycle.interpolant();
        Sums sums(cycle);
        const double half = cycle_deg / panels / 2.0;
        for (double k = 0.0; k < panels; ++k) {
            for (std::size_t i = 0; i < Gauss::abscissa().size(); ++i) {
                for (const double sign : {-1.0, 1.0}) {
                    const double angle = half * (2.0 * k + 1.0 + sign * Gauss::abscissa()[i]);
                    sums.add(Gauss::weights()[i], angle, moment(angle));
                }
            }
        }
        sums.put(out);
        return Message();
    };
}

/// As the scene computes them: integrals of the pieces, and the shaft's moment in closed form.
Run exact(const TorqueCycle& cycle, double) {
    return [&cycle](std::span<double> out) {
        const auto moment = cycle.interpolant();
        const double amplitude = cycle.amplitude;
        const auto order = moment.fourier(degree);
        const double variance =
            moment.variance() + amplitude * (amplitude / 2.0 + std::sin(cycle.alpha) * order.a +
                                             std::cos(cycle.alpha) * order.b);
        out[0] = moment.mean();
        out[1] = std::sqrt(std::max(variance, 0.0));
        out[2] = order.a;
        out[3] = order.b;
        return Message();
    };
}

std::vector<Expected> reference(const TorqueCycle& cycle) {
    const auto means = TorqueReference(cycle).means();
    return {{0, means.mean, cycle.size()},
            {1, means.rms, cycle.size()},
            {2, means.first_cos, cycle.size()},
            {3, means.first_sin, cycle.size()}};
}

}  // namespace

Kernel cycle_mean_kernel() {
    Definition<TorqueCycle> definition;
    definition.outputs = 4;
    Kernel& kernel = definition.kernel;
    kernel.id = "cycle-mean";
    kernel.title = Text::tr("Cycle mean and RMS");
    kernel.quantity = Text::tr(
        "mean of Mᵤₚₛ, its RMS about the mean, and the first order, which "
        "gives the RMS at every α");
    kernel.error_measure = Text::tr("share of the maximum torque of the table + A");
    kernel.evaluation = Text::tr("all of these, from the table");
    kernel.reference = Text::tr("Gauss-Legendre sums over the pieces, the spline by its bends");
    kernel.choice = {
        "balance-shaft", "exact", "pieces", 1e-9,
        Text::tr(
            "The paper's conclusions use a mean, so it must be the mean of the cycle, not of "
            "some nodes: nine digits for any table. The pieces between the rows are integrated "
            "exactly; then each shaft angle needs three multiplications.")};
    definition.methods = {
        node_rule({"nodes-end-twice",
                   Text::tr("node mean, end counted twice"),
                   Text::tr("never: 720° is 0° again, so a pure sine gets a mean of A sin α / "
                            "nodes (17.2 N·m in the paper)"),
                   {},
                   true},
                  [](std::size_t, std::size_t) { return 1.0; }),
        node_rule({"trapezoid",
                   Text::tr("trapezoid rule"),
                   Text::tr("a peak narrower than the step is seen or missed by chance; the kinks "
                            "at the rows leave order 2"),
                   {},
                   true},
                  [](std::size_t i, std::size_t n) { return i == 0 || i == n ? 0.5 : 1.0; }),
        {{"gauss-legendre",
          Text::tr("Gauss-Legendre, 10 points a panel"),
          Text::tr("converges slowly over the kinks at the rows; a peak inside one panel is lost"),
          {{Text::tr("1 panel"), 1},
           {Text::tr("4 panels"), 4},
           counted(Text::tr("%1 panels"), 16),
           {Text::tr("72 panels"), 72},
           counted(Text::tr("%1 panels"), 720)},
          true},
         gauss_legendre},
        {{"exact",
          Text::tr("exact integral of the interpolant"),
          Text::tr("exact for the interpolated table; the table does not show the engine between "
                   "its rows"),
          {{Text::tr("pieces"), 0}}},
         exact},
    };
    definition.sweeps =
        torque_sweeps({"shaft-angle", "pure-sine", "peak-width", "spline-rows", "irregular-rows"});
    definition.reference = reference;
    return make_kernel(std::move(definition));
}

}  // namespace ravnoves::methods
