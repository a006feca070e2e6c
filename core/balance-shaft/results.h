#pragma once

#include "balance-shaft/input.h"
#include "balance-shaft/solver.h"
#include "case-file/result_visitor.h"
#include "case-file/verdict.h"

namespace ravnoves::balance_shaft {

/// The values of a solved input, in the order of the contract.
void visit_results(ResultVisitor& visitor, const Solver& solver, const Result& result);
/// The same, which computes first what the visitor wants.
/// @param input  as check_input() leaves it
/// @throws InputError as Solver
void visit_results(ResultVisitor& visitor, const Input& input);

/// Whether the shaft fits, and what it does to the moment on the mounts; or a slip of the input
/// that puts this in doubt.
Verdict verdict(const Result& result);

}  // namespace ravnoves::balance_shaft
