#pragma once

#include <optional>

#include "balance-shaft/torque_table.h"

namespace ravnoves::balance_shaft {

struct Input;

/// Whether a torque table belongs to the masses and the speed entered.
///
/// Where the cylinder exchanges its gas, M_id is nearly the inertia torque alone,
/// M_j = −m_j ω² s′ s″ = C g(φ; λ) with C = m_j r² ω² and g the crank's exact kinematics, and a
/// little gas torque d sin φ of a steady pressure. C, λ and d are fitted to the table's rows on one
/// stroke, 15°…165° after the top dead centre that begins it (of the two such strokes in a cycle,
/// the one that looks like it more).
struct InertiaCheck {
    double entered = 0.0;           ///< m_j r² ω² of the input, N·m
    std::optional<double> fitted;   ///< the table's, N·m; empty where no fit is possible
    double fitted_lambda = 0.0;     ///< r/L of the fit
    double gas_exchange = 0.0;      ///< d of the fit, N·m
    double residual_rms = 0.0;      ///< of the rows against the fit, N·m
    double stroke_begin_deg = 0.0;  ///< 0 or 360: the dead centre that begins the stroke
    /// fitted is within tolerance of entered; empty where no fit is possible.
    std::optional<bool> consistent;
    /// The speed at which the masses entered have the fitted inertia torque, rad/s.
    double matching_speed = 0.0;
    /// The reciprocating mass that has it at the speed entered, kg.
    double matching_mass = 0.0;
    Message text;  ///< what this means, in English sentences

    static constexpr double tolerance = 0.15;  ///< of fitted against entered
};

/// @param table  M_id over a cycle
/// @param input  speed, masses and crank; not its torque
InertiaCheck check_inertia(const TorqueTable& table, const Input& input);

/// First remedy: the same input at the speed that the torque belongs to.
Input with_matching_speed(const Input& input, const InertiaCheck& check);

/// Second remedy: the same input with the torque rebuilt, the fitted inertia torque taken out and
/// that of the masses and the speed entered put in (with r/L of the input where its rod is known,
/// else of the fit). The torque becomes a table.
Input with_rebuilt_torque(const Input& input, const InertiaCheck& check);

}  // namespace ravnoves::balance_shaft
