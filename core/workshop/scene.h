#pragma once

#include <optional>
#include <string_view>

#include "case-file/case_context.h"
#include "case-file/case_file.h"
#include "case-file/field_reader.h"
#include "case-file/json_fwd.h"
#include "case-file/wanted.h"
#include "workshop/input.h"

namespace ravnoves::workshop {

/// Reads the case's "input" object. As it is, rules that join values are left to the page.
/// @throws InputError
Input read_input(const Json& input, Completeness completeness = Completeness::required);
/// Writes an "input" object that read_input() turns into the same Input.
Json write_input(const Input& input);

/// The input of another scene of the workshop as a job that gives the same numbers. Holes that a
/// case of bob-weights plans of itself after earlier runs become a record.
Input as_job(v8_plugs::Input plugs);
Input as_job(bob_weights::Input shaft);
/// The input of a case of the scenes v8-plugs or bob-weights as a job.
/// @return nothing for other scenes
/// @throws InputError as those scenes
std::optional<Input> read_as_job(std::string_view scene, const Json& input,
                                 Completeness completeness = Completeness::required);

/// A case of the scenes v8-plugs or bob-weights as one of workshop, half filled or not, with its
/// variants, and its study with the pointers of a job; any other as it is.
/// @throws InputError as those scenes
CaseFile as_job(CaseFile file);

/// The scene as the case file sees it.
/// @throws InputError
Json solve_scene(const Json& input, const CaseContext& context, const Wanted& wanted = {});

}  // namespace ravnoves::workshop
