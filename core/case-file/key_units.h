#pragma once

#include <cstddef>
#include <string_view>

#include "numerics/units.h"

namespace ravnoves {

/// What a key of a case file or a result says of its unit.
struct KeyUnit {
    Unit unit = units::none;
    std::size_t length = 0;  ///< characters at the key's end that say it
};

/// Of "shaft_angle_deg" degrees, said by four characters.
KeyUnit unit_of_key(std::string_view key);

/// The unit of the number at a pointer: an element of a list has the unit of the list's key.
Unit unit_at(std::string_view pointer);

}  // namespace ravnoves
