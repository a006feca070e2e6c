#pragma once

#include <array>
#include <string>
#include <vector>

#include "bibliography/formula.h"
#include "bob-weights/input.h"
#include "bob-weights/result.h"
#include "case-file/result_visitor.h"
#include "case-file/verdict.h"

namespace ravnoves::bob_weights {

/// The values of a solved job but for its verdict, in the order of the contract; unknown and
/// withheld ones are null.
/// @param result  solve(input) of an input with everything that a result needs
void visit_job(ResultVisitor& visitor, const Input& input, const Result& result);
/// The bob weight with its lines, or the planes alone.
void visit_bob_weight(ResultVisitor& visitor, const Input& input, const Result& result);
void visit_planes(ResultVisitor& visitor, const Input& input, const Result& result);

/// Whether the crankshaft passes; before it is read, what to hang on it.
Verdict verdict(const Input& input, const Result& result,
                const std::array<std::string, 2>& plane_names = {});

/// The formulas that the result of this input rests on, in the order of the computation.
std::vector<Formula> formulas(const Input& input);

}  // namespace ravnoves::bob_weights
