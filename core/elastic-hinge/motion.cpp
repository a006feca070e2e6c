#include "elastic-hinge/motion.h"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <utility>

#include "case-file/decimal.h"
#include "case-file/input_error.h"

namespace ravnoves::elastic_hinge {

namespace {

/// The mechanism at one crank angle, whatever its speed.
struct Place {
    double inertia;    ///< I, kg·m²
    double slope;      ///< I′, kg·m²
    double potential;  ///< V + Π − work of the crank's moment, J, up to a constant
    double moment;     ///< −d potential / dφ by weights, spring and the guide's slope, N·m
    double closeness;  ///< 1 / cos² ψ, which rounding in I grows with

    double acceleration(double speed) const {
        return (moment - 0.5 * slope * speed * speed) / inertia;
    }
};

struct Sample {
    double seconds, angle, speed, acceleration;
};

/// Angle and speed between two samples.
Sample between(const Sample& from, const Sample& to, double seconds) {
    const double h = to.seconds - from.seconds;
    const double u = (seconds - from.seconds) / h;
    const double rise = to.angle - from.angle;
    const double v0 = h * from.speed;
    const double v1 = h * to.speed;
    const double a0 = h * h * from.acceleration;
    const double a1 = h * h * to.acceleration;
    const double c3 = 10 * rise - 6 * v0 - 4 * v1 - (3 * a0 - a1) / 2;
    const double c4 = -15 * rise + 8 * v0 + 7 * v1 + (3 * a0 - 2 * a1) / 2;
    const double c5 = 6 * rise - 3 * (v0 + v1) - (a0 - a1) / 2;
    return {seconds, from.angle + u * (v0 + u * (a0 / 2 + u * (c3 + u * (c4 + u * c5)))),
            (v0 + u * (a0 + u * (3 * c3 + u * (4 * c4 + u * 5 * c5)))) / h, 0.0};
}

/// Where a function is 0 that has different signs at 0 and at the end: at the end's side of it.
template <typename Function>
double root(const Function& f, double end, double at_0, double at_end) {
    std::uintmax_t steps = 100;
    return boost::math::tools::toms748_solve(f, 0.0, end, at_0, at_end,
                                             boost::math::tools::eps_tolerance<double>(51), steps)
        .second;
}

/// The energy from which speeds follow: kinetic at one angle, and the potential there.
struct Level {
    double kinetic;    ///< J
    double potential;  ///< J

    double at(const Place& place) const { return kinetic - (place.potential - potential); }
    /// φ̇²; negative where the crank does not come.
    double square(const Place& place) const { return 2.0 * at(place) / place.inertia; }
    /// What rounding leaves of the energies, also by that of the angle after many turns, as a part.
    double noise(const Place& place, double phi) const {
        const double there = at(place);
        const double energy = std::abs(kinetic) + std::abs(potential) + std::abs(place.potential) +
                              std::abs(phi) * (std::abs(place.moment) +
                                               there * std::abs(place.slope) / place.inertia) +
                              there * place.closeness;
        return 4.0 * std::numeric_limits<double>::epsilon() * energy / there;
    }
};

Number turns_of(double angle) {
    return {rounded_to_decimals(std::abs(angle) / two_pi, 4)};
}

Sample sample_of(const Motion& motion, std::size_t i) {
    return {motion.time[i], motion.crank_angle[i], motion.speed[i], motion.acceleration[i]};
}

Sample state_at(const Motion& motion, double seconds) {
    if (motion.time.empty()) {
        return {};
    }
    const auto next = static_cast<std::size_t>(
        std::upper_bound(motion.time.begin(), motion.time.end(), seconds) - motion.time.begin());
    if (next == 0 || next == motion.time.size()) {
        return sample_of(motion, next == 0 ? 0 : next - 1);
    }
    return between(sample_of(motion, next - 1), sample_of(motion, next), seconds);
}

}  // namespace

double Motion::angle_at(double seconds) const {
    return state_at(*this, seconds).angle;
}

double Motion::speed_at(double seconds) const {
    return state_at(*this, seconds).speed;
}

std::optional<double> Motion::time_at(double angle) const {
    for (std::size_t i = 0; i < time.size(); ++i) {
        if (crank_angle[i] == angle) {
            return time[i];
        }
        if (i > 0 && (crank_angle[i - 1] < angle) != (crank_angle[i] < angle)) {
            const auto beyond = [&](double after) { return angle_at(time[i - 1] + after) - angle; };
            return time[i - 1] + root(beyond, time[i] - time[i - 1], crank_angle[i - 1] - angle,
                                      crank_angle[i] - angle);
        }
    }
    return std::nullopt;
}

namespace {

/// A motion from its start to its end, stretch by stretch.
class Run {
  public:
    Run(const Input& input, const Result& result, HingeSet hinges, const MotionProgress& progress,
        double tolerance)
        : design_(*result.design),
          hinges_(hinges),
          guide_(hinges == HingeSet::crank_and_rod ? result.crank_guide_with_rod
                                                   : result.crank_guide),
          wish_(input.motion.value_or(MotionWish{})),
          start_speed_(wish_.start_speed.value_or(input.angular_speed)),
          profile_error_(wish_.with_profile_error ? input.profile_error : 0.0),
          waves_(input.profile_error_waves),
          progress_(progress),
          tolerance_(std::max(tolerance, 1e-8)),
          weight_(potential_amplitude(design_.mechanism())) {
        check_guide();
        const Place first = at(wish_.start_angle);
        const double acceleration = first.acceleration(start_speed_);
        if (!std::isfinite(acceleration) || !(reduced_inertia_at_zero(design_.mechanism()) > 0.0)) {
            throw InputError("/input",
                             Text::tr("must give the crank and the rod together some mass for a "
                                      "motion"));
        }
        // A time in which something happens: of one radian at the start's speed or acceleration.
        const double rate = std::max({std::abs(start_speed_), std::sqrt(std::abs(acceleration)),
                                      1e-6 * design_.angular_speed(), 1e-9});
        longest_ = 50.0 * (wish_.turns * two_pi + 1.0) / rate;
        motion_.min_speed = start_speed_;
        motion_.max_speed = start_speed_;
        level_ = {0.5 * first.inertia * start_speed_ * start_speed_, first.potential};
        scale_ = level_.kinetic;
        // From rest the crank goes where it is accelerated to.
        side_ = (start_speed_ != 0.0 ? start_speed_ : acceleration) < 0.0 ? -1.0 : 1.0;
        record({0.0, wish_.start_angle, start_speed_, acceleration});
    }

