#include "elastic-hinge/motion.h"

#include <algorithm>
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "case-file/decimal.h"
#include "case-file/input_error.h"
#include "numerics/chebyshev.h"

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

/// The one equation of motion, I φ̈ + ½ I′ φ̇² = moment, and its integral, ½ I φ̇² + potential.
class System {
  public:
    System(const Design& design, const Guide& guide, const MotionSetup& setup)
        : design_(design),
          mechanism_(design.mechanism()),
          setup_(setup),
          shape_(setup.hinges == HingeSet::none ? nullptr : guide.shape.get()),
          branch_(guide.branch),
          weight_(potential_amplitude(mechanism_)),
          mean_(design.rod_hinge_mean()) {}

    Place at(double phi) const {
        ++asked_;
        const double s = std::sin(phi);
        const double c = std::cos(phi);
        const auto rod = rod_angle_exact(mechanism_.lambda, s, c);
        const auto inertia = reduced_inertia(mechanism_, s, c, rod);
        Place place{inertia.value, inertia.slope,
                    weight_ * s - setup_.crank_torque * (phi - setup_.start_angle),
                    setup_.crank_torque - weight_ * c, 1.0 / (rod.cos_psi * rod.cos_psi)};
        if (shape_ != nullptr) {
            add_hinges(phi, s, c, rod, inertia, place);
        }
        return place;
    }

    std::size_t asked() const { return asked_; }

  private:
    void add_hinges(double phi, double s, double c, const RodAngle<double>& rod,
                    const ReducedInertia<double>& inertia, Place& place) const {
        const auto rise = energy_rise(mechanism_, design_.angular_speed(), s, c, inertia);
        Demand demand{};
        if (setup_.hinges == HingeSet::crank) {
            demand = design_.demand(Hinge::crank, phi, {}, rise, 0.0);
        } else {
            AngleState state{};
            state.exact = rod;
            state.moment = design_.rod_moment(s, c);
            const double work = design_.rod_work(phi);
            demand = design_.demand(Hinge::crank_with_rod, phi, state, rise, work);
            place.potential += work;
            place.moment -=
                (state.moment.value(design_.angular_speed()) - mean_) * (1.0 + rod.dpsi);
        }
        const GuidePoint point = shape_->at(branch_, demand);
        const auto& spring = shape_->spring();
        const double waves = setup_.profile_error_waves;
        const double error = setup_.profile_error * std::sin(waves * phi);
        const double slope = point.slope + setup_.profile_error * waves * std::cos(waves * phi);
        const double change = spring.free_length - 2.0 * point.radius;
        // ½ c (change − 2 error)² less what is constant: no difference of large energies.
        place.potential +=
            2.0 * spring.stiffness * (error * (error - change) - shape_->given_out(demand));
        place.moment += 2.0 * spring.stiffness * (change - 2.0 * error) * slope;
    }

    const Design& design_;
    const Mechanism<double>& mechanism_;
    const MotionSetup& setup_;
    const GuideShape* shape_;
    Branch branch_;
    double weight_;
    double mean_;
    mutable std::size_t asked_ = 0;
};

constexpr std::size_t cell_points = 16;

const ChebyshevPoints& points() {
    static const ChebyshevPoints list(cell_points);
    return list;
}

struct Node {
    double angle, speed, acceleration;
};
struct Sample : Node {
    double seconds;
};

using State = std::array<double, 2>;  // φ, φ̇

/// Angle and speed between two samples.
State between(const Sample& from, const Sample& to, double seconds) {
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
    return {from.angle + u * (v0 + u * (a0 / 2 + u * (c3 + u * (c4 + u * c5)))),
            (v0 + u * (a0 + u * (3 * c3 + u * (4 * c4 + u * 5 * c5)))) / h};
}

