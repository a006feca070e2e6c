#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "case-file/json.h"

namespace ravnoves::methods {

inline bool says(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

inline bool has_only_finite_numbers(const Json& json) {
    if (json.is_number_float()) {
        return std::isfinite(json.get<double>());
    }
    return !json.is_structured() || std::all_of(json.begin(), json.end(), [](const Json& v) {
        return has_only_finite_numbers(v);
    });
}

}  // namespace ravnoves::methods
