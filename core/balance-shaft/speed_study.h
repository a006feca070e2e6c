#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "balance-shaft/clearance.h"
#include "balance-shaft/cycle_extrema.h"
#include "balance-shaft/input.h"
#include "balance-shaft/moment_plane.h"
#include "balance-shaft/place_search.h"
#include "balance-shaft/result.h"
#include "balance-shaft/shaft_moment.h"
#include "case-file/json_fwd.h"
#include "numerics/periodic_piecewise.h"

namespace ravnoves::balance_shaft {

/// Called with the part that is done, 0…1; false cancels.
using Progress = std::function<bool(double)>;

/// What the shaft's angle does over a band of speeds.
///
/// At the speed ω the engine torque is gas + ω² × unit inertia, with the gas torque of the input
/// (the load stays), and the shaft's moment grows with ω² too. The torque must be computed
/// (pressure, cycle), or be a table that belongs to the masses and the speed entered
/// (InertiaCheck): then the fitted inertia torque is its part that follows the speed.
class SpeedStudy {
  public:
    /// One speed of the band.
    struct Point {
        double angular_speed = 0.0;     ///< rad/s
        double moment_amplitude = 0.0;  ///< of the shaft, N·m
        double range_without = 0.0;     ///< ΔM_up, without a shaft, N·m
        double rms_without = 0.0;       ///< N·m
        double best_range_angle = 0.0;  ///< rad
        double best_range = 0.0;        ///< N·m
        double best_rms_angle = 0.0;    ///< rad
        double best_rms = 0.0;          ///< N·m
        // Of the angles that can be built; empty where none can.
        std::optional<double> buildable_range_angle;  ///< rad
        std::optional<double> buildable_rms_angle;    ///< rad
    };

    /// Range and RMS over (α, speed): element speed × angles + angle.
    struct Map {
        std::vector<double> shaft_angle_deg;  ///< 0 ≤ α < 360, equally spaced
        std::vector<double> range;            ///< N·m
        std::vector<double> rms;              ///< N·m
    };

    enum class Criterion { range, rms };
    enum class Measure {
        absolute,  ///< the criterion in N·m
        relative,  ///< the criterion over its value without a shaft at the same speed
    };

    /// The angle whose worst speed in the whole band, not only of its points, is the least bad.
    struct LeastBad {
        double shaft_angle = 0.0;  ///< rad, 0…2π
        double value = 0.0;        ///< the measure at the worst speed
        double worst_speed = 0.0;  ///< rad/s
        double gap = 0.0;          ///< no angle is better by more than this
    };

    /// The same of all places of the shaft's axis, at whatever distance from the crank's.
    struct LeastBadPlace {
        double x = 0.0;            ///< of the axis in the front view, m
        double y = 0.0;            ///< m
        double value = 0.0;        ///< the measure at the worst speed
        double worst_speed = 0.0;  ///< rad/s
        double gap = 0.0;          ///< no place is better by more than this
    };

    /// Solves every speed of the band; may be cancelled, then is_complete() is false.
    /// @throws InputError as check_input() and where the band cannot be
    SpeedStudy(const Input& input, const SpeedBand& band, const Progress& progress = {});

    /// Empty where the study could be made; else a sentence that says why not.
    const Message& reason() const { return reason_; }
    bool is_complete() const { return complete_; }
    const std::vector<Point>& points() const { return points_; }

    /// Nothing where cancelled.
    /// @param angles  ≥ 1
    std::optional<Map> map(std::size_t angles, const Progress& progress = {}) const;

    /// Minimax over every speed of the band, proven: cutting planes over α, and for the worst speed
    /// at an α its convexity (absolute: an end of the band), a quotient of quadratics (relative,
    /// RMS) or branch and bound (relative, range). The study must be complete.
    LeastBad least_bad_angle(Criterion criterion, Measure measure) const {
        return least_bad_angle(criterion, measure, whole_turn());
    }
    /// The same among these angles, one stretch at least.
    LeastBad least_bad_angle(Criterion criterion, Measure measure,
                             std::vector<AngleStretch> within) const;
    const BuildableAngles& buildable() const { return buildable_; }
    bool makes_moment() const { return unit_.force() != 0.0; }  ///< P₁ is not 0

