#pragma once

#include <optional>
#include <vector>

#include "balance-shaft/cylinder_gas.h"
#include "balance-shaft/inertia_check.h"
#include "balance-shaft/input.h"
#include "numerics/periodic_piecewise.h"

namespace ravnoves::balance_shaft {

/// The mechanism of an input. Crank angles φ of inputs and results count from the true top dead
/// centre, so its θ is φ + top_dead_centre().
SliderCrank<double> slider_crank(const Input& input);

/// The gas side of an input whose torque is computed, else nothing.
/// @throws InputError where the cycle cannot be
std::optional<CylinderGas> cylinder_gas(const Input& input);

/// Engine torque at rows of one cycle, in the part that follows the speed and the part that does
/// not: M_id = gas + ω² unit_inertia. What an offset cylinder adds to the tipping moment is in
/// neither (with_offset_term()).
struct TorqueParts {
    std::vector<double> crank_angle_deg;  ///< rows, the last one 720° after the first
    std::vector<double> gas;              ///< N·m
    std::vector<double> unit_inertia;     ///< −m_j s′ s″, N·m s²

    std::vector<double> torque(double angular_speed) const;  ///< M_id, N·m
};

/// The parts of a computed torque, every 0.5° (every 0.1° at the finest where a trace is finer).
TorqueParts torque_parts(const Input& input, const CylinderGas& gas);

/// The parts of a table that belongs to the masses and the speed entered: its fitted inertia torque
/// and the rest. Nothing where it does not belong to them.
std::optional<TorqueParts> torque_parts(const Input& input, const InertiaCheck& check);

/// −M_id over the crank angle in degrees, by the interpolation asked for.
PeriodicPiecewise tipping_moment(const std::vector<double>& crank_angle_deg,
                                 const std::vector<double>& torque, Interpolation interpolation);

}  // namespace ravnoves::balance_shaft
