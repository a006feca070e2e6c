#pragma once

#include <optional>
#include <vector>

#include "bob-weights/result.h"
#include "v8-plugs/input.h"
#include "v8-plugs/result.h"
#include "workshop/doubts.h"

namespace ravnoves::workshop {

/// Everything that page, card and result file show. Nothing is left out for a doubt here: what a
/// doubt blocks is withheld where it is shown.
struct Result {
    bob_weights::Result shaft;
    std::optional<v8_plugs::Input> plugs_input;  ///< whole_plugs() of the solved input
    std::optional<v8_plugs::Result> plugs;
    std::vector<Doubt> doubts;

    /// What the doubts block together.
    Withheld withheld() const;
    /// Whether the answer rests on values that will be others.
    bool is_provisional() const;
};

}  // namespace ravnoves::workshop
