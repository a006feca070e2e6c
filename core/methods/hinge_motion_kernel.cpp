#include <cmath>
#include <memory>
#include <stdexcept>

#include "case-file/input_error.h"
#include "elastic-hinge/method_choices.h"
#include "elastic-hinge/motion.h"
#include "elastic-hinge/presets.h"
#include "elastic-hinge/solver.h"
#include "methods/cancellation.h"
#include "methods/definition.h"
#include "methods/hinge_mechanism.h"
#include "numerics/constants.h"

namespace ravnoves::methods {

namespace {

using elastic_hinge::HingeSet;
using elastic_hinge::Motion;
using elastic_hinge::MotionSetup;

/// A motion of the crank with its hinge from a speed that is not the design speed, through a whole
/// number of turns. Outputs: crank angle (rad), speed (rad/s) at the exact time of those turns.
struct MotionCase {
    elastic_hinge::Input input;
    double start_speed = 0.0;  ///< rad/s
    double turns = 5.0;
    double seconds = 0.0;  ///< of the turns
    std::shared_ptr<const elastic_hinge::Result> solved;

    std::size_t outputs() const { return 2; }
    double evaluations() const { return turns; }
};

/// φ̇ at a crank angle, by energy: with the hinge, I φ̇² − ω² I is constant.
template <typename Scalar>
Scalar speed_at(const elastic_hinge::Mechanism<Scalar>& mechanism, const Scalar& omega,
                const Scalar& start_speed, const Scalar& sin_phi, const Scalar& cos_phi) {
    using std::sqrt;
    const auto inertia = inertia_at(mechanism, sin_phi, cos_phi);
    const Scalar at_zero = reduced_inertia_at_zero(mechanism);
    return sqrt(Scalar((at_zero * start_speed * start_speed + omega * omega * inertia.rise) /
                       inertia.value));
}

/// Time of one turn by the trapezoid rule, which converges geometrically here; points are doubled
/// until `tolerance` is reached.
template <typename Scalar>
Scalar time_of_turn(const MotionCase& motion, double tolerance) {
    using std::abs;
    using std::cos;
    using std::sin;
    const auto mechanism = mechanism_in<Scalar>(motion.input);
    const Scalar& turn = boost::math::constants::two_pi<Scalar>();
    Scalar last(0);
    Scalar sum(0);
    constexpr int most = 1 << 14;
    for (int n = 32; n <= most; n *= 2) {
        // Of the doubled points only every second one is new.
        for (int i = n == 32 ? 0 : 1; i < n; i += n == 32 ? 1 : 2) {
            const Scalar phi = turn * i / n;
            sum += 1 / speed_at(mechanism, Scalar(motion.input.angular_speed),
                                Scalar(motion.start_speed), Scalar(sin(phi)), Scalar(cos(phi)));
        }
        Scalar time = sum * turn / n;
        if (abs(Scalar(time - last)) < tolerance * time) {
            return time;
        }
        last = time;
    }
    return last;
}

/// φ̈ with the moment that the guide's spring has at its radius and slope, as simulate() has it.
class Acceleration {
  public:
    explicit Acceleration(const MotionCase& motion)
        : mechanism_(mechanism_in<double>(motion.input)),
          guide_(motion.solved->crank_guide),
          shape_(*guide_.shape),
          design_(*motion.solved->design),
          weight_(potential_amplitude(mechanism_)) {}

    /// −d(V + Π)/dφ, N·m.
    double moment(double phi, double sin_phi, double cos_phi,
                  const elastic_hinge::ReducedInertia<double>& inertia) const {
        const auto rise =
            energy_rise(mechanism_, design_.angular_speed(), sin_phi, cos_phi, inertia);
        const auto point = shape_.at(
            guide_.branch, design_.demand(elastic_hinge::Hinge::crank, phi, {}, rise, 0.0));
        const auto& spring = shape_.spring();
        const double change = spring.free_length - 2.0 * point.radius;
        return 2.0 * spring.stiffness * change * point.slope - weight_ * cos_phi;
    }

    double operator()(double phi, double speed) const {
        const double s = std::sin(phi);
        const double c = std::cos(phi);
        const auto rod = elastic_hinge::rod_angle_exact(mechanism_.lambda, s, c);
        const auto inertia = elastic_hinge::reduced_inertia(mechanism_, s, c, rod);
        return (moment(phi, s, c, inertia) - 0.5 * inertia.slope * speed * speed) / inertia.value;
    }

