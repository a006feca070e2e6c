#include <algorithm>
#include <array>
#include <cmath>

#include "balance-shaft/method_choices.h"
#include "balance-shaft/place_search.h"
#include "methods/definition.h"
#include "methods/torque_cycle.h"
#include "methods/torque_reference.h"
#include "numerics/constants.h"

namespace ravnoves::methods {

namespace {

using balance_shaft::MomentPlane;
using Place = Eigen::Vector2d;

/// The place (a, b) of the shaft, in N·m of its moment, with the least range. The range at a place
/// is prepared as the scene prepares it.
struct PlaceCase : TorqueCycle {
    std::size_t outputs() const { return 2; }
    double evaluations() const { return 1.0; }
    MomentPlane plane() const { return MomentPlane(interpolant()); }
};

using Search = Place (*)(const MomentPlane& plane, double setting);

/// The best place is no farther than this.
double reach_of(const MomentPlane& plane) {
    return plane.range({0.0, 0.0});
}

Place grid(const MomentPlane& plane, double side) {
    const double reach = reach_of(plane);
    const int steps = static_cast<int>(side);
    Place best(0.0, 0.0);
    double least = reach;
    for (int i = 0; i < steps; ++i) {
        for (int k = 0; k < steps; ++k) {
            const Place at(reach * (2.0 * i / (steps - 1) - 1.0),
                           reach * (2.0 * k / (steps - 1) - 1.0));
            const double range = plane.range(at);
            if (range < least) {
                least = range;
                best = at;
            }
        }
    }
    return best;
}

/// Nelder and Mead's simplex with the usual factors, from the crank's axis.
Place nelder_mead(const MomentPlane& plane, double steps) {
    struct Corner {
        Place at;
        double range;
    };
    const auto corner = [&](const Place& at) { return Corner{at, plane.range(at)}; };
    const double size = reach_of(plane) / 4.0;
    std::array<Corner, 3> simplex{corner({0.0, 0.0}), corner({size, 0.0}), corner({0.0, size})};
    for (int i = 0; i < static_cast<int>(steps); ++i) {
        std::sort(simplex.begin(), simplex.end(),
                  [](const Corner& a, const Corner& b) { return a.range < b.range; });
        const Place middle = (simplex[0].at + simplex[1].at) / 2.0;
        const Place away = middle - simplex[2].at;
        const Corner reflected = corner(middle + away);
        if (reflected.range < simplex[0].range) {
            const Corner expanded = corner(middle + 2.0 * away);
            simplex[2] = expanded.range < reflected.range ? expanded : reflected;
            continue;
        }
        if (reflected.range < simplex[1].range) {
            simplex[2] = reflected;
            continue;
        }
        const bool outside = reflected.range < simplex[2].range;
        const Corner contracted = corner(middle + (outside ? 0.5 : -0.5) * away);
        if (contracted.range < std::min(reflected.range, simplex[2].range)) {
            simplex[2] = contracted;
            continue;
        }
        for (std::size_t k = 1; k < 3; ++k) {
            simplex[k] = corner((simplex[0].at + simplex[k].at) / 2.0);
        }
    }
    return std::min_element(simplex.begin(), simplex.end(),
                            [](const Corner& a, const Corner& b) { return a.range < b.range; })
        ->at;
}

Place cutting_planes(const MomentPlane& plane, double) {
    return balance_shaft::minimise_range(plane).place;
}

Method<PlaceCase> method_of(MethodInfo info, Search search) {
    return {std::move(info), [search](const PlaceCase& cycle, double setting) -> Run {
                return [search, setting, plane = cycle.plane()](std::span<double> out) {
                    const Place found = search(plane, setting);
                    out[0] = found.x();
                    out[1] = found.y();
                    return Message();
                };
            }};
}

/// Where the first order of the moments vanishes: the best place for the RMS.
Run first_order(const PlaceCase& cycle, double) {
    return [moment = cycle.interpolant()](std::span<double> out) {
        const FourierPair order = moment.fourier(degree);
        out[0] = -order.a;
        out[1] = -order.b;
        return Message();
    };
}

std::vector<Expected> reference(const PlaceCase& cycle) {
    return {{0, TorqueReference(cycle).least_range_of_all(), cycle.size()}};
}

/// By how much the range at the place found exceeds the least one.
double measure(const PlaceCase& cycle, std::span<const double> out,
               const std::vector<Expected>& reference) {
    const Real50 range = TorqueReference(cycle).range(Real50(out[0]), Real50(out[1]));
    return static_cast<double>(abs(Real50(range - reference[0].value))) / reference[0].scale;
}

}  // namespace

Kernel best_position_kernel() {
    Definition<PlaceCase> definition;
    Kernel& kernel = definition.kernel;
    kernel.id = "best-position";
    kernel.title = CORE_TEXT("methods", "Best place of the shaft");
    kernel.quantity = CORE_TEXT("methods", "the place of the shaft with the least range of M_ups");
    kernel.error_measure =
        CORE_TEXT("methods", "range there less the least range, part of the largest torque + A");
    kernel.evaluation =
        CORE_TEXT("methods", "one search over all places, the table being prepared");
    kernel.reference = CORE_TEXT("methods", "ellipsoids around the place, halved by slopes");
    kernel.choice = balance_shaft::best_position_choice;
    definition.methods = {
        {{"first-order",
          CORE_TEXT("methods", "place without first order"),
          CORE_TEXT("methods", "the best place for the RMS, not for the range"),
          {{CORE_TEXT("methods", "closed form"), 0}},
          false},
         first_order},
        method_of({"grid", CORE_TEXT("methods", "grid"),
                   CORE_TEXT("methods", "as good as its step, for the price of its square"),
                   counted(CORE_TEXT("methods", "%1 a side"), {21, 81, 201}), false},
                  grid),
        method_of({"nelder-mead", CORE_TEXT("methods", "Nelder–Mead simplex"),
                   CORE_TEXT("methods",
                             "goes without slopes, but on a kink the simplex may shrink to a place "
                             "that is not the best, and it does not know"),
                   counted(CORE_TEXT("methods", "%1 steps"), {30, 60, 120}), false},
                  nelder_mead),
        method_of({"cutting-planes",
                   CORE_TEXT("methods", "cutting planes"),
                   CORE_TEXT("methods", "exact: the planes prove that no place is better"),
                   {{CORE_TEXT("methods", "exact"), 0}},
                   false},
                  cutting_planes),
    };
    definition.sweeps = {
        {{"second-minimum", CORE_TEXT("methods", "how much better the best of two minima is"),
          units::none, 1e-12, 1.0, Spacing::logarithmic, 0.0, 1e-12, 1.0, 0.1},
         [](double share) { return PlaceCase{two_minima_cycle(share)}; }},
        {{"peak-width", CORE_TEXT("methods", "width of the combustion peak"), units::degree, 0.05,
          60.0, Spacing::logarithmic, 0.0, 0.05, 60.0, 15.0},
         [](double width) { return PlaceCase{peak_cycle(width)}; }},
        {{"spline-rows", CORE_TEXT("methods", "rows of a table read by the spline"), units::none,
          8.0, 160.0, Spacing::logarithmic, 0.0, 8.0, 160.0, 48.0},
         [](double rows) { return PlaceCase{spline_cycle(rows)}; }},
        {{"irregular-rows", CORE_TEXT("methods", "rows of an irregular table"), units::none, 6.0,
          400.0, Spacing::logarithmic, 0.0, 6.0, 400.0, 48.0},
         [](double rows) { return PlaceCase{irregular_cycle(rows)}; }},
    };
    definition.reference = reference;
    definition.measure = measure;
    return make_kernel(std::move(definition));
}

}  // namespace ravnoves::methods
