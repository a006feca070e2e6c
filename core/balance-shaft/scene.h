#pragma once

#include "case-file/case_file.h"

namespace ravnoves::balance_shaft {

/// The scene "balance-shaft" of case files.
/// @throws InputError
Json solve_scene(const Json& input, const CaseContext& context);

}  // namespace ravnoves::balance_shaft
