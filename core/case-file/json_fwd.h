#pragma once

#include <nlohmann/json_fwd.hpp>

namespace ravnoves {

/// JSON whose objects keep the order in which keys were added: results read as the contract lists
/// them. Headers that only pass it on include this; code that looks inside includes json.h.
using Json = nlohmann::ordered_json;

}  // namespace ravnoves
