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
              "The paper's conclusions rest on a mean, so it has to be that of the cycle and not "
              "of a choice of nodes: nine digits for any table, however uneven its rows. The "
              "pieces between the rows are integrated exactly; after that every angle of the shaft "
              "costs three multiplications.")};

/// Range of M_ups at one α: MomentPlane.
inline constexpr MethodChoice moment_range_choice{
    "balance-shaft",
    "moment-range",
    "exact",
    "pieces",
    1e-9,
    CORE_TEXT("methods",
              "The best angle is found from differences of ranges, so nine digits. Nodes miss a "
              "peak between them; the extremum of a line plus a sine is known in closed form, and "
              "only the few intervals that can hold it are solved.")};

/// The angle with the least range: minimise_range().
inline constexpr MethodChoice best_angle_choice{
    "balance-shaft",
    "best-angle",
    "cutting-planes",
    "exact",
    1e-9,
    CORE_TEXT(
        "methods",
        "The range is the largest of many sinusoids: it has kinks at its minima and several of "
        "them. Sinusoids that bound it from below tell where no better angle can be, so the best "
        "one is found and not just a good one, with fewer evaluations than a scan of 5°.")};

/// The place with the least range: minimise_range().
inline constexpr MethodChoice best_position_choice{
    "balance-shaft",
    "best-position",
    "cutting-planes",
    "exact",
    1e-9,
    CORE_TEXT("methods",
              "Over the plane of places the range is convex: the largest of linear functions less "
              "the smallest. Planes under it find its kinks, where methods without slopes stop "
              "short and methods with slopes jump, and prove that no place is better.")};

/// What an answer leads with, below "result".
inline constexpr std::array<std::string_view, 6> leading_results{
    "/metrics/M_ups/range_Nm", "/metrics/M_ups/rms_Nm", "/optimum/range/shaft_angle_deg",
    "/optimum/range/range_Nm", "/moment_amplitude_Nm",  "/flywheel/excess_work_J"};
/// The choices of a method, below "input".
inline constexpr std::array<std::string_view, 1> method_choices{"/interpolation"};

}  // namespace ravnoves::balance_shaft
