#pragma once

#include <memory>
#include <span>
#include <string>

#include "balance-shaft/input.h"
#include "case-file/response.h"

namespace ravnoves::balance_shaft {

/// A response that solves no more than the moments on the mounts, for studies of metrics and best
/// α: the same numbers as solve_scene(), in microseconds.
/// @param input  as read_input() leaves it
/// @return nothing where a pointer asks for more
std::unique_ptr<Response> quick_response(const Input& input, std::span<const std::string> varied,
                                         std::span<const std::string> watched);

}  // namespace ravnoves::balance_shaft
