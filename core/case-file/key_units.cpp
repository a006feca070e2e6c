#include "case-file/key_units.h"

#include <algorithm>

namespace ravnoves {

Unit unit_at(std::string_view pointer) {
    const auto is_number = [](std::string_view key) {
        return !key.empty() &&
               std::all_of(key.begin(), key.end(), [](char c) { return c >= '0' && c <= '9'; });
    };
    for (std::size_t slash = pointer.rfind('/'); slash != std::string_view::npos;
         slash = pointer.rfind('/')) {
        const std::string_view key = pointer.substr(slash + 1);
        if (!is_number(key)) {
            return unit_of_key(key).unit;
        }
        pointer = pointer.substr(0, slash);
    }
    return units::none;
}

}  // namespace ravnoves
