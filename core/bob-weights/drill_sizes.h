#pragma once

#include <optional>
#include <string_view>

namespace ravnoves::bob_weights {

/// Diameter of a twist drill by its name in the inch series (ASME B94.11M), m: "#7" (1 to 60), "F"
/// (A to Z), "1/4", "1-1/4" with or without the sign of inches; nothing for other texts.
std::optional<double> named_drill(std::string_view name);

/// Whether drills of that diameter are sold: by twentieths of a millimetre, by 64ths of an inch, or
/// by number and letter.
/// @param diameter  m
bool is_usual_drill(double diameter);

}  // namespace ravnoves::bob_weights
