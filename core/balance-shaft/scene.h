#pragma once

#include "balance-shaft/input.h"
#include "balance-shaft/result.h"
#include "balance-shaft/solver.h"
#include "case-file/case_context.h"
#include "case-file/json_fwd.h"
#include "case-file/wanted.h"

namespace ravnoves::balance_shaft {

/// Reads the "input" object of a case.
/// @throws InputError that names the JSON pointer
Input read_input(const Json& input, const CaseContext& context);
/// The "input" object that reads back to the same Input.
Json write_input(const Input& input);
/// The unused sources of torque in the input, as "kept" of its case; null without any.
Json write_kept(const Input& input);
/// Takes them over into an input that was read. A file that cannot be read stays named.
/// @throws InputError that names the JSON pointer
void read_kept(const Json& kept, const CaseContext& context, Input& input);
/// The scene as the case file sees it.
/// @throws InputError
Json solve_scene(const Json& input, const CaseContext& context, const Wanted& wanted = {});

}  // namespace ravnoves::balance_shaft
