#include "case-file/object_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <utility>

#include "case-file/input_error.h"
#include "case-file/json.h"

namespace ravnoves {

namespace {

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t substituted = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, substituted});
        }
    }
    return row.back();
}

/// @param place  gives the JSON pointer, where it is needed
template <typename Place>
double checked_number(const Json& value, const Range& range, const Place& place) {
    if (!value.is_number()) {
        throw InputError(place(), Text::tr("must be a number"), show(value));
    }
    const double number = value.get<double>();
    if (!range.contains(number)) {
        throw InputError(place(), range.message(), Number{number});
    }
    return number;
}

}  // namespace

std::string escape_segment(std::string_view key) {
    std::string text;
    for (const char c : key) {
        if (c == '~') {
            text += "~0";
        } else if (c == '/') {
            text += "~1";
        } else {
            text += c;
        }
    }
    return text;
}

bool is_inner_pointer(const std::string& text) {
    try {
        return !keys_of(text).empty();
    } catch (const Json::exception&) {
        return false;
    }
}

std::vector<std::string> keys_of(const std::string& pointer) {
    std::vector<std::string> keys;
    for (Json::json_pointer rest(pointer); !rest.empty(); rest.pop_back()) {
        keys.push_back(rest.back());
    }
    std::reverse(keys.begin(), keys.end());
    return keys;
}

std::string printable(std::string_view text, std::size_t longest) {
    std::string shown;
    while (!text.empty()) {
        const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
        const unsigned lead = byte(0);
        const std::size_t length = lead < 0xC0U ? 1 : lead < 0xE0U ? 2 : lead < 0xF0U ? 3 : 4;
        unsigned code = length == 1 ? lead : lead & (0x7FU >> length);
        std::size_t count = 1;  // bytes of this character, fewer where they are no UTF-8
        while (count < std::min(length, text.size()) && (byte(count) & 0xC0U) == 0x80U) {
            code = code << 6U | (byte(count++) & 0x3FU);
        }
        if (count < length) {
            code = 0xFFFDU;  // a broken character is shown as it is
        }
        const auto is_from = [code](unsigned first, unsigned last) {
            return code >= first && code <= last;
        };
        std::string piece(text.substr(0, count));
        // U+202A to U+202E and U+2066 to U+2069 turn the direction of what comes after them.
        if (code < 0x20U || is_from(0x7FU, 0x9FU) || is_from(0x202AU, 0x202EU) ||
            is_from(0x2066U, 0x2069U)) {
            std::array<char, 16> escape{};
            std::snprintf(escape.data(), escape.size(), "\\u%04x", code);
            piece = escape.data();
        }
        if (shown.size() + piece.size() > longest) {
            return shown + "…";
        }
        shown += piece;
        text.remove_prefix(count);
    }
    return shown;
}

std::string show(const Json& value) {
    constexpr std::size_t longest = 40;
    return printable(value.dump(-1, ' ', false, Json::error_handler_t::replace), longest);
}

namespace {

/// Whether a key is another one that has its unit left out, as people do most.
bool is_without_unit(std::string_view given, std::string_view key) {
    constexpr std::size_t longest = 4;  // letters of each part of a unit, as of rad_s
    if (given.empty() || key.size() <= given.size() || !key.starts_with(given) ||
        key[given.size()] != '_') {
        return false;
    }
    std::size_t letters = 0;
    return std::all_of(key.begin() + static_cast<std::ptrdiff_t>(given.size()), key.end(),
                       [&letters](char c) {
                           letters = c == '_' ? 0 : letters + 1;
                           return letters <= longest;
                       });
}

}  // namespace

std::optional<std::string> nearest_word(std::string_view word,
                                        const std::vector<std::string>& candidates) {
    std::optional<std::string> best;
    std::size_t best_distance = std::max<std::size_t>(2, word.size() / 2) + 1;
    for (const std::string& candidate : candidates) {
        if (word.size() >= candidate.size() + best_distance) {
            continue;  // too long for any; the table would be as large
        }
        const std::size_t distance =
            is_without_unit(word, candidate) ? 1 : edit_distance(word, candidate);
        if (distance < best_distance) {
            best_distance = distance;
            best = candidate;
        }
    }
    return best;
}

ObjectReader::ObjectReader(const Json& value, std::string pointer)
    : value_(value), pointer_(std::move(pointer)) {
    if (!value_.is_object()) {
        throw InputError(pointer_, Text::tr("must be an object"), show(value_));
    }
}

