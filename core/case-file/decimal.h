#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

// Numbers as people type, write and round them: the one place for that.
namespace ravnoves {

/// Reads a number as people type it: decimal point or decimal comma, blanks around it, an optional
/// sign and exponent; the typographic minus (U+2212) too. One separator only: "1.234,5" is rejected
/// rather than guessed. Nothing where the whole text is not one finite number.
std::optional<double> parse_decimal(std::string_view text);

/// Without the blanks around it.
inline std::string_view trimmed(std::string_view text, std::string_view blanks = " \t\r\v") {
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    return text.substr(0, text.find_last_not_of(blanks) + 1);
}

/// Whether the number that a text begins with may have its thousands divided by a comma: "1,893",
/// not "0,893" or "1,89".
bool may_have_thousands(std::string_view text);

/// A number as a person would write it: the shortest decimal text that reads back to the same
/// double, with a decimal point, in any locale.
std::string format_number(double value);
/// Rounded to significant digits.
std::string format_number(double value, int significant_digits);
/// With a decimal point and that many decimals; zero has no sign.
std::string fixed_decimals(double value, int decimals);

/// The value rounded to significant digits.
double rounded_to_digits(double value, int digits);
/// The value rounded to decimals.
double rounded_to_decimals(double value, int decimals);
/// The largest of …, 0.1, 0.2, 0.5, 1, 2, 5, 10, … that is not above the value, which is positive.
double round_step(double value);

}  // namespace ravnoves
