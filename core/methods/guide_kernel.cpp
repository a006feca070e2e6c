#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>

#include "case-file/input_error.h"
#include "elastic-hinge/guide.h"
#include "elastic-hinge/kinematics.h"
#include "elastic-hinge/presets.h"
#include "elastic-hinge/result.h"
#include "methods/definition.h"
#include "methods/reference_mechanism.h"
#include "numerics/constants.h"

namespace ravnoves::methods {

namespace {

using elastic_hinge::Branch;
using elastic_hinge::Spring;

constexpr std::size_t intervals = 360;

/// Radius of the crank's guide every degree of one turn.
struct GuideCase {
    elastic_hinge::Input input;
    std::size_t hardest = 0;
    double hardest_angle = 0.0;  ///< rad

    /// Whole degrees, but for the one next to the angle where most energy has been given out:
    /// there the guide is hardest to compute, so that angle itself takes its place.
    double angle(std::size_t i) const {
        return i == hardest ? hardest_angle
                            : two_pi * static_cast<double>(i) / static_cast<double>(intervals);
    }

    const Spring& spring() const { return *input.spring; }
    elastic_hinge::EnergyRise<double> rise(double phi) const {
        const elastic_hinge::Mechanism<double> mechanism = mechanism_of(input);
        const double s = std::sin(phi);
        const double c = std::cos(phi);
        return elastic_hinge::energy_rise(
            mechanism, input.angular_speed, s, c,
            elastic_hinge::reduced_inertia(mechanism, s, c,
                                           elastic_hinge::rod_angle_exact(mechanism.lambda, s, c)));
    }
};

Message no_guide() {
    return Text::tr("the spring stores too little energy");
}

Message singular() {
    return Text::tr("runs into the spring's free length, where the equation is singular");
}

template <typename Radius>
Method<GuideCase> closed_form(MethodInfo info, const Radius& radius) {
    return {std::move(info), [radius](const GuideCase& guide, double) -> Run {
                return [&guide, radius](std::span<double> out) {
                    const auto spring = guide.spring();
                    const double square = spring.preload() * spring.preload();
                    for (std::size_t i = 0; i < out.size(); ++i) {
                        const double q = guide.rise(guide.angle(i)).rise / (2.0 * spring.stiffness);
                        if (!(q <= square)) {
                            return no_guide();
                        }
                        out[i] = radius(spring, q);
                    }
                    return Message();
                };
            }};
}

/// (2) as an equation for ρ: dρ/dφ, not finite where the spring is unloaded.
struct Slope {
    explicit Slope(const GuideCase& of) : guide(of), spring(of.spring()) {}
    const GuideCase& guide;
    Spring spring;

