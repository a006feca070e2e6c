#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "bibliography/formula.h"
#include "case-file/result_visitor.h"
#include "case-file/verdict.h"
#include "elastic-hinge/input.h"
#include "elastic-hinge/result.h"
#include "numerics/units.h"

namespace ravnoves::elastic_hinge {

/// The values of a solved input, in the order of the contract.
void visit_results(ResultVisitor& visitor, const Input& input, const Result& result);
/// The same, which solves the input first.
/// @throws InputError as solve()
void visit_results(ResultVisitor& visitor, const Input& input);

/// What the guides are called, in the order of Hinge.
inline constexpr Text guide_names[] = {Text::tr("Crank guide"),
                                       Text::tr("Crank guide with the rod hinge"),
                                       Text::tr("Rod hinge guide")};

/// A smaller preload beyond the minimum is lost to machining and assembly, m.
inline constexpr double min_preload_margin = 0.05 * units::mm;

/// What the crank's guide is worth: none; one that cannot be made; one that can.
Verdict verdict(const Input& input, const Result& result);

/// The formulas that the result of this input rests on, in the order of the computation.
std::vector<Formula> formulas(const Input& input);

/// What an answer leads with, by pointers below "result".
inline constexpr std::string_view leading[] = {
    "/guide/minimum_preload_mm", "/guide/relief_mm",           "/rod_hinge_moment_integral_J",
    "/counterweight_weight_N",   "/rod_hinge_guide/relief_mm", "/side_force/largest_with_hinge_N"};

/// What the model leaves out, a sentence each.
std::span<const Text> left_out();

}  // namespace ravnoves::elastic_hinge
