#pragma once

#include <cstddef>

#include "bob-weights/drilled.h"
#include "workshop/input.h"
#include "workshop/result.h"

namespace ravnoves::workshop {

/// Computes whatever the input allows, also where check_input() rejects it.
/// @param absent_is_zero  whether missing mass changes count as 0, as in a case; else nothing that
///                        depends on them is computed before they are known
/// @param places_parts    false: without the placing of the parts, which takes longest
Result solve(const Input& input, bool absent_is_zero = true, bool places_parts = true);

/// The same without doubts, for input whose machine shows the heavy spot: the older formats have
/// none, and studies of them solve a hundred thousand times.
Result solve_undoubted(const Input& input, bool absent_is_zero, bool places_parts);

/// The job as of its first `runs` runs: the last of them is the newest.
Input before_run(const Input& input, std::size_t runs);

/// What the readings asked for becomes the record of each run, from one on, that has none.
/// @param solve_then  to the result of the shaft
void record_plans(Input& input, std::size_t first_run, const auto& solve_then) {
    auto& runs = input.correction->earlier_runs;
    for (std::size_t run = first_run; run < runs.size(); ++run) {
        if (!runs[run].drilled) {
            runs[run].drilled = planned_holes(solve_then(before_run(input, run + 1)));
        }
    }
}

/// What of a result may be shown as an answer: without all that its doubts block, and without a
/// verdict where they block anything. Page, card and journal have nothing else.
Result allowed(Result result);

}  // namespace ravnoves::workshop