    /// I, I′ and the moment at once.
    struct Parts {
        double inertia, slope, moment;
    };
    Parts parts(double phi) const {
        const double s = std::sin(phi);
        const double c = std::cos(phi);
        const auto rod = elastic_hinge::rod_angle_exact(mechanism_.lambda, s, c);
        const auto inertia = elastic_hinge::reduced_inertia(mechanism_, s, c, rod);
        return {inertia.value, inertia.slope, moment(phi, s, c, inertia)};
    }
    double inertia(double phi) const {
        return inertia_at(mechanism_, std::sin(phi), std::cos(phi)).value;
    }

  private:
    elastic_hinge::Mechanism<double> mechanism_;
    const elastic_hinge::Guide& guide_;
    const elastic_hinge::GuideShape& shape_;
    const elastic_hinge::Design& design_;
    double weight_;
};

constexpr double slope_operations = 230.0;  // of one acceleration

/// Why there is no motion to compute; empty where there is.
Message why_not(const MotionCase& motion) {
    if (!motion.solved || !motion.solved->crank_guide.feasible) {
        return CORE_TEXT("methods", "there is no guide");
    }
    return motion.seconds > 0.0 && std::isfinite(motion.seconds)
               ? Text{}
               : CORE_TEXT("methods",
                           "at this speed the turns take no time that a number can hold");
}

Method<MotionCase> fixed_step(MethodInfo info, double slopes_per_step,
                              void (*integrate)(const Acceleration&, double h, long steps,
                                                double& phi, double& speed)) {
    Method<MotionCase> method;
    method.info = std::move(info);
    method.info.settings = counted(CORE_TEXT("methods", "%1 steps a turn"), {45, 90, 180, 360});
    method.info.has_order = true;
    method.prepare = [integrate](const MotionCase& motion, const Setting& setting) -> Run {
        return [&motion, integrate, per_turn = setting.value](std::span<double> out) {
            Message refusal = why_not(motion);
            if (refusal.empty()) {
                const auto steps = std::lround(per_turn * motion.turns);
                out[0] = 0.0;
                out[1] = motion.start_speed;
                integrate(Acceleration(motion), motion.seconds / static_cast<double>(steps), steps,
                          out[0], out[1]);
            }
            return refusal;
        };
    };
    method.operations = [slopes_per_step](const MotionCase&, const Setting& setting) {
        return setting.value * slopes_per_step * slope_operations;
    };
    return method;
}

/// Thousands of turns take seconds.
void check_now_and_then(long step) {
    if (step % 1024 == 0) {
        check_cancelled();
    }
}

void runge_kutta_4(const Acceleration& f, double h, long steps, double& phi, double& speed) {
    for (long i = 0; i < steps; ++i) {
        check_now_and_then(i);
        const double a = f(phi, speed);
        const double va = speed + h / 2.0 * a;
        const double b = f(phi + h / 2.0 * speed, va);
        const double vb = speed + h / 2.0 * b;
        const double c = f(phi + h / 2.0 * va, vb);
        const double vc = speed + h * c;
        const double d = f(phi + h * vb, vc);
        phi += h / 6.0 * (speed + 2.0 * va + 2.0 * vb + vc);
        speed += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
    }
}

/// Störmer–Verlet for H = p²/2I(φ) + U(φ): the half steps of p and φ are implicit, the first a
/// quadratic equation, the second a fixed point.
void stoermer_verlet(const Acceleration& f, double h, long steps, double& phi, double& speed) {
    double p = f.inertia(phi) * speed;
    auto here = f.parts(phi);
    for (long i = 0; i < steps; ++i) {
        check_now_and_then(i);
        // p½ = p + h/2 (moment + I′ p½² / 2I²)
        const double a = h / 4.0 * here.slope / (here.inertia * here.inertia);
        const double known = p + h / 2.0 * here.moment;
        const double root = std::sqrt(std::max(1.0 - 4.0 * a * known, 0.0));
        const double half = 2.0 * known / (1.0 + root);
        double next = phi + h * half / here.inertia;
        auto there = f.parts(next);
        for (int pass = 0; pass < 20; ++pass) {
            const double better = phi + h / 2.0 * half * (1.0 / here.inertia + 1.0 / there.inertia);
            const bool done = std::abs(better - next) <= 1e-15 * std::abs(better);
            next = better;
            there = f.parts(next);
            if (done) {
                break;
            }
        }
        p = half +
            h / 2.0 *
                (there.moment + there.slope * half * half / (2.0 * there.inertia * there.inertia));
        phi = next;
        here = there;
    }
    speed = p / here.inertia;
}

Motion simulate(const MotionCase& motion, double tolerance) {
    MotionSetup setup;
    setup.hinges = HingeSet::crank;
    setup.start_speed = motion.start_speed;
    setup.turns = motion.turns + 1.0;
    setup.longest_time = motion.seconds;
    setup.samples_per_turn = 4;
    setup.tolerance = tolerance;
    return elastic_hinge::simulate(motion.solved->design, motion.solved->crank_guide, setup,
                                   [](double) {
                                       check_cancelled();
                                       return true;
                                   });
}

Method<MotionCase> dormand_prince() {
    Method<MotionCase> method;
    method.info = {"dormand-prince",
                   CORE_TEXT("methods", "Dormand-Prince with step control"),
                   CORE_TEXT("methods",
                             "the energy drifts by about the tolerance at every turn: a little "
                             "less than its tolerance promises, but without end"),
                   {{"1e-5", 1e-5}, {"1e-8", 1e-8}, {"1e-11", 1e-11}, {"1e-13", 1e-13}},
                   false};
    method.prepare = [](const MotionCase& motion, const Setting& setting) -> Run {
        return [&motion, tolerance = setting.value](std::span<double> out) {
            Message refusal = why_not(motion);
            if (refusal.empty()) {
                try {
                    const Motion result = simulate(motion, tolerance);
                    refusal = result.reason.english();
                    out[0] = result.crank_angle.back();
                    out[1] = result.speed.back();
                } catch (const std::runtime_error& error) {
                    refusal = error.what();
                }
            }
            return refusal;
        };
    };
    method.operations = [](const MotionCase& motion, const Setting& setting) {
        if (!why_not(motion).empty()) {
            return 0.0;
        }
        constexpr double slopes_per_step = 6.0;
        constexpr double own_operations = 150.0;  // error estimate, dense output, energy
        return static_cast<double>(simulate(motion, setting.value).steps) *
               (slopes_per_step * slope_operations + own_operations + slope_operations) /
               motion.turns;
    };
    return method;
}

std::vector<Expected> reference(const MotionCase& motion) {
    if (!why_not(motion).empty()) {
        return {};
    }
    // After whole turns the speed is the start's; the doubles' time is off the exact one by its
    // rounding.
    const Real50 late =
        Real50(motion.seconds) - Real50(motion.turns) * time_of_turn<Real50>(motion, 1e-24);
    const Real50 angle = Real50(motion.turns) * boost::math::constants::two_pi<Real50>() +
                         late * Real50(motion.start_speed);
    // Per turn, as the error adds up.
    return {{0, angle, motion.turns},
            {1, Real50(motion.start_speed), motion.turns * motion.start_speed}};
}

/// The speed that the energy of the bars and of the spring allows at a dozen angles, and the time
/// of a turn by Simpson's rule over it.
std::optional<double> check(const MotionCase& motion, const std::vector<Expected>&) {
    if (!why_not(motion).empty()) {
        return std::nullopt;
    }
    const auto mechanism = mechanism_in<Real50>(motion.input);
    const Real50 omega(motion.input.angular_speed);
    const Real50 start(motion.start_speed);
    const Real50 one(1);
    Real50 worst(0);
    for (int i = 0; i < 12; ++i) {
        const Real50 phi = boost::math::constants::two_pi<Real50>() * i / 12;
        // T is quadratic in the speed: at speed 1 it is what remains when V is taken off.
        const auto kinetic = [&](const Real50& angle) {
            return Real50(energy_of_bars(motion.input, angle, one) -
                          energy_of_bars(motion.input, angle, Real50(0)));
        };
        // The guide keeps T + V + Π at ω, so at another speed (φ̇² − ω²) T(1) is constant.
        const Real50 constant = (start * start - omega * omega) * kinetic(Real50(0));
        const Real50 speed = sqrt(Real50(omega * omega + constant / kinetic(phi)));
        const Real50 formula =
            speed_at(mechanism, omega, start, Real50(sin(phi)), Real50(cos(phi)));
        worst = std::max(worst, Real50(abs(Real50(speed - formula)) / start));
    }
    return static_cast<double>(worst);
}

/// The paper's mechanism, with a spring stiff enough for its guide, from start_share × ω.
MotionCase make_motion(double lambda, double start_share, double turns) {
    MotionCase motion;
    motion.input = elastic_hinge::preset_zotov();
    motion.input.lambda = lambda;
    motion.start_speed = start_share * motion.input.angular_speed;
    motion.turns = std::round(turns);
    elastic_hinge::SolveOptions options;
    options.with_rod_guides = false;
    try {
        auto result = elastic_hinge::solve(motion.input, options);
        if (!result.crank_guide.feasible && result.crank_guide.minimum_stiffness) {
            constexpr double reserve = 4.0;
            motion.input.spring->stiffness = reserve * *result.crank_guide.minimum_stiffness;
            result = elastic_hinge::solve(motion.input, options);
        }
        motion.solved = std::make_shared<const elastic_hinge::Result>(std::move(result));
        motion.seconds = motion.turns * time_of_turn<double>(motion, 1e-15);
    } catch (const InputError&) {
        motion.solved = nullptr;  // λ = 1: refused by every method
    }
    return motion;
}

}  // namespace

Kernel hinge_motion_kernel() {
    Definition<MotionCase> definition;
    Kernel& kernel = definition.kernel;
    kernel.id = "hinge-motion";
    kernel.title = CORE_TEXT("methods", "Motion with a hinge");
    kernel.quantity =
        CORE_TEXT("methods", "crank angle and speed after whole turns off the design speed");
    kernel.error_measure = CORE_TEXT("methods", "rad, or part of the speed, for each turn made");
    kernel.evaluation = CORE_TEXT("methods", "one turn of motion");
    kernel.check_text = CORE_TEXT(
        "methods", "speeds by the energy of bars and spring, from differences of positions");
    kernel.check_tolerance = 1e-15;
    kernel.choice = elastic_hinge::motion_choice;
    definition.methods = {
        fixed_step({"rk4",
                    CORE_TEXT("methods", "Runge-Kutta of order 4, fixed step"),
                    CORE_TEXT("methods",
                              "its energy drifts steadily: with 90 steps a turn it is wrong after "
                              "thousands of turns, and near λ = 1 at once"),
                    {},
                    true},
                   4.0, runge_kutta_4),
        fixed_step(
            {"stoermer-verlet",
             CORE_TEXT("methods", "Störmer-Verlet, symplectic"),
             CORE_TEXT("methods", "its energy never drifts, but order 2 leaves it behind in time"),
             {},
             true},
            3.0, stoermer_verlet),
        dormand_prince(),
    };
    constexpr double off_design = 0.8;
    constexpr double paper_lambda = 0.3;
    definition.sweeps = {
        {{"lambda", CORE_TEXT("methods", "crank ratio λ, 5 turns"), units::none, 0.05, 1.0,
          Spacing::towards_end, 1e-3, 0.05, 0.95, paper_lambda},
         [=](double lambda) { return make_motion(lambda, off_design, 5.0); }},
        {{"start-speed", CORE_TEXT("methods", "start speed, part of the design speed"), units::none,
          0.05, 20.0, Spacing::logarithmic, 0.0, 0.05, 20.0, off_design},
         [=](double share) { return make_motion(paper_lambda, share, 5.0); }},
        {{"turns", CORE_TEXT("methods", "turns"), units::none, 1.0, 1e4, Spacing::logarithmic, 0.0,
          1.0, 1e3, 5.0},
         [=](double turns) { return make_motion(paper_lambda, off_design, turns); }},
    };
    definition.sweeps.back().info.points = 5;
    definition.reference = reference;
    definition.refusal = [](const MotionCase& motion) -> Message {
        try {
            elastic_hinge::Input input = motion.input;
            input.motion = elastic_hinge::MotionWish{};
            input.motion->turns = motion.turns;
            input.motion->start_speed = motion.start_speed;
            return elastic_hinge::solve(input).crank_guide.reason.english();
        } catch (const InputError& error) {
            return error.message();
        }
    };
    definition.check = check;
    return make_kernel(std::move(definition));
}

}  // namespace ravnoves::methods
