#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <functional>
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
#include "numerics/harmonics.h"
#include "numerics/runge_kutta.h"

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
    double start_speed = 0.0;   ///< rad/s
    double crank_torque = 0.0;  ///< constant, N·m
    double turns = 5.0;
    double seconds = 0.0;  ///< of the turns
    double before = 0.0;   ///< of all of them but the last, s
    std::shared_ptr<const elastic_hinge::Result> solved;

    std::size_t outputs() const { return 2 * static_cast<std::size_t>(parts); }
    double evaluations() const { return turns; }
    double seconds_of_turn() const { return seconds / turns; }  ///< on an average
    /// Of the outputs 2 (part − 1) and 2 (part − 1) + 1; part = 1…parts.
    double time(int part) const {
        return part == parts ? seconds : before + (seconds - before) * part / parts;
    }
    bool repeats() const { return crank_torque == 0.0; }
};

/// φ̇ at a crank angle, by energy: with the hinge, I φ̇² − ω² I − 2 M φ is constant.
template <typename Scalar>
class EnergySpeed {
  public:
    explicit EnergySpeed(const MotionCase& motion)
        : mechanism_(mechanism_in<Scalar>(motion.input)),
          omega_2_(Scalar(motion.input.angular_speed) * Scalar(motion.input.angular_speed)),
          start_(reduced_inertia_at_zero(mechanism_) * Scalar(motion.start_speed) *
                 Scalar(motion.start_speed)),
          twice_torque_(Scalar(2) * Scalar(motion.crank_torque)) {}

    Scalar operator()(const Scalar& phi) const {
        using std::cos;
        using std::sin;
        return at(phi, Scalar(sin(phi)), Scalar(cos(phi)));
    }
    Scalar at(const Scalar& phi, const Scalar& sin_phi, const Scalar& cos_phi) const {
        using std::sqrt;
        const auto inertia = inertia_at(mechanism_, sin_phi, cos_phi);
        return sqrt(
            Scalar((start_ + omega_2_ * inertia.rise + twice_torque_ * phi) / inertia.value));
    }

  private:
    elastic_hinge::Mechanism<Scalar> mechanism_;
    Scalar omega_2_, start_, twice_torque_;
};

/// Time from one crank angle to another, s: Gauss-Legendre in parts that are halved until two rules
/// agree.
Real50 time_between(const EnergySpeed<Real50>& speed, const Real50& from, const Real50& to) {
    const auto slowness = [&](const Real50& phi) { return Real50(1 / speed(phi)); };
    namespace quadrature = boost::math::quadrature;
    Real50 fine = quadrature::gauss<Real50, 30>::integrate(slowness, from, to);
    const Real50 coarse = quadrature::gauss<Real50, 20>::integrate(slowness, from, to);
    const Real50 enough = Real50("1e-32") * abs(Real50(to - from)) / speed(to);
    if (!(abs(Real50(fine - coarse)) > enough) || abs(Real50(to - from)) < Real50("1e-4")) {
        return fine;
    }
    const Real50 middle = (from + to) / 2;
    return time_between(speed, from, middle) + time_between(speed, middle, to);
}

/// Time of the first turns. Where they are alike, one of them by the trapezoid rule, which
/// converges geometrically; points are doubled until `tolerance` is reached.
template <typename Scalar>
Scalar time_of_turns(const MotionCase& motion, double turns, double tolerance) {
    using std::abs;
    const Scalar& turn = boost::math::constants::two_pi<Scalar>();
    if (!motion.repeats()) {
        const EnergySpeed<Real50> speed(motion);
        const Real50& whole = boost::math::constants::two_pi<Real50>();
        Real50 sum(0);
        for (int k = 0; k < static_cast<int>(turns); ++k) {
            sum += time_between(speed, whole * k, whole * (k + 1));
        }
        return static_cast<Scalar>(sum);
    }
    const EnergySpeed<Scalar> speed(motion);
    Scalar last(0);
    Scalar sum(0);
    constexpr int most = 1 << 14;
    for (int n = 32; n <= most; n *= 2) {
        // Of the doubled points only every second one is new.
        for (int i = n == 32 ? 0 : 1; i < n; i += n == 32 ? 1 : 2) {
            sum += 1 / speed(turn * i / n);
        }
        const Scalar time = sum * turn / n;
        if (abs(Scalar(time - last)) < tolerance * time) {
            return time * Scalar(turns);
        }
        last = time;
    }
    return last * Scalar(turns);
}