    double start() const { return spring.start_radius(Branch::compressed); }
    double operator()(double rho, double phi) const {
        return guide.rise(phi).slope / (2.0 * spring.stiffness * (spring.free_length - 2.0 * rho));
    }
    /// False where the spring is unloaded, or at a number that is none.
    bool holds(double rho) const { return rho < spring.free_length / 2.0; }
};

/// Steps of a fixed size through the whole turn.
Run runge_kutta(const GuideCase& guide, double steps) {
    return [&guide,
            parts = static_cast<int>(steps) / static_cast<int>(intervals)](std::span<double> out) {
        const Slope slope(guide);
        const auto system = [&](double rho, double& rate, double phi) { rate = slope(rho, phi); };
        boost::numeric::odeint::runge_kutta4<double> stepper;
        out[0] = slope.start();
        for (std::size_t i = 0; i < intervals; ++i) {
            const double h = (guide.angle(i + 1) - guide.angle(i)) / parts;
            double rho = out[i];
            for (int part = 0; part < parts; ++part) {
                stepper.do_step(system, rho, guide.angle(i) + h * part, h);
            }
            out[i + 1] = rho;
            if (!slope.holds(rho)) {
                return singular();
            }
        }
        return Message();
    };
}

/// With step control by Odeint, read off every degree.
Run dormand_prince(const GuideCase& guide, double tolerance) {
    return [&guide, tolerance](std::span<double> out) -> Message {
        namespace odeint = boost::numeric::odeint;
        using State = std::array<double, 1>;
        const Slope slope(guide);
        const auto system = [&](const State& x, State& dx, double phi) {
            dx[0] = slope(x[0], phi);
        };
        auto stepper = odeint::make_dense_output(tolerance * slope.spring.preload(), tolerance,
                                                 odeint::runge_kutta_dopri5<State>());
        State x{slope.start()};
        out[0] = x[0];
        stepper.initialize(x, 0.0, two_pi / intervals);
        constexpr int max_steps = 100'000;
        constexpr double no_step = 1e-15;
        int steps = 0;
        for (std::size_t i = 1; i <= intervals; ++i) {
            while (stepper.current_time() < guide.angle(i)) {
                try {
                    stepper.do_step(system);
                } catch (const odeint::step_adjustment_error&) {
                    return singular();
                }
                if (++steps > max_steps || !(stepper.current_time_step() > no_step) ||
                    !std::isfinite(stepper.current_state()[0])) {
                    return singular();
                }
            }
            stepper.calc_state(guide.angle(i), x);
            out[i] = x[0];
            if (!slope.holds(x[0])) {
                return singular();
            }
        }
        return {};
    };
}

/// The radius at which the spring's energy, ½ c (ℓ₀ − 2ρ)², is what it had less what the bars have
/// taken up.
std::vector<Expected> reference(const GuideCase& guide) {
    const ReferenceBars bars(guide.input);
    const elastic_hinge::Spring& spring = *guide.input.spring;
    const Real50 half_length = Real50(spring.free_length) / 2;
    const Real50 preload = abs(Real50(half_length - Real50(spring.guide_radius_at_zero)));
    const Real50 omega(guide.input.angular_speed);
    const auto energy = [&](const Real50& phi) {
        return Real50(bars.inertia(phi) * omega * omega / 2 + bars.potential(phi));
    };
    const Real50 start = energy(Real50(0));
    std::vector<Expected> list;
    Real50 minimum = half_length;
    Real50 maximum = -half_length;
    constexpr std::size_t every = 5;  // degrees: the error is as smooth as the guide
    for (std::size_t i = 0; i <= intervals; ++i) {
        if (i % every != 0 && i != guide.hardest) {
            continue;
        }
        // At the double's own angle: the end is 2π's double, and so is every degree.
        const Real50 taken_up = energy(Real50(guide.angle(i))) - start;
        const Real50 square = preload * preload - taken_up / (2 * Real50(spring.stiffness));
        if (square < 0) {
            return {};
        }
        const Real50 radius = half_length - sqrt(square);
        minimum = std::min(minimum, radius);
        maximum = std::max(maximum, radius);
        list.push_back({i, radius, 1.0});
    }
    const double relief = static_cast<double>(Real50(maximum - minimum));
    for (Expected& expected : list) {
        expected.scale = relief > 0.0 ? relief : 1.0;
    }
    return list;
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
            // Rejected by every method and by the scene; the whole degrees do.
        }
        return guide;
    };
}

}  // namespace

