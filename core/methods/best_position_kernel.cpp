#include <algorithm>

#include "balance-shaft/place_search.h"
#include "methods/definition.h"
#include "methods/torque_cycle.h"
#include "methods/torque_reference.h"
#include "numerics/constants.h"

namespace ravnoves::methods {

namespace {

using balance_shaft::MomentPlane;
using Place = Eigen::Vector2d;

// The place (a, b) of the shaft, in N·m of its moment, with the smallest range. The range at a
// place is prepared as the scene prepares it.

using Search = Place (*)(const MomentPlane& plane, double setting);

/// The best place is no farther than this.
double reach_of(const MomentPlane& plane) {
    return plane.range({0.0, 0.0});
}

Place grid(const MomentPlane& plane, double side) {
    const double reach = reach_of(plane);
    const int steps = static_cast<int>(side);
    Place best(0.0, 0.0);
    double minimum = reach;
    for (int i = 0; i < steps; ++i) {
        for (int k = 0; k < steps; ++k) {
            const Place at(reach * (2.0 * i / (steps - 1) - 1.0),
                           reach * (2.0 * k / (steps - 1) - 1.0));
            const double range = plane.range(at);
            if (range < minimum) {
                minimum = range;
                best = at;
            }
        }
    }
    return best;
}

Place cutting_planes(const MomentPlane& plane, double) {
    return balance_shaft::minimise_range(plane).place;
}

Method<TorqueCycle> method_of(MethodInfo info, Search search) {
    return {std::move(info), [search](const TorqueCycle& cycle, double setting) -> Run {
                return [search, setting,
                        plane = MomentPlane(cycle.interpolant())](std::span<double> out) {
                    const Place found = search(plane, setting);
                    out[0] = found.x();
                    out[1] = found.y();
                    return Message();
                };
            }};
}

/// Where the first order of the moments vanishes: the best place for the RMS.
Run first_order(const TorqueCycle& cycle, double) {
    return [moment = cycle.interpolant()](std::span<double> out) {
        const FourierPair order = moment.fourier(degree);
        out[0] = -order.a;
        out[1] = -order.b;
        return Message();
    };
}

std::vector<Expected> reference(const TorqueCycle& cycle) {
    return {{0, TorqueReference(cycle).min_range_of_all(), cycle.size()}};
}

/// By how much the range at the place found exceeds the smallest one.
double measure(const TorqueCycle& cycle, std::span<const double> out,
               const std::vector<Expected>& reference) {
    const Real50 range = TorqueReference(cycle).range(Real50(out[0]), Real50(out[1])).range;
    return static_cast<double>(abs(Real50(range - reference[0].value))) / reference[0].scale;
}

}  // namespace

Kernel best_position_kernel() {
    Definition<TorqueCycle> definition;
    definition.outputs = 2;
    Kernel& kernel = definition.kernel;
    kernel.id = "best-position";
    kernel.title = Text::tr("Best place of the shaft");
    kernel.quantity = Text::tr("the place of the shaft with the minimum range of M_ups");
    kernel.error_measure = Text::tr("range minus minimum range, share of the maximum torque + A");
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
                  cutting_planes),
    };
    definition.sweeps =
        torque_sweeps({"second-minimum", "peak-width", "spline-rows", "irregular-rows"});
    definition.reference = reference;
    definition.measure = measure;
    return make_kernel(std::move(definition));
}

}  // namespace ravnoves::methods