/// A stretch of the motion in one direction, x = −1…1 from its first angle to its last. Where the
/// crank stands still at an end, the angle is quadratic in x there, so that the time is smooth.
struct Cell {
    double begin = 0.0;  ///< rad
    double span = 0.0;   ///< rad, negative backwards
    bool from_rest = false;
    bool to_rest = false;
    std::array<double, cell_points> rate{};      ///< series of dt/dx, s
    std::array<double, cell_points + 1> time{};  ///< and of the time since the first angle
    std::array<Node, cell_points> nodes{};
    std::vector<Sample> samples;  ///< as they were recorded, by the time since the first angle
    double work = 0.0;            ///< of all moments, J
    double potential = 0.0;       ///< at the last angle, J
    double energy = 0.0;          ///< largest kinetic or potential energy, J
    double last_terms = 0.0;      ///< of the rate's series, against the first: what is left out
    double noise = 0.0;           ///< what rounding leaves in the rate, against the same

    double angle(double x) const { return begin + span * part(0.5 * (1.0 + x)); }
    double seconds(double x) const { return chebyshev_value(time, x); }
    double speed(double x) const { return span * slope(x) / chebyshev_value(rate, x); }
    double slope(double x) const {  ///< d part / dx
        return from_rest ? 0.5 * (1.0 + x) : to_rest ? 0.5 * (1.0 - x) : 0.5;
    }
    /// x of a part 0…1 of the span.
    double place(double part_of_span) const {
        const double y = from_rest ? std::sqrt(part_of_span)
                         : to_rest ? 1.0 - std::sqrt(1.0 - part_of_span)
                                   : part_of_span;
        return 2.0 * y - 1.0;
    }

  private:
    double part(double y) const { return from_rest ? y * y : to_rest ? y * (2.0 - y) : y; }
};

/// The energy from which speeds follow: kinetic at one angle, and the potential there.
struct Level {
    double kinetic;    ///< J
    double potential;  ///< J
    double at(const Place& place) const { return kinetic - (place.potential - potential); }
    double speed(const Place& place) const {
        return std::sqrt(2.0 * std::max(at(place), 0.0) / place.inertia);
    }
};

/// Fills a cell whose begin, span and ends are set.
/// @return false where the kinetic energy is not positive at some point, the first being `reached`
bool fill(const System& system, const Level& level, Cell& cell, double& reached) {
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    std::array<double, cell_points> rate{};
    std::array<double, cell_points> power{};
    const double side = cell.span < 0.0 ? -1.0 : 1.0;
    double noise = 0.0;
    for (std::size_t j = 0; j < cell_points; ++j) {
        const double x = points()[j];
        const double phi = cell.angle(x);
        const Place place = system.at(phi);
        const double kinetic = level.at(place);
        if (!(kinetic > 0.0)) {
            reached = phi;
            return false;
        }
        const double speed = side * level.speed(place);
        const double slope = cell.span * cell.slope(x);
        rate[j] = slope / speed;
        power[j] = place.moment * slope;
        cell.nodes[j] = {phi, speed, place.acceleration(speed)};
        // What rounding leaves of the energies, also by that of the angle after many turns.
        const double energy =
            std::abs(level.kinetic) + std::abs(level.potential) + std::abs(place.potential) +
            std::abs(phi) *
                (std::abs(place.moment) + kinetic * std::abs(place.slope) / place.inertia) +
            kinetic * place.closeness;
        noise = std::max(noise, 4.0 * epsilon * rate[j] * energy / kinetic);
        cell.energy = std::max({cell.energy, kinetic, std::abs(kinetic - level.kinetic)});
    }
    points().transform(power, cell.rate);
    chebyshev_integral(cell.rate, cell.time);
    cell.work = chebyshev_value(cell.time, 1.0);
    points().transform(rate, cell.rate);
    chebyshev_integral(cell.rate, cell.time);
    const double whole = 0.5 * cell.rate[0];
    cell.last_terms =
        std::max(std::abs(cell.rate[cell_points - 1]), std::abs(cell.rate[cell_points - 2])) /
        whole;
    cell.noise = noise / whole;
    cell.potential = system.at(cell.angle(1.0)).potential;
    return true;
}

Number turns_of(double angle) {
    return {rounded_to_decimals(std::abs(angle) / two_pi, 4)};
}

