#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "case-file/message.h"
#include "elastic-hinge/design.h"
#include "elastic-hinge/guide.h"
#include "elastic-hinge/input.h"

namespace ravnoves::elastic_hinge {

/// How a motion ended.
enum class MotionEnd {
    completed,  ///< all the turns (or the time) asked for
    reversed,   ///< the crank stopped and would turn back
    too_slow,   ///< the turns were not done within the longest time
    cancelled,  ///< by the caller
};

/// One forward motion: I φ̈ + ½ I′ φ̇² + V′ + Π′ = moment on the crank.
struct MotionSetup {
    HingeSet hinges = HingeSet::none;
    double start_angle = 0.0;    ///< rad
    double start_speed = 0.0;    ///< rad/s, any sign
    double crank_torque = 0.0;   ///< constant, N·m
    double turns = 5.0;          ///< stops after as many turns either way
    double profile_error = 0.0;  ///< ε of waves ε sin(n φ) on the crank's guide, m
    int profile_error_waves = 1;
    /// Of the speed that is read between samples, 1e-8 or more: the time is better by far.
    double tolerance = 1e-8;
};

/// The motion at growing times.
struct Motion {
    MotionEnd end = MotionEnd::completed;
    Message reason;                    ///< how it ended, as a sentence; empty where completed
    std::vector<double> time;          ///< s
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

/// The motion by its energy: T + V + Π − work of the crank's moment is constant and a function of φ
/// and φ̇² alone, so the speed at every angle is known without integration, and the time is the
/// integral of dφ/φ̇, by Gauss sums from sample to sample. Samples are so close that between them
/// the speed keeps the energy too. Nothing drifts, and without a moment on the crank the first turn
/// serves for all.
///
/// The crank's hinge acts through its guide: the spring's moment on a roller at ρ(φ) with slope
/// ρ′(φ), whatever the crank's speed.
/// @param crank_guide  for HingeSet::crank a guide of Hinge::crank, for crank_and_rod one of
///                     Hinge::crank_with_rod; unused for none
/// @throws InputError where a wanted hinge has no feasible guide, the mechanism locks (λ = 1) or
///         has no inertia, or the work takes too long
Motion simulate(const std::shared_ptr<const Design>& design, const Guide& crank_guide,
                const MotionSetup& setup, const MotionProgress& progress = {});

/// The side force at any crank speed and acceleration, N, by Newton–Euler on rod, slider and
/// counterweight, with the moment of a hinge between crank and rod. As in (6) and (7) it is the
/// force of the slider on its guide, positive upwards.
/// @param hinge_moment  on the rod, counter-clockwise, N·m; 0 without hinge
double side_force(const Mechanism<double>& mechanism, double phi, double speed, double acceleration,
                  double hinge_moment);

}  // namespace ravnoves::elastic_hinge