/// φ̈ with the moment that the guide's spring has at its radius and slope, as simulate() has it.
class Acceleration {
  public:
    explicit Acceleration(const MotionCase& motion)
        : mechanism_(mechanism_in<double>(motion.input)),
          guide_(motion.solved->crank_guide),
          shape_(*guide_.shape),
          design_(*motion.solved->design),
          weight_(potential_amplitude(mechanism_)),
          torque_(motion.crank_torque) {}

    /// −d(V + Π)/dφ and the moment on the crank, N·m.
    double moment(double phi, double sin_phi, double cos_phi,
                  const elastic_hinge::ReducedInertia<double>& inertia) const {
        const auto rise =
            energy_rise(mechanism_, design_.angular_speed(), sin_phi, cos_phi, inertia);
        const auto point = shape_.at(
            guide_.branch, design_.demand(elastic_hinge::Hinge::crank, phi, {}, rise, 0.0));
        const auto& spring = shape_.spring();
        const double change = spring.free_length - 2.0 * point.radius;
        return torque_ + 2.0 * spring.stiffness * change * point.slope - weight_ * cos_phi;
    }

    double operator()(double phi, double speed) const {
        ++asked_;
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
        ++asked_;
        const double s = std::sin(phi);
        const double c = std::cos(phi);
        const auto rod = elastic_hinge::rod_angle_exact(mechanism_.lambda, s, c);
        const auto inertia = elastic_hinge::reduced_inertia(mechanism_, s, c, rod);
        return {inertia.value, inertia.slope, moment(phi, s, c, inertia)};
    }
    double inertia(double phi) const {
        return inertia_at(mechanism_, std::sin(phi), std::cos(phi)).value;
    }

    /// How often the mechanism was computed.
    long asked() const { return asked_; }

