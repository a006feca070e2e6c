#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <limits>
#include <optional>

#include "case-file/input_error.h"
#include "elastic-hinge/energy.h"
#include "elastic-hinge/guide_formula.h"
#include "elastic-hinge/method_choices.h"
#include "elastic-hinge/presets.h"
#include "elastic-hinge/solver.h"
#include "methods/definition.h"
#include "methods/enclosure.h"
#include "methods/hinge_mechanism.h"
#include "methods/rosenbrock.h"
#include "numerics/chebyshev.h"
#include "numerics/constants.h"

namespace ravnoves::methods {

namespace {

using elastic_hinge::Branch;
using elastic_hinge::EnergyRise;
using elastic_hinge::GuideSpring;

constexpr std::size_t intervals = 360;

/// Radius of the crank's guide every degree of one turn.
struct GuideCase {
    elastic_hinge::Input input;
    std::size_t hardest = 0;
    double hardest_angle = 0.0;  ///< rad

    std::size_t outputs() const { return intervals + 1; }
    double evaluations() const { return static_cast<double>(outputs()); }
    /// Whole degrees, but for the one next to the angle where most energy has been given out:
    /// there the guide is hardest to compute, so that angle itself takes its place.
    double angle(std::size_t i) const {
        return i == hardest ? hardest_angle
                            : two_pi * static_cast<double>(i) / static_cast<double>(intervals);
    }

    template <typename Scalar>
    GuideSpring<Scalar> spring() const {
        const elastic_hinge::Spring& given = input.spring.value();
        return {Scalar(given.stiffness), Scalar(given.free_length),
                Scalar(given.guide_radius_at_zero)};
    }
    template <typename Scalar>
    EnergyRise<Scalar> rise(const Scalar& phi) const {
        return energy_rise_at(mechanism_in<Scalar>(input), Scalar(input.angular_speed), phi);
    }
    template <typename Scalar>
    Scalar given_out(const Scalar& phi) const {
        return rise(phi).rise / (2 * Scalar(input.spring->stiffness));
    }
};

constexpr double rise_operations = 170.0;

Message no_guide() {
    return CORE_TEXT("methods", "the spring would have to give out more energy than it stores");
}

template <typename Radius>
Method<GuideCase> closed_form(MethodInfo info, const Radius& radius, double operations) {
    Method<GuideCase> method;
    method.info = std::move(info);
    method.prepare = [radius](const GuideCase& guide, const Setting&) -> Run {
        return [&guide, radius](std::span<double> out) {
            const auto spring = guide.spring<double>();
            const double square = spring.preload() * spring.preload();
            for (std::size_t i = 0; i < out.size(); ++i) {
                const double q = guide.given_out(guide.angle(i));
                if (!(q <= square)) {
                    return no_guide();
                }
                out[i] = radius(spring, q);
            }
            return Message();
        };
    };
    method.operations = [operations](const GuideCase&, const Setting&) {
        return rise_operations + operations;
    };
    return method;
}

/// (2) as an equation for ρ: dρ/dφ, not finite where the spring is unloaded.
struct Slope {
    explicit Slope(const GuideCase& of) : guide(of), spring(of.spring<double>()) {}
    const GuideCase& guide;
    GuideSpring<double> spring;

    double start() const { return spring.start_radius(Branch::compressed); }
    double scale() const { return spring.preload(); }
    double operator()(double rho, double phi) const {
        return elastic_hinge::guide_slope_ode(spring, rho, guide.rise(phi).slope);
    }
    /// Not a number where the spring is unloaded.
    double radius(double rho) const {
        return rho < spring.free_length / 2.0 ? rho : std::numeric_limits<double>::quiet_NaN();
    }
};

/// (2) as an equation for u = (ℓ₀/2 − ρ)², u′ = −M/2c: nothing in it is singular, and its
/// right-hand side does not even know u. What it starts from is taken off, so that small reliefs
/// keep digits.
struct SquareSlope {
    explicit SquareSlope(const GuideCase& of) : guide(of), spring(of.spring<double>()) {}
    const GuideCase& guide;
    GuideSpring<double> spring;

