#pragma once

#include "workshop/input.h"
#include "workshop/result.h"

namespace ravnoves::workshop {

/// Computes whatever the input allows, also where check_input() does not let it pass.
/// @param changes_known  false: nothing that rests on the mass changes of the plugs; a case counts
///                       those that it does not give as 0
/// @param places_parts   false: without the placing of the parts, which takes longest
Result solve(const Input& input, bool changes_known = true, bool places_parts = true);

/// What of a result may be shown as an answer: without all that its doubts block, and without a
/// verdict where they block anything. Page, card and journal have nothing else.
Result allowed(Result result);

}  // namespace ravnoves::workshop
