#pragma once

#include <vector>

#include "balance-shaft/solver.h"

namespace ravnoves::balance_shaft {

/// What a shaft fitted k teeth out, and the play of its gears, do.
///
/// A shaft that turns ahead by δ has the counterweight force P₁ (sin(φ + δ), −cos(φ + δ)) instead
/// of P₁ (sin φ, −cos φ). Its moment about the crank axis is P₁ l sin(α + φ + δ), as if α had grown
/// by δ; and the forces no longer cancel: a force of constant size 2 P₁ |sin(δ/2)| remains that
/// turns backwards. One tooth of z is δ = 360°/z. Play b at the pitch circle of radius l/2 lets the
/// shaft wander over ±b/l about its place.
struct GearError {
    double phase_error = 0.0;     ///< δ, rad
    double residual_force = 0.0;  ///< 2 P₁ |sin(δ/2)|, N, turning against the crank
    double range = 0.0;           ///< ΔM_ups with the error, N·m
    double rms = 0.0;             ///< N·m

    double play = 0.0;            ///< half of the angle that the play leaves, rad
    double play_force = 0.0;      ///< largest residual force at the ends of the play, N
    double play_range_low = 0.0;  ///< smallest and largest ΔM_ups over the play, N·m
    double play_range_high = 0.0;

    std::vector<double> crank_angle_deg;  ///< 0 to the end of the cycle, every degree
    std::vector<double> M_ups;            ///< with the error, N·m
    std::vector<double> M_ups_low;        ///< band of the play about it, N·m
    std::vector<double> M_ups_high;
};

/// @param shaft_angle  α, rad
GearError gear_error(const Solver& solver, double shaft_angle);

}  // namespace ravnoves::balance_shaft