Kernel guide_kernel() {
    using elastic_hinge::preset_zotov;
    Definition<GuideCase> definition;
    definition.outputs = intervals + 1;
    definition.evaluations = [](const GuideCase&) { return intervals + 1.0; };
    Kernel& kernel = definition.kernel;
    kernel.id = "guide";
    kernel.title = Text::tr("Guide of the elastic hinge");
    kernel.quantity = Text::tr("radius ρ(φ) of the crank's guide over one turn");
    kernel.error_measure = Text::tr("part of the guide's relief");
    kernel.evaluation = Text::tr("ρ at one crank angle");
    kernel.reference =
        Text::tr("residual energy of the spring, from the energy of the three bodies");
    kernel.choice = {
        "elastic-hinge", "closed-form", "free of cancellation", 1e-7,
        Text::tr(
            "A guide acts by its relief, which may be a few micrometres on a radius of a hundred "
            "millimetres: seven digits of the relief. The closed form needs no step and no "
            "start. Without a difference of nearly equal squares it stays accurate until the "
            "spring releases all its energy.")};
    definition.methods = {
        closed_form(
            {"printed-form",
             Text::tr("closed form as printed"),
             Text::tr("a difference of nearly equal squares: it loses the digits of a small "
                      "relief or a small preload"),
             {{"(3)", 0}}},
            [](const Spring& spring, double q) {
                // ρ = ℓ₀/2 − √(ℓ₀²/4 − B), B = ℓ₀ρ₀ − ρ₀² + q
                const double l = spring.free_length;
                const double rho = spring.guide_radius_at_zero;
                return l / 2.0 - std::sqrt(l * l / 4.0 - (l * rho - rho * rho + q));
            }),
        closed_form({"closed-form",
                     Text::tr("closed form"),
                     Text::tr("half of the digits remain where the spring releases all its "
                              "energy; beyond that no guide exists"),
                     {{Text::tr("free of cancellation"), 0}}},
                    [](const Spring& spring, double q) {
                        return guide_radius(spring, Branch::compressed, q);
                    }),
        {{"rk4", Text::tr("Runge-Kutta of order 4"),
          Text::tr("loses its order where ρ approaches ℓ₀/2: the slope is infinite there"),
          counted(Text::tr("%1 steps"), {360, 720, 3600}), true},
         runge_kutta},
        {{"dormand-prince",
          Text::tr("Dormand-Prince with step control"),
          Text::tr("its steps shrink to 0 where ρ approaches ℓ₀/2"),
          {{"1e-6", 1e-6}, {"1e-8", 1e-8}, {"1e-10", 1e-10}, {"1e-12", 1e-12}}},
         dormand_prince},
    };
    const GuideCase paper{preset_zotov()};
    const double min_preload = scene_guide(paper.input).minimum_preload;
    const double margin = paper.spring().preload() / min_preload - 1.0;
    definition.sweeps = {
        {{"preload", Text::tr("preload above the minimum, relative"), units::none, 1e-12, 1e2,
          Spacing::logarithmic, 1e-12, 1e2, margin},
         paper_with([min_preload](elastic_hinge::Input& input, double excess) {
             input.spring->guide_radius_at_zero =
                 input.spring->free_length / 2.0 - min_preload * (1.0 + excess);
         })},
        {{"stiffness", Text::tr("stiffness c of the spring"), units::N_per_m, 1e4, 1e12,
          Spacing::logarithmic, 1e5, 1e10, paper.input.spring->stiffness},
         paper_with([](elastic_hinge::Input& input, double c) { input.spring->stiffness = c; })},
        {{"stiffness-preloaded", Text::tr("stiffness c, preload 1.1 times the minimum"),
          units::N_per_m, 1e7, 1e15, Spacing::logarithmic, 1e7, 1e15,
          paper.input.spring->stiffness},
         paper_with([paper_min = min_preload](elastic_hinge::Input& input, double c) {
             constexpr double reserve = 1.1;
             elastic_hinge::Spring& spring = *input.spring;
             spring.guide_radius_at_zero =
                 spring.free_length / 2.0 - reserve * paper_min * std::sqrt(spring.stiffness / c);
             spring.stiffness = c;
         })},
        {{"speed", Text::tr("crank speed ω"), units::rad_per_s, 1.0, 1e4, Spacing::logarithmic, 1.0,
          1e3, paper.input.angular_speed},
         paper_with(
             [](elastic_hinge::Input& input, double speed) { input.angular_speed = speed; })},
        {{"locking", Text::tr("distance from locking, 1 − λ"), units::none, 1e-6, 0.99,
          Spacing::logarithmic, 1e-6, 0.99, 1.0 - paper.input.lambda},
         paper_with([](elastic_hinge::Input& input, double gap) { input.lambda = 1.0 - gap; })},
    };
    definition.reference = reference;
    return make_kernel(std::move(definition));
}

}  // namespace ravnoves::methods
