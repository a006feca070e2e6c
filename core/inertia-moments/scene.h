#pragma once

#include "case-file/case_context.h"
#include "case-file/json_fwd.h"
#include "case-file/wanted.h"
#include "inertia-moments/input.h"

namespace ravnoves::inertia_moments {

/// Reads the "input" object of a case.
///
/// Beyond the contract's keys: `layout` may be {"type": "library", "name", …sizes…}, and the
/// optional objects `rod`, `balance_shafts`, `balance_shaft_basis`, `counterweights`,
/// `firing_order` (of a table) and `step_deg` (adds the curves to the result).
/// @throws InputError that names the JSON pointer
Input read_input(const Json& input);

/// The "input" object that reads back to the same Input.
Json write_input(const Input& input);

/// The scene as the case file sees it.
/// @throws InputError
Json solve_scene(const Json& input, const CaseContext& context, const Wanted& wanted = {});

}  // namespace ravnoves::inertia_moments
