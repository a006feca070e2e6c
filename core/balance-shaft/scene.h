#pragma once

#include "balance-shaft/input.h"
#include "balance-shaft/result.h"
#include "balance-shaft/solver.h"
#include "case-file/case_context.h"
#include "case-file/case_file.h"
#include "case-file/json_fwd.h"

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
/// Cases of before have the cylinder's sizes in the object of their torque and in the envelope:
/// moves them to "cylinder", and what a study varies there. The bore of a kept torque that is
/// another than the cylinder's is left out, which CaseFile::changes says.
/// @throws InputError that names both places where two sizes differ
void gather_cylinder(CaseFile& file);

}  // namespace ravnoves::balance_shaft