std::string ObjectReader::pointer_to(std::string_view key) const {
    return pointer_ + "/" + printable(escape_segment(key));
}

void ObjectReader::know(std::string_view key) {
    if (std::find(known_.begin(), known_.end(), key) == known_.end()) {
        known_.emplace_back(key);
    }
}

bool ObjectReader::has(std::string_view key) {
    know(key);
    return value_.contains(key);
}

const Json& ObjectReader::raw(std::string_view key) {
    know(key);
    const auto found = value_.find(key);
    if (found == value_.end()) {
        reject_mistyped(key);
        throw InputError(pointer_to(key), Text::tr("is required and missing"));
    }
    return *found;
}

void ObjectReader::reject_mistyped(std::string_view key) const {
    constexpr std::size_t slip = 2;  // letters
    for (const auto& item : value_.items()) {
        const std::string& given = item.key();
        const bool is_as_long = given.size() <= key.size() + slip && key.size() > 2 * slip;
        if (std::find(known_.begin(), known_.end(), given) == known_.end() &&
            (is_without_unit(given, key) || (is_as_long && edit_distance(key, given) <= slip))) {
            throw InputError(pointer_to(key), {Text::tr("is required and missing; found: %1"),
                                               quoted_list({given})});
        }
    }
}

double ObjectReader::number(std::string_view key, const Range& range) {
    return checked_number(raw(key), range, [&] { return pointer_to(key); });
}

std::optional<double> ObjectReader::optional_number(std::string_view key, const Range& range) {
    return has(key) ? std::optional(number(key, range)) : std::nullopt;
}

std::uint64_t ObjectReader::whole(std::string_view key, std::uint64_t min, std::uint64_t max) {
    const Json& value = raw(key);
    const double size = value.is_number() ? value.get<double>() : -1.0;
    const bool is_whole = size >= 0.0 && size < 1e19 && std::floor(size) == size;
    const std::uint64_t number = !is_whole                 ? max + 1
                                 : value.is_number_float() ? static_cast<std::uint64_t>(size)
                                                           : value.get<std::uint64_t>();
    if (number < min || number > max) {
        throw InputError(pointer_to(key),
                         {Text::tr("must be a whole number from %1 to %2"), std::to_string(min),
                          std::to_string(max)},
                         show(value));
    }
    return number;
}

std::string ObjectReader::text(std::string_view key) {
    const Json& value = raw(key);
    if (!value.is_string()) {
        throw InputError(pointer_to(key), Text::tr("must be a text"), show(value));
    }
    return value.get<std::string>();
}

std::string ObjectReader::text(std::string_view key, std::string fallback) {
    return has(key) ? text(key) : std::move(fallback);
}

int ObjectReader::choice(std::string_view key, std::span<const Word> words) {
    const Json& value = raw(key);
    std::vector<std::string> allowed;
    for (const Word& word : words) {
        if (value.is_string() && value.get_ref<const std::string&>() == word.word) {
            return static_cast<int>(allowed.size());
        }
        allowed.emplace_back(word.word);
    }
    throw InputError(pointer_to(key), {Text::tr("must be one of %1"), quoted_list(allowed)},
                     show(value));
}

const Json& ObjectReader::list(std::string_view key) {
    const Json& value = raw(key);
    if (!value.is_array()) {
        throw InputError(pointer_to(key), Text::tr("must be a list"), show(value));
    }
    return value;
}

std::vector<double> ObjectReader::numbers(std::string_view key, const Range& range) {
    const Json& array = list(key);
    std::vector<double> values;
    values.reserve(array.size());
    for (const Json& element : array) {
        values.push_back(checked_number(
            element, range, [&] { return pointer_to(key) + "/" + std::to_string(values.size()); }));
    }
    return values;
}

ObjectReader ObjectReader::object(std::string_view key) {
    return {raw(key), pointer_to(key)};
}

std::vector<std::string> ObjectReader::keys() {
    std::vector<std::string> names;
    for (const auto& item : value_.items()) {
        names.push_back(item.key());
        know(item.key());
    }
    return names;
}

void ObjectReader::finish(const Text& unknown) const {
    for (const auto& item : value_.items()) {
        if (std::find(known_.begin(), known_.end(), item.key()) != known_.end()) {
            continue;
        }
        if (const auto near = nearest_word(item.key(), known_)) {
            throw InputError::unknown_key(
                pointer_to(item.key()),
                {Text::tr("is not a known key; the nearest is %1"), quoted_list({*near})});
        }
        throw InputError::unknown_key(pointer_to(item.key()), unknown);
    }
}

}  // namespace ravnoves
