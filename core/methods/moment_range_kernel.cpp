#include <cmath>
#include <limits>
#include <queue>

#include "balance-shaft/angle_search.h"
#include "balance-shaft/method_choices.h"
#include "methods/definition.h"
#include "methods/enclosure.h"
#include "methods/torque_cycle.h"
#include "methods/torque_reference.h"
#include "numerics/constants.h"

namespace ravnoves::methods {

namespace {

/// Range of M_ups at one α. What does not depend on α is prepared, as the scene prepares it.
struct RangeCase : TorqueCycle {
    std::size_t outputs() const { return 1; }
    double evaluations() const { return 1.0; }
};

/// M_up and the sines at equally spaced nodes: two multiplications and additions per node and α.
class Nodes {
  public:
    Nodes(const TorqueCycle& cycle, double step_deg)
        : amplitude_(cycle.amplitude), alpha_(cycle.alpha) {
        const auto moment = cycle.interpolant<double>();
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

Method<RangeCase> nodes() {
    Method<RangeCase> method;
    method.info = {
        "nodes",
        CORE_TEXT("methods", "largest and smallest node"),
        CORE_TEXT("methods",
                  "an extremum between the nodes is cut off, and a narrow peak is not seen at all"),
        {{"30°", 30}, {"15°", 15}, {"5°", 5}, {"1°", 1}, {"0.1°", 0.1}},
        false};
    method.prepare = [](const RangeCase& cycle, const Setting& setting) -> Run {
        return [nodes = Nodes(cycle, setting.value)](std::span<double> out) {
            out[0] = nodes.range();
            return Message();
        };
    };
    method.operations = [](const RangeCase&, const Setting& setting) {
        return cycle_deg / setting.value * 6.0;
    };
    return method;
}

/// A golden section in one interval for the largest value of a function.
template <typename Function>
double golden_section_maximum(const Function& f, double a, double b, double tolerance) {
    constexpr double ratio = 0.618033988749894848;
    double left = b - ratio * (b - a);
    double right = a + ratio * (b - a);
    double f_left = f(left);
    double f_right = f(right);
    while (b - a > tolerance) {
        if (f_left > f_right) {
            b = right;
            right = left;
            f_right = f_left;
            left = b - ratio * (b - a);
            f_left = f(left);
        } else {
            a = left;
            left = right;
            f_left = f_right;
            right = a + ratio * (b - a);
            f_right = f(right);
        }
    }
    return std::max({f(a), f(b), f_left, f_right});
}

Method<RangeCase> golden_section() {
    Method<RangeCase> method;
    method.info = {
        "golden-section",
        CORE_TEXT("methods", "golden section between the rows"),
        CORE_TEXT("methods",
                  "finds one of two extrema between two rows, which long straight pieces have"),
        {counted(CORE_TEXT("methods", "to %1°"), 1),
         counted(CORE_TEXT("methods", "to %1°"), 1e-2),
         {{CORE_TEXT("methods", "to %1°"), "1e-6"}, 1e-6}},
        false};
    method.prepare = [](const RangeCase& cycle, const Setting& setting) -> Run {
        return [&cycle, moment = cycle.interpolant<double>(),
                tolerance = setting.value](std::span<double> out) {
            double highest = -std::numeric_limits<double>::infinity();
            double lowest = -std::numeric_limits<double>::infinity();
            for (std::size_t i = 0; i < moment.size(); ++i) {
                const double from = moment.knots()[i];
                const auto value = [&](double t) {
                    return moment.pieces()[i].value(t) +
                           cycle.amplitude * std::sin((from + t) * degree + cycle.alpha);
                };
                const double h = moment.knots()[i + 1] - from;
                highest = std::max(highest, golden_section_maximum(value, 0.0, h, tolerance));
                lowest = std::max(
                    lowest,
                    golden_section_maximum([&](double t) { return -value(t); }, 0.0, h, tolerance));
            }
            out[0] = highest + lowest;
            return Message();
        };
    };
    method.operations = [](const RangeCase& cycle, const Setting& setting) {
        const double pieces = static_cast<double>(cycle.moment.size() - 1);
        const double steps = std::log(cycle_deg / pieces / setting.value) / 0.4812;
        return 2.0 * pieces * (std::max(steps, 0.0) + 4.0) * 24.0;
    };
    return method;
}

Method<RangeCase> exact() {
    Method<RangeCase> method;
    method.info = {"exact",
                   CORE_TEXT("methods", "exact extrema of the pieces"),
                   CORE_TEXT("methods", "exact for the table as it is read"),
                   {{CORE_TEXT("methods", "pieces"), 0}},
                   false};
    method.prepare = [](const RangeCase& cycle, const Setting&) -> Run {
        return [plane = balance_shaft::MomentPlane(cycle.interpolant<double>()),
                shaft = balance_shaft::shaft_at(cycle.amplitude, cycle.alpha)](
                   std::span<double> out) {
            out[0] = plane.range(shaft);
            return Message();
        };
    };
    method.operations = [](const RangeCase& cycle, const Setting&) {
        // Every folded knot once, and about four intervals solved.
        const double knots = static_cast<double>(cycle.moment.size() - 1) / 2.0;
        return 7.0 * knots + 4.0 * (cycle.cubic ? 600.0 : 40.0) + 40.0;
    };
    return method;
}

/// A stretch of a piece with bounds of a moment on it, N·m.
struct Box {
    std::size_t piece;
    double from, to;  ///< from the piece's knot, degrees
    double highest;   ///< no value is above it

    bool operator<(const Box& other) const { return highest < other.highest; }
};

/// A bound above the largest of sign × M_ups that is no further above it than the tolerance: the
/// box with the highest bound is halved until its bound is that near to a value.
/// @param boxes  counts the enclosures made
double enclosed_maximum(const PeriodicPiecewise& moment, double amplitude, double alpha,
                        double sign, double tolerance, int& boxes) {
    const Enclosure unit = Enclosure(degree * (1.0 - 1e-16), degree * (1.0 + 1e-16));
    std::priority_queue<Box> open;
    double reached = -std::numeric_limits<double>::infinity();
    const auto open_box = [&](std::size_t i, double from, double to) {
        const auto& p = moment.pieces()[i];
        const Enclosure knot(moment.knots()[i]);
        const auto phase = [&](const Enclosure& t) { return (knot + t) * unit + Enclosure(alpha); };
        const auto value = [&](const Enclosure& t) {
            return sign * (p.y + t * (p.c1 + t * (p.c2 + t * p.c3)) + amplitude * sin(phase(t)));
        };
        const Enclosure box(from, to);
        const Enclosure slope = sign * (p.c1 + box * (2.0 * p.c2 + box * (3.0 * p.c3)) +
                                        amplitude * unit * cos(phase(box)));
        const Enclosure start = value(from);
        const Enclosure end = value(to);
        boxes += 3;
        reached = std::max({reached, start.lower(), end.lower()});
        double highest = std::max(start.upper(), end.upper());
        if (slope.lower() < 0.0 && slope.upper() > 0.0) {
            const double middle = 0.5 * (from + to);
            const Enclosure inside = value(middle) + slope * (box - Enclosure(middle));
            highest = std::max(highest, inside.upper());
            ++boxes;
        }
        if (highest > reached) {
            open.push({i, from, to, highest});
        }
    };
    for (std::size_t i = 0; i < moment.size(); ++i) {
        open_box(i, 0.0, moment.knots()[i + 1] - moment.knots()[i]);
    }
    constexpr int most = 20'000;
    while (!open.empty() && open.top().highest > reached + tolerance && boxes < most) {
        const Box box = open.top();
        open.pop();
        const double middle = 0.5 * (box.from + box.to);
        open_box(box.piece, box.from, middle);
        open_box(box.piece, middle, box.to);
    }
    return open.empty() ? reached : std::max(reached, open.top().highest);
}

double enclosed_range(const RangeCase& cycle, const PeriodicPiecewise& moment, double tolerance,
                      int& boxes) {
    double sum = 0.0;
    for (const double sign : {1.0, -1.0}) {
        sum += enclosed_maximum(moment, cycle.amplitude, cycle.alpha, sign,
                                tolerance * cycle.size() / 2.0, boxes);
    }
    return sum;
}

Method<RangeCase> intervals() {
    Method<RangeCase> method;
    method.info = {"intervals",
                   CORE_TEXT("methods", "interval bounds, halved"),
                   CORE_TEXT("methods",
                             "cannot miss a peak however narrow, and says how far off it is at "
                             "most; the price is thousands of times that of the closed form"),
                   {{{CORE_TEXT("methods", "to %1"), "1e-3"}, 1e-3},
                    {{CORE_TEXT("methods", "to %1"), "1e-6"}, 1e-6},
                    {{CORE_TEXT("methods", "to %1"), "1e-9"}, 1e-9}},
                   false};
    method.prepare = [](const RangeCase& cycle, const Setting& setting) -> Run {
        return [&cycle, moment = cycle.interpolant<double>(),
                tolerance = setting.value](std::span<double> out) {
            int boxes = 0;
            out[0] = enclosed_range(cycle, moment, tolerance, boxes);
            return Message();
        };
    };
    method.operations = [](const RangeCase& cycle, const Setting& setting) {
        int boxes = 0;
        enclosed_range(cycle, cycle.interpolant<double>(), setting.value, boxes);
        constexpr double of_a_box = 4.0 * 28.0;  // both ends of every operation, rounded apart
        return boxes * of_a_box;
    };
    return method;
}

std::vector<Expected> reference(const RangeCase& cycle) {
    return {{0, TorqueReference(cycle).range(Real50(cycle.alpha)), cycle.size()}};
}

/// The method in use: it folds the two revolutions and solves few intervals.
std::optional<double> check(const RangeCase& cycle, const std::vector<Expected>& reference) {
    const balance_shaft::MomentPlane plane(cycle.interpolant<double>());
    const double range = plane.range(balance_shaft::shaft_at(cycle.amplitude, cycle.alpha));
    const Real50 gap = abs(Real50(range - reference[0].value));
    return static_cast<double>(gap) / cycle.size();
}

}  // namespace

Kernel moment_range_kernel() {
    Definition<RangeCase> definition;
    Kernel& kernel = definition.kernel;
    kernel.id = "moment-range";
    kernel.title = CORE_TEXT("methods", "Range of Mᵤₚₛ");
    kernel.quantity =
        CORE_TEXT("methods", "ΔMᵤₚₛ, largest less smallest moment over the cycle, at one α");
    kernel.error_measure = CORE_TEXT("methods", "part of the largest torque of the table + A");
    kernel.evaluation = CORE_TEXT("methods", "the range at one α, the table being prepared");
    kernel.check_text = CORE_TEXT(
        "methods", "extrema of every degree by Newton's method, against the method in use");
    kernel.check_tolerance = 1e-13;
    kernel.choice = balance_shaft::moment_range_choice;
    definition.methods = {nodes(), golden_section(), intervals(), exact()};
    const TorqueCycle paper = paper_cycle();
    definition.sweeps = {
        {{"shaft-angle", CORE_TEXT("methods", "shaft angle α, the paper's engine"), units::degree,
          0.0, 360.0, Spacing::linear, 0.0, 0.0, 360.0, paper.alpha / degree},
         [paper](double alpha) {
             RangeCase cycle{paper};
             cycle.alpha = alpha * degree;
             return cycle;
         }},
        {{"peak-width", CORE_TEXT("methods", "width of the combustion peak"), units::degree, 0.05,
          60.0, Spacing::logarithmic, 0.0, 0.05, 60.0, 15.0},
         [](double width) { return RangeCase{peak_cycle(width)}; }},
        {{"amplitude", CORE_TEXT("methods", "amplitude of the shaft's moment, the paper's torque"),
          units::N_m, 1.0, 1e5, Spacing::logarithmic, 0.0, 1.0, 1e5, paper.amplitude},
         [paper](double amplitude) {
             RangeCase cycle{paper};
             cycle.amplitude = amplitude;
             return cycle;
         }},
        {{"spline-rows", CORE_TEXT("methods", "rows of a table read by the spline"), units::none,
          8.0, 160.0, Spacing::logarithmic, 0.0, 8.0, 160.0, 48.0},
         [](double rows) { return RangeCase{spline_cycle(rows)}; }},
        {{"irregular-rows", CORE_TEXT("methods", "rows of an irregular table"), units::none, 6.0,
          400.0, Spacing::logarithmic, 0.0, 6.0, 400.0, 48.0},
         [](double rows) { return RangeCase{irregular_cycle(rows)}; }},
    };
    definition.reference = reference;
    definition.check = check;
    return make_kernel(std::move(definition));
}

}  // namespace ravnoves::methods
