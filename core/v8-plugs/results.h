#pragma once

#include <optional>
#include <vector>

#include "bibliography/formula.h"
#include "case-file/result_visitor.h"
#include "case-file/verdict.h"
#include "v8-plugs/input.h"
#include "v8-plugs/result.h"

namespace ravnoves::v8_plugs {

/// The values of a solved input, in the order of the contract; without advice, the work on the
/// plugs is null.
/// @param result   solve(input) of an input with everything that a result needs
/// @param placing  of the weighed parts, by excess_factors()
/// @param speed    in service, rad/s
void visit_plugs(ResultVisitor& visitor, const Input& input, const Result& result,
                 const std::optional<shop::Matched>& placing, const std::optional<double>& speed);

/// The instruction of an option, with the mass to take off each plug, kg.
Message describe_action(const Option& option, double reduction);
/// Why an option does not work (residual beyond the tolerance); empty where it does.
Message describe_failure(const Option& option, double tolerance);
/// "works", within which tolerance it does, or why it does not.
Message describe_verdict(const Option& option, double tolerance);
/// The work on the plugs as a technician would say it; where the neglected shift of their centre of
/// mass matters, with the mass that counts it.
Message plug_work(const Input& input, const Result& result);

/// Whether the plugs can compensate, without machine and warnings.
Verdict verdict_of_plugs(const Input& input, const Result& result);

/// That the plug's sizes do not fit its mass, as it was entered or as the paper prints it.
struct PlugDoubt {
    Message text;             ///< empty where they do
    bool is_certain = false;  ///< the answer uses a mass that no bore makes right
};
PlugDoubt plug_doubt(const Input& input, const Result& result);

/// How often a heavier big end counts, and for what; empty while that is not known.
Message rod_note(const Input& input, const Result& result);

/// A sentence for each limit of a plug that is the paper's, where mass or sizes of that plug are
/// other ones.
std::vector<Message> paper_limits(const Input& input, const Result& result);

/// The formulas that the result of this input rests on, in the order of the computation.
std::vector<Formula> formulas(const Input& input);

}  // namespace ravnoves::v8_plugs