    Motion to_end() {
        const auto per_turn =
            static_cast<std::size_t>(std::max(180, profile_error_ != 0.0 ? 8 * waves_ : 0));
        const auto turned = [&](std::size_t stretches) {
            const double turns = static_cast<double>(stretches) / static_cast<double>(per_turn);
            return two_pi * std::min(turns, wish_.turns);
        };
        for (std::size_t i = 1; !done_ && turned(i - 1) < turned(i); ++i) {
            go(wish_.start_angle + side_ * turned(i));
            if (i == per_turn && wish_.crank_torque == 0.0) {
                i += per_turn * repeat_turn();
            }
            if (i % per_turn == 0) {
                report();
            }
        }
        finish();
        return std::move(motion_);
    }

  private:
    void check_guide() const {
        if (!design_.has_exact_kinematics()) {
            throw InputError("/input/lambda",
                             Text::tr("must be less than 1 for a motion: the mechanism locks"),
                             Number{design_.mechanism().lambda});
        }
        if (hinges_ != HingeSet::none && !guide_.feasible) {
            throw InputError(
                "/input/spring",
                {Text::tr("must give a feasible guide for this motion: %1"), guide_.reason});
        }
    }

    /// Near λ = 1 the rod's inertia jumps at the dead centres, and no step is short enough for it;
    /// with waves of the profile's error it is the number of turns.
    void check_work() const {
        constexpr std::size_t maximum = 10'000'000;  // a few seconds
        const double lambda = design_.mechanism().lambda;
        constexpr double nearly_one = 0.999;
        // The work of the rod's hinge is then an integral at each point.
        const bool integrates = lambda > nearly_one && hinges_ == HingeSet::crank_and_rod;
        if (asked_ <= (integrates ? maximum / 400 : maximum)) {
            return;
        }
        if (lambda > nearly_one) {
            throw InputError(
                "/input/lambda",
                {Text::tr("must be further from 1 for a motion: more than %1 points"), asked_},
                Number{lambda});
        }
        throw InputError("/input/motion/turns",
                         {Text::tr("must be less for this motion: %1 points reach only turn %2"),
                          asked_, turns_of(last_.angle - wish_.start_angle)},
                         Number{wish_.turns});
    }

    Place at(double phi) const {
        ++asked_;
        const double s = std::sin(phi);
        const double c = std::cos(phi);
        const auto rod = rod_angle_exact(design_.mechanism().lambda, s, c);
        const auto inertia = reduced_inertia(design_.mechanism(), s, c, rod);
        Place place{inertia.value, inertia.slope,
                    weight_ * s - wish_.crank_torque * (phi - wish_.start_angle),
                    wish_.crank_torque - weight_ * c, 1.0 / (rod.cos_psi * rod.cos_psi)};
        if (hinges_ != HingeSet::none) {
            add_hinges(phi, place);
        }
        return place;
    }

