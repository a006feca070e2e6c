#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "bob-weights/input.h"
#include "bob-weights/result.h"

/// The record of drilled holes, as the case keeps it.
namespace ravnoves::bob_weights {

/// Metal drilled and pressed in after a run, by the case.
/// @param run     its place among the runs
/// @param before  metal drilled there and pressed in after the runs before it
std::array<Metal, 2> recorded(const std::vector<DrilledHole>& holes, const Correction& correction,
                              std::size_t run, const std::array<Metal, 2>& before);

/// The holes of the record, each with its place, run by run.
auto recorded_holes(auto& correction) {
    std::vector<std::pair<Hole::Place, decltype(&correction->record.drilled->front())>> holes;
    for (std::size_t run = 0; correction && run <= correction->earlier_runs.size(); ++run) {
        auto& drilled = run < correction->earlier_runs.size()
                            ? correction->earlier_runs[run].drilled
                            : correction->record.drilled;
        for (std::size_t hole = 0; drilled && hole < drilled->size(); ++hole) {
            holes.emplace_back(Hole::Place{run, hole}, &(*drilled)[hole]);
        }
    }
    return holes;
}

/// The holes planned by the present run, for its record: none where its readings are no longer
/// valid.
/// @return empty while there is no plan
std::optional<std::vector<DrilledHole>> planned_holes(const Result& result);

/// Whether the plan that the shop has, printed or put aside, is not the present one.
bool is_other_plan(const Correction& correction, const Result& result);

}  // namespace ravnoves::bob_weights
