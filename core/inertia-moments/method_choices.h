#pragma once

#include <array>
#include <string_view>

#include "numerics/method_choice.h"

namespace ravnoves::inertia_moments {

/// Piston motion on the nodes of a turn: SliderCrank with the sines that UniformTransform keeps.
inline constexpr MethodChoice slider_crank_choice{
    "inertia-moments",
    "slider-crank",
    "exact-table",
    "double",
    1e-9,
    CORE_TEXT("methods",
              "Reports print six digits, and balanced layouts must give zero as a difference of "
              "large forces: nine digits. The exact form needs one square root; a series of the "
              "same cost has three digits at λ = 0.5 and none near locking. The sines of the nodes "
              "are stored: every cylinder and turn needs them.")};

/// Orders of force and torque: discrete Fourier transform whose length follows from the accuracy.
inline constexpr MethodChoice orders_choice{
    "inertia-moments",
    "inertia-orders",
    "transform-by-accuracy",
    "1e-13",
    1e-11,
    CORE_TEXT("methods",
              "In a balanced layout orders cancel and only rounding may remain: eleven digits. No "
              "fixed number of points suffices for every λ and K; the number follows from the "
              "known decay of the orders.")};

/// What an answer leads with, below "result".
inline constexpr std::array<std::string_view, 8> leading_results{
    "/exact/order_1/force_N/forward/amplitude",   "/exact/order_1/force_N/backward/amplitude",
    "/exact/order_1/moment_Nm/forward/amplitude", "/exact/order_1/moment_Nm/backward/amplitude",
    "/exact/order_2/force_N/forward/amplitude",   "/exact/order_2/force_N/backward/amplitude",
    "/exact/order_2/moment_Nm/forward/amplitude", "/exact/order_2/moment_Nm/backward/amplitude"};

}  // namespace ravnoves::inertia_moments
