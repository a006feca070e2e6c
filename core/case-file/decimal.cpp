#include "case-file/decimal.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace ravnoves {

std::optional<double> parse_decimal(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n\xC2\xA0";  // with the no-break space's bytes
    while (!text.empty() && blanks.find(text.front()) != std::string_view::npos) {
        text.remove_prefix(1);
    }
    while (!text.empty() && blanks.find(text.back()) != std::string_view::npos) {
        text.remove_suffix(1);
    }
    std::string plain;
    constexpr std::string_view minus_sign = "\xE2\x88\x92";
    if (text.substr(0, minus_sign.size()) == minus_sign) {
        plain = "-";
        text.remove_prefix(minus_sign.size());
    } else if (!text.empty() && text.front() == '+') {
        text.remove_prefix(1);
        if (!text.empty() && (text.front() == '-' || text.front() == '+')) {
            return std::nullopt;
        }
    }
    plain += text;
    std::replace(plain.begin(), plain.end(), ',', '.');
    double value = 0.0;
    const char* const end = plain.data() + plain.size();
    const auto [stop, error] = std::from_chars(plain.data(), end, value);
    if (error != std::errc{} || stop != end || !std::isfinite(value)) {
        return std::nullopt;
    }
    return value;
}

std::string fixed_decimals(double value, int decimals) {
    std::array<char, 400> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                   std::chars_format::fixed, decimals)
                         .ptr;
    std::string text(buffer.data(), end);
    if (text.starts_with('-') && text.find_first_not_of("-0.") == std::string::npos) {
        text.erase(0, 1);
    }
    return text;
}

}  // namespace ravnoves
