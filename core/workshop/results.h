#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "bibliography/formula.h"
#include "case-file/result_visitor.h"
#include "case-file/verdict.h"
#include "workshop/input.h"
#include "workshop/result.h"

namespace ravnoves::workshop {

/// The values of a solved input, in the order of the contract. A value that a doubt blocks is null,
/// and the number is under "doubtful".
/// @param result  solve(input) of an input with everything that a result needs
void visit_results(ResultVisitor& visitor, const Input& input, const Result& result);
/// The same, which solves the input first.
void visit_results(ResultVisitor& visitor, const Input& input);

/// The contents of "plugs".
void visit_plugs(ResultVisitor& visitor, const Input& input, const Result& result);

/// Of the job, also of a sheet half filled: STOP where a doubt blocks something, else pass or fail,
/// else what to hang. It names every warning.
Verdict verdict(const Input& input, const Result& result);
/// The same beside a list of the warnings: no more than that there are any.
Verdict short_verdict(const Input& input, const Result& result);

/// Formulas of the plugs, if any, and of bob weight and correction.
std::vector<Formula> formulas(const Input& input);
/// What an answer leads with, by pointers below "result".
inline constexpr std::string_view leading[] = {"/bobweight_g",
                                               "/plugs/options/steel-machined/required_reduction_g",
                                               "/correction/planes/0/unbalance_g_mm",
                                               "/correction/planes/1/unbalance_g_mm",
                                               "/correction/planes/0/remaining_g_mm",
                                               "/correction/planes/1/remaining_g_mm"};

/// What the models leave out.
std::span<const Text> left_out();

}  // namespace ravnoves::workshop
