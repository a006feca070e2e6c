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
              "A guide acts by its relief, which may be a few micrometres on a radius of a hundred "
              "millimetres: seven digits of the relief. The closed form needs no step and no "
              "start. Without a difference of nearly equal squares it stays accurate until the "
              "spring releases all its energy.")};

/// Motion with hinges: simulate() at MotionSetup's own tolerance.
inline constexpr MethodChoice motion_choice{
    "elastic-hinge",
    "hinge-motion",
    "energy-series",
    "1e-8",
    1e-7,
    CORE_TEXT("methods",
              "Ripple is read to parts of a million after up to a thousand turns: an error of 1e-7 "
              "a turn. The energy gives the speed at every angle; only the time is integrated, "
              "without drift. Adaptive series find the steep places of a turn, also with a moment "
              "on the crank, from rest and up to a reversal.")};

/// What an answer leads with, below "result".
inline constexpr std::array<std::string_view, 6> leading_results{
    "/guide/minimum_preload_mm", "/guide/relief_mm",           "/rod_hinge_moment_integral_J",
    "/counterweight_weight_N",   "/rod_hinge_guide/relief_mm", "/side_force/largest_with_hinge_N"};
/// The choices of a method, below "input".
inline constexpr std::array<std::string_view, 1> method_choices{"/kinematics"};

}  // namespace ravnoves::elastic_hinge
