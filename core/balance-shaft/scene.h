#pragma once

#include "balance-shaft/balance_shaft.h"
#include "case-file/case_file.h"

namespace ravnoves::balance_shaft {

/// The scene "balance-shaft" of case files.
/// @throws InputError
Json solve_scene(const Json& input, const CaseContext& context);

/// The whole "result" object: write_result() and what is computed beside it (crank-only balancing,
/// gear error) at the result's α. Page and command line both print this.
Json write_whole_result(const Solver& solver, const Result& result);

}  // namespace ravnoves::balance_shaft