/// Near λ = 1 the rod's inertia jumps at the dead centres, and no step is short enough for it; with
/// waves of the profile's error it is the number of turns.
void check_work(std::size_t points, const Design& design, const MotionSetup& setup, double turned) {
    constexpr std::size_t maximum = 10'000'000;  // a few seconds
    const double lambda = design.mechanism().lambda;
    constexpr double nearly_one = 0.999;
    // The work of the rod's hinge is then an integral at each point.
    const bool integrates = lambda > nearly_one && setup.hinges == HingeSet::crank_and_rod;
    if (points <= (integrates ? maximum / 400 : maximum)) {
        return;
    }
    if (lambda > nearly_one) {
        throw InputError(
            "/input/lambda",
            {Text::tr("must be further from 1 for a motion: more than %1 points"), points},
            Number{lambda});
    }
    throw InputError("/input/motion/turns",
                     {Text::tr("must be less for this motion: %1 points reach only turn %2"),
                      points, turns_of(turned)},
                     Number{setup.turns});
}

void check_setup(const Design& design, const Guide& guide, const MotionSetup& setup) {
    if (!design.has_exact_kinematics()) {
        throw InputError("/input/lambda",
                         Text::tr("must be less than 1 for a motion: the mechanism locks"),
                         Number{design.mechanism().lambda});
    }
    if (setup.hinges != HingeSet::none) {
        const Hinge wanted = setup.hinges == HingeSet::crank ? Hinge::crank : Hinge::crank_with_rod;
        if (!guide.feasible || !guide.shape || guide.hinge != wanted) {
            throw InputError(
                "/input/spring",
                guide.reason.empty()
                    ? Message(Text::tr("must give a feasible guide for this motion"))
                    : Message(Text::tr("must give a feasible guide for this motion: %1"),
                              guide.reason));
        }
    }
}

}  // namespace

namespace {

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
    const auto sample = [&](std::size_t i) {
        return Sample{{motion.crank_angle[i], motion.speed[i], motion.acceleration[i]},
                      motion.time[i]};
    };
    return between(sample(next - 1), sample(next), seconds);
}

}  // namespace

double Motion::angle_at(double seconds) const {
    return state_at(*this, seconds)[0];
}

double Motion::speed_at(double seconds) const {
    return state_at(*this, seconds)[1];
}

std::optional<double> Motion::time_at(double angle) const {
    const auto beyond = [&](double seconds) { return angle_at(seconds) - angle; };
    for (std::size_t i = 0; i < time.size(); ++i) {
        if (crank_angle[i] == angle) {
            return time[i];
        }
        if (i > 0 && (crank_angle[i - 1] < angle) != (crank_angle[i] < angle)) {
            std::uintmax_t steps = 100;
            return boost::math::tools::toms748_solve(
                       beyond, time[i - 1], time[i], crank_angle[i - 1] - angle,
                       crank_angle[i] - angle, boost::math::tools::eps_tolerance<double>(50), steps)
                .first;
        }
    }
    return std::nullopt;
}

namespace {

/// A motion from its start to its end, cell by cell.
class Run {
  public:
    Run(const Design& design, const Guide& guide, const MotionSetup& setup,
        const MotionProgress& progress)
        : design_(design), setup_(setup), progress_(progress), system_(design, guide, setup) {
        const Place first = system_.at(setup.start_angle);
        const double acceleration = first.acceleration(setup.start_speed);
        if (!std::isfinite(acceleration) || !(reduced_inertia_at_zero(design.mechanism()) > 0.0)) {
            throw InputError("/input",
                             Text::tr("must give the crank and the rod together some mass for a "
                                      "motion"));
        }
        // A time in which something happens: of one radian at the start's speed or acceleration.
        const double rate =
            std::max({std::abs(setup.start_speed), std::sqrt(std::abs(acceleration)),
                      1e-6 * design.angular_speed(), 1e-9});
        longest_ = 50.0 * (setup.turns * two_pi + 1.0) / rate;
        motion_.min_speed = setup.start_speed;
        motion_.max_speed = setup.start_speed;
        record(0.0, setup.start_angle, setup.start_speed, acceleration);
        level_ = {0.5 * first.inertia * setup.start_speed * setup.start_speed, first.potential};
        start_potential_ = first.potential;
        scale_ = level_.kinetic;
        // From rest the crank goes where it is accelerated to.
        side_ = (setup.start_speed != 0.0 ? setup.start_speed : acceleration) < 0.0 ? -1.0 : 1.0;
    }

