#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <functional>
#include <memory>
#include <stdexcept>

#include "case-file/input_error.h"
#include "elastic-hinge/motion.h"
#include "elastic-hinge/presets.h"
#include "elastic-hinge/result.h"
#include "methods/definition.h"
#include "methods/reference_mechanism.h"
#include "numerics/constants.h"

namespace ravnoves::methods {

namespace {

using elastic_hinge::HingeSet;
using elastic_hinge::Motion;

/// A motion of the crank with its hinge from a speed that is not the design speed, through a whole
/// number of turns. Outputs: crank angle (rad) and speed (rad/s) at `parts` equally spaced times of
/// the last turn; the last of them is its end. Errors that are undone by the end of a turn are seen
/// so as well.
struct MotionCase {
    static constexpr int parts = 9;  ///< divides the steps of the methods with fixed steps

    elastic_hinge::Input input;
    double start_speed = 0.0;   ///< rad/s
    double crank_torque = 0.0;  ///< constant, N·m
    double turns = 5.0;
    double seconds = 0.0;  ///< of the turns
    Real50 before;         ///< of all of them but the last, s
    std::shared_ptr<const elastic_hinge::Result> solved;

    double seconds_of_turn() const { return seconds / turns; }  ///< on an average
    /// Of the outputs 2 (part − 1) and 2 (part − 1) + 1; part = 1…parts.
    double time(int part) const {
        const auto start = static_cast<double>(before);
        return part == parts ? seconds : start + (seconds - start) * part / parts;
    }
};

/// φ̇ at a crank angle: the guide keeps T + V + Π at the design speed ω, so at another speed
/// (φ̇² − ω²) I is constant but for the work on the crank.
class ReferenceSpeed {
  public:
    explicit ReferenceSpeed(const MotionCase& motion)
        : bars_(motion.input),
          square_(Real50(motion.input.angular_speed) * Real50(motion.input.angular_speed)),
          constant_((Real50(motion.start_speed) * Real50(motion.start_speed) - square_) *
                    bars_.inertia(Real50(0))),
          twice_torque_(2 * Real50(motion.crank_torque)) {}

    Real50 operator()(const Real50& phi) const {
        return sqrt(Real50(square_ + (constant_ + twice_torque_ * phi) / bars_.inertia(phi)));
    }

  private:
    ReferenceBars bars_;
    Real50 square_, constant_, twice_torque_;
};

/// Time from one crank angle to another, s: Gauss-Legendre in parts that are halved until two rules
/// agree.
Real50 time_between(const ReferenceSpeed& speed, const Real50& from, const Real50& to) {
    const auto slowness = [&](const Real50& phi) { return Real50(1 / speed(phi)); };
    namespace quadrature = boost::math::quadrature;
    const Real50 fine = quadrature::gauss<Real50, 30>::integrate(slowness, from, to);
    const Real50 coarse = quadrature::gauss<Real50, 20>::integrate(slowness, from, to);
    const Real50 enough = Real50("1e-20") * abs(Real50(to - from)) / speed(to);
    if (!(abs(Real50(fine - coarse)) > enough) || abs(Real50(to - from)) < Real50("1e-4")) {
        return fine;
    }
    const Real50 middle = (from + to) / 2;
    return time_between(speed, from, middle) + time_between(speed, middle, to);
}

/// Time of the first turns; without a moment on the crank they are alike.
Real50 time_of_turns(const MotionCase& motion, double turns) {
    const ReferenceSpeed speed(motion);
    const Real50& whole = boost::math::constants::two_pi<Real50>();
    if (motion.crank_torque == 0.0) {
        return Real50(turns) * time_between(speed, Real50(0), whole);
    }
    Real50 sum(0);
    for (int k = 0; k < static_cast<int>(turns); ++k) {
        sum += time_between(speed, whole * k, whole * (k + 1));
    }
    return sum;
}

/// φ̈ with the moment that the guide's spring has at its radius and slope, as simulate() has it.
class Acceleration {
  public:
    explicit Acceleration(const MotionCase& motion)
        : mechanism_(mechanism_of(motion.input)),
          guide_(motion.solved->crank_guide),
          shape_(*guide_.shape),
          design_(*motion.solved->design),
          weight_(potential_amplitude(mechanism_)),
          torque_(motion.crank_torque) {}

