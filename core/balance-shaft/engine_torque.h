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

/// Fills in what a computed torque needs and the input lacks: the default length of the rod and
/// bore.
void fill_cylinder(Input& input);

/// Takes the torque from another source. Missing inputs of a computed torque are filled in; a cycle
/// without a load gets the load of the previous torque.
/// @param mean_torque  of the previous torque, N·m, driving where positive
void take_torque_kind(Input& input, TorqueSource::Kind kind, double mean_torque);

/// Engine torque over the crank angle in degrees, in the part that follows the speed and the part
/// that does not: M_id = gas + ω² unit_inertia. What an offset cylinder adds to the tipping moment
/// is in neither (with_offset_term()).
struct TorqueParts {
    PeriodicPiecewise gas;           ///< N·m
    PeriodicPiecewise unit_inertia;  ///< −m_j s′ s″, N·m s², with the same knots

    PeriodicPiecewise at(double angular_speed) const {
        return PeriodicPiecewise::sum(gas, unit_inertia, angular_speed * angular_speed);
    }
};

/// Of an input whose torque is computed: cubics between every 0.5° and every place where the
/// pressure has a kink, so that the curve is the torque itself to about 1e-5 of its range, whatever
/// interpolation a table would have.
TorqueParts torque_parts(const Input& input, const CylinderGas& gas);

/// The parts of a table that belongs to the masses and the speed entered: its fitted inertia torque
/// and the rest. Nothing where it does not belong to them.
std::optional<TorqueParts> torque_parts(const Input& input, const InertiaCheck& check);

/// M_id of a table over the crank angle in degrees, by the interpolation asked for.
PeriodicPiecewise torque_curve(const TorqueTable& table, Interpolation interpolation);

}  // namespace ravnoves::balance_shaft
