#pragma once

#include <optional>
#include <vector>

#include "balance-shaft/input.h"
#include "numerics/periodic_piecewise.h"

namespace ravnoves::balance_shaft {

/// What the engine torque does to the speed, against a load that takes its mean.
///
/// The excess energy E(φ) = ∫ (M_id − mean) dφ has the period of the cycle; it is largest and
/// smallest where the torque crosses its mean. The excess work ΔE = E_max − E_min turns into speed:
/// with the moment of inertia J of all that turns evenly, J (ω²_max − ω²_min)/2 = ΔE, so the
/// coefficient of fluctuation is δ = (ω_max − ω_min)/ω = ΔE/(J ω²) with the mean (ω_max + ω_min)/2
/// for ω. Text-book result; the inertia of the reciprocating masses is in M_id and not in J.
struct Flywheel {
    double excess_work = 0.0;           ///< ΔE, J
    double max_angle = 0.0;             ///< crank angle of the highest energy (speed), rad
    double min_angle = 0.0;             ///< and of the lowest, rad
    double max_energy = 0.0;            ///< E at these, J, from φ = 0
    double min_energy = 0.0;            ///< J
    std::optional<double> fluctuation;  ///< δ, given or of the J given
    std::optional<double> inertia;  ///< J, kg·m², given or for the δ given; empty where δ is 0
    std::vector<double> energy;     ///< E at the crank angles asked for, J, 0 at φ = 0
};

/// Exact for the interpolant: its integrals piece by piece, its crossings of the mean solved.
/// @param torque         M_id, N·m, over the crank angle in degrees
/// @param angular_speed  ω, rad/s
/// @param angles_deg     where the curve is wanted
Flywheel flywheel(const PeriodicPiecewise& torque, double angular_speed,
                  const std::optional<FlywheelTarget>& target,
                  const std::vector<double>& angles_deg);

}  // namespace ravnoves::balance_shaft
