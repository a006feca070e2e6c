#pragma once

#include <optional>

#include "balance-shaft/angle_search.h"
#include "balance-shaft/engine_torque.h"
#include "balance-shaft/input.h"
#include "balance-shaft/result.h"
#include "numerics/angle.h"

namespace ravnoves::balance_shaft {

/// The moments on the mounts at every α: what the solver's result begins with, without the front
/// view, the curves and the sweep.
struct Moments {
    SliderCrank<double> crank;
    double top;  ///< θ at top dead centre, where φ is 0, rad
    PistonFirstOrder piston_1;
    double phase;  ///< M_s = P₁ l sin(α + φ + phase), rad
    Forces forces;
    std::optional<CylinderGas> gas;  ///< where the torque is computed
    PeriodicPiecewise torque;        ///< M_id over φ in degrees, given or computed
    PeriodicPiecewise moment;        ///< M_up over φ in degrees
    MomentPlane plane;               ///< of M_up

    /// @param checked  as check_input() leaves it
    explicit Moments(const Input& checked);

    /// Follows an input of the same tipping moment.
    void follow(const Input& checked);

    /// M_s at an angle.
    MomentPlane::Moment shaft_moment(double alpha) const {
        return shaft_at(forces.moment_amplitude, alpha + phase);
    }

    /// What a result says of all this, at the input's α: its numbers up to the metrics and their
    /// changes. @param optima  the best α as well
    void fill(const Input& input, bool optima, Result& result) const;
    /// The part of that which follows the shaft's angle.
    void move_shaft(double alpha, Result& result) const;
};

/// From where to where the range is as small as at the best angle, but for rounding: it is where
/// its maximum and its minimum are a turn apart, which the shaft moves alike. Empty where it is
/// not.
/// @param best  in the angle of the plane
Message flat_note(const Moments& moments, const AngleMinimum& best);

/// Whether what M_up follows from is the same in both: a torque that is given, or all that a
/// computed one and the offset's part depend on.
bool have_same_tipping_moment(const Input& one, const Input& other);

/// Values that differ by less than this part of their size are equal: the rest is rounding.
inline constexpr double rounding_share = 1e-12;

}  // namespace ravnoves::balance_shaft
