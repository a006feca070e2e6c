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

/// The angles of the shaft that can be built as these numbers vary; those of shaft_angle too, which
/// they do not depend on.
/// @param input  as read_input() leaves it
/// @return nothing where a pointer is not a number of its own
BuildableOf quick_buildable(const Input& input, std::span<const std::string> varied);

}  // namespace ravnoves::balance_shaft
