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

using balance_shaft::MomentPlane;

/// The torque with the shaft at any angle.
struct ShaftAngles {
    MomentPlane plane;
    double amplitude;

    double range(double alpha) const {
        return plane.range(balance_shaft::shaft_at(amplitude, alpha));
    }
};

// The α with the smallest range. The range at an α is prepared as the scene prepares it.

using Search = double (*)(const ShaftAngles& extrema, double setting);

double scan(const ShaftAngles& extrema, double step_deg) {
    const int steps = static_cast<int>(std::round(360.0 / step_deg));
    double best = 0.0;
    double minimum = std::numeric_limits<double>::infinity();
    for (int i = 0; i < steps; ++i) {
        const double alpha = two_pi * i / steps;
        const double range = extrema.range(alpha);
        if (range < minimum) {
            minimum = range;
            best = alpha;
        }
    }
    return best;
}

double brent(const ShaftAngles& extrema, double scan_step) {
    const auto range = [&](double alpha) { return extrema.range(alpha); };
    constexpr int bits = 40;
    if (scan_step == 0.0) {
        return boost::math::tools::brent_find_minima(range, 0.0, two_pi, bits).first;
    }
    const double start = scan(extrema, scan_step);
    const double step = scan_step * degree;
    return boost::math::tools::brent_find_minima(range, start - step, start + step, bits).first;
}

double cutting_planes(const ShaftAngles& extrema, double) {
    return balance_shaft::minimise_range(extrema.plane, extrema.amplitude).alpha;
}

Method<TorqueCycle> method_of(MethodInfo info, Search search) {
    return {std::move(info), [search](const TorqueCycle& cycle, double setting) -> Run {
                const ShaftAngles extrema{MomentPlane(cycle.interpolant()), cycle.amplitude};
                return [search, setting, extrema](std::span<double> out) {
                    out[0] = search(extrema, setting);
                    return Message();
                };
            }};
}

std::vector<Expected> reference(const TorqueCycle& cycle) {
    return {{0, TorqueReference(cycle).min_range(), cycle.size()}};
}

/// By how much the range at the angle found exceeds the smallest one.
double measure(const TorqueCycle& cycle, std::span<const double> out,
               const std::vector<Expected>& reference) {
    const Real50 range = TorqueReference(cycle).range(Real50(out[0])).range;
    return static_cast<double>(abs(Real50(range - reference[0].value))) / reference[0].scale;
}

}  // namespace

Kernel best_angle_kernel() {
    Definition<TorqueCycle> definition;
    Kernel& kernel = definition.kernel;
    kernel.id = "best-angle";
    kernel.title = Text::tr("Best shaft angle");
    kernel.quantity = Text::tr("the α of the minimum range of Mᵤₚₛ");
    kernel.error_measure = Text::tr("range minus minimum range, share of the maximum torque + A");
    kernel.evaluation = Text::tr("one search over all α, with the table prepared");
    kernel.reference =
        Text::tr("every angle of a scan where the slope turns, halved until it is found");
    kernel.choice = {
        "balance-shaft", "cutting-planes", "exact", 1e-9,
        Text::tr(
            "The range is the maximum of many sinusoids, with kinks and several minima. "
            "Sinusoids that bound it from below exclude worse angles, so the optimum is proven, "
            "with fewer evaluations than a scan of 5°.")};
    definition.methods = {
        method_of({"scan",
                   Text::tr("scan"),
                   Text::tr("limited by its step, for any table"),
                   {{"30°", 30}, {"5°", 5}, {"1°", 1}, {"0.1°", 0.1}}},
                  scan),
        method_of({"brent",
                   Text::tr("Brent's method"),
                   Text::tr("finds one of several minima, and on a kink its parabolas do not help"),
                   {{Text::tr("one start"), 0},
                    counted(Text::tr("from a scan of %1°"), 30),
                    counted(Text::tr("from a scan of %1°"), 10)}},
                  brent),
        method_of({"cutting-planes",
                   Text::tr("cutting planes"),
                   Text::tr("exact: the bounds prove that no angle is better"),
                   {{Text::tr("exact"), 0}}},
                  cutting_planes),
    };
    definition.sweeps = torque_sweeps(
        {"amplitude", "second-minimum", "peak-width", "spline-rows", "irregular-rows"});
    definition.reference = reference;
    definition.measure = measure;
    return make_kernel(std::move(definition));
}

}  // namespace ravnoves::methods
