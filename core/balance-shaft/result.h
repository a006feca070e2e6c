#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "balance-shaft/clearance.h"
#include "balance-shaft/cylinder_gas.h"
#include "balance-shaft/envelope.h"
#include "balance-shaft/flywheel.h"
#include "balance-shaft/inertia_check.h"
#include "case-file/message.h"

namespace ravnoves::balance_shaft {

/// The change from one value to another as a fraction of its size: −0.1 is 10 % less.
inline double relative_change(double from, double to) {
    return to / std::abs(from) - std::copysign(1.0, from);
}

/// A change or share as messages show it.
inline Number in_percent(double share) {
    return {share / units::percent, units::percent, -1};
}

/// Criteria of one moment over the continuous cycle (not over its samples).
struct MomentMetrics {
    double mean = 0.0;       ///< N·m, cycle integral / cycle
    double max = 0.0;        ///< N·m
    double min = 0.0;        ///< N·m
    double range = 0.0;      ///< max − min, N·m
    double rms = 0.0;        ///< N·m, about the mean
    double max_angle = 0.0;  ///< crank angle of the maximum, rad, 0…4π (2π)
    double min_angle = 0.0;  ///< crank angle of the minimum, rad, 0…4π (2π)
};

/// Moments over the cycle, sampled at every step_deg, both ends included.
struct MomentCurves {
    std::vector<double> crank_angle_deg;  ///< 0…720, or 0…360 of a two-stroke engine
    std::vector<double> M_up;             ///< tipping moment −M_id + e m_j ω² s″, N·m
    std::vector<double> M_s;              ///< moment of the shaft, (4), N·m
    std::vector<double> M_ups;            ///< moment on the mounts, (5), N·m
    // Where the torque is computed, else empty:
    std::vector<double> M_gas;      ///< gas torque, a part of M_id = M_offset − M_up, N·m
    std::vector<double> M_inertia;  ///< inertia torque, the other part, N·m
    std::vector<double> M_offset;   ///< e m_j ω² s″, what an offset cylinder adds to M_up, N·m
    std::vector<double> pressure;   ///< Pa
    std::vector<double> volume;     ///< m³; of a pressure trace without the clearance volume
};

/// Criteria over the shaft's angle, at every step_deg, both ends included. The means are cycle
/// integrals; the printed ones average nodes as the paper did, with the cycle's end counted twice.
struct AngleSweep {
    std::vector<double> shaft_angle_deg;     ///< 0…360
    std::vector<double> range;               ///< ΔM_ups, N·m
    std::vector<double> rms;                 ///< of M_ups about its mean, N·m
    std::vector<double> mean_M_s;            ///< N·m, 0 for every α
    std::vector<double> mean_M_ups;          ///< N·m, the same for every α
    std::vector<double> printed_mean_M_s;    ///< M_sm of 25 nodes, N·m (the paper's Fig. 4)
    std::vector<double> printed_mean_M_ups;  ///< M_upsm: printed_mean_M_s + node mean of M_up
};

/// The shaft angle with the smallest value of a criterion.
struct Optimum {
    std::optional<double> shaft_angle;  ///< rad, 0…2π; empty: no α is better than another
    double value = 0.0;                 ///< N·m, the criterion there
    Message note;  ///< why there is no angle, or where others are as good; else empty
};

/// One line of an order spectrum: amplitude × sin(order × φ + phase).
struct OrderLine {
    double order = 0.0;      ///< multiples of the crank's speed; a four-stroke has halves, too
    double amplitude = 0.0;  ///< N·m
    double phase = 0.0;      ///< rad
};

inline constexpr std::size_t spectrum_orders = 12;  ///< the highest order of a spectrum

/// The first order's forces and the counterweights'.
struct Forces {
    double inertia_force_1_max = 0.0;  ///< P_j1 max = m_j r ω², N
    double counterweight_mass = 0.0;   ///< m₁, kg, (1) or as given
    double counterweight_force = 0.0;  ///< P₁ = m₁ ρ₁ ω², N
    double moment_amplitude = 0.0;     ///< P₁ l, N·m
};

/// Everything that the page shows and that the command line prints.
struct Result : Forces {
    // What the shaft's angle does not change.
    double angular_speed = 0.0;       ///< ω, rad/s
    double reciprocating_mass = 0.0;  ///< m_j, kg
    MomentMetrics M_up;
    double order_1_amplitude = 0.0;  ///< amplitude of M_up's first order, N·m
    double order_1_phase = 0.0;      ///< rad: that order is amplitude × sin(φ + phase)
    /// Part of M_up's variance that is of the first order, 0…1; empty where M_up is constant.
    std::optional<double> order_1_share;
    double printed_mean_M_up = 0.0;  ///< mean over the table's rows, both ends, N·m
    InertiaCheck inertia_check;
    /// Orders ½, 1 … 12 (1, 2 … 12 of a two-stroke engine), exact for the interpolant.
    std::vector<OrderLine> spectrum_M_up;
    std::optional<IndicatedCycle> indicated;  ///< where the torque is computed
    double indicated_power = 0.0;  ///< work × ω / cycle, W; where the torque is computed
    Flywheel flywheel;
    Optimum best_range;  ///< of all angles
    Optimum best_rms;
    BuildableAngles buildable;
    Optimum best_range_buildable;  ///< of the feasible angles
    Optimum best_rms_buildable;
    /// Crank angle φ at top dead centre is 0; there the crank is at this angle from the
    /// cylinder's direction, rad: 0 where the cylinder is not offset.
    double dead_centre = 0.0;
    /// Both counterweights lag by this behind the direction opposite the crankpin, rad.
    double counterweight_lag = 0.0;
    AngleSweep sweep;
    std::vector<Message> doubts;       ///< of the input: it looks like a slip
    bool trace_is_a_turn_off = false;  ///< one of them; TorqueSource::trace_shift corrects it
    std::vector<Message> notes;        ///< what the user should know beyond the numbers
    /// For m₁ ρ₁, by the sizes that the input gives, else those that the front view takes; feasible
    /// where it fits in the swing circle too.
    RelievedShaft relieved_shaft;
    Message assumed_sizes;  ///< what is_buildable rests on and the case does not give, or empty

    // What follows the shaft's angle: updated by Solver::move_shaft().
    double shaft_angle = 0.0;  ///< α, rad, 0…2π
    MomentMetrics M_s;
    MomentMetrics M_ups;
    double printed_mean_M_s = 0.0;    ///< mean over the paper's 25 nodes (two-stroke: 13), N·m
    double printed_mean_M_ups = 0.0;  ///< printed_mean_M_s + printed_mean_M_up, N·m
    /// Change of range and RMS against the engine without a shaft, as a fraction (−0.1 is 10 %
    /// less); empty where M_up is constant.
    std::optional<double> range_change;
    std::optional<double> rms_change;
    MomentCurves curves;  ///< crank_angle_deg and M_up do not follow
    Envelope envelope;
    Obstacle obstacle = Obstacle::none;  ///< obstacle of an infeasible shaft
    bool is_buildable = false;
    std::vector<OrderLine> spectrum_M_ups;  ///< differs from M_up's in order 1 alone
};

}  // namespace ravnoves::balance_shaft
