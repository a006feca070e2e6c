#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "case-file/message.h"
#include "elastic-hinge/input.h"
#include "elastic-hinge/result.h"

namespace ravnoves::elastic_hinge {

/// How a motion ended.
enum class MotionEnd {
    completed,  ///< all the turns (or the time) asked for
    reversed,   ///< the crank stopped and would turn back
    too_slow,   ///< the turns were not done within the longest time
    cancelled,  ///< by the caller
};

/// The motion at growing times.
struct Motion {
    MotionEnd end = MotionEnd::completed;
    Message reason;            ///< how it ended, as a sentence; empty where completed or cancelled
    std::vector<double> time;  ///< s
    std::vector<double> crank_angle;   ///< rad
    std::vector<double> speed;         ///< rad/s
    std::vector<double> acceleration;  ///< rad/s²
    double min_speed = 0.0;            ///< rad/s, of the continuous motion
    double max_speed = 0.0;
    double mean_speed = 0.0;  ///< angle turned / time, rad/s
    /// (max − min) / mean, the coefficient of speed fluctuation; 0 where the mean is 0.
    double ripple = 0.0;
    /// Largest difference between the work of all moments, the spring's by the slope of its guide,
    /// and what the energies gave for it, against the largest T or change of T.
    double energy_drift = 0.0;
    std::size_t evaluations = 0;  ///< crank angles at which the mechanism was computed

    /// Crank angle (rad) and speed (rad/s) at a time between the samples, by the polynomial of
    /// order 5 through angle, speed and acceleration of both neighbours.
    double angle_at(double seconds) const;
    double speed_at(double seconds) const;
    /// The first time (s) at which the crank is at an angle (rad); nothing where it never is.
    std::optional<double> time_at(double angle) const;
};

/// Called with the part done, 0…1; false cancels.
using MotionProgress = std::function<bool(double)>;

inline constexpr double motion_tolerance = 1e-8;  ///< that a motion is computed with

/// The motion I φ̈ + ½ I′ φ̇² + V′ + Π′ = moment on the crank, by its energy: T + V + Π − work of the
/// crank's moment is constant and a function of φ and φ̇² alone, so the speed at every angle is
/// known without integration, and the time is the integral of dφ/φ̇, by Gauss sums from sample to
/// sample. Samples are so close that between them the speed keeps the energy too. Nothing drifts,
/// and without a moment on the crank the first turn serves for all.
///
/// The crank's hinge acts through its guide: the spring's moment on a roller at ρ(φ) with slope
/// ρ′(φ), whatever the crank's speed.
/// @param result  of the input, whose motion (without one: five turns at the design speed) is
///                computed
/// @param tolerance  of the speed that is read between samples, 1e-8 or more: the time is better by
///                   far
/// @throws InputError where a wanted hinge has no feasible guide, the mechanism locks (λ = 1) or
///         has no inertia, or the work takes too long
Motion simulate(const Input& input, const Result& result, HingeSet hinges,
                const MotionProgress& progress = {}, double tolerance = motion_tolerance);

}  // namespace ravnoves::elastic_hinge
