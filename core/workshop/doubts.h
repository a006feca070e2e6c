#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "bob-weights/result.h"
#include "case-file/verdict.h"
#include "v8-plugs/result.h"
#include "workshop/input.h"

namespace ravnoves::workshop {

/// What a doubt keeps out of the answer.
struct Withheld {
    bool bob_weight = false;
    bool holes = false;
    bool verdict = false;

    bool any() const { return bob_weight || holes || verdict; }
};

/// What a rule looks at.
struct DoubtCase {
    const Input& input;
    const bob_weights::Result& shaft;
    const v8_plugs::Input* plugs_input;  ///< whole_plugs(); null without plugs
    const v8_plugs::Result* plugs;
};

/// One line of the table of doubts.
struct DoubtRule {
    std::string_view word;  ///< in the result
    Severity severity;
    Withheld blocks;
    std::string_view act;  ///< what would help, as the page knows it; empty where nothing does
    std::vector<Message> (*find)(const DoubtCase& job);  ///< each with what to do
    bool is_provisional = false;  ///< the answer will be another once all is known
};

/// All of them, the worst first.
std::span<const DoubtRule> doubt_rules();

/// A doubt of a job.
struct Doubt {
    const DoubtRule* rule;
    Message text;
};
std::vector<Doubt> find_doubts(const DoubtCase& job);

/// The entered mass of a part and the weighed one are not of the same part.
bool contradicts_scale(const Input& input, const bob_weights::PartField& part);

/// An act of the verdict: the columns of the rod's ends change places.
inline constexpr std::string_view swap_ends_act = "swap-rod-ends";
/// An act of the verdict: enter the holes really drilled.
inline constexpr std::string_view drilled_act = "correct-drilled";

}  // namespace ravnoves::workshop