    Motion to_end() {
        while (!done_) {
            check_work(system_.asked(), design_, setup_, phi_ - setup_.start_angle);
            Cell cell;
            cell.begin = phi_;
            cell.from_rest = at_rest_;
            // Shorter ones are lost in the rounding of the angle.
            const double rounding = std::numeric_limits<double>::epsilon() * std::abs(phi_);
            const double shortest_cell = forced_ * std::max(1e-11, 64.0 * rounding);
            // Cells end at whole turns.
            const double slack = 1e-12 + rounding;
            const double gone = std::abs(phi_ - setup_.start_angle) / two_pi;
            const double to_turn = (std::floor(gone + slack) + 1.0 - gone) * two_pi;
            const double to_stop = std::isnan(stop_) ? 2.0 * to_turn : side_ * (stop_ - phi_);
            if (!(to_stop > 0.0) && !at_rest_) {
                stop();
                break;
            }
            cell.to_rest = std::min(span_, to_turn) > 0.999 * to_stop;
            if (cell.to_rest && at_rest_) {  // not at both ends
                cell.to_rest = false;
                span_ = 0.5 * to_stop;
            }
            cell.span = side_ * (cell.to_rest ? to_stop : std::min(span_, to_turn));
            double reached = 1.0;
            const bool filled = fill(system_, level_, cell, reached);
            // Rounding may spoil the last places before a stop; a stop well before one is another.
            if (!filled && (std::isnan(stop_) || side_ * (reached - phi_) < 0.9 * to_stop)) {
                if (find_stop(cell, reached)) {
                    continue;
                }
            }
            if (filled && !std::isfinite(cell.last_terms)) {
                throw std::runtime_error("the motion left the range of numbers");
            }
            if (!filled || cell.last_terms > setup_.tolerance + cell.noise) {
                if (std::abs(cell.span) > shortest_cell) {
                    span_ = 0.5 * std::abs(cell.span);
                    continue;
                }
                if (!filled && !at_rest_) {
                    stop();
                    break;
                }
                if (!filled) {  // nothing drives it
                    motion_.end = MotionEnd::too_slow;
                    break;
                }
                forced_ *= 2.0;
            } else {
                forced_ = std::max(0.5 * forced_, 1.0);
            }
            // A cell that a turn's end cut short says nothing of how long the next one may be.
            const bool has_room = cell.last_terms < 1e-3 * setup_.tolerance + cell.noise;
            span_ = std::min(std::max(span_, (has_room ? 2.0 : 1.0) * std::abs(cell.span)),
                             longest_cell);
            pass(cell, 0.0);
            at_rest_ = false;
            if (done_) {
                break;
            }
            if (cell.to_rest) {
                stop();
                break;
            }
            if (setup_.crank_torque != 0.0) {
                continue;  // else every turn is like the first
            }
            turn_.push_back(cell);
            repeat_turn(slack);
        }
        finish();
        return std::move(motion_);
    }

  private:
    void take_speed(double speed) {
        motion_.min_speed = std::min(motion_.min_speed, speed);
        motion_.max_speed = std::max(motion_.max_speed, speed);
    }

    void record(double time, double angle, double speed, double acceleration) {
        motion_.time.push_back(time);
        motion_.crank_angle.push_back(angle);
        motion_.speed.push_back(speed);
        motion_.acceleration.push_back(acceleration);
        take_speed(speed);
    }

    /// Takes the speed where it is a maximum or minimum between two nodes.
    void take_node(const Node& node) {
        const auto last = std::exchange(last_node_, node);
        if (!last || (last->acceleration < 0.0) == (node.acceleration < 0.0)) {
            take_speed(node.speed);
            return;
        }
        const double reach = std::max(std::abs(last->acceleration), std::abs(node.acceleration)) *
                             std::abs((node.angle - last->angle) / node.speed);
        const bool counts =
            node.speed + reach > motion_.max_speed || node.speed - reach < motion_.min_speed;
        if (counts && reach > 1e-13 * std::abs(node.speed)) {
            std::uintmax_t tries = 60;
            const auto bracket = boost::math::tools::toms748_solve(
                [&](double angle) {
                    const Place place = system_.at(angle);
                    return place.acceleration(level_.speed(place));
                },
                std::min(last->angle, node.angle), std::max(last->angle, node.angle),
                last->angle < node.angle ? last->acceleration : node.acceleration,
                last->angle < node.angle ? node.acceleration : last->acceleration,
                boost::math::tools::eps_tolerance<double>(40), tries);
            take_speed(side_ * level_.speed(system_.at(bracket.second)));
        }
        take_speed(node.speed);
    }

