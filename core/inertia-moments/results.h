#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "bibliography/formula.h"
#include "case-file/result_visitor.h"
#include "case-file/verdict.h"
#include "inertia-moments/input.h"
#include "inertia-moments/result.h"

namespace ravnoves::inertia_moments {

/// The values of a solved input, in the order of the contract.
void visit_results(ResultVisitor& visitor, const Input& input, const Result& result);
/// The same, which solves the input first.
/// @throws InputError as solve()
void visit_results(ResultVisitor& visitor, const Input& input);

/// The largest residual force and moment of orders 1 to 4, and what puts them in doubt.
Verdict verdict(const Input& input, const Result& result);

/// The formulas that the result of this input rests on, in the order of the computation.
std::vector<Formula> formulas(const Input& input);

/// What an answer leads with, by pointers below "result".
inline constexpr std::string_view leading[] = {
    "/exact/order_1/force_N/forward/amplitude",   "/exact/order_1/force_N/backward/amplitude",
    "/exact/order_1/moment_Nm/forward/amplitude", "/exact/order_1/moment_Nm/backward/amplitude",
    "/exact/order_2/force_N/forward/amplitude",   "/exact/order_2/force_N/backward/amplitude",
    "/exact/order_2/moment_Nm/forward/amplitude", "/exact/order_2/moment_Nm/backward/amplitude"};

/// What the model leaves out, a sentence each.
std::span<const Text> left_out();

}  // namespace ravnoves::inertia_moments
