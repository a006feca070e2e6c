#pragma once

#include <cmath>

#include "case-file/json.h"

namespace ravnoves {

/// The first number that is NaN or infinite; none where all are finite.
inline const Json* not_finite(const Json& value) {
    if (value.is_structured()) {
        for (const Json& each : value) {
            if (const Json* found = not_finite(each)) {
                return found;
            }
        }
    }
    return value.is_number_float() && !std::isfinite(value.get<double>()) ? &value : nullptr;
}

}  // namespace ravnoves
