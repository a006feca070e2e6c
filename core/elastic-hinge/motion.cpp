#include "elastic-hinge/motion.h"

#include <algorithm>
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <limits>
#include <utility>

#include "case-file/input_error.h"

namespace ravnoves::elastic_hinge {

namespace {

using State = std::array<double, 2>;  // φ, φ̇

/// The one equation of motion.
class System {
  public:
    System(const Design& design, const Guide& guide, const MotionSetup& setup)
        : design_(design),
          mechanism_(design.mechanism()),
          setup_(setup),
          shape_(setup.hinges == HingeSet::none ? nullptr : guide.shape.get()),
          branch_(guide.branch),
          potential_(potential_amplitude(mechanism_)),
          mean_(design.rod_hinge_mean()) {}

    void operator()(const State& x, State& dx, double /*time*/) const {
        const double s = std::sin(x[0]);
        const double c = std::cos(x[0]);
        const auto rod = rod_angle_exact(mechanism_.lambda, s, c);
        const auto inertia = reduced_inertia(mechanism_, s, c, rod);
        double moment = setup_.crank_torque - 0.5 * inertia.slope * x[1] * x[1] - potential_ * c;
        if (shape_ != nullptr) {
            moment += hinge_moment(x[0], s, c, rod, inertia);
        }
        dx[0] = x[1];
        dx[1] = moment / inertia.value;
    }

    /// T, J.
    double kinetic(const State& x) const {
        const double s = std::sin(x[0]);
        const double c = std::cos(x[0]);
        const auto rod = rod_angle_exact(mechanism_.lambda, s, c);
        return 0.5 * reduced_inertia(mechanism_, s, c, rod).value * x[1] * x[1];
    }

    /// V + Π − work of the crank's moment, J.
    double potential(const State& x) const {
        double energy =
            potential_ * std::sin(x[0]) - setup_.crank_torque * (x[0] - setup_.start_angle);
        if (shape_ != nullptr) {
            const GuidePoint point = shape_->at(branch_, x[0]);
            energy += shape_->energy(point.radius + error(x[0]));
            if (setup_.hinges == HingeSet::crank_and_rod) {
                energy += design_.rod_work(x[0]);
            }
        }
        return energy;
    }

  private:
    double error(double phi) const {
        return setup_.profile_error * std::sin(setup_.profile_error_waves * phi);
    }

    /// −dΠ/dφ of all hinges, N·m.
    double hinge_moment(double phi, double s, double c, const RodAngle<double>& rod,
                        const ReducedInertia<double>& inertia) const {
        const auto rise = energy_rise(mechanism_, design_.angular_speed(), s, c, inertia);
        double rod_moment = 0.0;
        AngleState state{};
        Demand demand{};
        if (setup_.hinges == HingeSet::crank) {
            demand = design_.demand(Hinge::crank, phi, state, rise, 0.0);
        } else {
            state.exact = rod;
            state.moment = design_.rod_moment(s, c);
            demand = design_.demand(Hinge::crank_with_rod, phi, state, rise, design_.rod_work(phi));
            rod_moment = (state.moment.value(design_.angular_speed()) - mean_) * (1.0 + rod.dpsi);
        }
        const GuidePoint point = shape_->at(branch_, demand);
        const auto& spring = shape_->spring();
        const double waves = setup_.profile_error_waves;
        const double slope = point.slope + setup_.profile_error * waves * std::cos(waves * phi);
        const double change = spring.free_length - 2.0 * (point.radius + error(phi));
        return 2.0 * spring.stiffness * change * slope - rod_moment;
    }