  private:
    mutable long asked_ = 0;
    elastic_hinge::Mechanism<double> mechanism_;
    const elastic_hinge::Guide& guide_;
    const elastic_hinge::GuideShape& shape_;
    const elastic_hinge::Design& design_;
    double weight_;
    double torque_;
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

/// Thousands of turns take seconds.
void check_now_and_then(long step) {
    if (step % 1024 == 0) {
        check_cancelled();
    }
}

void put(const TurnState& state, int part, std::span<double> out) {
    const auto i = 2 * static_cast<std::size_t>(part - 1);
    out[i] = state.angle;
    out[i + 1] = state.speed;
}

/// Brings a state through a time; `setting` is the method's.
/// @return why it cannot, or nothing
using Advance = std::function<Message(double seconds, TurnState& state)>;
using Integrator = Advance (*)(const MotionCase&, const Acceleration&, double setting);

Message integrate(const MotionCase& motion, const Acceleration& f, Integrator integrator,
                  double setting, std::span<double> out) {
    Advance advance = integrator(motion, f, setting);
    TurnState state{0.0, motion.start_speed};
    double before = 0.0;
    for (int part = 1; part <= MotionCase::parts; ++part) {
        const double time = motion.time(part);
        Message refusal = advance(time - before, state);
        if (!refusal.empty()) {
            return refusal;
        }
        put(state, part, out);
        before = time;
    }
    return {};
}

Method<MotionCase> integrated(MethodInfo info, double own_operations, Integrator integrator) {
    Method<MotionCase> method;
    method.info = std::move(info);
    method.prepare = [integrator](const MotionCase& motion, const Setting& setting) -> Run {
        return [&motion, integrator, value = setting.value](std::span<double> out) {
            Message refusal = why_not(motion);
            return refusal.empty() ? integrate(motion, Acceleration(motion), integrator, value, out)
                                   : refusal;
        };
    };
    method.operations = [integrator, own_operations](const MotionCase& motion,
                                                     const Setting& setting) {
        if (!why_not(motion).empty()) {
            return 0.0;
        }
        const Acceleration f(motion);
        std::vector<double> out(motion.outputs());
        integrate(motion, f, integrator, setting.value, out);
        return static_cast<double>(f.asked()) * (slope_operations + own_operations) / motion.turns;
    };
    return method;
}

/// Equal steps, so many a turn, from one wanted time to the next.
template <typename Step>
Advance equal_steps(const MotionCase& motion, double per_turn, Step step) {
    const double longest = motion.seconds_of_turn() / per_turn;
    return [longest, step](double seconds, TurnState& state) mutable {
        constexpr double rounding = 1e-9;
        const auto steps = std::max(1L, std::lround(std::ceil(seconds / longest - rounding)));
        for (long i = 0; i < steps; ++i) {
            check_now_and_then(i);
            step(seconds / static_cast<double>(steps), state);
        }
        return Message();
    };
}

Advance runge_kutta_4(const MotionCase& motion, const Acceleration& f, double per_turn) {
    return equal_steps(motion, per_turn, [&f](double h, TurnState& x) {
        const double a = f(x.angle, x.speed);
        const double va = x.speed + h / 2.0 * a;
        const double b = f(x.angle + h / 2.0 * x.speed, va);
        const double vb = x.speed + h / 2.0 * b;
        const double c = f(x.angle + h / 2.0 * va, vb);
        const double vc = x.speed + h * c;
        const double d = f(x.angle + h * vb, vc);
        x.angle += h / 6.0 * (x.speed + 2.0 * va + 2.0 * vb + vc);
        x.speed += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
    });
}

/// Störmer–Verlet for H = p²/2I(φ) + U(φ): the half steps of p and φ are implicit, the first a
/// quadratic equation, the second a fixed point.
Advance stoermer_verlet(const MotionCase& motion, const Acceleration& f, double per_turn) {
    auto here = f.parts(0.0);
    return equal_steps(motion, per_turn, [&f, here](double h, TurnState& x) mutable {
        const double p = here.inertia * x.speed;
        // p½ = p + h/2 (moment + I′ p½² / 2I²)
        const double a = h / 4.0 * here.slope / (here.inertia * here.inertia);
        const double known = p + h / 2.0 * here.moment;
        const double root = std::sqrt(std::max(1.0 - 4.0 * a * known, 0.0));
        const double half = 2.0 * known / (1.0 + root);
        double next = x.angle + h * half / here.inertia;
        auto there = f.parts(next);
        for (int pass = 0; pass < 20; ++pass) {
            const double better =
                x.angle + h / 2.0 * half * (1.0 / here.inertia + 1.0 / there.inertia);
            const bool done = std::abs(better - next) <= 1e-15 * std::abs(better);
            next = better;
            there = f.parts(next);
            if (done) {
                break;
            }
        }
        const double last = half + h / 2.0 *
                                       (there.moment + there.slope * half * half /
                                                           (2.0 * there.inertia * there.inertia));
        x = {next, last / there.inertia};
        here = there;
    });
}

template <std::size_t S>
Advance implicit(const MotionCase& motion, const Acceleration& f, double per_turn,
                 const ImplicitTable<S>& table) {
    std::array<double, S> rates{};
    rates.fill(f(0.0, motion.start_speed));
    return equal_steps(motion, per_turn, [&f, &table, rates](double h, TurnState& x) mutable {
        implicit_step(table, f, h, x, rates);
    });
}

Message lost() {
    return CORE_TEXT("methods", "its steps shrink to nothing");
}

Advance dormand_prince(const MotionCase& motion, const Acceleration& f, double tolerance) {
    namespace odeint = boost::numeric::odeint;
    using State = std::array<double, 2>;
    // The absolute tolerance is that of an angle and of a speed at once: relative to the speed.
    constexpr double absolute = 1e-2;
    auto stepper =
        odeint::make_dense_output(tolerance * absolute * std::max(1.0, motion.start_speed),
                                  tolerance, odeint::runge_kutta_dopri5<State>());
    stepper.initialize(State{0.0, motion.start_speed}, 0.0, 1e-3 / motion.start_speed);
    const auto most_steps = static_cast<long>(1e5 * motion.turns);
    return [&f, stepper, most_steps, end = 0.0](double seconds, TurnState& x) mutable -> Message {
        end += seconds;
        const auto slope = [&f](const State& at, State& rate, double) {
            rate = {at[1], f(at[0], at[1])};
        };
        for (long i = 0; stepper.current_time() < end; ++i) {
            check_now_and_then(i);
            try {
                stepper.do_step(slope);
            } catch (const odeint::step_adjustment_error&) {
                return lost();
            }
            if (i == most_steps || !std::isfinite(stepper.current_state()[0])) {
                return lost();
            }
        }
        State state{};
        stepper.calc_state(end, state);
        x = {state[0], state[1]};
        return {};
    };
}

Advance dop853(const MotionCase& motion, const Acceleration& f, double tolerance) {
    return [&f, method = Dop853(tolerance, motion.start_speed, motion.seconds_of_turn() / 64.0),
            slice = motion.seconds_of_turn()](double seconds, TurnState& x) mutable -> Message {
        // Turn by turn, to be asked between them whether to go on.
        const double slices = std::ceil(seconds / slice - 1e-9);
        for (long i = 0; static_cast<double>(i) < slices; ++i) {
            check_now_and_then(i);
            if (!method.advance(f, seconds / slices, x)) {
                return lost();
            }
        }
        return {};
    };
}

/// The time of a turn as a Fourier series in the crank angle, from 1/φ̇ at equal steps of it: at
/// a wanted time the angle is found by Newton's method. Nothing but whole turns repeats, so there
/// must be no moment on the crank.
class PeriodicTime {
  public:
    /// @param nodes  so many, or below 1: doubled until the last eighth of the orders is below that
    PeriodicTime(const MotionCase& motion, double nodes) : speed_(motion) {
        constexpr std::size_t first = 32;
        constexpr std::size_t most = 1 << 13;
        for (auto n = nodes >= 1.0 ? static_cast<std::size_t>(nodes) : first;; n *= 2) {
            check_cancelled();
            const UniformTransform<double> transform(n);
            const std::vector<double> before = std::move(pace_);
            pace_.assign(n, 0.0);
            for (std::size_t i = 0; i < n; ++i) {
                if (!before.empty() && i % 2 == 0) {
                    pace_[i] = before[i / 2];
                    continue;
                }
                ++asked_;
                pace_[i] = 1.0 / speed_.at(0.0, transform.node_sin()[i], transform.node_cos()[i]);
            }
            orders_ = transform.orders(pace_, static_cast<int>(n / 2) - 1);
            products_ += static_cast<double>(n * n) * 2.0;
            double last = 0.0;
            for (std::size_t k = n / 2 - n / 16; k < orders_.size(); ++k) {
                last = std::max({last, std::abs(orders_[k].cos), std::abs(orders_[k].sin)});
            }
            if (nodes >= 1.0 || !(last > nodes * orders_[0].cos) || n >= most) {
                return;
            }
        }
    }

