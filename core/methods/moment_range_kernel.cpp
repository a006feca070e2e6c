#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>

#include "balance-shaft/angle_search.h"
#include "methods/definition.h"
#include "methods/torque_cycle.h"
#include "methods/torque_reference.h"
#include "numerics/constants.h"

namespace ravnoves::methods {

namespace {

// Range of M_ups at one α. What does not depend on α is prepared, as the scene prepares it.

/// M_up and the sines at equally spaced nodes: two multiplications and additions per node and α.
class Nodes {
  public:
    Nodes(const TorqueCycle& cycle, double step_deg)
        : amplitude_(cycle.amplitude), alpha_(cycle.alpha) {
        const auto moment = cycle.interpolant();
        const auto n = static_cast<Eigen::Index>(std::round(cycle_deg / step_deg));
        moment_.resize(n);
        cos_.resize(n);
        sin_.resize(n);
        for (Eigen::Index i = 0; i < n; ++i) {
            const double angle = cycle_deg * static_cast<double>(i) / static_cast<double>(n);
            moment_[i] = moment(angle);
            cos_[i] = std::cos(angle * degree);
            sin_[i] = std::sin(angle * degree);
        }
    }
    double range() const {
        const double x = amplitude_ * std::sin(alpha_);
        const double y = amplitude_ * std::cos(alpha_);
        double highest = -std::numeric_limits<double>::infinity();
        double lowest = std::numeric_limits<double>::infinity();
        for (Eigen::Index i = 0; i < moment_.size(); ++i) {
            const double value = moment_[i] + x * cos_[i] + y * sin_[i];
            highest = std::max(highest, value);
            lowest = std::min(lowest, value);
        }
        return highest - lowest;
    }

  private:
    double amplitude_;
    double alpha_;
    Eigen::ArrayXd moment_, cos_, sin_;
};

Run prepare_nodes(const TorqueCycle& cycle, double step_deg) {
    return [nodes = Nodes(cycle, step_deg)](std::span<double> out) {
        out[0] = nodes.range();
        return Message();
    };
}

/// The largest value of each piece by Brent's method.
Run prepare_brent(const TorqueCycle& cycle, double bits) {
    return [&cycle, moment = cycle.interpolant(),
            bits = static_cast<int>(bits)](std::span<double> out) {
        double range = 0.0;
        for (const double sign : {1.0, -1.0}) {
            double highest = -std::numeric_limits<double>::infinity();
            for (std::size_t i = 0; i < moment.size(); ++i) {
                const double from = moment.knots()[i];
                const auto depth = [&](double t) {
                    return -sign * (moment.pieces()[i].value(t) +
                                    cycle.amplitude * std::sin((from + t) * degree + cycle.alpha));
                };
                const double width = moment.knots()[i + 1] - from;
                const double inside =
                    boost::math::tools::brent_find_minima(depth, 0.0, width, bits).second;
                highest = std::max({highest, -depth(0.0), -inside});
            }
            range += highest;
        }
        out[0] = range;
        return Message();
    };
}

Run prepare_exact(const TorqueCycle& cycle, double) {
    return [plane = balance_shaft::MomentPlane(cycle.interpolant()),
            shaft = balance_shaft::shaft_at(cycle.amplitude, cycle.alpha)](std::span<double> out) {
        out[0] = plane.range(shaft);
        return Message();
    };
}

std::vector<Expected> reference(const TorqueCycle& cycle) {
    return {{0, TorqueReference(cycle).range(Real50(cycle.alpha)).range, cycle.size()}};
}

}  // namespace

Kernel moment_range_kernel() {
    Definition<TorqueCycle> definition;
    Kernel& kernel = definition.kernel;
    kernel.id = "moment-range";
    kernel.title = Text::tr("Range of Mᵤₚₛ");
    kernel.quantity = Text::tr("ΔMᵤₚₛ, maximum minus minimum moment over the cycle, at one α");
    kernel.error_measure = Text::tr("share of the maximum torque of the table + A");
    kernel.evaluation = Text::tr("the range at one α, with the table prepared");
    kernel.reference = Text::tr("extrema of every half degree by Newton's method");
    kernel.choice = {
        "balance-shaft", "exact", "pieces", 1e-9,
        Text::tr(
            "The optimum angle compares ranges, so nine digits. Nodes miss a peak between them; "
            "the extremum of a line plus a sine has a closed form, and only the few intervals "
            "that may contain it are solved.")};
    definition.methods = {
        {{"nodes",
          Text::tr("maximum and minimum node"),
          Text::tr("cuts off an extremum between the nodes and misses a narrow peak"),
          {{"30°", 30}, {"15°", 15}, {"5°", 5}, {"1°", 1}, {"0.1°", 0.1}}},
         prepare_nodes},
        {{"brent",
          Text::tr("Brent's method between the rows"),
          Text::tr("finds only one of two extrema on long straight pieces"),
          {counted(Text::tr("to %1 bits"), 8), counted(Text::tr("to %1 bits"), 24)}},
         prepare_brent},
        {{"exact",
          Text::tr("exact extrema of the pieces"),
          Text::tr("exact for the interpolated table"),
          {{Text::tr("pieces"), 0}}},
         prepare_exact},
    };
    definition.sweeps =
        torque_sweeps({"shaft-angle", "peak-width", "amplitude", "spline-rows", "irregular-rows"});
    definition.reference = reference;
    return make_kernel(std::move(definition));
}

}  // namespace ravnoves::methods
