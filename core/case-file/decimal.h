#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace ravnoves {

/// Reads a number as people type it: decimal point or decimal comma, blanks around it, an optional
/// sign and exponent; the typographic minus (U+2212) too. One separator only: "1.234,5" is refused
/// rather than guessed. Nothing where the whole text is not one finite number.
std::optional<double> parse_decimal(std::string_view text);

/// With a decimal point and so many decimals; what rounds to nothing has no sign.
std::string fixed_decimals(double value, int decimals);

}  // namespace ravnoves
