#pragma once

#include "balance-shaft/input.h"

namespace ravnoves::balance_shaft {

/// check_input() without the ranges of the single fields.
/// @throws InputError
void check_joined(const Input& input);

}  // namespace ravnoves::balance_shaft