    TurnState at(double time) {
        const double turn = two_pi * orders_[0].cos;
        const double turns = std::floor(time / turn);
        const double wanted = time - turns * turn;
        double phi = wanted / orders_[0].cos;
        for (int pass = 0; pass < 50; ++pass) {
            // t(φ) = Σ (a sin kφ + b (1 − cos kφ)) / k, by turning a vector through φ.
            double t = orders_[0].cos * phi;
            double pace = orders_[0].cos;
            const double c1 = std::cos(phi);
            const double s1 = std::sin(phi);
            double c = c1;
            double s = s1;
            for (std::size_t k = 1; k < orders_.size(); ++k) {
                const auto& order = orders_[k];
                t += (order.cos * s + order.sin * (1.0 - c)) / static_cast<double>(k);
                pace += order.cos * c + order.sin * s;
                const double next = c * c1 - s * s1;
                s = s * c1 + c * s1;
                c = next;
            }
            products_ += 15.0 * static_cast<double>(orders_.size());
            const double step = (wanted - t) / pace;
            phi = std::clamp(phi + step, 0.0, two_pi);
            if (!(std::abs(step) > 1e-15)) {
                break;
            }
        }
        return {turns * two_pi + phi, speed_(phi)};
    }

    double operations() const { return 160.0 * static_cast<double>(asked_) + products_; }

