#pragma once

#include <optional>
#include <vector>

#include "balance-shaft/angle_search.h"
#include "balance-shaft/place_search.h"
#include "balance-shaft/shaft_places.h"
#include "balance-shaft/solver.h"

namespace ravnoves::balance_shaft {

/// A place of the balance shaft's axis in the front view, m: x = l sin α, y = l cos α.
struct ShaftPosition {
    double x = 0.0;
    double y = 0.0;

    static ShaftPosition at(double centre_distance, double shaft_angle);
    double centre_distance() const;  ///< l, m
    double shaft_angle() const;      ///< α, rad, 0…2π; 0 at the crank's axis

    friend bool operator==(const ShaftPosition&, const ShaftPosition&) = default;
};

/// The criteria of the moment on the mounts with the shaft's axis at a place.
struct PositionCriteria {
    double range = 0.0;  ///< ΔM_ups, N·m
    double rms = 0.0;    ///< N·m, about the mean
    double size = 0.0;   ///< m², box of the front view (Envelope: width × height)
};

/// A place that is best by a criterion, or that no other beats in range, RMS and size at once.
struct BestPosition {
    ShaftPosition position;
    PositionCriteria criteria;
    double gap = 0.0;  ///< N·m: no place is better by more than this
};

/// The same among the feasible places; empty with the reason where none is.
struct BestPositions {
    std::optional<BestPosition> range;
    std::optional<BestPosition> rms;
    Message reason;
};

/// Criteria over a rectangle of places: element row × columns + column, rows upwards.
struct PositionMap {
    double left = 0.0, right = 0.0, bottom = 0.0, top = 0.0;  ///< m
    std::size_t columns = 0, rows = 0;
    std::vector<double> range;  ///< N·m
    std::vector<double> rms;    ///< N·m
};

/// Sign of a change as a share; 0 where it is printed as 0.0 %.
int sign_as_shown(double change);

/// What the criteria do from one place to another: "range 0.5 % smaller, RMS 43.0 % larger, box
/// unchanged"; without the box where the first has none.
Message trade_off(const PositionCriteria& from, const PositionCriteria& to);

/// What depends on the shaft's place alone while the counterweights stay as equation (1) (or the
/// case) has them: M_s = P₁ (x cos φ' + y sin φ'), so range and RMS are convex over the plane.
/// Const members may run in several threads.
class PositionStudy {
  public:
    explicit PositionStudy(const Solver& solver);

    PositionCriteria at(const ShaftPosition& position) const;
    /// The place where range and RMS are the engine's without a shaft (the axes meet): at the
    /// crank.
    double range_without() const { return range_without_; }  ///< N·m
    double rms_without() const { return rms_without_; }      ///< N·m

    BestPositions best() const;            ///< over all places
    BestPositions best_buildable() const;  ///< over the feasible ones
    /// Of the feasible places at most a hundredth worse than the best one by its criterion, one of
    /// the smallest size, to a thousandth; of several the one that is best by the other criterion.
    /// The gap is the size's, m².
    /// @param best  best_buildable() by range or by RMS
    BestPosition smallest_buildable(const BestPosition& best, bool by_range) const;

    Obstacle obstacle(const ShaftPosition& position) const;
    Message obstacle_reason(const ShaftPosition& position) const;  ///< a sentence; empty: none

    /// Pareto front of range, RMS and size among the feasible places, ascending size: for some
    /// sizes and some weights of range against RMS (as parts of their values without a shaft) the
    /// place with the smallest weighted sum, to front_gap. Others are between these.
    static constexpr double front_gap = 1e-6;
    std::vector<BestPosition> front() const { return front(best_buildable()); }
    std::vector<BestPosition> front(const BestPositions& best_buildable) const;

    PositionMap map(double left, double right, double bottom, double top, std::size_t columns,
                    std::size_t rows) const;

  private:
    using Moment = MomentPlane::Moment;

    const MomentPlane& plane() const { return solver_.moments().plane; }
    /// M_s = a cos φ + b sin φ = P₁ l sin(α + φ + phase) of a place: (a, b), N·m.
    Moment moment(const Eigen::Vector2d& place) const { return force_ * (turn_ * place); }
    /// P₁ must not be 0.
    Eigen::Vector2d place_of(const Moment& moment) const {
        return turn_.transpose() * moment / force_;
    }
    bool is_constant() const { return range_without_ <= rounding_share * size_; }
    /// weight × range + (1 − weight) × RMS, N·m.
    PlaceQuestion question_of_sum(double weight) const;
    PlaceQuestion question_of_size() const;
    BestPosition judged(const PlaceFound& found) const;
    std::optional<BestPosition> best_built(double weight, const BestPosition& free) const;

    Solver solver_;
    ShaftPlaces places_;
    double force_;          ///< P₁, N
    Eigen::Matrix2d turn_;  ///< by the phase of M_s
    double range_without_;  ///< N·m
    double rms_without_;    ///< N·m
    double size_;           ///< largest |M_up|, N·m
};

/// The fifth criterion of the paper: overall size over the shaft's angle, beside the moment's.
///
/// All vectors have one element per angle, every half degree, 0 ≤ α < 360°.
struct EnvelopeStudy {
    std::vector<double> shaft_angle_deg;
    std::vector<double> width;   ///< m, of the front view's box
    std::vector<double> height;  ///< m
    std::vector<double> area;    ///< m², width × height
    std::vector<double> range;   ///< ΔM_ups, N·m
    std::vector<bool> buildable;
    /// Feasible, and no other feasible one beats it in area or range without being worse in the
    /// other (Pareto); what differs by rounding_share is equal.
    std::vector<bool> efficient;
};

EnvelopeStudy envelope_study(const Solver& solver);

}  // namespace ravnoves::balance_shaft
