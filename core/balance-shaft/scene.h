#pragma once

#include "balance-shaft/balance_shaft.h"
#include "case-file/case_context.h"
#include "case-file/json_fwd.h"

namespace ravnoves::balance_shaft {

/// The scene "balance-shaft" of case files.
/// @throws InputError
Json solve_scene(const Json& input, const CaseContext& context);

/// What a page shows before sizes are entered: a bar of 50 mm, relieved over 400 mm.
inline constexpr RelievedShaftSizes default_relieved_shaft{0.050, std::nullopt, 0.400};

/// The relieved shaft for the solver's m₁ ρ₁ and speed, with the input's sizes or the default ones.
RelievedShaft relieved_shaft(const Solver& solver);

/// The whole "result" object: write_result() and what is computed beside it (crank-only balancing,
/// gear error) at the result's α. Page and command line both print this.
Json write_whole_result(const Solver& solver, const Result& result);

}  // namespace ravnoves::balance_shaft
