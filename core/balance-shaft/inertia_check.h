#pragma once

#include <optional>

#include "balance-shaft/torque_table.h"
#include "case-file/message.h"

namespace ravnoves::balance_shaft {

struct Input;

/// Whether a torque table matches the masses and the speed entered.
///
/// Where the cylinder exchanges its gas, M_id is nearly the inertia torque alone, M_j = −m_j ω² s′
/// s″ = C g(φ; λ) with C = m_j r² ω² and g the crank's exact kinematics, and a little gas torque −d
/// s′(φ; λ)/r of a steady pressure. C, d and, where no rod length gives it, λ are fitted to the
/// table's rows on one stroke, 15°…165° after the top dead centre that begins it (of the two such
/// strokes in a four-stroke cycle, the one with the better fit).
///
/// Where the rod's λ leaves a large residual, λ is fitted all the same: the torque may be another
/// rod's. A fit with a large residual, or at a bound of λ, gives no verdict, and text is the
/// reason. A torque computed from the masses and the speed is not compared with them.
struct InertiaCheck {
    double entered = 0.0;          ///< m_j r² ω² of the input, N·m
    std::optional<double> fitted;  ///< the table's, N·m; empty where no fit is possible
    double fitted_lambda = 0.0;    ///< r/L of the fit
    double residual_rms = 0.0;     ///< of the rows against the fit, N·m
    bool lambda_fitted = true;     ///< false where the rod length gave it
    /// The fit fails with the rod's r/L and succeeds with a free one: the torque belongs to a crank
    /// with fitted_lambda, whatever speed and masses are.
    bool is_of_other_rod = false;
    /// fitted is within tolerance of entered; empty where no fit is possible.
    std::optional<bool> consistent;
    /// The speed at which the masses entered have the fitted inertia torque, rad/s.
    double matching_speed = 0.0;
    /// The reciprocating mass that has it at the speed entered, kg.
    double matching_mass = 0.0;
    Message text;     ///< what this means, or why nothing can be said, in English sentences
    Message warning;  ///< the same in short, where inconsistent or beyond the doubt; else empty

    static constexpr double tolerance = 0.15;  ///< of fitted against entered
    // The doubt: what fitted and entered may differ by though speed and masses are right. Masses
    // are known to some percent, mostly by the share of the rod; a pressure that rises or falls
    // over the stroke is an inertia torque to the fit; so is a part of what the fit leaves.
    static constexpr double masses_doubt = 0.05;
    static constexpr double pressure_doubt = 0.1e5;  ///< Pa, on the piston at the crank's radius
    static constexpr double residual_doubt = 2.5;    ///< of the residual (RMS)
    /// The largest residual (RMS) of an accepted fit, as a share of the fitted torque.
    static constexpr double largest_residual = 0.04;
};

/// The check of an input's table, or the reason for none.
InertiaCheck check_inertia(const Input& input);

/// Inertia torque for mⱼ r² ω² = 1, −s′ s″/r², of the input's crank with another r/L.
double unit_inertia_torque(const Input& input, double lambda, double crank_angle_deg);

/// A remedy beside the matching speed: the same input with the torque rebuilt, the fitted inertia
/// torque replaced by the inertia torque of the masses and the speed entered (with r/L of the input
/// where its rod is known, else of the fit). The torque becomes a table.
Input with_rebuilt_torque(const Input& input, const InertiaCheck& check);

}  // namespace ravnoves::balance_shaft
