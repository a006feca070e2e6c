#pragma once

#include <array>
#include <string_view>

#include "numerics/method_choice.h"

namespace ravnoves::elastic_hinge {

/// Radius of the crank's guide: guide_radius().
inline constexpr MethodChoice guide_choice{
    "elastic-hinge",
    "guide",
    "closed-form",
    "free of cancellation",
    1e-7,
    CORE_TEXT("methods",
              "What a guide does lies in its relief, which may be a few micrometres on a radius of "
              "a hundred millimetres: seven digits of the relief. The closed form needs no step "
              "and no start; written without a difference of nearly equal squares it keeps its "
              "digits down to the point where the spring gives out all that it stores.")};

/// Motion with hinges: simulate() at MotionSetup's own tolerance.
inline constexpr MethodChoice motion_choice{
    "elastic-hinge",
    "hinge-motion",
    "energy-series",
    "1e-8",
    1e-7,
    CORE_TEXT(
        "methods",
        "Ripple is read off to parts of a million, after up to a thousand turns: so an error of "
        "1e-7 a turn. The energy gives the speed at every angle, so only the time is integrated, "
        "and nothing can drift. Series over stretches that are halved where they must be find the "
        "steep places of a turn by themselves, and they hold with a moment on the crank, from rest "
        "and up to a reversal, where turns do not repeat.")};

/// What an answer leads with, below "result".
inline constexpr std::array<std::string_view, 6> leading_results{
    "/guide/minimum_preload_mm", "/guide/relief_mm",           "/rod_hinge_moment_integral_J",
    "/counterweight_weight_N",   "/rod_hinge_guide/relief_mm", "/side_force/largest_with_hinge_N"};
/// The choices of a method, below "input".
inline constexpr std::array<std::string_view, 1> method_choices{"/kinematics"};

}  // namespace ravnoves::elastic_hinge
