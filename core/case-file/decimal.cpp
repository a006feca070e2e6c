#include "case-file/decimal.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace ravnoves {

std::optional<double> parse_decimal(std::string_view text) {
    text = trimmed(text, " \t\r\n\xC2\xA0");  // with the no-break space's bytes
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

bool may_have_thousands(std::string_view text) {
    const std::size_t first = text.find_first_of("0123456789,.");
    if (first == std::string_view::npos) {
        return false;
    }
    text.remove_prefix(first);
    const auto digits = [](std::string_view part) {
        return std::min(part.find_first_not_of("0123456789"), part.size());
    };
    const std::size_t before = digits(text);
    if (before < 1 || before > 3 || text.front() == '0' || text.substr(before, 1) != ",") {
        return false;
    }
    text.remove_prefix(before + 1);
    const std::size_t behind = digits(text);
    const std::string_view rest = text.substr(behind);
    return behind == 3 && !rest.starts_with(',') && !rest.starts_with('.');
}

std::string format_number(double value) {
    if (std::isnan(value)) {
        return "not a number";
    }
    if (std::isinf(value)) {
        return value > 0 ? "infinity" : "-infinity";
    }
    // People write 100000, not 1e+05; very large and very small numbers keep their exponent.
    const double size = std::abs(value);
    const bool plain = size == 0.0 || (size >= 1e-5 && size < 1e15);
    std::array<char, 64> buffer{};
    char* const last = buffer.data() + buffer.size();
    const auto end = plain ? std::to_chars(buffer.data(), last, value, std::chars_format::fixed).ptr
                           : std::to_chars(buffer.data(), last, value).ptr;
    return {buffer.data(), end};
}

std::string format_number(double value, int significant_digits) {
    return format_number(rounded_to_digits(value, significant_digits));
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

double rounded_to_digits(double value, int digits) {
    if (!std::isfinite(value)) {
        return value;
    }
    std::array<char, 64> buffer{};
    const char* const end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                          std::chars_format::general, digits)
                                .ptr;
    double shorter = value;
    std::from_chars(buffer.data(), end, shorter);
    return shorter;
}

double rounded_to_decimals(double value, int decimals) {
    const double parts = std::pow(10.0, decimals);
    return std::round(value * parts) / parts;
}

double round_step(double value) {
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    for (const double step : {5.0, 2.0}) {
        if (step * decade <= value * (1.0 + 1e-12)) {
            return step * decade;
        }
    }
    return decade;
}

}  // namespace ravnoves