  private:
    EnergySpeed<double> speed_;
    std::vector<double> pace_;  ///< 1/φ̇, s
    std::vector<Harmonic<double>> orders_;
    long asked_ = 0;
    double products_ = 0.0;
};

Method<MotionCase> energy_trapezoid() {
    Method<MotionCase> method;
    method.info = {
        "energy-trapezoid",
        CORE_TEXT("methods", "energy, time by the trapezoid rule"),
        CORE_TEXT("methods",
                  "converges geometrically and never drifts, but only where every turn is like "
                  "the last: not with a moment on the crank, not from rest and not to a reversal; "
                  "a slow start takes thousands of nodes"),
        {counted(CORE_TEXT("methods", "%1 nodes"), 16),
         counted(CORE_TEXT("methods", "%1 nodes"), 64),
         counted(CORE_TEXT("methods", "%1 nodes"), 256),
         {{CORE_TEXT("methods", "doubled until %1"), "1e-8"}, 1e-8},
         {{CORE_TEXT("methods", "doubled until %1"), "1e-11"}, 1e-11}},
        false};
    method.prepare = [](const MotionCase& motion, const Setting& setting) -> Run {
        return [&motion, value = setting.value](std::span<double> out) {
            Message refusal = why_not(motion);
            if (!motion.repeats()) {
                refusal =
                    CORE_TEXT("methods", "with a moment on the crank no turn is like another");
            }
            if (refusal.empty()) {
                PeriodicTime time(motion, value);
                for (int part = 1; part <= MotionCase::parts; ++part) {
                    put(time.at(motion.time(part)), part, out);
                }
            }
            return refusal;
        };
    };
    method.operations = [](const MotionCase& motion, const Setting& setting) {
        if (!why_not(motion).empty() || !motion.repeats()) {
            return 0.0;
        }
        PeriodicTime time(motion, setting.value);
        for (int part = 1; part <= MotionCase::parts; ++part) {
            time.at(motion.time(part));
        }
        return time.operations() / motion.turns;
    };
    return method;
}

/// As the scene computes it.
Motion simulate(const MotionCase& motion, double tolerance) {
    MotionSetup setup;
    setup.hinges = HingeSet::crank;
    setup.start_speed = motion.start_speed;
    setup.turns = motion.turns + 1.0;
    setup.crank_torque = motion.crank_torque;
    setup.longest_time = motion.seconds;
    setup.tolerance = tolerance;
    return elastic_hinge::simulate(motion.solved->design, motion.solved->crank_guide, setup,
                                   [](double) {
                                       check_cancelled();
                                       return true;
                                   });
}

Method<MotionCase> energy_series() {
    Method<MotionCase> method;
    method.info = {"energy-series",
                   CORE_TEXT("methods", "energy, time by Chebyshev series"),
                   CORE_TEXT("methods",
                             "stretches are halved near a standstill, which costs; where the crank "
                             "can just pass a dead point or just not, rounding decides which"),
                   {{"1e-5", 1e-5}, {"1e-8", 1e-8}, {"1e-11", 1e-11}, {"1e-13", 1e-13}},
                   false};
    method.prepare = [](const MotionCase& motion, const Setting& setting) -> Run {
        return [&motion, tolerance = setting.value](std::span<double> out) {
            Message refusal = why_not(motion);
            if (!refusal.empty()) {
                return refusal;
            }
            try {
                const Motion result = simulate(motion, tolerance);
                refusal = result.reason;
                // As the scene reads it between its samples.
                for (int part = 1; part <= MotionCase::parts; ++part) {
                    const double time = motion.time(part);
                    put({result.angle_at(time), result.speed_at(time)}, part, out);
                }
            } catch (const std::runtime_error& error) {
                refusal = error.what();
            }
            return refusal;
        };
    };
    method.operations = [](const MotionCase& motion, const Setting& setting) {
        if (!why_not(motion).empty()) {
            return 0.0;
        }
        const Motion result = simulate(motion, setting.value);
        constexpr double at_a_place = slope_operations + 15.0;
        constexpr double of_a_place = 80.0;  // its part in the series of time and work, or its time
        constexpr double of_a_sample = 10.0;  // to record it
        return (static_cast<double>(result.evaluations) * (at_a_place + of_a_place) +
                static_cast<double>(result.time.size()) * of_a_sample) /
               motion.turns;
    };
    return method;
}

std::vector<Expected> reference(const MotionCase& motion) {
    if (!why_not(motion).empty()) {
        return {};
    }
    const EnergySpeed<Real50> speed_at(motion);
    const Real50& turn = boost::math::constants::two_pi<Real50>();
    const Real50 first = Real50(motion.turns - 1.0) * turn;  // of the last turn
    const Real50 before = time_of_turns<Real50>(motion, motion.turns - 1.0, 1e-32);
    std::vector<Expected> list;
    Real50 angle = first;
    Real50 time = before;
    for (int part = 1; part <= MotionCase::parts; ++part) {
        const Real50 wanted(motion.time(part));
        Real50 speed;
        // Newton's method between bounds; the first step is a guess.
        Real50 early = angle;
        Real50 late = first + turn * Real50("1.001");
        Real50 step = first + turn * part / MotionCase::parts - angle;
        constexpr int most = 100;
        for (int i = 0; i < most; ++i) {
            time += time_between(speed_at, angle, angle + step);
            angle += step;
            (time < wanted ? early : late) = angle;
            speed = speed_at(angle);
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
        list.push_back({at, angle, motion.turns});
        list.push_back({at + 1, speed, motion.turns * static_cast<double>(speed)});
    }
    return list;
}

/// The speeds that the energy of the bars and of the spring allows, and by them the time that the
/// crank takes to the angles of the reference and for the whole last turn.
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
    // The guide keeps T + V + Π at ω, so at another speed (φ̇² − ω²) T(1) is constant but for the
    // work on the crank.
    const Real50 constant = (start * start - omega * omega) * kinetic(Real50(0));
    const auto speed = [&](const Real50& phi) {
        const Real50 work = Real50(motion.crank_torque) * phi;
        return Real50(sqrt(Real50(omega * omega + (constant + work) / kinetic(phi))));
    };
    boost::math::quadrature::tanh_sinh<Real50> quadrature;
    const auto time_to = [&](const Real50& from, const Real50& to) {
        return quadrature.integrate([&](const Real50& phi) { return Real50(1 / speed(phi)); }, from,
                                    to, Real50("1e-24"));
    };
    const Real50& turn = boost::math::constants::two_pi<Real50>();
    const Real50 first = Real50(motion.turns - 1.0) * turn;
    const Real50 before = time_of_turns<Real50>(motion, motion.turns - 1.0, 1e-32);
    const Real50 promised = time_of_turns<Real50>(motion, motion.turns, 1e-32) - before;
    const Real50 whole = time_to(first, first + turn / 2) + time_to(first + turn / 2, first + turn);
    Real50 worst = abs(Real50(whole / promised - 1));
    Real50 angle = first;
    Real50 time = before;
    for (const Expected& expected : reference) {
        const int part = static_cast<int>(expected.index / 2) + 1;
        if (expected.index % 2 == 0) {
            time += time_to(angle, expected.value);
            angle = expected.value;
            worst =
                std::max(worst, Real50(abs(Real50(time - Real50(motion.time(part)))) / promised));
        } else {
            worst = std::max(worst, Real50(abs(Real50(speed(angle) / expected.value - 1))));
        }
    }
    return static_cast<double>(worst);
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
        motion.seconds = time_of_turns<double>(motion, motion.turns, 1e-15);
        motion.before = time_of_turns<double>(motion, motion.turns - 1.0, 1e-15);
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
        integrated({"rk4", CORE_TEXT("methods", "Runge-Kutta of order 4, fixed step"),
                    CORE_TEXT("methods",
                              "its energy drifts steadily: with 90 steps a turn it is wrong after "
                              "thousands of turns, and near λ = 1 at once"),
                    counted(CORE_TEXT("methods", "%1 steps a turn"), {45, 90, 180, 360}), true},
                   10.0, runge_kutta_4),
        integrated(
            {"stoermer-verlet", CORE_TEXT("methods", "Störmer-Verlet, symplectic"),
             CORE_TEXT("methods", "its energy never drifts, but order 2 leaves it behind in time"),
             counted(CORE_TEXT("methods", "%1 steps a turn"), {45, 90, 180, 360}), true},
            20.0, stoermer_verlet),
        integrated({"implicit-midpoint", CORE_TEXT("methods", "implicit midpoint rule, symplectic"),
                    CORE_TEXT("methods",
                              "half the error of Störmer-Verlet for as much work, but order 2 all "
                              "the same: nothing here is stiff enough to repay an implicit rule"),
                    counted(CORE_TEXT("methods", "%1 steps a turn"), {45, 90, 180, 360}), true},
                   15.0,
                   [](const MotionCase& motion, const Acceleration& f, double per_turn) {
                       return implicit(motion, f, per_turn, implicit_midpoint);
                   }),
        integrated({"gauss-6", CORE_TEXT("methods", "Gauss of order 6, symplectic"),
                    CORE_TEXT("methods",
                              "neither its energy drifts nor does it lag, but each step solves "
                              "for three accelerations; near λ = 1 a step spans the steep place"),
                    counted(CORE_TEXT("methods", "%1 steps a turn"), {27, 45, 90, 180}), true},
                   25.0,
                   [](const MotionCase& motion, const Acceleration& f, double per_turn) {
                       return implicit(motion, f, per_turn, gauss_6);
                   }),
        integrated({"radau-5", CORE_TEXT("methods", "Radau IIA of order 5"),
                    CORE_TEXT("methods",
                              "as dear as Gauss's method, and it damps: the energy drifts; made "
                              "for stiff equations, which this is not"),
                    counted(CORE_TEXT("methods", "%1 steps a turn"), {27, 45, 90, 180}), true},
                   25.0,
                   [](const MotionCase& motion, const Acceleration& f, double per_turn) {
                       return implicit(motion, f, per_turn, radau_5);
                   }),
        integrated({"dormand-prince",
                    CORE_TEXT("methods", "Dormand-Prince with step control"),
                    CORE_TEXT("methods",
                              "the energy drifts by about the tolerance at every turn: a little "
                              "less than its tolerance promises, but without end"),
                    {{"1e-5", 1e-5}, {"1e-8", 1e-8}, {"1e-11", 1e-11}, {"1e-13", 1e-13}},
                    false},
                   40.0, dormand_prince),
        integrated({"dop853",
                    CORE_TEXT("methods", "Dormand-Prince of order 8 with step control"),
                    CORE_TEXT("methods",
                              "fewer and longer steps than order 5 for ten digits, and the same "
                              "drift without end"),
                    {{"1e-5", 1e-5}, {"1e-8", 1e-8}, {"1e-11", 1e-11}, {"1e-13", 1e-13}},
                    false},
                   40.0, dop853),
        energy_trapezoid(),
        energy_series(),
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
    definition.sweeps.push_back(
        {{"crank-torque", CORE_TEXT("methods", "moment on the crank, 5 turns"), units::N_m, 1e-3,
          1e2, Spacing::logarithmic, 0.0, 1e-3, 1e2, 0.5},
         [=](double torque) { return make_motion(paper_lambda, off_design, 5.0, torque); }});
    definition.sweeps.back().info.points = 9;
    definition.reference = reference;
    definition.refusal = [](const MotionCase& motion) -> Message {
        try {
            elastic_hinge::Input input = motion.input;
            input.motion = elastic_hinge::MotionWish{};
            input.motion->turns = motion.turns;
            input.motion->start_speed = motion.start_speed;
            input.motion->crank_torque = motion.crank_torque;
            return elastic_hinge::solve(input).crank_guide.reason.english();
        } catch (const InputError& error) {
            return error.message();
        }
    };
    definition.check = check;
    return make_kernel(std::move(definition));
}

}  // namespace ravnoves::methods
