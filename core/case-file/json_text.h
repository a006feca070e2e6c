#pragma once

#include <string>

#include "case-file/json_fwd.h"

namespace ravnoves {

/// Whether the text of a value is broken into lines.
enum class JsonLayout {
    lines,    ///< each value on a line of its own, two blanks deeper than its container
    one_line  ///< without a blank or a break
};

/// Laid out as by the library's dump(), in less time: most of that is numbers. Each is the shortest
/// decimal that reads back to the same double, and of several the nearest, which the library's
/// misses at times; one that is not finite is `null`. Bytes of a text that are not UTF-8 are
/// replaced.
std::string json_text(const Json& value, JsonLayout layout);

}  // namespace ravnoves
