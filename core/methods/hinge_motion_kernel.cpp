#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
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
/// number of turns. Outputs: crank angle (rad) and speed (rad/s) at `parts` equally spaced times of
/// the last turn; the last of them is its end. Errors that are undone by the end of a turn are seen
/// so as well.
struct MotionCase {
    static constexpr int parts = 9;  ///< divides the steps of the methods with fixed steps

    elastic_hinge::Input input;
    double start_speed = 0.0;  ///< rad/s
    double turns = 5.0;
    double seconds = 0.0;  ///< of the turns
    std::shared_ptr<const elastic_hinge::Result> solved;

    std::size_t outputs() const { return 2 * static_cast<std::size_t>(parts); }
    double evaluations() const { return turns; }
    /// Of the outputs 2 (part − 1) and 2 (part − 1) + 1; part = 1…parts.
    double time(int part) const {
        return seconds * ((turns - 1.0 + static_cast<double>(part) / parts) / turns);
    }
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
                const Acceleration acceleration(motion);
                const double h = motion.seconds / (per_turn * motion.turns);
                double phi = 0.0;
                double speed = motion.start_speed;
                integrate(acceleration, h, std::lround(per_turn * (motion.turns - 1.0)), phi,
                          speed);
                for (std::size_t i = 0; i < out.size(); i += 2) {
                    integrate(acceleration, h, std::lround(per_turn / MotionCase::parts), phi,
                              speed);
                    out[i] = phi;
                    out[i + 1] = speed;
                }
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
                    // As the scene reads it between its samples.
                    for (int part = 1; part <= MotionCase::parts; ++part) {
                        const auto i = 2 * static_cast<std::size_t>(part - 1);
                        out[i] = result.angle_at(motion.time(part));
                        out[i + 1] = result.speed_at(motion.time(part));
                    }
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
        constexpr double sample_operations = slope_operations + 40.0;
        const Motion result = simulate(motion, setting.value);
        return (static_cast<double>(result.steps) *
                    (slopes_per_step * slope_operations + own_operations) +
                static_cast<double>(result.time.size()) * sample_operations) /
               motion.turns;
    };
    return method;
}

/// Time from one crank angle to another, s: Gauss-Legendre in parts that are halved until two rules
/// agree.
Real50 time_between(const MotionCase& motion, const elastic_hinge::Mechanism<Real50>& mechanism,
                    const Real50& from, const Real50& to) {
    const Real50 omega(motion.input.angular_speed);
    const Real50 start(motion.start_speed);
    const auto slowness = [&](const Real50& phi) {
        return Real50(1 / speed_at(mechanism, omega, start, Real50(sin(phi)), Real50(cos(phi))));
    };
    namespace quadrature = boost::math::quadrature;
    const Real50 fine = quadrature::gauss<Real50, 30>::integrate(slowness, from, to);
    const Real50 coarse = quadrature::gauss<Real50, 20>::integrate(slowness, from, to);
    const Real50 enough = Real50("1e-32") / abs(start);
    if (!(abs(Real50(fine - coarse)) > enough) || abs(Real50(to - from)) < Real50("1e-4")) {
        return fine;
    }
    const Real50 middle = (from + to) / 2;
    return time_between(motion, mechanism, from, middle) +
           time_between(motion, mechanism, middle, to);
}

