#pragma once

#include <vector>

#include "bob-weights/input.h"
#include "case-file/message.h"

namespace ravnoves::bob_weights {

/// The first-order inertia force of the cylinders that one bob weight represents, with
/// counterweights that the bob weight balances: a part that turns with the crank and one that turns
/// against it. Together they run round an ellipse.
///
/// A piston whose axis is at β, its crankpin at ψ, pushes along its axis with
///     m r ω² cos(ψ − β) e^{iβ} = ½ m r ω² (e^{iψ} + e^{2iβ} e^{−iψ}).
/// A mass F m on the crankpin, balanced by the counterweights, removes F m r ω² e^{iψ} from the
/// first part. Of a throw with axes at ±γ/2 and crankpins at φ ∓ δ/2 both add up to
///     (1 − 2F) cos(δ/2) e^{iφ} + cos(γ + δ/2) e^{−iφ},
/// of one cylinder to (½ − F) e^{iφ} + ½ e^{−iφ}.
struct FirstOrder {
    double forward;   ///< kg at the crank radius; signed
    double backward;  ///< kg at the crank radius; signed

    /// Half axes: upright (along the bisector of the banks, or the cylinder) and across, kg.
    double upright() const { return std::abs(forward + backward); }
    double across() const { return std::abs(forward - backward); }
    double maximum() const { return std::abs(forward) + std::abs(backward); }
};

/// Where the force points as the throw turns from upright, a closed curve; kg at the crank radius.
struct ForcePath {
    std::vector<double> across;
    std::vector<double> upright;
};
ForcePath force_path(const FirstOrder& force);

/// How many cylinders the force is of: both of a throw, or one.
bool is_pair(const Engine& engine);

/// @param factor              F in all, overbalance included; 0.5 for 50 %
/// @param reciprocating_mass  m of one cylinder, kg
FirstOrder first_order(const Engine& engine, double factor, double reciprocating_mass);

/// What theory gives: ½ where it makes the forward part vanish, and of split crankpins
/// ½ (1 − |cos(γ + δ/2)| / cos(δ/2)), where the ellipse is a line.
double theory_factor(const Engine& engine);

/// Whether the crankpins balance one another, so that equal bob weights change nothing: of an even
/// number of cylinders in line, four or more.
bool balances_itself(const Engine& engine);

/// Why that, as text.
Message factor_reason(const Engine& engine);

/// What the factor in use makes of the force, as text.
/// @param factor  F in all
Message factor_effect(const Engine& engine, double factor);

}  // namespace ravnoves::bob_weights
