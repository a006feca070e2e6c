#include "balance-shaft/rod_sweep.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

namespace ravnoves::balance_shaft {

RodSweep::RodSweep(const FrontView& view) : crank_(view.crank()) {
    const double length2 = crank_.rod_length * crank_.rod_length;
    per_length2_ = length2 > 0.0 ? 1.0 / length2 : 0.0;
    for (std::size_t i = 0; i < samples; ++i) {
        const Rod rod = rod_at(step * static_cast<double>(i));
        x_[i] = rod.x;
        y_[i] = rod.y;
        along_x_[i] = rod.along_x;
        along_y_[i] = rod.along_y;
    }
    // |s'| between the samples: a bound from r and the steepest rod.
    const double across = crank_.crank_radius + std::abs(crank_.offset);
    const double upright2 = length2 - across * across;
    const double tangent =
        upright2 > 0.0 ? across / std::sqrt(upright2) : std::numeric_limits<double>::infinity();
    motion_ = crank_.crank_radius * std::hypot(1.0, tangent) * step;
    left_ = bottom_ = std::numeric_limits<double>::infinity();
    right_ = top_ = -left_;
    for (std::size_t i = 0; i < samples; ++i) {
        for (const double t : {0.0, 1.0}) {
            left_ = std::min(left_, x_[i] + t * along_x_[i]);
            right_ = std::max(right_, x_[i] + t * along_x_[i]);
            bottom_ = std::min(bottom_, y_[i] + t * along_y_[i]);
            top_ = std::max(top_, y_[i] + t * along_y_[i]);
        }
    }
}

RodSweep::Rod RodSweep::rod_at(double theta) const {
    const double x = crank_.crank_radius * std::sin(theta);
    const double y = crank_.crank_radius * std::cos(theta);
    return {x, y, crank_.offset - x, crank_.at(theta).s - y};
}

double RodSweep::square(const Rod& rod, double x, double y) const {
    const double to_x = x - rod.x;
    const double to_y = y - rod.y;
    const double along = to_x * rod.along_x + to_y * rod.along_y;
    const double t = std::clamp(along * per_length2_, 0.0, 1.0);
    const double dx = to_x - t * rod.along_x;
    const double dy = to_y - t * rod.along_y;
    return dx * dx + dy * dy;
}

double RodSweep::squares(double x, double y, Column& out) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < samples; ++i) {
        out[i] = square({x_[i], y_[i], along_x_[i], along_y_[i]}, x, y);
        least = std::min(least, out[i]);
    }
    return least;
}

/// Where the square of the distance is least: its slope changes sign once beside the least sample.
double RodSweep::flat_between(double low, double high, double x, double y) const {
    const auto slope = [&](double theta) {
        const double sin = std::sin(theta);
        const double cos = std::cos(theta);
        const auto piston = crank_.at(theta);
        const Rod rod{crank_.crank_radius * sin, crank_.crank_radius * cos,
                      crank_.offset - crank_.crank_radius * sin,
                      piston.s - crank_.crank_radius * cos};
        const double to_x = x - rod.x;
        const double to_y = y - rod.y;
        const double t =
            std::clamp((to_x * rod.along_x + to_y * rod.along_y) * per_length2_, 0.0, 1.0);
        const double pin_x = crank_.crank_radius * cos;
        const double pin_y = -crank_.crank_radius * sin;
        return -((to_x - t * rod.along_x) * (1.0 - t) * pin_x +
                 (to_y - t * rod.along_y) * ((1.0 - t) * pin_y + t * piston.ds));
    };
    const double slope_low = slope(low);
    const double slope_high = slope(high);
    if (!(slope_low < 0.0 && slope_high > 0.0)) {
        return boost::math::tools::brent_find_minima(
                   [&](double theta) { return square(rod_at(theta), x, y); }, low, high, 26)
            .first;
    }
    std::uintmax_t tries = 40;
    // The distance is flat there: half of a double's digits are enough.
    const auto [left, right] =
        boost::math::tools::toms748_solve(slope, low, high, slope_low, slope_high,
                                          boost::math::tools::eps_tolerance<double>(30), tries);
    return left + (right - left) / 2.0;
}

RodSweep::Nearest RodSweep::nearest(double x, double y) const {
    Column square_at;
    double least = squares(x, y, square_at);
    double angle = 0.0;
    for (std::size_t i = 0; i < samples; ++i) {
        const double before = square_at[(i + samples - 1) % samples];
        const double after = square_at[(i + 1) % samples];
        const double theta = step * static_cast<double>(i);
        if (square_at[i] == least) {
            angle = theta;
        }
        // A minimum between samples is below them by no more than the rod moves.
        if (square_at[i] <= before && square_at[i] <= after &&
            std::sqrt(square_at[i]) - motion_ <= std::sqrt(least)) {
            const double at = flat_between(theta - step, theta + step, x, y);
            const double value = square(rod_at(at), x, y);
            if (value <= least) {
                least = value;
                angle = at;
            }
        }
    }
    const Rod rod = rod_at(angle);
    const double along = (x - rod.x) * rod.along_x + (y - rod.y) * rod.along_y;
    const double t = std::clamp(along * per_length2_, 0.0, 1.0);
    return {std::sqrt(least), rod.x + t * rod.along_x, rod.y + t * rod.along_y};
}

bool RodSweep::is_clear(double x, double y, double needed) const {
    const double beside = std::max({left_ - x, x - right_, 0.0});
    const double above = std::max({bottom_ - y, y - top_, 0.0});
    const double motion = motion_ / 2.0;
    if (std::hypot(beside, above) - motion >= needed) {
        return true;
    }
    Column square_at;
    const double least = std::sqrt(squares(x, y, square_at));
    if (least < needed) {
        return false;
    }
    return least - motion >= needed || distance(x, y) >= needed;
}

}  // namespace ravnoves::balance_shaft
