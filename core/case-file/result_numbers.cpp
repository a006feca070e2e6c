#include "case-file/result_numbers.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace ravnoves {

namespace {

/// Of "/3" the 3; without a place, one that no list has.
std::size_t place_in_list(std::string_view rest) {
    constexpr auto none = static_cast<std::size_t>(-1);
    std::size_t place = none;
    const char* const end = rest.data() + rest.size();
    const bool is_number = rest.size() > 1 && (rest[1] != '0' || rest.size() == 2) &&
                           std::from_chars(rest.data() + 1, end, place).ptr == end;
    return is_number ? place : none;
}

/// @param rest  of the pointer within a value: empty, or places in lists ("/3/1")
std::optional<double> number_in(const ResultValue& value, std::string_view rest, const Unit& unit) {
    const auto element = [&](const auto& list, std::string_view place) {
        const std::size_t i = place_in_list(place);
        return i < list.size() ? std::optional(list[i] / unit) : std::nullopt;
    };
    if (rest.empty()) {
        const auto number = single_number(value);
        return number && std::holds_alternative<double>(value) ? *number / unit : number;
    }
    if (const auto* numbers = std::get_if<std::span<const double>>(&value)) {
        return element(*numbers, rest);
    }
    if (const auto* integers = std::get_if<std::span<const int>>(&value)) {
        return element(*integers, rest);
    }
    if (const auto* rows = std::get_if<NumberRows>(&value)) {
        const std::size_t column = std::min(rest.find('/', 1), rest.size());
        const std::size_t row = place_in_list(rest.substr(0, column));
        if (row < rows->si.size() / rows->columns) {
            return element(rows->si.subspan(row * rows->columns, rows->columns),
                           rest.substr(column));
        }
    }
    return std::nullopt;
}

}  // namespace

ResultNumbers::ResultNumbers(std::span<const std::string> pointers) {
    for (const std::string& pointer : pointers) {
        numbers_.push_back({pointer});
    }
}

void ResultNumbers::clear() {
    for (Picked& number : numbers_) {
        number.value.reset();
    }
    reasons_.clear();
    start();
}

Message ResultNumbers::why(std::size_t i) const {
    std::string_view around = numbers_[i].pointer;
    while (!around.empty()) {
        around = around.substr(0, around.rfind('/'));
        const auto found = std::find_if(reasons_.rbegin(), reasons_.rend(),
                                        [&](const auto& each) { return each.first == around; });
        if (found != reasons_.rend()) {
            return found->second;
        }
    }
    return {};
}

std::optional<std::string_view> ResultNumbers::rest(const Picked& number,
                                                    std::string_view key) const {
    const auto inside = behind(number.pointer, here());
    return inside && !inside->empty() ? behind(inside->substr(1), key) : std::nullopt;
}

bool ResultNumbers::wants(std::string_view key) const {
    return std::ranges::any_of(numbers_,
                               [&](const Picked& number) { return rest(number, key).has_value(); });
}

void ResultNumbers::leaf(const ResultField& field, const ResultValue& value) {
    const auto* const* text = std::get_if<const Message*>(&value);
    if (text != nullptr && !(*text)->empty() && (field.key == "reason" || field.key == "note")) {
        reasons_.emplace_back(here(), **text);
    }
    for (Picked& number : numbers_) {
        const auto within = rest(number, field.key);
        const auto found = within ? number_in(value, *within, field.unit) : std::nullopt;
        if (found && std::isfinite(*found)) {
            number.value = found;
            number.period = period_of(field);
        }
    }
}

}  // namespace ravnoves
