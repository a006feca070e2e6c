#pragma once

#include <array>
#include <string>

#include "bob-weights/input.h"
#include "bob-weights/result.h"
#include "case-file/result_visitor.h"
#include "case-file/verdict.h"

namespace ravnoves::bob_weights {

/// The values of a solved input, in the order of the contract.
/// @param result  solve(input) of an input that holds all that a result needs
void visit_results(ResultVisitor& visitor, const Input& input, const Result& result);
/// The same, which solves the input first.
void visit_results(ResultVisitor& visitor, const Input& input);

/// The same of a workshop's job, without its verdict; what is not known, or withheld, is null.
void visit_job(ResultVisitor& visitor, const Input& input, const Result& result);
/// Of it the bob weight with its lines, or the planes alone.
void visit_bob_weight(ResultVisitor& visitor, const Input& input, const Result& result);
void visit_planes(ResultVisitor& visitor, const Input& input, const Result& result);

/// Whether the crankshaft passes; before it is read, what to hang on it.
Verdict verdict(const Input& input, const Result& result,
                const std::array<std::string, 2>& plane_names = {});

}  // namespace ravnoves::bob_weights