    /// As a system of Odeint's.
    void operator()(const std::array<double, 2>& at, std::array<double, 2>& rate, double) const {
        const auto [phi, speed] = at;
        const double s = std::sin(phi);
        const double c = std::cos(phi);
        const auto inertia = elastic_hinge::reduced_inertia(
            mechanism_, s, c, elastic_hinge::rod_angle_exact(mechanism_.lambda, s, c));
        const auto rise = energy_rise(mechanism_, design_.angular_speed(), s, c, inertia);
        const auto point = shape_.at(guide_.branch, {phi, 1.0, rise.rise, rise.slope, rise.second});
        const auto& spring = shape_.spring();
        const double change = spring.free_length - 2.0 * point.radius;
        const double moment = torque_ + 2.0 * spring.stiffness * change * point.slope - weight_ * c;
        rate = {speed, (moment - 0.5 * inertia.slope * speed * speed) / inertia.value};
    }

  private:
    elastic_hinge::Mechanism<double> mechanism_;
    const elastic_hinge::Guide& guide_;
    const elastic_hinge::GuideShape& shape_;
    const elastic_hinge::Design& design_;
    double weight_;
    double torque_;
};

/// Why there is no motion to compute; empty where there is.
Message why_not(const MotionCase& motion) {
    if (!motion.solved || !motion.solved->crank_guide.feasible) {
        return Text::tr("there is no guide");
    }
    const double square = motion.start_speed * motion.start_speed;
    return std::isnormal(square) && motion.seconds > 0.0 && std::isfinite(motion.seconds)
               ? Text{}
               : Text::tr("at this speed the time of a turn is below the range of numbers");
}

namespace odeint = boost::numeric::odeint;

using TurnState = std::array<double, 2>;  ///< angle, rad, and speed, rad/s

void put(const TurnState& state, int part, std::span<double> out) {
    std::copy(state.begin(), state.end(), out.begin() + 2 * (part - 1));
}

/// Brings a state through a time.
/// @return why it cannot, or nothing
using Advance = std::function<Message(double seconds, TurnState& state)>;
using Integrator = Advance (*)(const MotionCase&, const Acceleration&, double setting);

Method<MotionCase> integrated(MethodInfo info, Integrator integrator) {
    return {std::move(info), [integrator](const MotionCase& motion, double setting) -> Run {
                return [&motion, integrator, setting](std::span<double> out) {
                    Message rejection = why_not(motion);
                    if (!rejection.empty()) {
                        return rejection;
                    }
                    const Acceleration acceleration(motion);
                    const Advance advance = integrator(motion, acceleration, setting);
                    TurnState state{0.0, motion.start_speed};
                    double before = 0.0;
                    for (int part = 1; part <= MotionCase::parts && rejection.empty(); ++part) {
                        rejection = advance(motion.time(part) - before, state);
                        put(state, part, out);
                        before = motion.time(part);
                    }
                    return rejection;
                };
            }};
}

/// Equal steps, so many a turn, from one wanted time to the next.
Advance runge_kutta_4(const MotionCase& motion, const Acceleration& f, double per_turn) {
    const double longest = motion.seconds_of_turn() / per_turn;
    return [&f, longest, stepper = odeint::runge_kutta4<TurnState>()](double seconds,
                                                                      TurnState& x) mutable {
        constexpr double rounding = 1e-9;
        const auto steps = std::max(1L, std::lround(std::ceil(seconds / longest - rounding)));
        const double h = seconds / static_cast<double>(steps);
        for (long i = 0; i < steps; ++i) {
            stepper.do_step(std::cref(f), x, 0.0, h);  // whatever the time
        }
        return Message();
    };
}

Advance dormand_prince(const MotionCase& motion, const Acceleration& f, double tolerance) {
    // The absolute tolerance is that of an angle and of a speed at once: relative to the speed.
    constexpr double absolute = 1e-2;
    auto stepper =
        odeint::make_dense_output(tolerance * absolute * std::max(1.0, motion.start_speed),
                                  tolerance, odeint::runge_kutta_dopri5<TurnState>());
    stepper.initialize(TurnState{0.0, motion.start_speed}, 0.0, 1e-3 / motion.start_speed);
    const auto max_steps = static_cast<long>(1e5 * motion.turns);
    const Message lost = Text::tr("its steps shrink to 0");
    return
        [&f, stepper, lost, max_steps, end = 0.0](double seconds, TurnState& x) mutable -> Message {
            end += seconds;
            for (long i = 0; stepper.current_time() < end; ++i) {
                try {
                    stepper.do_step(std::cref(f));
                } catch (const odeint::step_adjustment_error&) {
                    return lost;
                }
                if (i == max_steps || !std::isfinite(stepper.current_state()[0])) {
                    return lost;
                }
            }
            stepper.calc_state(end, x);
            return {};
        };
}

/// As the scene computes it.
Motion simulate(const MotionCase& motion, double tolerance) {
    elastic_hinge::Input input = motion.input;
    const double turns = motion.turns + 0.01;  // a little beyond the last time
    input.motion = elastic_hinge::MotionWish{
        .turns = turns, .start_speed = motion.start_speed, .crank_torque = motion.crank_torque};
    return elastic_hinge::simulate(input, *motion.solved, HingeSet::crank, {}, tolerance);
}

Run energy_series(const MotionCase& motion, double tolerance) {
    return [&motion, tolerance](std::span<double> out) {
        Message rejection = why_not(motion);
        if (!rejection.empty()) {
            return rejection;
        }
        try {
            const Motion result = simulate(motion, tolerance);
            rejection = result.reason;
            // As the scene reads it between its samples.
            for (int part = 1; part <= MotionCase::parts; ++part) {
                const double time = motion.time(part);
                put({result.angle_at(time), result.speed_at(time)}, part, out);
            }
        } catch (const std::runtime_error& error) {
            rejection = error.what();
        }
        return rejection;
    };
}

std::vector<Expected> reference(const MotionCase& motion) {
    if (!why_not(motion).empty()) {
        return {};
    }
    const ReferenceSpeed speed_at(motion);
    const Real50& turn = boost::math::constants::two_pi<Real50>();
    const Real50 first = Real50(motion.turns - 1.0) * turn;  // of the last turn
    std::vector<Expected> list;
    Real50 angle = first;
    Real50 time = motion.before;
    for (int part = 1; part <= MotionCase::parts; ++part) {
        const Real50 wanted(motion.time(part));
        Real50 speed;
        // Newton's method between bounds; the first step is a guess.
        Real50 early = angle;
        Real50 late = first + turn * Real50("1.001");
        Real50 step = first + turn * part / MotionCase::parts - angle;
        constexpr int maximum = 100;
        for (int i = 0; i < maximum; ++i) {
            time += time_between(speed_at, angle, angle + step);
            angle += step;
            (time < wanted ? early : late) = angle;
            speed = speed_at(angle);
            step = (wanted - time) * speed;
            if (abs(step) < Real50("1e-22")) {
                break;
            }
            if (!(angle + step > early && angle + step < late)) {
                step = (early + late) / 2 - angle;
            }
        }
        // Per turn, as the error adds up.
        const auto at = 2 * static_cast<std::size_t>(part - 1);
        list.push_back({at, angle, motion.turns});
        list.push_back({at + 1, speed, motion.turns * static_cast<double>(speed)});
    }
    return list;
}

/// The paper's mechanism, with a spring stiff enough for its guide, from start_share × ω.
MotionCase make_motion(double lambda, double start_share, double turns, double torque = 0.0) {
    MotionCase motion;
    motion.crank_torque = torque;
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
        motion.before = time_of_turns(motion, motion.turns - 1.0);
        motion.seconds = static_cast<double>(time_of_turns(motion, motion.turns));
    } catch (const InputError&) {
        motion.solved = nullptr;  // λ = 1: rejected by every method
    }
    return motion;
}

}  // namespace

