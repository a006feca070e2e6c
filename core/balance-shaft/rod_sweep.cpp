#include "balance-shaft/rod_sweep.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>

namespace ravnoves::balance_shaft {

RodSweep::RodSweep(const FrontView& view) : crank_(view.crank()) {
    const double length2 = crank_.rod_length * crank_.rod_length;
    per_length2_ = length2 > 0.0 ? 1.0 / length2 : 0.0;
    for (Eigen::Index i = 0; i < samples; ++i) {
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
    const Column to_x = x - x_;
    const Column to_y = y - y_;
    const Column t = ((to_x * along_x_ + to_y * along_y_) * per_length2_).max(0.0).min(1.0);
    out = (to_x - t * along_x_).square() + (to_y - t * along_y_).square();
    return out.minCoeff();
}

/// Where the square of the distance is smallest within a step of a sample that lies no higher than
/// its neighbours: it is flat there, so half of a double's digits of the angle are enough.
RodSweep::Rod RodSweep::lowest_beside(Eigen::Index sample, double x, double y) const {
    const double theta = step * static_cast<double>(sample);
    const auto square_at = [&](double angle) { return square(rod_at(angle), x, y); };
    constexpr int bits = 26;
    return rod_at(
        boost::math::tools::brent_find_minima(square_at, theta - step, theta + step, bits).first);
}

RodSweep::Nearest RodSweep::nearest(double x, double y) const {
    return nearer_than(x, y, std::numeric_limits<double>::infinity()).value();
}

std::optional<RodSweep::Nearest> RodSweep::nearer_than(double x, double y, double needed) const {
    Column square_at;
    const double minimum = squares(x, y, square_at);
    if (std::sqrt(minimum) - motion_ / 2.0 >= needed) {
        return std::nullopt;
    }
    // A minimum between samples is below them by no more than the rod moves.
    const double reach = std::sqrt(minimum) + motion_;
    const double candidate = reach * reach * (1.0 + 1e-12);
    Rod rod{};
    double best = std::numeric_limits<double>::infinity();
    for (Eigen::Index i = 0; i < samples; ++i) {
        if (square_at[i] > candidate) {
            continue;
        }
        const double before = square_at[i == 0 ? samples - 1 : i - 1];
        const double after = square_at[i + 1 == samples ? 0 : i + 1];
        if (square_at[i] <= before && square_at[i] <= after) {
            const Rod lowest = lowest_beside(i, x, y);
            const double value = square(lowest, x, y);
            if (value < best) {
                best = value;
                rod = lowest;
            }
        }
        if (square_at[i] < best) {
            best = square_at[i];
            rod = {x_[i], y_[i], along_x_[i], along_y_[i]};
        }
    }
    const double along = (x - rod.x) * rod.along_x + (y - rod.y) * rod.along_y;
    const double t = std::clamp(along * per_length2_, 0.0, 1.0);
    const Nearest found{std::sqrt(best), rod.x + t * rod.along_x, rod.y + t * rod.along_y};
    return found.distance < needed ? std::optional(found) : std::nullopt;
}

}  // namespace ravnoves::balance_shaft