    /// Minimax over the band and over all places, which is convex in the place: cutting planes.
    /// Empty where the shaft makes no moment.
    std::optional<LeastBadPlace> least_bad_place(Criterion criterion, Measure measure) const;
    /// Among the places that can be built, by branch and bound; empty where none can.
    std::optional<LeastBadPlace> least_bad_place_buildable(Criterion criterion,
                                                           Measure measure) const {
        return least_bad_place_buildable(criterion, measure, least_bad_place(criterion, measure));
    }
    /// @param free  least_bad_place() of the same
    std::optional<LeastBadPlace> least_bad_place_buildable(
        Criterion criterion, Measure measure, const std::optional<LeastBadPlace>& free) const;

  private:
    struct Speed {
        double angular_speed;  ///< rad/s
        double amplitude;      ///< of the shaft, N·m
        CycleExtrema extrema;  ///< with the shaft
        Extrema without;       ///< without it
        double variance;       ///< without it, (N·m)²
        FourierPair order_1;
    };
    /// The least bad angle for some speeds; of the RMS the square.
    struct AtSpeeds {
        double alpha = 0.0;
        double value = 0.0;
        double gap = 0.0;
        double worst_speed = 0.0;
    };

    Speed speed_at(double angular_speed) const;
    static double divisor(const Speed& speed, Criterion criterion, Measure measure);
    static Cut<double> cut(const Speed& speed, Criterion criterion, Measure measure, double alpha);
    static AtSpeeds least_bad_of(const std::vector<const Speed*>& speeds, Criterion criterion,
                                 Measure measure, const std::vector<AngleStretch>& within);
    /// @param a, b  the shaft's moment over ω²: a cos φ + b sin φ, N·m s²
    double worst_rms_speed(double a, double b) const;
    /// @param range  with the shaft
    std::optional<Speed> worst_range_speed(const std::vector<const Speed*>& speeds,
                                           const std::function<double(const Speed&)>& range) const;

    /// One speed's criterion over the plane of places.
    struct SpeedPlane {
        double square;  ///< ω²
        double over;    ///< divisor
        double without;
        MomentPlane plane;
        double variance;
        FourierPair order_1;
    };
    SpeedPlane speed_plane(double angular_speed, Criterion criterion, Measure measure) const;
    /// The largest of some speeds at a place, and which.
    struct Worst {
        double value = 0.0;
        Eigen::Vector2d gradient{0.0, 0.0};
        double square = 0.0;
    };
    /// @param unit  the shaft's moment over ω², N·m s²; the gradient is by it
    static Worst worst_of(const std::vector<SpeedPlane>& planes, Criterion criterion,
                          const Eigen::Vector2d& unit);
    using PlaceOfPlanes = std::function<std::optional<PlaceFound>(const std::vector<SpeedPlane>&)>;
    std::optional<LeastBadPlace> least_bad_place(Criterion criterion, Measure measure,
                                                 const PlaceOfPlanes& find) const;
    PlaceQuestion question_of(const std::vector<SpeedPlane>& planes, Criterion criterion) const;

    /// From α to α + phase_, which the moments go by.
    void turn(std::vector<AngleStretch>& stretches) const;

    Message reason_;
    BuildableAngles buildable_;
    double phase_ = 0.0;  ///< Solver::shaft_phase()
    bool complete_ = false;
    PeriodicPiecewise gas_;      ///< parts of M_up = gas + ω² inertia, N·m
    PeriodicPiecewise inertia_;  ///< N·m s²
    FourierPair gas_order_;      ///< their first orders
    FourierPair inertia_order_;
    ShaftMoment unit_;             ///< for ω = 1: P₁ in N s²
    double unit_amplitude_ = 0.0;  ///< P₁ l for ω = 1, N·m s²
    std::optional<ShaftPlaces> places_;
    std::vector<Point> points_;
    std::vector<Speed> speeds_;
};

/// The object "speed_band" of a result; the map only where asked for.
Json write_speed_study(const SpeedStudy& study, const std::optional<SpeedStudy::Map>& map);

}  // namespace ravnoves::balance_shaft
