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
    const auto end = plain
                         ? std::to_chars(buffer.data(), last, value, std::chars_format::fixed).ptr
                         : std::to_chars(buffer.data(), last, value).ptr;
    return {buffer.data(), end};
}

std::string format_number(double value, int significant_digits) {
    if (!std::isfinite(value)) {
        return format_number(value);
    }
    std::array<char, 64> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                   std::chars_format::general, significant_digits)
                         .ptr;
    return {buffer.data(), end};
}

double from_si(const FieldSpec& field, double si) {
    const double value = si / field.to_si;
    if (!std::isfinite(value)) {
        return value;
    }
    for (const int digits : {12, 15, 16}) {
        const std::string text = format_number(value, digits);
        double rounded = 0.0;
        std::from_chars(text.data(), text.data() + text.size(), rounded);
        if (rounded * field.to_si == si) {
            return rounded;
        }
    }
    return value;
}

std::string Range::describe() const {
    const bool has_min = std::isfinite(min);
    const bool has_max = std::isfinite(max);
    if (has_min && has_max) {
        if (!min_open && !max_open) {
            return "must be from " + format_number(min) + " to " + format_number(max);
        }
        return std::string("must be ") + (min_open ? "greater than " : "at least ") +
               format_number(min) + " and " + (max_open ? "less than " : "at most ") +
               format_number(max);
    }
    if (has_min) {
        return (min_open ? "must be greater than " : "must be at least ") + format_number(min);
    }
    if (has_max) {
        return (max_open ? "must be less than " : "must be at most ") + format_number(max);
    }
    return "must be a finite number";
}

}  // namespace ravnoves
