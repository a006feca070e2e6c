#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>

#include "case-file/json_fwd.h"  // IWYU pragma: export

namespace ravnoves {

/// An empty object with room for so many items. One that grows copies what it holds, since its keys
/// are constant: for curves that costs more than to compute them.
inline Json object_with_room(std::size_t items) {
    Json::object_t object;
    object.reserve(items);
    return object;
}

}  // namespace ravnoves