Kernel hinge_motion_kernel() {
    const std::vector<Setting> tolerances{
        {"1e-5", 1e-5}, {"1e-8", 1e-8}, {"1e-11", 1e-11}, {"1e-13", 1e-13}};
    Definition<MotionCase> definition;
    definition.outputs = 2 * std::size_t{MotionCase::parts};
    definition.evaluations = [](const MotionCase& motion) { return motion.turns; };
    Kernel& kernel = definition.kernel;
    kernel.id = "hinge-motion";
    kernel.title = Text::tr("Motion with a hinge");
    kernel.quantity =
        Text::tr("crank angle and speed at nine times of the last turn, off the design speed");
    kernel.error_measure = Text::tr("rad, or share of the speed, per turn");
    kernel.evaluation = Text::tr("one turn of motion");
    kernel.reference =
        Text::tr("speeds by the energy of the three bodies, times by Gauss-Legendre sums");
    kernel.choice = {
        "elastic-hinge", "energy-series", "1e-8", 1e-7,
        Text::tr(
            "Ripple is read to parts of a million after up to a thousand turns: an error of 1e-7 "
            "a turn. The energy gives the speed at every angle; only the time is integrated, "
            "without drift. Adaptive steps find the steep places of a turn, also with a moment "
            "on the crank, from rest and up to a reversal.")};
    definition.methods = {
        integrated({"rk4", Text::tr("Runge-Kutta of order 4, fixed step"),
                    Text::tr("its energy drifts: with 90 steps a turn it is wrong after thousands "
                             "of turns, near λ = 1 at once"),
                    counted(Text::tr("%1 steps a turn"), {45, 90, 180, 360}), true},
                   runge_kutta_4),
        integrated(
            {"dormand-prince", Text::tr("Dormand-Prince with step control"),
             Text::tr("the energy drifts by about the tolerance at every turn, without limit"),
             tolerances},
            dormand_prince),
        {{"energy-series",
          Text::tr("energy, time by Gauss sums"),
          Text::tr("slower near a standstill; where the crank barely passes a dead point, "
                   "rounding decides"),
          {{"1e-5", 1e-5}, {"1e-8", 1e-8}}},
         energy_series},
    };
    constexpr double off_design = 0.8;
    constexpr double paper_lambda = 0.3;
    definition.sweeps = {
        {{"locking", Text::tr("distance from locking, 1 − λ"), units::none, 1e-3, 0.95,
          Spacing::logarithmic, 0.05, 0.95, 1.0 - paper_lambda},
         [=](double gap) { return make_motion(1.0 - gap, off_design, 5.0); }},
        {{"start-speed", Text::tr("start speed, part of the design speed"), units::none, 0.05, 20.0,
          Spacing::logarithmic, 0.05, 20.0, off_design},
         [=](double share) { return make_motion(paper_lambda, share, 5.0); }},
        {{"turns", Text::tr("turns"), units::none, 1.0, 300.0, Spacing::logarithmic, 1.0, 300.0,
          5.0, 5},
         [=](double turns) { return make_motion(paper_lambda, off_design, turns); }},
        {{"crank-torque", Text::tr("moment on the crank, 5 turns"), units::N_m, 1e-3, 1e2,
          Spacing::logarithmic, 1e-3, 1e2, 0.5, 9},
         [=](double torque) { return make_motion(paper_lambda, off_design, 5.0, torque); }},
    };
    definition.reference = reference;
    return make_kernel(std::move(definition));
}

}  // namespace ravnoves::methods
