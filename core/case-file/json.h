#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>

#include "case-file/json_fwd.h"  // IWYU pragma: export

namespace nlohmann {

/// Frees a value with its contents, without taking memory: the library first moves all to a list,
/// which ends the program where there is no memory for that list. A document is at most 100 levels
/// deep (`parse_json`), which fit the stack.
template <>
inline void ordered_json::json_value::destroy(value_t kind) {
    switch (kind) {
        case value_t::object:
            delete object;
            break;
        case value_t::array:
            delete array;
            break;
        case value_t::string:
            delete string;
            break;
        case value_t::binary:
            delete binary;
            break;
        default:
            break;
    }
}

}  // namespace nlohmann

namespace ravnoves {

/// An empty object with room for that many items. A growing one copies its contents, since its keys
/// are constant: for curves that costs more than to compute them.
inline Json object_with_room(std::size_t items) {
    Json::object_t object;
    object.reserve(items);
    return object;
}

}  // namespace ravnoves
