#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>

#include "balance-shaft/angle_search.h"
#include "balance-shaft/place_search.h"
#include "methods/definition.h"
#include "methods/torque_cycle.h"
#include "methods/torque_reference.h"
#include "numerics/constants.h"

// The angle α, or the place (a, b) in N·m of its moment, at which a shaft makes the range smallest.
// The range of each is prepared as the scene prepares it.
namespace ravnoves::methods {

namespace {

using balance_shaft::MomentPlane;
using Place = Eigen::Vector2d;

/// The torque with the shaft at any angle or place.
struct Ranges {
    MomentPlane plane;
    double amplitude;

    double at(double alpha) const { return plane.range(balance_shaft::shaft_at(amplitude, alpha)); }
};

double scan(const Ranges& ranges, double step_deg) {
    const int steps = static_cast<int>(std::round(360.0 / step_deg));
    double best = 0.0;
    double minimum = std::numeric_limits<double>::infinity();
    for (int i = 0; i < steps; ++i) {
        const double alpha = two_pi * i / steps;
        const double range = ranges.at(alpha);
        if (range < minimum) {
            minimum = range;
            best = alpha;
        }
    }
    return best;
}

double brent(const Ranges& ranges, double scan_step) {
    const auto range = [&](double alpha) { return ranges.at(alpha); };
    constexpr int bits = 40;
    if (scan_step == 0.0) {
        return boost::math::tools::brent_find_minima(range, 0.0, two_pi, bits).first;
    }
    const double start = scan(ranges, scan_step);
    const double step = scan_step * degree;
    return boost::math::tools::brent_find_minima(range, start - step, start + step, bits).first;
}

double best_angle(const Ranges& ranges, double) {
    return balance_shaft::minimise_range(ranges.plane, ranges.amplitude).alpha;
}

/// The best place is no farther than the range without shaft.
Place grid(const Ranges& ranges, double side) {
    const double reach = ranges.plane.range({0.0, 0.0});
    const int steps = static_cast<int>(side);
    Place best(0.0, 0.0);
    double minimum = reach;
    for (int i = 0; i < steps; ++i) {
        for (int k = 0; k < steps; ++k) {
            const Place at(reach * (2.0 * i / (steps - 1) - 1.0),
                           reach * (2.0 * k / (steps - 1) - 1.0));
            const double range = ranges.plane.range(at);
            if (range < minimum) {
                minimum = range;
                best = at;
            }
        }
    }
    return best;
}

Place best_place(const Ranges& ranges, double) {
    return balance_shaft::minimise_range(ranges.plane).place;
}

void put(double alpha, std::span<double> out) {
    out[0] = alpha;
}
void put(const Place& place, std::span<double> out) {
    out[0] = place.x();
    out[1] = place.y();
}

template <typename Found>
Method<TorqueCycle> method_of(MethodInfo info, Found (*search)(const Ranges&, double setting)) {
    return {std::move(info), [search](const TorqueCycle& cycle, double setting) -> Run {
                const Ranges ranges{MomentPlane(cycle.interpolant()), cycle.amplitude};
                return [search, setting, ranges](std::span<double> out) {
                    put(search(ranges, setting), out);
                    return Message();
                };
            }};
}

/// Where the first order of the moments vanishes: the best place for the RMS.
Run first_order(const TorqueCycle& cycle, double) {
    return [moment = cycle.interpolant()](std::span<double> out) {
        const FourierPair order = moment.fourier(degree);
        put(Place(-order.a, -order.b), out);
        return Message();
    };
}

/// By how much the range at what was found exceeds the smallest one.
double measure(const TorqueCycle& cycle, std::span<const double> out,
               const std::vector<Expected>& reference) {
    const TorqueReference exact(cycle);
    const auto found =
        out.size() == 1 ? exact.range(Real50(out[0])) : exact.range(Real50(out[0]), Real50(out[1]));
    return static_cast<double>(abs(Real50(found.range - reference[0].value))) / reference[0].scale;
}

Kernel kernel_of(Definition<TorqueCycle> definition, Real50 (TorqueReference::*smallest)() const) {
    definition.kernel.error_measure =
        Text::tr("range minus minimum range, share of the maximum torque + A");
    definition.reference = [smallest](const TorqueCycle& cycle) {
        return std::vector<Expected>{{0, (TorqueReference(cycle).*smallest)(), cycle.size()}};
    };
    definition.measure = measure;
    return make_kernel(std::move(definition));
}

}  // namespace

Kernel best_angle_kernel() {
    Definition<TorqueCycle> definition;
    Kernel& kernel = definition.kernel;
    kernel.id = "best-angle";
    kernel.title = Text::tr("Best shaft angle");
    kernel.quantity = Text::tr("the α of the minimum range of Mᵤₚₛ");
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
                  best_angle),
    };
    definition.sweeps = torque_sweeps(
        {"amplitude", "second-minimum", "peak-width", "spline-rows", "irregular-rows"});
    return kernel_of(std::move(definition), &TorqueReference::min_range);
}

Kernel best_position_kernel() {
    Definition<TorqueCycle> definition;
    definition.outputs = 2;
    Kernel& kernel = definition.kernel;
    kernel.id = "best-position";
    kernel.title = Text::tr("Best place of the shaft");
    kernel.quantity = Text::tr("the place of the shaft with the minimum range of M_ups");
    kernel.evaluation = Text::tr("one search over all places, with the table prepared");
    kernel.reference = Text::tr("ellipsoids around the place, cut by slopes");
    kernel.choice = {
        "balance-shaft", "cutting-planes", "exact", 1e-9,
        Text::tr(
            "Over the plane of places the range is convex: the maximum of linear functions minus "
            "their minimum. Planes below find its kinks, where other methods stop or jump, and "
            "prove that no place is better.")};
    definition.methods = {
        {{"first-order",
          Text::tr("place without first order"),
          Text::tr("the optimum of the RMS, not of the range"),
          {{Text::tr("closed form"), 0}}},
         first_order},
        method_of({"grid", Text::tr("grid"), Text::tr("limited by its step, at a quadratic cost"),
                   counted(Text::tr("%1 a side"), {21, 81, 201})},
                  grid),
        method_of({"cutting-planes",
                   Text::tr("cutting planes"),
                   Text::tr("exact: the planes prove that no place is better"),
                   {{Text::tr("exact"), 0}}},
                  best_place),
    };
    definition.sweeps =
        torque_sweeps({"second-minimum", "peak-width", "spline-rows", "irregular-rows"});
    return kernel_of(std::move(definition), &TorqueReference::min_range_of_all);
}

}  // namespace ravnoves::methods
