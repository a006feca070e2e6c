#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "balance-shaft/clearance.h"
#include "balance-shaft/input.h"
#include "balance-shaft/moment_plane.h"
#include "balance-shaft/result.h"
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
        // Of the feasible angles; empty where none is.
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

    /// The angle whose worst speed in the whole band, not only of its points, is the best
    /// compromise.
    struct BestCompromise {
        double shaft_angle = 0.0;  ///< rad, 0…2π
        double value = 0.0;        ///< the measure at the worst speed
        double worst_speed = 0.0;  ///< rad/s
        double gap = 0.0;          ///< no angle is better by more than this
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
    /// at an α its convexity (absolute: an end of the band) or branch and bound (relative). The
    /// study must be complete.
    /// @param within  the angles to choose from, one stretch at least
    BestCompromise best_compromise_angle(
        Criterion criterion, Measure measure,
        const std::vector<AngleStretch>& within = whole_turn()) const;
    const BuildableAngles& buildable() const { return buildable_; }

  private:
    struct Speed {
        double angular_speed;          ///< rad/s
        double amplitude;              ///< of the shaft, N·m
        MomentPlane plane;             ///< of M_up
        MomentPlane::Extrema without;  ///< a shaft

        /// The range, or the mean square about the mean.
        double without_shaft(Criterion criterion) const;
        /// What the value with the shaft is divided by.
        double divisor(Criterion criterion, Measure measure) const;
        /// The quotient at α + phase_, with a sinusoid of α that bounds it.
        Cut cut(Criterion criterion, Measure measure, double alpha) const;
    };

    Speed speed_at(double angular_speed) const;
    /// For some speeds alone: at α + phase_, of the RMS the square.
    static BestCompromise best_compromise_of(const std::vector<const Speed*>& speeds,
                                             Criterion criterion, Measure measure,
                                             const std::vector<AngleStretch>& within);
    std::optional<Speed> worst_speed_of(const std::vector<const Speed*>& speeds,
                                        Criterion criterion, double alpha) const;

    Message reason_;
    BuildableAngles buildable_;
    double phase_ = 0.0;  ///< of the piston's first order, rad
    bool complete_ = false;
    PeriodicPiecewise gas_;      ///< parts of M_up = gas + ω² inertia, N·m
    PeriodicPiecewise inertia_;  ///< N·m s²
    double inertia_variance_ = 0.0;
    double twice_covariance_ = 0.0;  ///< of the two
    double unit_amplitude_ = 0.0;    ///< P₁ l for ω = 1, N·m s²
    std::vector<Point> points_;
    std::vector<Speed> speeds_;
};

}  // namespace ravnoves::balance_shaft