    void add_hinges(double phi, Place& place) const {
        if (hinges_ == HingeSet::crank_and_rod) {
            const Demand demand = design_.demand(Hinge::rod, phi);
            place.potential -= demand.energy;
            place.moment += demand.moment * demand.dpolar;
        }
        const Demand demand = design_.demand(guide_.hinge, phi);
        const GuidePoint point = guide_.shape->at(guide_.branch, demand);
        const auto& spring = guide_.shape->spring();
        const double error = profile_error_ * std::sin(waves_ * phi);
        const double slope = point.slope + profile_error_ * waves_ * std::cos(waves_ * phi);
        const double change = spring.free_length - 2.0 * point.radius;
        // ½ c (change − 2 error)² less what is constant: no difference of large energies.
        place.potential +=
            2.0 * spring.stiffness * (error * (error - change) - guide_.shape->given_out(demand));
        place.moment += 2.0 * spring.stiffness * (change - 2.0 * error) * slope;
    }

    void end(MotionEnd how) {
        motion_.end = how;
        done_ = true;
    }

    void report() {
        const double part =
            std::max(std::abs(last_.angle - wish_.start_angle) / (two_pi * wish_.turns),
                     last_.seconds / longest_);
        if (!done_ && progress_ && !progress_(std::min(part, 1.0))) {
            end(MotionEnd::cancelled);
        }
    }

    void take_speed(double speed) {
        motion_.min_speed = std::min(motion_.min_speed, speed);
        motion_.max_speed = std::max(motion_.max_speed, speed);
    }

    void record(const Sample& sample) {
        motion_.time.push_back(sample.seconds);
        motion_.crank_angle.push_back(sample.angle);
        motion_.speed.push_back(sample.speed);
        motion_.acceleration.push_back(sample.acceleration);
        take_speed(sample.speed);
        last_ = sample;
    }

    /// Where the crank is in a direction from a sample, moving by its energy.
    double square_beyond(const Sample& from, double angle) const {
        return level_.square(at(from.angle + side_ * angle));
    }

    /// Adds what is needed of samples up to an angle.
    void go(double to) {
        if (done_) {
            return;
        }
        check_work();
        const Sample from = last_;
        Sample next{0.0, to, 0.0, 0.0};
        Place place = at(to);
        const bool stops = !(level_.at(place) > 0.0);
        if (stops && from.speed != 0.0) {
            next.angle = from.angle + side_ * root([&](double x) { return square_beyond(from, x); },
                                                   std::abs(to - from.angle),
                                                   from.speed * from.speed, level_.square(place));
            if (next.angle == from.angle) {
                return end(MotionEnd::reversed);
            }
            place = at(next.angle);
        } else if (!stops) {
            next.speed = side_ * std::sqrt(level_.square(place));
        }
        next.acceleration = place.acceleration(next.speed);
        // Shorter ones are lost in the rounding of the angle.
        const double shortest =
            forced_ *
            std::max(1e-11, 64.0 * std::numeric_limits<double>::epsilon() * std::abs(from.angle));
        const Crossing crossing = cross(from, next);
        const bool fits = crossing.error <= 1.0;
        if (!fits && std::abs(next.angle - from.angle) > shortest) {
            const double middle = 0.5 * (from.angle + next.angle);
            go(middle);
            go(to);
            return;
        }
        if (!(crossing.seconds > 0.0 && std::isfinite(crossing.seconds))) {
            // Nothing drives it, or rounding decides.
            return end(from.speed == 0.0 ? MotionEnd::too_slow : MotionEnd::reversed);
        }
        forced_ = fits ? std::max(0.5 * forced_, 1.0) : 2.0 * forced_;
        next.seconds = from.seconds + crossing.seconds;
        pass(from, next, crossing.work);
        if (stops && !done_) {
            end(MotionEnd::reversed);
        }
    }

    struct Crossing {
        double seconds, work;  ///< s, J of all moments
        double error;          ///< of what is read between the samples, in units of what is allowed
    };

    /// Between two samples the angle is that of a constant acceleration, φ = (2 v₀ u + (v₁ − v₀)
    /// u²) / (v₀ + v₁) of the way, u = 0…1, so that also from and to a standstill time is smooth in
    /// u.
    Crossing cross(const Sample& from, const Sample& to) const {
        const double way = to.angle - from.angle;
        const double change = to.speed - from.speed;
        const double sum = from.speed + to.speed;
        if (sum == 0.0) {
            return {0.0, 0.0, std::numeric_limits<double>::infinity()};
        }
        const auto both = boost::math::quadrature::gauss<double, 5>::integrate(
            [&](double u) {
                const double angle = from.angle + way * u * (2.0 * from.speed + change * u) / sum;
                const double slope = 2.0 * way * (from.speed + change * u) / sum;
                const Place place = at(angle);
                const double speed = side_ * std::sqrt(level_.square(place));
                return std::complex<double>(slope / speed, place.moment * slope);
            },
            0.0, 1.0);
        Sample end = to;
        end.seconds = from.seconds + both.real();
        constexpr double worst = 0.276;  // of an interval, where the polynomial's speed is
        const Sample read = between(from, end, std::lerp(from.seconds, end.seconds, worst));
        const Place place = at(read.angle);
        const double speed = side_ * std::sqrt(level_.square(place));
        const double allowed = 0.25 * tolerance_ + level_.noise(place, read.angle);
        return {both.real(), both.imag(),
                std::abs(read.speed - speed) / std::max(std::abs(from.speed), std::abs(to.speed)) /
                    allowed};
    }

