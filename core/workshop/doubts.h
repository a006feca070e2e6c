#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "bob-weights/drilling.h"
#include "case-file/verdict.h"
#include "workshop/input.h"

namespace ravnoves::workshop {

/// What a doubt keeps out of the answer.
struct Withheld {
    bool bob_weight = false;
    bool holes = false;
    bool verdict = false;
    bool limits = false;  ///< what may remain, or the radius that it is at

    bool any() const { return bob_weight || holes || verdict; }
};

struct DoubtSearch;

/// One line of the table of doubts.
struct DoubtRule {
    std::string_view word;  ///< in the result
    Severity severity;
    Withheld blocks;
    std::string_view act;  ///< what would help, as the page knows it; empty where nothing does
    void (*find)(DoubtSearch& job);
    bool is_provisional = false;  ///< the answer will be another once all is known
};

/// All of them, the worst first.
std::span<const DoubtRule> doubt_rules();

/// A doubt of a job.
struct Doubt {
    const DoubtRule* rule;
    Message text;
    std::optional<bob_weights::Hole::Place> hole{};  ///< of the record, that it begins with
};
struct Result;
std::vector<Doubt> find_doubts(const Input& input, const Result& result);

/// The entered mass of a part and the weighed one are not of the same part.
bool contradicts_scale(const Input& input, const bob_weights::PartField& part);

/// An act of the verdict: the columns of the rod's ends change places.
inline constexpr std::string_view swap_ends_act = "swap-rod-ends";
/// An act of the verdict: enter the holes really drilled.
inline constexpr std::string_view drilled_act = "correct-drilled";
/// An act of the verdict: nothing was drilled by the plan printed or put aside.
inline constexpr std::string_view present_plan_act = "use-present-plan";

}  // namespace ravnoves::workshop
