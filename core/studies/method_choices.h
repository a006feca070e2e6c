#pragma once

#include "numerics/method_choice.h"

namespace ravnoves::studies {

/// Mean and standard deviation of results whose inputs scatter: Sampler, as the window begins.
inline constexpr MethodChoice scatter_choice{
    "balance-shaft",
    "scatter",
    "sobol",
    "4096 samples",
    1e-2,
    CORE_TEXT("methods",
              "What scatters is known to a few digits itself, so a hundredth of the standard "
              "deviation will do. Slopes give that for the price of some samples, but not where an "
              "optimum jumps or a clearance binds, and they do not know that they fail there. "
              "Scrambled Sobol points hold it everywhere with the fewest samples, and other seeds "
              "tell their error.")};

}  // namespace ravnoves::studies
