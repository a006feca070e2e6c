#pragma once

#include <string>

#include "case-file/json_fwd.h"

namespace ravnoves {

/// What `dump()` writes, byte by byte, in half the time: results are long lists of numbers.
/// @param indent  spaces of a level; negative: all on one line
/// @param mends   bytes that are not UTF-8 become U+FFFD; else nlohmann::json::type_error is thrown
std::string json_text(const Json& value, int indent, bool mends = false);

}  // namespace ravnoves