    const Design& design_;
    const Mechanism<double>& mechanism_;
    const MotionSetup& setup_;
    const GuideShape* shape_;
    Branch branch_;
    double potential_;
    double mean_;
};

Number turns_of(double angle) {
    return {std::round(std::abs(angle) / two_pi * 1e4) / 1e4};
}

void check_setup(const Design& design, const Guide& guide, const MotionSetup& setup) {
    if (!design.has_exact_kinematics()) {
        throw InputError(
            "/input/lambda",
            CORE_TEXT("elastic-hinge", "must be less than 1 for a motion: the mechanism locks"),
            Number{design.mechanism().lambda});
    }
    if (setup.hinges != HingeSet::none) {
        const Hinge wanted = setup.hinges == HingeSet::crank ? Hinge::crank : Hinge::crank_with_rod;
        if (!guide.feasible || !guide.shape || guide.hinge != wanted) {
            throw InputError(
                "/input/spring",
                guide.reason.empty()
                    ? Message(CORE_TEXT("elastic-hinge",
                                        "must make a guide that exists for this motion"))
                    : Message(CORE_TEXT("elastic-hinge",
                                        "must make a guide that exists for this motion: %1"),
                              guide.reason));
        }
    }
}

}  // namespace

namespace {

/// Angle and speed within the interval that ends with sample `next`.
State between(const Motion& motion, std::size_t next, double seconds) {
    const std::size_t i = next - 1;
    const double h = motion.time[next] - motion.time[i];
    const double u = (seconds - motion.time[i]) / h;
    const double rise = motion.crank_angle[next] - motion.crank_angle[i];
    const double v0 = h * motion.speed[i];
    const double v1 = h * motion.speed[next];
    const double a0 = h * h * motion.acceleration[i];
    const double a1 = h * h * motion.acceleration[next];
    const double c3 = 10 * rise - 6 * v0 - 4 * v1 - (3 * a0 - a1) / 2;
    const double c4 = -15 * rise + 8 * v0 + 7 * v1 + (3 * a0 - 2 * a1) / 2;
    const double c5 = 6 * rise - 3 * (v0 + v1) - (a0 - a1) / 2;
    return {motion.crank_angle[i] + u * (v0 + u * (a0 / 2 + u * (c3 + u * (c4 + u * c5)))),
            (v0 + u * (a0 + u * (3 * c3 + u * (4 * c4 + u * 5 * c5)))) / h};
}

State state_at(const Motion& motion, double seconds) {
    if (motion.time.empty()) {
        return {};
    }
    const auto next = static_cast<std::size_t>(
        std::upper_bound(motion.time.begin(), motion.time.end(), seconds) - motion.time.begin());
    if (next == 0) {
        return {motion.crank_angle.front(), motion.speed.front()};
    }
    if (next == motion.time.size()) {
        return {motion.crank_angle.back(), motion.speed.back()};
    }
    return between(motion, next, seconds);
}

}  // namespace

double Motion::angle_at(double seconds) const {
    return state_at(*this, seconds)[0];
}

double Motion::speed_at(double seconds) const {
    return state_at(*this, seconds)[1];
}

Motion simulate(const std::shared_ptr<const Design>& design, const Guide& crank_guide,
                const MotionSetup& setup, const MotionProgress& progress) {
    check_setup(*design, crank_guide, setup);
    const System system(*design, crank_guide, setup);
    Motion motion;

    const State start{setup.start_angle, setup.start_speed};
    State slope{};
    system(start, slope, 0.0);
    const double inertia = reduced_inertia_at_zero(design->mechanism());
    if (!std::isfinite(slope[1]) || !(inertia > 0.0)) {
        throw InputError(
            "/input", CORE_TEXT("elastic-hinge",
                                "must give the crank and the rod together some mass for a motion"));
    }
    const double wanted = setup.turns * two_pi;

    // A time in which something happens: of one radian at the start's speed or acceleration.
    const double rate = std::max({std::abs(setup.start_speed), std::sqrt(std::abs(slope[1])),
                                  1e-6 * design->angular_speed(), 1e-9});
    double longest = setup.longest_time;
    if (!(longest > 0.0)) {
        longest = 50.0 * (setup.turns * two_pi + 1.0) / rate;
    }

    motion.min_speed = setup.start_speed;
    motion.max_speed = setup.start_speed;
    const auto take_speed = [&](double speed) {
        motion.min_speed = std::min(motion.min_speed, speed);
        motion.max_speed = std::max(motion.max_speed, speed);
    };
    const auto record = [&](double time, const State& x, double acceleration) {
        motion.time.push_back(time);
        motion.crank_angle.push_back(x[0]);
        motion.speed.push_back(x[1]);
        motion.acceleration.push_back(acceleration);
        take_speed(x[1]);
    };
    const double potential_0 = system.potential(start);
    const double kinetic_0 = system.kinetic(start);
    double drift = 0.0;
    double scale = kinetic_0;
    const auto watch = [&](const State& x) {
        const double kinetic = system.kinetic(x);
        const double potential = system.potential(x) - potential_0;
        drift = std::max(drift, std::abs((kinetic - kinetic_0) + potential));
        scale = std::max({scale, kinetic, std::abs(potential)});
    };

    namespace odeint = boost::numeric::odeint;
    // The absolute tolerance is that of an angle and of a speed at once: relative to the speed.
    auto stepper = odeint::make_dense_output(setup.tolerance * std::max(1.0, rate) * 1e-2,
                                             setup.tolerance, odeint::runge_kutta_dopri5<State>());
    stepper.initialize(start, 0.0, 1e-3 / rate);
    record(0.0, start, slope[1]);

    const double sample_angle = two_pi / std::max(setup.samples_per_turn, 4);
    constexpr std::size_t most_steps = 20'000'000;
    bool done = false;
    // The time at which f of the state changes its sign within the last step.
    const auto locate = [&](const auto& f, double from, double to) {
        State x{};
        const auto at = [&](double time) {
            stepper.calc_state(time, x);
            return f(x);
        };
        const double a = at(from);
        const double b = at(to);
        if (a == 0.0) {
            return from;
        }
        if (b == 0.0 || (a < 0.0) == (b < 0.0)) {
            return to;
        }
        std::uintmax_t tries = 60;
        const auto bracket = boost::math::tools::toms748_solve(
            at, from, to, a, b, boost::math::tools::eps_tolerance<double>(48), tries);
        return bracket.second;
    };

    const auto acceleration = [&](const State& x) {
        State rate_of_x{};
        system(x, rate_of_x, 0.0);
        return rate_of_x[1];
    };
    // Takes the speed where it is greatest or least between the last two samples.
    double last_acceleration = slope[1];
    const auto take_extremum = [&](double begin, double end, const State& x) {
        const double present = motion.acceleration.back();
        const double last = std::exchange(last_acceleration, present);
        const double reach = std::max(std::abs(last), std::abs(present)) * (end - begin);
        const bool turns = (last < 0.0) != (present < 0.0);
        const bool counts = x[1] + reach > motion.max_speed || x[1] - reach < motion.min_speed;
        if (turns && counts && reach > 1e-13 * std::abs(x[1])) {
            State extreme{};
            stepper.calc_state(locate(acceleration, begin, end), extreme);
            take_speed(extreme[1]);
        }
    };

    while (!done) {
        const auto [from, step_end] = stepper.do_step(std::cref(system));
        ++motion.steps;
        double to = step_end;
        const State& ahead = stepper.current_state();
        if (!std::isfinite(ahead[0]) || !std::isfinite(ahead[1])) {
            throw std::runtime_error("the motion left the range of numbers");
        }
        State before{};
        stepper.calc_state(from, before);

        if (std::abs(ahead[0] - setup.start_angle) >= wanted) {
            const double side = ahead[0] > setup.start_angle ? 1.0 : -1.0;
            to = locate([&](const State& x) { return side * (x[0] - setup.start_angle) - wanted; },
                        from, to);
            motion.end = MotionEnd::completed;
            done = true;
        }
        if (to >= longest) {
            to = longest;
            done = true;
            motion.end = setup.longest_time > 0.0 ? MotionEnd::completed : MotionEnd::too_slow;
        }
        // From rest the first sign is that of the acceleration.
        if (setup.stop_at_reversal && before[1] != 0.0 && (before[1] < 0.0) != (ahead[1] < 0.0)) {
            const double stop = locate([](const State& x) { return x[1]; }, from, step_end);
            if (stop <= to) {
                to = stop;
                done = true;
                motion.end = MotionEnd::reversed;
            }
        }

        State x{};
        stepper.calc_state(to, x);
        const auto parts = static_cast<int>(
            std::clamp(std::ceil(std::abs(x[0] - before[0]) / sample_angle), 1.0, 1000.0));
        double last_time = from;
        for (int part = 1; part <= parts; ++part) {
            const double time = from + (to - from) * part / parts;
            stepper.calc_state(time, x);
            record(time, x, acceleration(x));
            take_extremum(last_time, time, x);
            last_time = time;
        }
        watch(x);
        if (motion.steps >= most_steps) {
            motion.end = MotionEnd::too_slow;
            done = true;
        }
        if (progress && (done || motion.steps % 256 == 0)) {
            const double part =
                done ? 1.0 : std::max(std::abs(x[0] - setup.start_angle) / wanted, to / longest);
            if (!progress(std::min(part, 1.0)) && !done) {
                motion.end = MotionEnd::cancelled;
                done = true;
            }
        }
    }

    const double turned = motion.crank_angle.back() - setup.start_angle;
    motion.mean_speed = motion.time.back() > 0.0 ? turned / motion.time.back() : 0.0;
    motion.ripple = motion.mean_speed != 0.0
                        ? (motion.max_speed - motion.min_speed) / std::abs(motion.mean_speed)
                        : 0.0;
    motion.energy_drift = scale > 0.0 ? drift / scale : 0.0;
    switch (motion.end) {
        case MotionEnd::completed:
            break;
        case MotionEnd::reversed:
            motion.reason = {
                CORE_TEXT("elastic-hinge", "the crank stops after %1 turns and would turn back"),
                turns_of(turned)};
            break;
        case MotionEnd::too_slow:
            motion.reason = {CORE_TEXT("elastic-hinge", "the crank made only %1 turns in %2"),
                             turns_of(turned), Number{motion.time.back(), units::second, 6}};
            break;
        case MotionEnd::cancelled:
            motion.reason = {CORE_TEXT("elastic-hinge", "cancelled after %1 turns"),
                             turns_of(turned)};
            break;
    }
    return motion;
}

double side_force(const Mechanism<double>& m, double phi, double speed, double acceleration,
                  double hinge_moment) {
    const double s = std::sin(phi);
    const double c = std::cos(phi);
    const auto rod = rod_angle_exact(m.lambda, s, c);
    const double l = m.rod_length();
    const double r = m.crank_radius;
    const double l2 = m.counterweight_distance;
    const double square = speed * speed;
    // Accelerations by φ̇² and φ̈; the rod turns through −ψ.
    const double dd_cos_phi = -c * square - s * acceleration;
    const double dd_sin_phi = -s * square + c * acceleration;
    const double dd_cos_psi = rod.d2cos * square + rod.dcos * acceleration;
    const double dd_sin_psi = m.lambda * dd_sin_phi;
    const double dd_psi = rod.d2psi * square + rod.dpsi * acceleration;
    const struct {
        double mass, along;  // kg; distance from A towards B, m
    } bodies[] = {{m.slider_mass, l}, {m.rod_mass, 0.5 * l}, {m.counterweight_mass, -l2}};
    // Moments about A: Σ (r × m (a − g)) + I α = hinge moment + (B − A) × force on the slider.
    double sum = -m.rod_mass * l * l / 12.0 * dd_psi;
    for (const auto& body : bodies) {
        const double ax = r * dd_cos_phi + body.along * dd_cos_psi;
        const double ay = r * dd_sin_phi - body.along * dd_sin_psi;
        const double x = body.along * rod.cos_psi;
        const double y = -body.along * rod.sin_psi;
        sum += body.mass * (x * (ay + m.gravity) - y * ax);
    }
    return (hinge_moment - sum) / (l * rod.cos_psi);
}

}  // namespace ravnoves::elastic_hinge
