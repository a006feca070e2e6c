#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "studies/study.h"

namespace ravnoves {

/// Between order statistics.
double percentileOf(const std::vector<double>& ascending, double share);

inline constexpr int scatteredSamples = 128;
/// 128 samples of inputs that scatter by these laws, evenly also by themselves; Sobol points
/// but for Monte Carlo.
std::vector<std::vector<double>> samplesOf(const std::vector<studies::Law>& laws,
                                           studies::Method method, std::uint64_t seed);

}  // namespace ravnoves
