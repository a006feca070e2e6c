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

/// What a doubt keeps out of a workshop's result: it is null there.
struct Withheld {
    bool bob_weight = false;
    bool holes = false;
    bool verdict = false;

    bool any() const { return bob_weight || holes || verdict; }
};
/// The same of a workshop's job, without its verdict.
void visit_job(ResultVisitor& visitor, const Input& input, const Result& result,
               const Withheld& withheld);
/// The values that are withheld from it.
void visit_withheld(ResultVisitor& visitor, const Input& input, const Result& result,
                    const Withheld& withheld);

/// Whether the crankshaft passes; before it is read, what to hang on it.
Verdict verdict(const Input& input, const Result& result,
                const std::array<std::string, 2>& plane_names = {});

}  // namespace ravnoves::bob_weights