std::vector<Expected> reference(const MotionCase& motion) {
    if (!why_not(motion).empty()) {
        return {};
    }
    const auto mechanism = mechanism_in<Real50>(motion.input);
    const Real50 omega(motion.input.angular_speed);
    const Real50 start(motion.start_speed);
    const Real50& turn = boost::math::constants::two_pi<Real50>();
    const Real50 turn_time = time_of_turn<Real50>(motion, 1e-32);
    std::vector<Expected> list;
    Real50 angle(0);  // within the last turn
    Real50 time(0);   // there
    for (int part = 1; part <= MotionCase::parts; ++part) {
        const Real50 wanted = Real50(motion.time(part)) - Real50(motion.turns - 1.0) * turn_time;
        Real50 speed = start;
        // Newton's method between bounds; the first step is a guess.
        Real50 early = angle;
        Real50 late = turn * Real50("1.001");
        Real50 step = turn * part / MotionCase::parts - angle;
        constexpr int most = 100;
        for (int i = 0; i < most; ++i) {
            time += time_between(motion, mechanism, angle, angle + step);
            angle += step;
            (time < wanted ? early : late) = angle;
            speed = speed_at(mechanism, omega, start, Real50(sin(angle)), Real50(cos(angle)));
            step = (wanted - time) * speed;
            if (abs(step) < Real50("1e-30")) {
                break;
            }
            if (!(angle + step > early && angle + step < late)) {
                step = (early + late) / 2 - angle;
            }
        }
        // Per turn, as the error adds up.
        const auto at = 2 * static_cast<std::size_t>(part - 1);
        list.push_back({at, Real50(motion.turns - 1.0) * turn + angle, motion.turns});
        list.push_back({at + 1, speed, motion.turns * static_cast<double>(speed)});
    }
    return list;
}

/// The speeds that the energy of the bars and of the spring allows, and by them the time that the
/// crank takes to the angles of the reference and for a whole turn.
std::optional<double> check(const MotionCase& motion, const std::vector<Expected>& reference) {
    if (!why_not(motion).empty()) {
        return std::nullopt;
    }
    const Real50 omega(motion.input.angular_speed);
    const Real50 start(motion.start_speed);
    // T is quadratic in the speed: at speed 1 it is what remains when V is taken off.
    const auto kinetic = [&](const Real50& angle) {
        return Real50(energy_of_bars(motion.input, angle, Real50(1)) -
                      energy_of_bars(motion.input, angle, Real50(0)));
    };
    // The guide keeps T + V + Π at ω, so at another speed (φ̇² − ω²) T(1) is constant.
    const Real50 constant = (start * start - omega * omega) * kinetic(Real50(0));
    const auto speed = [&](const Real50& phi) {
        return Real50(sqrt(Real50(omega * omega + constant / kinetic(phi))));
    };
    boost::math::quadrature::tanh_sinh<Real50> quadrature;
    const auto time_to = [&](const Real50& from, const Real50& to) {
        return quadrature.integrate([&](const Real50& phi) { return Real50(1 / speed(phi)); }, from,
                                    to, Real50("1e-24"));
    };
    const Real50& turn = boost::math::constants::two_pi<Real50>();
    const Real50 whole = time_to(Real50(0), turn / 2) + time_to(turn / 2, turn);
    const Real50 promised = time_of_turn<Real50>(motion, 1e-32);
    Real50 worst = abs(Real50(whole / promised - 1));
    Real50 angle(0);
    Real50 time(0);
    for (const Expected& expected : reference) {
        const int part = static_cast<int>(expected.index / 2) + 1;
        if (expected.index % 2 == 0) {
            const Real50 next = expected.value - Real50(motion.turns - 1.0) * turn;
            time += time_to(angle, next);
            angle = next;
            const Real50 wanted = Real50(motion.time(part)) - Real50(motion.turns - 1.0) * promised;
            worst = std::max(worst, Real50(abs(Real50(time - wanted)) / promised));
        } else {
            worst = std::max(worst, Real50(abs(Real50(speed(angle) / expected.value - 1))));
        }
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
    kernel.quantity = CORE_TEXT(
        "methods", "crank angle and speed at nine times of the last turn, off the design speed");
    kernel.error_measure = CORE_TEXT("methods", "rad, or part of the speed, for each turn made");
    kernel.evaluation = CORE_TEXT("methods", "one turn of motion");
    kernel.check_text = CORE_TEXT("methods",
                                  "speeds by the energy of bars and spring, from differences of "
                                  "positions, and the times that follow from them");
    kernel.check_tolerance = 1e-20;
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