    double start() const { return 0.0; }
    double scale() const { return spring.preload() * spring.preload(); }
    double operator()(double /*given_out*/, double phi) const {
        return guide.rise(phi).slope / (2.0 * spring.stiffness);
    }
    double radius(double given_out) const {
        return guide_radius(spring, Branch::compressed, given_out);
    }
};

Message singular() {
    return CORE_TEXT("methods",
                     "runs into the spring's free length, where the equation is singular");
}

/// Steps of a fixed size through the whole turn; `step(slope, y, phi, h)` returns the next y.
template <typename Equation, typename Step>
Method<GuideCase> fixed_step(MethodInfo info, double slopes_per_step, Step step) {
    Method<GuideCase> method;
    method.info = std::move(info);
    method.prepare = [step](const GuideCase& guide, const Setting& setting) -> Run {
        return [&guide, step, steps = static_cast<int>(setting.value)](std::span<double> out) {
            const Equation slope(guide);
            const int parts = steps / static_cast<int>(intervals);
            double y = slope.start();
            out[0] = slope.radius(y);
            for (std::size_t i = 0; i < intervals; ++i) {
                const double h = (guide.angle(i + 1) - guide.angle(i)) / parts;
                for (int part = 0; part < parts; ++part) {
                    y = step(slope, y, guide.angle(i) + h * part, h);
                }
                out[i + 1] = slope.radius(y);
                if (std::isnan(out[i + 1])) {
                    return singular();
                }
            }
            return Message();
        };
    };
    method.operations = [slopes_per_step](const GuideCase&, const Setting& setting) {
        return setting.value / static_cast<double>(intervals) * slopes_per_step *
               (rise_operations + 15.0);
    };
    return method;
}

namespace odeint = boost::numeric::odeint;

template <typename Equation>
double runge_kutta_step(const Equation& slope, double y, double phi, double h) {
    const double a = slope(y, phi);
    const double b = slope(y + h / 2.0 * a, phi + h / 2.0);
    const double c = slope(y + h / 2.0 * b, phi + h / 2.0);
    const double d = slope(y + h * c, phi + h);
    return y + h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
}

/// With step control by Odeint, read off every degree; counts the slopes asked for.
template <typename Equation>
Message run_adaptive(const GuideCase& guide, double tolerance, std::span<double> out, int& asked) {
    using State = std::array<double, 1>;
    const Equation slope(guide);
    const auto system = [&](const State& x, State& dx, double phi) {
        ++asked;
        dx[0] = slope(x[0], phi);
    };
    auto stepper = odeint::make_dense_output(tolerance * slope.scale(), tolerance,
                                             odeint::runge_kutta_dopri5<State>());
    State x{slope.start()};
    out[0] = slope.radius(x[0]);
    stepper.initialize(x, 0.0, two_pi / intervals);
    constexpr int most_steps = 100'000;
    constexpr double no_step = 1e-15;
    int steps = 0;
    for (std::size_t i = 1; i <= intervals; ++i) {
        while (stepper.current_time() < guide.angle(i)) {
            try {
                stepper.do_step(system);
            } catch (const odeint::step_adjustment_error&) {
                return singular();
            }
            if (++steps > most_steps || !(stepper.current_time_step() > no_step) ||
                !std::isfinite(stepper.current_state()[0])) {
                return singular();
            }
        }
        stepper.calc_state(guide.angle(i), x);
        out[i] = slope.radius(x[0]);
        if (std::isnan(out[i])) {
            return singular();
        }
    }
    return {};
}

/// The same by an implicit method: Rosenbrock's of order 4 with its exact Jacobian.
Message run_implicit(const GuideCase& guide, double tolerance, std::span<double> out, int& asked) {
    const Slope slope(guide);
    ScalarEquation equation;
    equation.slope = [&](double phi, double rho) {
        ++asked;
        return slope(rho, phi);
    };
    equation.by_y = [&](double phi, double rho) {
        ++asked;
        return slope(rho, phi) * 2.0 / (slope.spring.free_length - 2.0 * rho);
    };
    equation.by_x = [&](double phi, double rho) {
        ++asked;
        return elastic_hinge::guide_slope_ode(slope.spring, rho, guide.rise(phi).second);
    };
    out[0] = slope.spring.start_radius(Branch::compressed);
    std::vector<double> angles;
    for (std::size_t i = 0; i <= intervals; ++i) {
        angles.push_back(guide.angle(i));
    }
    const bool done = integrate_rosenbrock(equation, angles, tolerance * slope.spring.preload(),
                                           tolerance, out.data());
    return done ? Message() : singular();
}

using Adaptive = Message (*)(const GuideCase&, double, std::span<double>, int&);

Method<GuideCase> adaptive(MethodInfo info, Adaptive integrate) {
    Method<GuideCase> method;
    method.info = std::move(info);
    method.prepare = [integrate](const GuideCase& guide, const Setting& setting) -> Run {
        return [&guide, integrate, tolerance = setting.value](std::span<double> out) {
            int asked = 0;
            return integrate(guide, tolerance, out, asked);
        };
    };
    method.operations = [integrate](const GuideCase& guide, const Setting& setting) {
        std::vector<double> out(guide.outputs());
        int asked = 0;
        integrate(guide, setting.value, out, asked);
        return asked * (rise_operations + 25.0) / guide.evaluations();
    };
    return method;
}

/// ρ through Chebyshev points of equal pieces of the turn, in the place of a table.
Method<GuideCase> chebyshev() {
    constexpr std::size_t pieces = 8;
    Method<GuideCase> method;
    method.info = {"chebyshev",
                   CORE_TEXT("methods", "Chebyshev interpolant on eighths of the turn"),
                   CORE_TEXT("methods",
                             "half the price of the closed form for a smooth guide; but a corner, "
                             "which the guide gets as the spring comes to give out all that it "
                             "stores, and λ near 1 leave it two or three digits"),
                   counted(CORE_TEXT("methods", "%1 points"), {6, 8, 12, 16}), false};
    method.prepare = [](const GuideCase& guide, const Setting& setting) -> Run {
        return [&guide, points = ChebyshevPoints(static_cast<std::size_t>(setting.value))](
                   std::span<double> out) {
            const auto spring = guide.spring<double>();
            const double square = spring.preload() * spring.preload();
            std::vector<double> values(points.size());
            std::vector<double> series(points.size());
            constexpr double width = two_pi / pieces;
            std::size_t i = 0;
            for (std::size_t piece = 0; piece < pieces; ++piece) {
                const double middle = width * (static_cast<double>(piece) + 0.5);
                for (std::size_t j = 0; j < points.size(); ++j) {
                    const double q = guide.given_out(middle + width / 2.0 * points[j]);
                    if (!(q <= square)) {
                        return no_guide();
                    }
                    values[j] = guide_radius(spring, Branch::compressed, q);
                }
                points.transform(values, series);
                const double end = middle + width / 2.0;
                while (i < out.size() && (guide.angle(i) <= end || piece + 1 == pieces)) {
                    out[i] = chebyshev_value(series, (guide.angle(i) - middle) / (width / 2.0));
                    ++i;
                }
            }
            return Message();
        };
    };
    method.operations = [](const GuideCase& guide, const Setting& setting) {
        const double n = setting.value;
        return pieces * n * (rise_operations + 20.0 + 2.0 * n) / guide.evaluations() + 3.0 * n +
               4.0;
    };
    return method;
}

/// Whether the guide exists, by enclosures of what the spring has given out: true or false where
/// that is proved for every angle and not just for those looked at.
/// @param smallest  box that is still parted, rad
/// @param boxes     counts the enclosures made
std::optional<bool> proved_to_exist(const GuideCase& guide, double smallest, int& boxes) {
    const auto spring = guide.spring<Enclosure>();
    const Enclosure preload = spring.free_length / 2 - spring.radius_at_zero;
    const Enclosure square = preload * preload;
    const auto mechanism = mechanism_in<Enclosure>(guide.input);
    const Enclosure omega(guide.input.angular_speed);
    std::vector<std::pair<double, double>> open;
    constexpr int first = 32;
    open.reserve(first);
    for (int i = 0; i < first; ++i) {
        open.emplace_back(two_pi * i / first, two_pi * (i + 1) / first);
    }
    constexpr int most = 20'000;
    while (!open.empty()) {
        const auto [from, to] = open.back();
        open.pop_back();
        const double middle = 0.5 * (from + to);
        const auto rise = energy_rise_at(mechanism, omega, Enclosure(middle));
        const Enclosure here = rise.rise / (2 * spring.stiffness);
        if (here.lower() > square.upper()) {
            return false;
        }
        // The value at the middle and the slope over the box: of second order in its width.
        const Enclosure slope = energy_rise_at(mechanism, omega, Enclosure(from, to)).slope;
        const Enclosure over_box =
            here + slope / (2 * spring.stiffness) * (Enclosure(from, to) - Enclosure(middle));
        boxes += 2;
        if (over_box.upper() <= square.lower()) {
            continue;
        }
        if (to - from < smallest || boxes > most) {
            return std::nullopt;
        }
        open.emplace_back(from, middle);
        open.emplace_back(middle, to);
    }
    return true;
}

Method<GuideCase> enclosed() {
    Method<GuideCase> method;
    method.info = {
        "intervals",
        CORE_TEXT("methods", "closed form, existence proved by intervals"),
        CORE_TEXT(
            "methods",
            "the only one that proves the guide for the angles between those looked at; where "
            "little preload is to spare, boxes that are too large cannot decide, and it says so"),
        {{{CORE_TEXT("methods", "boxes to %1 rad"), "1e-3"}, 1e-3},
         {{CORE_TEXT("methods", "boxes to %1 rad"), "1e-6"}, 1e-6},
         {{CORE_TEXT("methods", "boxes to %1 rad"), "1e-9"}, 1e-9}},
        false};
    method.prepare = [](const GuideCase& guide, const Setting& setting) -> Run {
        return [&guide, smallest = setting.value](std::span<double> out) -> Message {
            int boxes = 0;
            const auto exists = proved_to_exist(guide, smallest, boxes);
            if (!exists) {
                return CORE_TEXT("methods", "cannot prove that the guide exists");
            }
            if (!*exists) {
                return no_guide();
            }
            const auto spring = guide.spring<double>();
            for (std::size_t i = 0; i < out.size(); ++i) {
                out[i] = guide_radius(spring, Branch::compressed, guide.given_out(guide.angle(i)));
            }
            return {};
        };
    };
    method.operations = [](const GuideCase& guide, const Setting& setting) {
        int boxes = 0;
        proved_to_exist(guide, setting.value, boxes);
        constexpr double wider = 4.0;  // an operation on intervals, in those on numbers
        return rise_operations + 20.0 + boxes * wider * rise_operations / guide.evaluations();
    };
    return method;
}

std::vector<Expected> reference(const GuideCase& guide) {
    const auto spring = guide.spring<Real50>();
    std::vector<Expected> list;
    Real50 least = spring.radius_at_zero;
    Real50 most = spring.radius_at_zero;
    constexpr std::size_t every = 5;  // degrees: the error is as smooth as the guide
    for (std::size_t i = 0; i <= intervals; ++i) {
        if (i % every != 0 && i != guide.hardest) {
            continue;
        }
        // At the double's own angle: the end is 2π's double, and so is every degree.
        const Real50 q = guide.given_out(Real50(guide.angle(i)));
        if (q > spring.preload() * spring.preload()) {
            return {};
        }
        const Real50 radius = guide_radius(spring, Branch::compressed, q);
        least = std::min(least, radius);
        most = std::max(most, radius);
        list.push_back({i, radius, 1.0});
    }
    const double relief = static_cast<double>(Real50(most - least));
    for (Expected& expected : list) {
        expected.scale = relief > 0.0 ? relief : 1.0;
    }
    return list;
}

/// The spring's energy against the energy of the moving bars, their speeds by differences of their
/// positions.
std::optional<double> check(const GuideCase& guide, const std::vector<Expected>& reference) {
    const auto spring = guide.spring<Real50>();
    const Real50 omega(guide.input.angular_speed);
    const Real50 start = energy_of_bars(guide.input, Real50(0), omega);
    const auto stored = [&](const Real50& rho) {
        const Real50 change = spring.free_length - 2 * rho;
        return Real50(spring.stiffness * change * change / 2);
    };
    const Real50 at_start = stored(spring.radius_at_zero);
    Real50 worst(0);
    for (std::size_t k = 0; k < reference.size(); k += 5) {
        const Expected& expected = reference[k];
        const Real50 taken_up =
            energy_of_bars(guide.input, Real50(guide.angle(expected.index)), omega) - start;
        const Real50 gap = abs(Real50(stored(expected.value) + taken_up - at_start));
        worst = std::max(worst, Real50(gap / at_start));
    }
    return static_cast<double>(worst);
}

elastic_hinge::Guide scene_guide(const elastic_hinge::Input& input) {
    elastic_hinge::SolveOptions options;
    options.with_rod_guides = false;
    return elastic_hinge::solve(input, options).crank_guide;
}

/// The paper's mechanism with one of its numbers changed.
template <typename Change>
std::function<GuideCase(double)> paper_with(const Change& change) {
    return [change](double value) {
        GuideCase guide{elastic_hinge::preset_zotov()};
        change(guide.input, value);
        try {
            guide.hardest_angle = scene_guide(guide.input).worst_angle;
            guide.hardest = static_cast<std::size_t>(
                std::lround(guide.hardest_angle / two_pi * static_cast<double>(intervals)));
            if (guide.hardest == intervals || guide.hardest == 0) {
                guide.hardest = 0;  // the start, whose radius is given
                guide.hardest_angle = 0.0;
            }
        } catch (const InputError&) {
            // Refused by every method and by the scene; the whole degrees do.
        }
        return guide;
    };
}

}  // namespace

Kernel guide_kernel() {
    using elastic_hinge::preset_zotov;
    Definition<GuideCase> definition;
    Kernel& kernel = definition.kernel;
    kernel.id = "guide";
    kernel.title = CORE_TEXT("methods", "Guide of the elastic hinge");
    kernel.quantity = CORE_TEXT("methods", "radius ρ(φ) of the crank's guide over one turn");
    kernel.error_measure = CORE_TEXT("methods", "part of the guide's relief");
    kernel.evaluation = CORE_TEXT("methods", "ρ at one crank angle");
    kernel.check_text = CORE_TEXT(
        "methods",
        "energy of the spring against that of the bars, speeds by differences of positions");
    kernel.check_tolerance = 1e-15;
    kernel.choice = elastic_hinge::guide_choice;
    definition.methods = {
        closed_form(
            {"printed-form",
             CORE_TEXT("methods", "closed form as printed"),
             CORE_TEXT("methods",
                       "a difference of nearly equal squares: it loses the digits of a small "
                       "relief or a small preload"),
             {{"(3)", 0}},
             false},
            [](const GuideSpring<double>& spring, double q) {
                return guide_radius_printed(spring, Branch::compressed, q);
            },
            15.0),
        closed_form(
            {"closed-form",
             CORE_TEXT("methods", "closed form"),
             CORE_TEXT("methods",
                       "half of the digits are left where the spring gives out all that it stores; "
                       "beyond there is no guide"),
             {{CORE_TEXT("methods", "free of cancellation"), 0}},
             false},
            [](const GuideSpring<double>& spring, double q) {
                return guide_radius(spring, Branch::compressed, q);
            },
            20.0),
        fixed_step<Slope>({"euler", CORE_TEXT("methods", "Euler's method"),
                           CORE_TEXT("methods", "order 1: the guide does not close after a turn"),
                           counted(CORE_TEXT("methods", "%1 steps"), {360, 3600, 36000}), true},
                          1.0,
                          [](const Slope& slope, double rho, double phi, double h) {
                              return rho + h * slope(rho, phi);
                          }),
        fixed_step<Slope>(
            {"rk4", CORE_TEXT("methods", "Runge-Kutta of order 4"),
             CORE_TEXT("methods",
                       "loses its order where ρ comes near ℓ₀/2: the slope is infinite there"),
             counted(CORE_TEXT("methods", "%1 steps"), {360, 720, 3600}), true},
            4.0, runge_kutta_step<Slope>),
        adaptive({"dormand-prince",
                  CORE_TEXT("methods", "Dormand-Prince with step control"),
                  CORE_TEXT("methods", "its steps shrink to nothing where ρ comes near ℓ₀/2"),
                  {{"1e-6", 1e-6}, {"1e-8", 1e-8}, {"1e-10", 1e-10}, {"1e-12", 1e-12}},
                  false},
                 run_adaptive<Slope>),
        adaptive({"rosenbrock",
                  CORE_TEXT("methods", "Rosenbrock 4, implicit, with step control"),
                  CORE_TEXT("methods", "the same place stops it: what is singular is not stiff"),
                  {{"1e-6", 1e-6}, {"1e-9", 1e-9}, {"1e-12", 1e-12}},
                  false},
                 run_implicit),
        fixed_step<SquareSlope>(
            {"square-rk4", CORE_TEXT("methods", "Runge-Kutta of order 4 for (ℓ₀/2 − ρ)²"),
             CORE_TEXT("methods",
                       "nothing is singular in the square: it is an integral, and the order holds "
                       "everywhere; but its root halves the digits where ρ comes to ℓ₀/2"),
             counted(CORE_TEXT("methods", "%1 steps"), {360, 720, 3600}), true},
            4.0, runge_kutta_step<SquareSlope>),
        adaptive({"square-dormand-prince",
                  CORE_TEXT("methods", "Dormand-Prince for (ℓ₀/2 − ρ)²"),
                  CORE_TEXT("methods",
                            "long steps everywhere, but the same root; and the energy whose slope "
                            "it integrates is known in closed form"),
                  {{"1e-6", 1e-6}, {"1e-8", 1e-8}, {"1e-10", 1e-10}, {"1e-12", 1e-12}},
                  false},
                 run_adaptive<SquareSlope>),
        chebyshev(),
        enclosed(),
    };
    const GuideCase paper{preset_zotov()};
    const double least_preload = scene_guide(paper.input).minimum_preload;
    const double margin = paper.spring<double>().preload() / least_preload - 1.0;
    definition.sweeps = {
        {{"preload", CORE_TEXT("methods", "preload above the least one, part of it"), units::none,
          1e-12, 1e2, Spacing::logarithmic, 0.0, 1e-12, 1e2, margin},
         paper_with([least_preload](elastic_hinge::Input& input, double excess) {
             input.spring->guide_radius_at_zero =
                 input.spring->free_length / 2.0 - least_preload * (1.0 + excess);
         })},
        {{"stiffness", CORE_TEXT("methods", "stiffness c of the spring"), units::N_per_m, 1e4, 1e12,
          Spacing::logarithmic, 0.0, 1e5, 1e10, paper.input.spring->stiffness},
         paper_with([](elastic_hinge::Input& input, double c) { input.spring->stiffness = c; })},
        {{"stiffness-preloaded", CORE_TEXT("methods", "stiffness c, preload 1.1 times the least"),
          units::N_per_m, 1e7, 1e15, Spacing::logarithmic, 0.0, 1e7, 1e15,
          paper.input.spring->stiffness},
         paper_with([paper_least = least_preload](elastic_hinge::Input& input, double c) {
             constexpr double reserve = 1.1;
             elastic_hinge::Spring& spring = *input.spring;
             spring.guide_radius_at_zero =
                 spring.free_length / 2.0 - reserve * paper_least * std::sqrt(spring.stiffness / c);
             spring.stiffness = c;
         })},
        {{"speed", CORE_TEXT("methods", "crank speed ω"), units::rad_per_s, 1.0, 1e4,
          Spacing::logarithmic, 0.0, 1.0, 1e3, paper.input.angular_speed},
         paper_with(
             [](elastic_hinge::Input& input, double speed) { input.angular_speed = speed; })},
        {{"lambda", CORE_TEXT("methods", "crank ratio λ"), units::none, 0.01, 1.0,
          Spacing::towards_end, 1e-6, 0.01, 1.0 - 1e-6, paper.input.lambda},
         paper_with([](elastic_hinge::Input& input, double lambda) { input.lambda = lambda; })},
    };
    definition.reference = reference;
    definition.refusal = [](const GuideCase& guide) -> Message {
        try {
            return scene_guide(guide.input).reason.english();
        } catch (const InputError& error) {
            return error.message();
        }
    };
    definition.check = check;
    return make_kernel(std::move(definition));
}

}  // namespace ravnoves::methods
