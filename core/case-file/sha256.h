#pragma once

#include <string>
#include <string_view>

#include "case-file/message.h"

namespace ravnoves {

/// SHA-256 [fips-180-4] of bytes, as 64 hexadecimal digits.
std::string sha256(std::string_view bytes);

/// Whether a sum that is kept is not the one there is now; its digits may be capitals, as some
/// programs print them. Where none is kept, nothing is known.
bool is_other_sum(std::string_view kept, std::string_view now);
/// That a file of a case has another sum than the case keeps.
Message changed_note(const std::string& file);

}  // namespace ravnoves