    void pass(const Sample& from, Sample next, double work) {
        if ((from.acceleration < 0.0) != (next.acceleration < 0.0)) {  // a maximum or minimum
            const double x = root(
                [&](double way) {
                    const Place place = at(from.angle + side_ * way);
                    return place.acceleration(std::sqrt(std::max(level_.square(place), 0.0)));
                },
                std::abs(next.angle - from.angle), from.acceleration, next.acceleration);
            take_speed(side_ * std::sqrt(std::max(square_beyond(from, x), 0.0)));
        }
        if (next.seconds >= longest_) {
            next = between(from, next, longest_);
            next.acceleration = at(next.angle).acceleration(next.speed);
            end(MotionEnd::too_slow);
        }
        const Place place = at(next.angle);
        const double risen = place.potential - level_.potential;
        work_ += work;
        drift_ = std::max(drift_, std::abs(work_ + risen));
        scale_ = std::max({scale_, level_.at(place), std::abs(risen)});
        record(next);
    }

    /// Without a moment on the crank every turn is like the first.
    /// @return how many more there are
    std::size_t repeat_turn() {
        constexpr std::size_t max_samples = 20'000'000;
        const std::size_t count = motion_.time.size();
        const double seconds = last_.seconds;
        std::size_t turns = 0;
        for (double k = 1.0; !done_ && k + 1.0 <= wish_.turns; ++k, ++turns) {
            for (std::size_t i = 1; i < count; ++i) {
                Sample sample = sample_of(motion_, i);
                sample.seconds += k * seconds;
                sample.angle += k * side_ * two_pi;
                record(sample);
            }
            if (last_.seconds >= longest_ || motion_.time.size() > max_samples) {
                end(MotionEnd::too_slow);
            }
            report();
        }
        return turns;
    }

    /// What the motion comes to, and why it ended.
    void finish() {
        const double turned = last_.angle - wish_.start_angle;
        motion_.mean_speed = last_.seconds > 0.0 ? turned / last_.seconds : 0.0;
        motion_.ripple = motion_.mean_speed != 0.0 ? (motion_.max_speed - motion_.min_speed) /
                                                         std::abs(motion_.mean_speed)
                                                   : 0.0;
        motion_.energy_drift = scale_ > 0.0 ? drift_ / scale_ : 0.0;
        motion_.evaluations = asked_;
        switch (motion_.end) {
            case MotionEnd::completed:
            case MotionEnd::cancelled:
                break;
            case MotionEnd::reversed:
                motion_.reason = {Text::tr("the crank stops after %1 turns and reverses"),
                                  turns_of(turned)};
                break;
            case MotionEnd::too_slow:
                motion_.reason =
                    turned == 0.0
                        ? Message(Text::tr("the crank is at rest"))
                        : Message{Text::tr("the crank made only %1 turns in %2"), turns_of(turned),
                                  Number{last_.seconds, units::second, 6}};
                break;
        }
    }

    const Design& design_;
    HingeSet hinges_;
    const Guide& guide_;
    MotionWish wish_;
    double start_speed_;    ///< rad/s
    double profile_error_;  ///< ε of waves ε sin(n φ) on the crank's guide, m
    int waves_;
    const MotionProgress& progress_;
    double tolerance_;
    double weight_;
    mutable std::size_t asked_ = 0;  ///< places
    Motion motion_;
    Sample last_{};
    double longest_ = 0.0;  ///< time, s
    Level level_{};
    double side_ = 1.0;  ///< which way the crank goes
    double work_ = 0.0;
    double drift_ = 0.0;
    double scale_ = 0.0;
    bool done_ = false;
    double forced_ = 1.0;  ///< grows where even the shortest stretches are not smooth
};

}  // namespace

Motion simulate(const Input& input, const Result& result, HingeSet hinges,
                const MotionProgress& progress, double tolerance) {
    return Run(input, result, hinges, progress, tolerance).to_end();
}

}  // namespace ravnoves::elastic_hinge