    void take_samples(Cell& cell, double end, int parts) {
        cell.samples.clear();
        for (int part = 1; part <= parts; ++part) {
            const double x = part == parts ? end : -1.0 + (end + 1.0) * part / parts;
            const double angle = cell.angle(x);
            const Place place = system_.at(angle);
            const double speed = cell.slope(x) > 0.0 ? side_ * level_.speed(place) : 0.0;
            cell.samples.push_back({{angle, speed, place.acceleration(speed)}, cell.seconds(x)});
        }
    }

    /// What is read between samples has to be as good as they are.
    void sample(Cell& cell, double end) {
        constexpr double fewest = 8.0;
        constexpr double maximum = 1000.0;
        const double parts = std::clamp(
            std::ceil(std::abs(cell.angle(end) - cell.begin) / sample_angle_), fewest, maximum);
        take_samples(cell, end, static_cast<int>(parts));
        double error = 0.0;
        double fastest = 0.0;
        for (std::size_t i = 1; i < cell.samples.size(); ++i) {
            constexpr double worst = 0.276;  // of an interval, where the polynomial's speed is
            const double part = static_cast<double>(i) + worst;
            const double x = -1.0 + (end + 1.0) * part / parts;
            const State read = between(cell.samples[i - 1], cell.samples[i], cell.seconds(x));
            const double speed = cell.speed(x);
            error = std::max(error, std::abs(read[1] - speed));
            fastest = std::max(fastest, std::abs(speed));
        }
        // Of order 5; beyond four times as many it is the time's error that is seen.
        const double allowed = 0.25 * std::max(setup_.tolerance, 1e-8) * fastest;
        if (error > allowed) {
            const double finer = std::min(1.1 * std::pow(error / allowed, 0.2), 4.0);
            take_samples(cell, end, static_cast<int>(std::min(std::ceil(finer * parts), maximum)));
        }
    }

    /// Goes through a cell, new or used again some turns further, as far as angle and time allow.
    void pass(Cell& cell, double turns_before) {
        double end = 1.0;
        const double left = wanted_ - side_ * (phi_ - setup_.start_angle);
        if (left <= std::abs(cell.span) + 1e-15 * wanted_) {
            end = std::min(cell.place(std::clamp(left / std::abs(cell.span), 0.0, 1.0)), 1.0);
            motion_.end = MotionEnd::completed;
            done_ = true;
        }
        const bool at_limit = time_ + cell.seconds(end) >= longest_;
        if (at_limit) {
            std::uintmax_t tries = 60;
            end = boost::math::tools::toms748_solve(
                      [&](double x) { return time_ + cell.seconds(x) - longest_; }, -1.0, end,
                      time_ - longest_, time_ + cell.seconds(end) - longest_,
                      boost::math::tools::eps_tolerance<double>(50), tries)
                      .second;
            motion_.end = MotionEnd::too_slow;
            done_ = true;
        }
        if (turns_before == 0.0) {
            for (std::size_t j = 0; j < cell_points && points()[j] <= end; ++j) {
                take_node(cell.nodes[j]);
            }
            work_ += cell.work;
            scale_ = std::max(scale_, cell.energy);
            drift_ = std::max(drift_, std::abs(work_ + (cell.potential - start_potential_)));
        }
        if (turns_before == 0.0 || end < 1.0) {
            sample(cell, end);
        }
        for (const Sample& point : cell.samples) {
            record(time_ + point.seconds, side_ * two_pi * turns_before + point.angle, point.speed,
                   point.acceleration);
        }
        if (at_limit) {
            motion_.time.back() = longest_;
        }
        time_ = motion_.time.back();
        phi_ = motion_.crank_angle.back();
        ++motion_.steps;
        if (motion_.time.size() >= max_samples && !done_) {
            motion_.end = MotionEnd::too_slow;
            done_ = true;
        }
        if (progress_ && (done_ || motion_.steps % 256 == 0)) {
            const double part =
                done_ ? 1.0
                      : std::max(std::abs(phi_ - setup_.start_angle) / wanted_, time_ / longest_);
            if (!progress_(std::min(part, 1.0)) && !done_) {
                motion_.end = MotionEnd::cancelled;
                done_ = true;
            }
        }
    }

