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
              "Uncertain inputs are known to a few digits, so a hundredth of the standard "
              "deviation suffices. Slopes give that for a few samples, but fail unnoticed where an "
              "optimum jumps or a clearance limits. Scrambled Sobol points give it everywhere with "
              "the fewest samples; other seeds show their error.")};

}  // namespace ravnoves::studies
