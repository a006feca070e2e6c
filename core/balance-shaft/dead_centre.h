#pragma once

#include <optional>

#include "balance-shaft/cylinder_gas.h"
#include "case-file/message.h"
#include "numerics/slider_crank.h"

namespace ravnoves::balance_shaft {

struct Input;

/// The firing top dead centre of a pressure trace, found from its compression line.
struct DeadCentre {
    double angle = 0.0;        ///< in the trace's own angles, rad
    double shift = 0.0;        ///< to be added to them (TorqueSource::trace_shift), rad
    double uncertainty = 0.0;  ///< two standard deviations, rad

    bool is_certain() const { return uncertainty < 1.0 * degree; }
    /// The shift to make: whole turns, 0 too, where the rest is within the uncertainty.
    double proposed_shift() const;
    /// "The dead centre is at 362.1 ± 0.3°: shift the angles by −2.1°."
    Message describe() const;
};

/// Finds the dead centre by a model of the closed cylinder without combustion,
///
///     ln p = k − n ln V − ½ b ln² V − c Q + p₀/p,    V = V_c + A (s_max − s(θ − θ₀)),
///
/// with the loss of heat to the walls Q ~ ∫ p^0.8 T^−0.53 (1 − T_w/T) dθ, which makes the peak of a
/// motored engine come before its dead centre (the thermodynamic loss angle, some tenths of a
/// degree). θ₀ and V_c are sought, the others follow as a linear fit; all have the spread of
/// engines as a prior: n 1.34 ± 0.04, b 0.01 ± 0.02, loss angle 0.3° ± 0.4°, zero of the pressure
/// 0 ± 0.05 bar, ln of the compression ratio ln 13 ± 0.35. The line begins where the valves are
/// shut and ends where the model no longer fits: at the start of combustion, or in a motored engine
/// beyond the dead centre.
///
/// Source of the heat transfer's form: Woschni's correlation; of the criterion: a compression
/// without combustion is the same polytrope all along, only at the right phase.
/// @param trace  of one cycle, absolute pressures
/// @return empty without a compression, or with too few rows
std::optional<DeadCentre> find_dead_centre(const SliderCrank<double>& crank,
                                           const PressureTrace& trace);

/// The same for the trace of the torque; empty without one.
std::optional<DeadCentre> find_dead_centre(const Input& input);

/// That the trace's shift puts its dead centre elsewhere than it was found; empty where it does
/// not.
Message dead_centre_note(const Input& input, const std::optional<DeadCentre>& centre);

}  // namespace ravnoves::balance_shaft
