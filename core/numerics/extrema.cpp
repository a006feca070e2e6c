#include "numerics/extrema.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "numerics/real50.h"

namespace ravnoves {

namespace {

/// The root of a monotone function in [low, high], at whose ends it has the signs of f_low and
/// f_high: Newton's step where it stays in the bracket, else bisection.
template <typename Scalar, typename Function>
Scalar bracketed_root(const Function& value_and_slope, Scalar low, Scalar high,
                      const Scalar& f_low) {
    using std::abs;
    const Scalar rounding = 2 * std::numeric_limits<Scalar>::epsilon();
    Scalar t = (low + high) / 2;
    Scalar previous_width = high - low;
    for (int iteration = 0; iteration < 200; ++iteration) {
        const auto [value, slope] = value_and_slope(t);
        if (value == 0) {
            return t;
        }
        ((value > 0) == (f_low > 0) ? low : high) = t;
        Scalar next = t - value / slope;
        const Scalar width = high - low;
        // Newton must also shrink the bracket or take small steps; else bisect.
        const bool usable =
            next > low && next < high && (abs(next - t) < previous_width / 2 || iteration < 3);
        if (!usable) {
            next = (low + high) / 2;
        }
        if (next <= low || next >= high ||
            abs(next - t) <= rounding * std::max(Scalar(abs(t)), Scalar(abs(next)))) {
            return next;
        }
        previous_width = usable ? abs(next - t) : width;
        t = next;
    }
    return t;
}

/// Ends and inner points of [0, h] at which a monotone stretch of a function begins or ends.
template <typename Scalar>
BasicPlaces<Scalar> with_ends(const BasicPlaces<Scalar>& inner, const Scalar& h) {
    BasicPlaces<Scalar> all;
    all.push_back(Scalar(0));
    for (const Scalar& t : inner) {
        all.push_back(t);
    }
    all.push_back(h);
    return all;
}

template <typename Scalar, typename Function>
BasicPlaces<Scalar> roots_between(const Function& value_and_slope,
                                  const BasicPlaces<Scalar>& ends) {
    BasicPlaces<Scalar> roots;
    Scalar left = value_and_slope(ends[0]).first;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const Scalar right = value_and_slope(ends[i + 1]).first;
        if ((left > 0 && right < 0) || (left < 0 && right > 0)) {
            roots.push_back(bracketed_root(value_and_slope, ends[i], ends[i + 1], left));
        } else if (right == 0 && i + 2 < ends.size()) {
            roots.push_back(ends[i + 1]);
        }
        left = right;
    }
    return roots;
}

}  // namespace

template <typename Scalar>
BasicPlaces<Scalar> stationary_points(const PiecewiseCubic<Scalar>& p, const Scalar& amplitude,
                                      const Scalar& angular_frequency, const Scalar& phase,
                                      const Scalar& h) {
    using std::abs;
    using std::acos;
    using std::cos;
    using std::floor;
    using std::sin;
    const Scalar& two_pi = boost::math::constants::two_pi<Scalar>();
    const Scalar& w = angular_frequency;
    const auto first = [&](const Scalar& t) {
        const Scalar angle = w * t + phase;
        const Scalar c = amplitude * cos(angle);
        const Scalar s = amplitude * sin(angle);
        return std::pair<Scalar, Scalar>(p.slope(t) + w * c, 2 * p.c2 + 6 * p.c3 * t - w * w * s);
    };
    // No stationary point where the slopes at the ends are of one sign and larger than the
    // curvature can bend back.
    const Scalar slope_left = first(Scalar(0)).first;
    const Scalar slope_right = first(h).first;
    const Scalar curvature =
        2 * std::max(Scalar(abs(p.c2)), Scalar(abs(Scalar(p.c2 + 3 * p.c3 * h)))) +
        w * w * amplitude;
    if (slope_left * slope_right > 0 && abs(slope_left) + abs(slope_right) > curvature * h) {
        return {};
    }

    const auto second = [&](const Scalar& t) {
        const Scalar angle = w * t + phase;
        return std::pair<Scalar, Scalar>(2 * p.c2 + 6 * p.c3 * t - w * w * amplitude * sin(angle),
                                         6 * p.c3 - w * w * w * amplitude * cos(angle));
    };
    // Third derivative: 6 c₃ − A ω³ cos(ωt + φ₀) = 0.
    BasicPlaces<Scalar> bends;
    const Scalar third = w * w * w * amplitude;
    if (abs(6 * p.c3) < third) {
        const Scalar angle = acos(Scalar(6 * p.c3 / third));
        const Scalar first_turn = floor(Scalar((phase - angle) / two_pi));
        for (int turn = 0; turn <= 3; ++turn) {
            for (const int sign : {-1, 1}) {
                const Scalar t = (sign * angle + (first_turn + turn) * two_pi - phase) / w;
                if (t > 0 && t < h) {
                    bends.push_back(t);
                }
            }
        }
    }
    const BasicPlaces<Scalar> inflections = roots_between(second, with_ends(bends, h));
    return roots_between(first, with_ends(inflections, h));
}

template BasicPlaces<double> stationary_points(const PiecewiseCubic<double>&, const double&,
                                               const double&, const double&, const double&);
template BasicPlaces<Real50> stationary_points(const PiecewiseCubic<Real50>&, const Real50&,
                                               const Real50&, const Real50&, const Real50&);

}  // namespace ravnoves
