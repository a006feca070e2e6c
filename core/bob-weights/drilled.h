#pragma once

#include <array>
#include <optional>
#include <vector>

#include "bob-weights/input.h"
#include "bob-weights/result.h"

/// The record of what was drilled, as the case keeps it.
namespace ravnoves::bob_weights {

/// What the case says is drilled and pressed in after a run.
/// @param run     its place among the earlier runs
/// @param before  what was drilled there and pressed in after those before it
std::array<Metal, 2> recorded(const std::vector<DrilledHole>& holes, const Correction& correction,
                              std::size_t run, const std::array<Metal, 2>& before);

/// What is to be drilled by the run that is corrected, for the record of it: nothing where its
/// readings do not hold.
/// @return empty while there is no plan
std::optional<std::vector<DrilledHole>> planned_holes(const Result& result);

}  // namespace ravnoves::bob_weights
