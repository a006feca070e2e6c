#pragma once

#include <nlohmann/json.hpp>

namespace ravnoves {

/// JSON whose objects keep the order in which keys were added: results read as the contract lists
/// them.
using Json = nlohmann::ordered_json;

}  // namespace ravnoves
