#pragma once

#include <cmath>
#include <limits>

#include "case-file/message.h"
#include "numerics/units.h"

namespace ravnoves {

/// The interval of an input, in the unit that the user sees. Case files and forms read the same
/// Range, so both reject the same values.
struct Range {
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
    bool min_open = false;  ///< min itself is not allowed

    static constexpr double unbounded = std::numeric_limits<double>::infinity();

    /// min < x <= max
    static constexpr Range greater_than(double min, double max = unbounded) {
        return {min, max, true};
    }
    /// min <= x <= max
    static constexpr Range between(double min, double max) { return {min, max}; }
    /// min <= x
    static constexpr Range at_least(double min) { return {min}; }

    /// True where x is finite and in the interval.
    bool contains(double x) const {
        return std::isfinite(x) && (min_open ? x > min : x >= min) && x <= max;
    }

    /// The rule as text: "must be greater than 0", "must be from 0 to 360".
    Message message(Unit unit = units::none) const;
};

}  // namespace ravnoves
