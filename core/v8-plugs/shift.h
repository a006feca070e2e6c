#pragma once

#include <optional>

#include "v8-plugs/compensation.h"
#include "v8-plugs/plug_geometry.h"

namespace ravnoves::v8_plugs {

/// Effect on a crankpin of the shift of a machined plug's centre of mass towards the crank axis,
/// which the method neglects (2): that much is overcompensated. From the planned bore, or for the
/// range of shifts that the paper gives.
struct ShiftEffect {
    bool planned = false;    ///< from the bore; then smallest and largest are the same
    double min_shift = 0.0;  ///< Δr, m
    double max_shift = 0.0;  ///< m
    double minimum = 0.0;    ///< compensated beyond what the method counts, kg·m
    double maximum = 0.0;    ///< kg·m
    /// Residual on a crankpin with it, the worse of both ends, kg·m; negative: too much is
    /// compensated.
    double residual_unbalance = 0.0;
    /// The option works by the method's count, and with the shift it leaves more than the
    /// tolerance.
    bool matters = false;
    /// What to take off one plug so that with the shift the residual is zero, kg; within the limit
    /// of the plug. For the maximum and for the minimum shift.
    double min_reduction = 0.0;
    double max_reduction = 0.0;
    /// The same for the shift halfway, where both ends of the range leave the same residual; and
    /// that residual, kg·m.
    double reduction = 0.0;
    double uncertainty = 0.0;
    double radius = 0.0;          ///< of the centre of mass of a plug with that taken off, m
    std::optional<double> depth;  ///< of the bore for that, from the face, m; where planned

    friend bool operator==(const ShiftEffect&, const ShiftEffect&) = default;
};

/// Nothing where the option takes nothing off its plugs.
/// @param setup  where it is known
std::optional<ShiftEffect> shift_effect(const Option& option, double tolerance,
                                        const std::optional<BoreSetup>& setup);

/// The warning, with what to do instead; empty where the shift does not matter.
Message describe(const ShiftEffect& effect, double tolerance);
}  // namespace ravnoves::v8_plugs
