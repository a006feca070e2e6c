#include "balance-shaft/flywheel.h"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <limits>

#include "numerics/angle.h"

namespace ravnoves::balance_shaft {

namespace {

using Cubic = PeriodicPiecewise::Cubic;

/// ∫ (p − mean) dt over (0, t), t in degrees: N·m·°.
double excess_of(const Cubic& p, double mean, double t) {
    return t * (p.y - mean + t * (p.c1 / 2.0 + t * (p.c2 / 3.0 + t * p.c3 / 4.0)));
}

/// The places in (0, h) where the piece crosses the level, and where it is stationary: between the
/// latter it is monotone.
std::vector<double> crossings(const Cubic& p, double level, double h) {
    std::vector<double> ends{0.0};
    // Of c1 + 2 c2 t + 3 c3 t², without cancellation.
    const double discriminant = p.c2 * p.c2 - 3.0 * p.c1 * p.c3;
    if (discriminant >= 0.0) {
        const double q = -(p.c2 + std::copysign(std::sqrt(discriminant), p.c2));
        for (const double t : {q / (3.0 * p.c3), p.c1 / q}) {
            if (t > 0.0 && t < h) {  // false for what is not a number
                ends.push_back(t);
            }
        }
    }
    ends.push_back(h);
    std::sort(ends.begin(), ends.end());
    const auto above = [&](double t) { return p.value(t) - level; };
    std::vector<double> found(ends.begin() + 1, ends.end() - 1);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const double left = above(ends[i]);
        const double right = above(ends[i + 1]);
        if (left * right < 0.0) {
            std::uintmax_t steps = 100;
            const auto [low, high] = boost::math::tools::toms748_solve(
                above, ends[i], ends[i + 1], left, right,
                boost::math::tools::eps_tolerance<double>(), steps);
            found.push_back((low + high) / 2.0);
        }
    }
    return found;
}

}  // namespace

Flywheel flywheel(const PeriodicPiecewise& torque, double angular_speed,
                  const std::optional<FlywheelTarget>& target,
                  const std::vector<double>& angles_deg) {
    const double mean = torque.mean();
    const std::vector<double>& knots = torque.knots();
    Flywheel result;
    // Energies in N·m·° from the first knot; every extremum is a crossing or (a kink or a jump of a
    // nearly steep line) a knot.
    std::vector<double> at_knot{0.0};
    at_knot.reserve(knots.size());
    double highest = -std::numeric_limits<double>::infinity();
    double lowest = std::numeric_limits<double>::infinity();
    const auto offer = [&](double energy, double angle) {
        if (energy > highest) {
            highest = energy;
            result.max_angle = angle;
        }
        if (energy < lowest) {
            lowest = energy;
            result.min_angle = angle;
        }
    };
    for (std::size_t i = 0; i < torque.size(); ++i) {
        const Cubic& piece = torque.pieces()[i];
        const double h = knots[i + 1] - knots[i];
        offer(at_knot[i], knots[i]);
        for (const double t : crossings(piece, mean, h)) {
            offer(at_knot[i] + excess_of(piece, mean, t), knots[i] + t);
        }
        at_knot.push_back(at_knot[i] + excess_of(piece, mean, h));
    }
    const auto energy_at = [&](double angle) {
        const auto place = torque.find(angle);
        return at_knot[place.piece] + excess_of(torque.pieces()[place.piece], mean, place.t);
    };
    const double zero = energy_at(0.0);
    result.max_angle = wrap(result.max_angle, torque.period()) * degree;
    result.min_angle = wrap(result.min_angle, torque.period()) * degree;
    result.max_energy = (highest - zero) * degree;
    result.min_energy = (lowest - zero) * degree;
    result.excess_work = (highest - lowest) * degree;
    result.energy.reserve(angles_deg.size());
    for (const double angle : angles_deg) {
        result.energy.push_back((energy_at(angle) - zero) * degree);
    }
    if (target) {
        const double square = angular_speed * angular_speed;
        result.inertia = target->inertia;
        result.fluctuation = target->fluctuation;
        if (target->inertia) {
            result.fluctuation = result.excess_work / (*target->inertia * square);
        } else if (target->fluctuation) {
            result.inertia = result.excess_work / (*target->fluctuation * square);
        }
    }
    return result;
}

}  // namespace ravnoves::balance_shaft
