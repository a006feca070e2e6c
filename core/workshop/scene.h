#pragma once

#include "case-file/case_context.h"
#include "case-file/field_reader.h"
#include "case-file/json_fwd.h"
#include "case-file/wanted.h"
#include "workshop/input.h"

namespace ravnoves::workshop {

/// Reads the case's "input" object. With Completeness::as_is, rules that join values are left to
/// the page.
/// @throws InputError
Input read_input(const Json& input, Completeness completeness = Completeness::required);
/// Writes an "input" object that read_input() turns into the same Input.
Json write_input(const Input& input);

/// The scene as the case file sees it.
/// @throws InputError
Json solve_scene(const Json& input, const CaseContext& context, const Wanted& wanted = {});

}  // namespace ravnoves::workshop
