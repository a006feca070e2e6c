#include "numerics/extrema.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "numerics/constants.h"

namespace ravnoves {

namespace {

/// The root of a monotone function in [low, high], at whose ends it has the signs of f_low and
/// f_high: Newton's step where it stays in the bracket, else bisection.
template <typename Function>
double bracketed_root(const Function& value_and_slope, double low, double high, double f_low) {
    const double rounding = 2 * std::numeric_limits<double>::epsilon();
    double t = (low + high) / 2;
    double previous_width = high - low;
    for (int iteration = 0; iteration < 200; ++iteration) {
        const auto [value, slope] = value_and_slope(t);
        if (value == 0) {
            return t;
        }
        ((value > 0) == (f_low > 0) ? low : high) = t;
        double next = t - value / slope;
        const double width = high - low;
        // Newton must also shrink the bracket or take small steps; else bisect.
        const bool usable =
            next > low && next < high && (std::abs(next - t) < previous_width / 2 || iteration < 3);
        if (!usable) {
            next = (low + high) / 2;
        }
        if (next <= low || next >= high ||
            std::abs(next - t) <= rounding * std::max(std::abs(t), std::abs(next))) {
            return next;
        }
        previous_width = usable ? std::abs(next - t) : width;
        t = next;
    }
    return t;
}

/// Ends and inner points of [0, h] at which a monotone stretch of a function begins or ends.
Places with_ends(const Places& inner, double h) {
    Places all;
    all.push_back(0.0);
    for (const double t : inner) {
        all.push_back(t);
    }
    all.push_back(h);
    return all;
}

template <typename Function>
Places roots_between(const Function& value_and_slope, const Places& ends) {
    Places roots;
    double left = value_and_slope(ends[0]).first;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const double right = value_and_slope(ends[i + 1]).first;
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

Places stationary_points(const PiecewiseCubic& p, double amplitude, double angular_frequency,
                         double phase, double h) {
    const double w = angular_frequency;
    const auto first = [&](double t) {
        const double angle = w * t + phase;
        const double c = amplitude * std::cos(angle);
        const double s = amplitude * std::sin(angle);
        return std::pair<double, double>(p.slope(t) + w * c, 2 * p.c2 + 6 * p.c3 * t - w * w * s);
    };
    // No stationary point where the slopes at the ends are of one sign and larger than the
    // curvature can bend back.
    const double slope_left = first(0.0).first;
    const double slope_right = first(h).first;
    const double curvature =
        2 * std::max(std::abs(p.c2), std::abs(p.c2 + 3 * p.c3 * h)) + w * w * amplitude;
    if (slope_left * slope_right > 0 &&
        std::abs(slope_left) + std::abs(slope_right) > curvature * h) {
        return {};
    }

    const auto second = [&](double t) {
        const double angle = w * t + phase;
        return std::pair<double, double>(
            2 * p.c2 + 6 * p.c3 * t - w * w * amplitude * std::sin(angle),
            6 * p.c3 - w * w * w * amplitude * std::cos(angle));
    };
    // Third derivative: 6 c₃ − A ω³ cos(ωt + φ₀) = 0.
    Places bends;
    const double third = w * w * w * amplitude;
    if (std::abs(6 * p.c3) < third) {
        const double angle = std::acos(6 * p.c3 / third);
        const double first_turn = std::floor((phase - angle) / two_pi);
        for (int turn = 0; turn <= 3; ++turn) {
            for (const int sign : {-1, 1}) {
                const double t = (sign * angle + (first_turn + turn) * two_pi - phase) / w;
                if (t > 0 && t < h) {
                    bends.push_back(t);
                }
            }
        }
    }
    const Places inflections = roots_between(second, with_ends(bends, h));
    return roots_between(first, with_ends(inflections, h));
}

}  // namespace ravnoves
