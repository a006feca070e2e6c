#pragma once

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
    "dormand-prince",
    "1e-11",
    1e-7,
    CORE_TEXT(
        "methods",
        "Ripple and energy drift are read off to parts of a million, after up to a thousand turns: "
        "so an error of 1e-7 a turn. Step control finds the few steep places of a turn by itself; "
        "a fixed step that held at λ = 0.95 would be wasted everywhere else.")};

}  // namespace ravnoves::elastic_hinge