    /// The crank has stopped and would turn back.
    void stop() {
        motion_.end = MotionEnd::reversed;
        done_ = true;
    }

    /// Where the crank stops on the way through a cell: after the last point that moves.
    /// @param reached  an angle that it does not reach
    bool find_stop(const Cell& cell, double reached) {
        const auto kinetic = [&](double angle) { return level_.at(system_.at(angle)); };
        double from = phi_;
        for (std::size_t j = 0; j < cell_points; ++j) {
            const double angle = cell.angle(points()[j]);
            from = side_ * (reached - angle) > 0.0 ? angle : from;
        }
        const double a = kinetic(from);
        const double b = kinetic(reached);
        if (a > 0.0 && b < 0.0) {
            std::uintmax_t tries = 80;
            const auto bracket = boost::math::tools::toms748_solve(
                kinetic, std::min(from, reached), std::max(from, reached), side_ > 0.0 ? a : b,
                side_ > 0.0 ? b : a, boost::math::tools::eps_tolerance<double>(52), tries);
            stop_ = side_ > 0.0 ? bracket.first : bracket.second;
            return true;
        }
        return false;
    }

    /// Goes on by the cells of a turn that is whole.
    void repeat_turn(double slack) {
        const double turned = std::abs(phi_ - turn_.front().begin);
        for (double turns = 1.0; !done_ && turned > two_pi * (1.0 - slack); ++turns) {
            for (std::size_t i = 0; i < turn_.size() && !done_; ++i) {
                pass(turn_[i], turns);
            }
        }
    }

    /// What the motion comes to, and why it ended.
    void finish() {
        const double turned = motion_.crank_angle.back() - setup_.start_angle;
        motion_.mean_speed = motion_.time.back() > 0.0 ? turned / motion_.time.back() : 0.0;
        motion_.ripple = motion_.mean_speed != 0.0 ? (motion_.max_speed - motion_.min_speed) /
                                                         std::abs(motion_.mean_speed)
                                                   : 0.0;
        motion_.energy_drift = scale_ > 0.0 ? drift_ / scale_ : 0.0;
        motion_.evaluations = system_.asked();
        switch (motion_.end) {
            case MotionEnd::completed:
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
                                  Number{motion_.time.back(), units::second, 6}};
                break;
            case MotionEnd::cancelled:
                motion_.reason = {Text::tr("cancelled after %1 turns"), turns_of(turned)};
                break;
        }
    }

    static constexpr std::size_t max_samples = 20'000'000;
    static constexpr double longest_cell = two_pi / 4.0;
    static constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

    const Design& design_;
    const MotionSetup& setup_;
    const MotionProgress& progress_;
    System system_;
    Motion motion_;
    double wanted_ = setup_.turns * two_pi;
    double longest_ = 0.0;  ///< time, s
    double sample_angle_ = two_pi / std::max(setup_.samples_per_turn, 4);
    Level level_{};
    double start_potential_ = 0.0;
    double side_ = 1.0;  ///< which way the crank goes
    bool at_rest_ = setup_.start_speed == 0.0;
    double phi_ = setup_.start_angle;
    double time_ = 0.0;
    double work_ = 0.0;
    double drift_ = 0.0;
    double scale_ = 0.0;
    bool done_ = false;
    std::optional<Node> last_node_;
    std::vector<Cell> turn_;
    double span_ = two_pi / 8.0;
    double stop_ = nowhere;  ///< the angle at which the crank will stop, where that is known
    double forced_ = 1.0;    ///< grows where even the shortest cells are not smooth
};

}  // namespace

Motion simulate(const std::shared_ptr<const Design>& design, const Guide& crank_guide,
                const MotionSetup& setup, const MotionProgress& progress) {
    check_setup(*design, crank_guide, setup);
    return Run(*design, crank_guide, setup, progress).to_end();
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
