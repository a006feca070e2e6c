#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "balance-shaft/input.h"
#include "balance-shaft/moments.h"
#include "balance-shaft/solver.h"
#include "bibliography/formula.h"
#include "case-file/result_visitor.h"
#include "case-file/verdict.h"

namespace ravnoves::balance_shaft {

/// The values of the result, in the order of the contract.
/// @param input  as check_input() leaves it
/// @throws InputError as Solver
void visit_results(ResultVisitor& visitor, const Input& input);

/// visit_results() of inputs that differ in a few numbers: what these leave as it was is computed
/// once. For one thread at a time.
class RepeatedResults {
  public:
    /// @param input  as check_input() leaves it
    /// @throws InputError as visit_results()
    void visit(ResultVisitor& visitor, const Input& input);

  private:
    const Moments& moments_of(const Input& input);

    std::optional<Moments> moments_;
    Input moments_of_;
};

/// Acts of the verdict: the trace belongs a turn earlier or later; a better α is feasible; only
/// another place of the shaft has a smaller range.
inline constexpr std::string_view move_trace_act = "move-trace";
inline constexpr std::string_view best_range_act = "best-range";
inline constexpr std::string_view best_place_act = "best-place";

/// Whether the shaft fits, and its effect on the moment on the mounts; or a slip of the input that
/// makes this doubtful.
Verdict verdict(const Result& result);

/// The formulas that the result of this input rests on, in the order of the computation.
std::vector<Formula> formulas(const Input& input);

/// What an answer leads with, by pointers below "result".
inline constexpr std::string_view leading[] = {
    "/metrics/M_ups/range_Nm", "/metrics/M_ups/rms_Nm", "/optimum/range/shaft_angle_deg",
    "/optimum/range/range_Nm", "/moment_amplitude_Nm",  "/flywheel/excess_work_J"};

/// What the model leaves out, a sentence each.
std::span<const Text> left_out();

}  // namespace ravnoves::balance_shaft
