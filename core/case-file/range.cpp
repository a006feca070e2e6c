#include "case-file/range.h"

#include <array>
#include <charconv>
#include <cmath>

namespace ravnoves {

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
    return format_number(rounded_to(value, significant_digits));
}

Message Range::message(Unit unit) const {
    const auto number = [&](double value) { return Number{value, unit}; };
    const Number low{min, unit, 0, true};
    const bool has_min = std::isfinite(min);
    const bool has_max = std::isfinite(max);
    if (has_min && has_max) {
        if (!min_open && !max_open) {
            return {CORE_TEXT("core", "must be from %1 to %2"), low, number(max)};
        }
        const Text text =
            min_open ? (max_open ? CORE_TEXT("core", "must be greater than %1 and less than %2")
                                 : CORE_TEXT("core", "must be greater than %1 and at most %2"))
                     : CORE_TEXT("core", "must be at least %1 and less than %2");
        return {text, low, number(max)};
    }
    if (has_min) {
        return {min_open ? CORE_TEXT("core", "must be greater than %1")
                         : CORE_TEXT("core", "must be at least %1"),
                number(min)};
    }
    if (has_max) {
        return {max_open ? CORE_TEXT("core", "must be less than %1")
                         : CORE_TEXT("core", "must be at most %1"),
                number(max)};
    }
    return CORE_TEXT("core", "must be a finite number");
}

Message Range::whole_number_message() const {
    return {CORE_TEXT("core", "must be a whole number from %1 to %2"), min, max};
}

double rounded_to(double value, int digits) {
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

}  // namespace ravnoves
