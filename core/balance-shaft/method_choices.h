#pragma once

#include <array>
#include <string_view>

#include "numerics/method_choice.h"

namespace ravnoves::balance_shaft {

/// Mean and RMS of M_ups: PeriodicPiecewise::mean(), variance() and fourier().
inline constexpr MethodChoice cycle_mean_choice{
    "balance-shaft",
    "cycle-mean",
    "exact",
    "pieces",
    1e-9,
    CORE_TEXT("methods",
              "The paper's conclusions use a mean, so it must be the mean of the cycle, not of "
              "some nodes: nine digits for any table. The pieces between the rows are integrated "
              "exactly; then each shaft angle needs three multiplications.")};

/// Range of M_ups at one α: MomentPlane.
inline constexpr MethodChoice moment_range_choice{
    "balance-shaft",
    "moment-range",
    "exact",
    "pieces",
    1e-9,
    CORE_TEXT("methods",
              "The optimum angle compares ranges, so nine digits. Nodes miss a peak between them; "
              "the extremum of a line plus a sine has a closed form, and only the few intervals "
              "that may contain it are solved.")};

/// The angle with the smallest range: minimise_range().
inline constexpr MethodChoice best_angle_choice{
    "balance-shaft",
    "best-angle",
    "cutting-planes",
    "exact",
    1e-9,
    CORE_TEXT("methods",
              "The range is the maximum of many sinusoids, with kinks and several minima. "
              "Sinusoids that bound it from below exclude worse angles, so the optimum is proven, "
              "with fewer evaluations than a scan of 5°.")};

/// The place with the smallest range: minimise_range().
inline constexpr MethodChoice best_position_choice{
    "balance-shaft",
    "best-position",
    "cutting-planes",
    "exact",
    1e-9,
    CORE_TEXT("methods",
              "Over the plane of places the range is convex: the maximum of linear functions minus "
              "their minimum. Planes below find its kinks, where other methods stop or jump, and "
              "prove that no place is better.")};

/// What an answer leads with, below "result".
inline constexpr std::array<std::string_view, 6> leading_results{
    "/metrics/M_ups/range_Nm", "/metrics/M_ups/rms_Nm", "/optimum/range/shaft_angle_deg",
    "/optimum/range/range_Nm", "/moment_amplitude_Nm",  "/flywheel/excess_work_J"};
/// The choices of a method, below "input".
inline constexpr std::array<std::string_view, 1> method_choices{"/interpolation"};

}  // namespace ravnoves::balance_shaft
