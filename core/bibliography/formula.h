#pragma once

#include <string_view>

#include "numerics/text.h"

namespace ravnoves {

/// A formula that a scene computes by, for people to read: what a report prints of the theory.
struct Formula {
    Text name;                  ///< its result: "Moment of the shaft"
    std::string_view html;      ///< with <sub>, <sup> and <i>; else plain text
    std::string_view source{};  ///< key in the bibliography; empty: mechanics, derived in the help
    std::string_view equation{};  ///< in the source: "(1)", "Table 1"; empty where it has no number
    Text where{};                 ///< what the symbols are; may be empty
};

}  // namespace ravnoves
