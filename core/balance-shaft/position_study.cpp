#include "balance-shaft/position_study.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "balance-shaft/best_range.h"
#include "balance-shaft/moment_plane.h"
#include "numerics/constants.h"
#include "numerics/cutting_planes.h"

namespace ravnoves::balance_shaft {

namespace {

/// Ranges below this part of the size are rounding.
constexpr double constant_torque = 1e-12;

/// The moment's coefficients by cos φ and sin φ, N·m.
using Moment = Eigen::Vector2d;

}  // namespace

struct PositionStudy::Prepared {
    Solver solver;
    MomentPlane plane;
    ShaftPlaces places;
    double force;      ///< P₁, N
    double cos_phase;  ///< M_s = P₁ l sin(α + φ + phase)
    double sin_phase;
    Moment rms_centre;  ///< where the variance is least: opposes M_up's first order
    double least_variance;
    double range_without;
    double rms_without;
    double size;  ///< largest |M_up|, N·m

    explicit Prepared(const Solver& of);

    Moment moment(const ShaftPosition& at) const {
        return {force * (at.x * cos_phase + at.y * sin_phase),
                force * (at.y * cos_phase - at.x * sin_phase)};
    }
    ShaftPosition position(const Moment& m) const {
        return {(m.x() * cos_phase - m.y() * sin_phase) / force,
                (m.x() * sin_phase + m.y() * cos_phase) / force};
    }
    double range(const Moment& m) const { return plane(m.x(), m.y()).range(); }
    double rms(const Moment& m) const {
        return std::sqrt(least_variance + (m - rms_centre).squaredNorm() / 2.0);
    }
    PositionCriteria criteria(const ShaftPosition& at) const {
        const Moment m = moment(at);
        return {range(m), rms(m), places.size(at.x, at.y)};
    }
    bool is_constant() const { return range_without <= constant_torque * size; }
    BestPosition best_range() const;
    BestPosition best_rms() const;
};

PositionStudy::Prepared::Prepared(const Solver& of)
    : solver(of),
      plane(of.tipping_moment()),
      places(of.front_view(), of.input().place_limits),
      force(of.counterweight_force()),
      cos_phase(std::cos(of.shaft_phase())),
      sin_phase(std::sin(of.shaft_phase())),
      rms_centre(-of.tipping_order_1().a, -of.tipping_order_1().b),
      least_variance(std::max(0.0, of.tipping_variance() - rms_centre.squaredNorm() / 2.0)) {
    const MomentPlane::Extrema found = plane(0.0, 0.0);
    range_without = found.range();
    size = std::max(std::abs(found.max.value), std::abs(found.min.value));
    rms_without = std::sqrt(std::max(0.0, of.tipping_variance()));
}

/// min u + w over x, y, u, w: u ≥ M(φ) + x cos φ + y sin φ at the maxima met, w the same of −M at
/// the minima. Each is a plane under the range's convex halves, so u + w is a lower bound.
BestPosition PositionStudy::Prepared::best_range() const {
    using Planes = CuttingPlanes<double, 4>;
    using Vector = Planes::Vector;
    // The range is at least 2 |m| less that without a shaft, so the best |m| is at most the latter.
    const double reach = range_without * (1.0 + 1e-9);
    Moment at = rms_centre.norm() < reach ? rms_centre : Moment(0.0, 0.0);
    MomentPlane::Extrema found = plane(at.x(), at.y());
    const auto upper = [](const MomentPlane::Place& p) -> Vector { return {-p.cos, -p.sin, 1, 0}; };
    const auto lower = [](const MomentPlane::Place& p) -> Vector { return {p.cos, p.sin, 0, 1}; };
    const double x = found.max.cos < found.min.cos ? -1.0 : 1.0;
    const double y = found.max.sin < found.min.sin ? -1.0 : 1.0;
    const double rounding = 8.0 * std::numeric_limits<double>::epsilon() * size;
    Planes planes({0, 0, 1, 1},
                  {{upper(found.max), found.max.moment},
                   {lower(found.min), -found.min.moment},
                   {{x, 0, 0, 0}, -reach},
                   {{0, y, 0, 0}, -reach}},
                  rounding);
    planes.add({-x, 0, 0, 0}, -reach);
    planes.add({0, -y, 0, 0}, -reach);
    BestPosition best;
    Moment best_at = at;
    best.criteria.range = found.range();
    constexpr int most_rounds = 400;
    for (int round = 0; round < most_rounds; ++round) {
        const Vector& vertex = planes.solve();
        best.gap = std::max(0.0, best.criteria.range - vertex[2] - vertex[3]);
        if (best.gap <= 4.0 * rounding) {
            break;
        }
        at = vertex.head<2>();
        found = plane(at.x(), at.y());
        if (found.range() < best.criteria.range) {
            best.criteria.range = found.range();
            best_at = at;
        }
        planes.add(upper(found.max), found.max.moment);
        planes.add(lower(found.min), -found.min.moment);
    }
    best.position = position(best_at);
    best.criteria.rms = rms(best_at);
    best.criteria.size = places.size(best.position.x, best.position.y);
    best.gap = std::max(best.gap, rounding);
    return best;
}

BestPosition PositionStudy::Prepared::best_rms() const {
    BestPosition best;
    best.position = position(rms_centre);
    best.criteria = {range(rms_centre), std::sqrt(least_variance),
                     places.size(best.position.x, best.position.y)};
    best.gap = 8.0 * std::numeric_limits<double>::epsilon() * rms_without;
    return best;
}

ShaftPosition ShaftPosition::at(double centre_distance, double shaft_angle) {
    return {centre_distance * std::sin(shaft_angle), centre_distance * std::cos(shaft_angle)};
}

double ShaftPosition::centre_distance() const {
    return std::hypot(x, y);
}

double ShaftPosition::shaft_angle() const {
    const double angle = std::atan2(x, y);
    return angle < 0.0 ? std::min(angle + two_pi, std::nextafter(two_pi, 0.0)) : angle;
}

PositionStudy::PositionStudy(const Solver& solver)
    : prepared_(std::make_shared<const Prepared>(solver)) {}

PositionCriteria PositionStudy::at(const ShaftPosition& position) const {
    return prepared_->criteria(position);
}

double PositionStudy::range_without() const {
    return prepared_->range_without;
}

double PositionStudy::rms_without() const {
    return prepared_->rms_without;
}

BestPositions PositionStudy::best() const {
    BestPositions answer;
    if (prepared_->force == 0.0) {
        answer.reason =
            CORE_TEXT("balance-shaft", "The shaft makes no moment, so its place changes nothing.");
        return answer;
    }
    if (prepared_->is_constant()) {
        BestPosition at_crank;
        at_crank.criteria = prepared_->criteria({});
        answer.range = answer.rms = at_crank;
        answer.reason = CORE_TEXT("balance-shaft",
                                  "The tipping moment is constant: every shaft away from the "
                                  "crank's axis only adds to it.");
        return answer;
    }
    answer.range = prepared_->best_range();
    answer.rms = prepared_->best_rms();
    return answer;
}

BestPosition PositionStudy::best_range_at(double centre_distance) const {
    const double amplitude = prepared_->force * centre_distance;
    BestPosition best;
    if (amplitude > 0.0) {
        const BestRange found =
            minimise_range(CycleExtrema(prepared_->solver.tipping_moment(), amplitude));
        best.position =
            ShaftPosition::at(centre_distance, found.shaft_angle - prepared_->solver.shaft_phase());
        best.gap = found.gap;
    } else {
        best.position = ShaftPosition::at(centre_distance, 0.0);
    }
    best.criteria = prepared_->criteria(best.position);
    return best;
}

BestPosition PositionStudy::best_rms_at(double centre_distance) const {
    BestPosition best;
    const Moment& centre = prepared_->rms_centre;
    const bool any = centre.norm() <= constant_torque * prepared_->size;
    best.position = ShaftPosition::at(
        centre_distance,
        any ? 0.0 : std::atan2(centre.x(), centre.y()) - prepared_->solver.shaft_phase());
    best.criteria = prepared_->criteria(best.position);
    return best;
}

Obstacle PositionStudy::obstacle(const ShaftPosition& position) const {
    return prepared_->places.obstacle(position.x, position.y);
}

Message PositionStudy::obstacle_reason(const ShaftPosition& position) const {
    return prepared_->places.reason(obstacle(position), position.x, position.y);
}

BestPositions PositionStudy::best_buildable() const {
    return best();
}

std::vector<FrontPosition> PositionStudy::front() const {
    return {};
}

PositionMap PositionStudy::map(double left, double right, double bottom, double top,
                               std::size_t columns, std::size_t rows) const {
    PositionMap map{left, right, bottom, top, columns, rows, {}, {}};
    const auto step = [](double from, double to, std::size_t count) {
        return count > 1 ? (to - from) / static_cast<double>(count - 1) : 0.0;
    };
    const Moment origin = prepared_->moment({left, bottom});
    const Moment along = prepared_->moment({step(left, right, columns), 0.0});
    const Moment across = prepared_->moment({0.0, step(bottom, top, rows)});
    map.range = prepared_->plane.ranges({{origin.x(), origin.y()},
                                         {along.x(), along.y()},
                                         {across.x(), across.y()},
                                         columns,
                                         rows});
    map.rms.reserve(columns * rows);
    const Moment start = origin - prepared_->rms_centre;
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t column = 0; column < columns; ++column) {
            const Moment m =
                start + static_cast<double>(column) * along + static_cast<double>(row) * across;
            map.rms.push_back(std::sqrt(prepared_->least_variance + m.squaredNorm() / 2.0));
        }
    }
    return map;
}

}  // namespace ravnoves::balance_shaft
