#include "case-file/json_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "case-file/json.h"

namespace ravnoves {

namespace {

class JsonWriter {
  public:
    explicit JsonWriter(JsonLayout layout)
        : has_lines_(layout == JsonLayout::lines), between_(has_lines_ ? ",\n" : ",") {}

    std::string take() { return std::move(text_); }
    void write(const Json& value) {
        switch (value.type()) {
            case Json::value_t::object:
                write_items(value.get_ref<const Json::object_t&>(), "{}", [&](const auto& item) {
                    write_string(item.first);
                    text_ += has_lines_ ? ": " : ":";
                    write(item.second);
                });
                break;
            case Json::value_t::array:
                write_items(value.get_ref<const Json::array_t&>(), "[]",
                            [&](const Json& item) { write(item); });
                break;
            case Json::value_t::number_float:
                write_double(value.get_ref<const Json::number_float_t&>());
                break;
            case Json::value_t::string:
                write_string(value.get_ref<const Json::string_t&>());
                break;
            default:
                text_ += value.dump();
        }
    }

  private:
    template <typename Items, typename WriteItem>
    void write_items(const Items& items, std::string_view brackets, const WriteItem& write_item) {
        if (items.empty()) {
            text_ += brackets;
            return;
        }
        text_ += brackets.front();
        if (has_lines_) {
            between_ += indent;
        }
        std::size_t skipped = 1;  // the comma before the first
        for (const auto& item : items) {
            text_.append(between_, skipped);
            skipped = 0;
            write_item(item);
        }
        if (has_lines_) {
            between_.resize(between_.size() - indent.size());
        }
        text_.append(between_, 1);
        text_ += brackets.back();
    }

    void write_string(const std::string& string) {
        const bool is_plain = std::all_of(string.begin(), string.end(), [](char c) {
            return c >= ' ' && c <= '~' && c != '"' && c != '\\';
        });
        if (is_plain) {
            text_.append(1, '"').append(string).append(1, '"');
        } else {
            text_ += Json(string).dump(-1, ' ', false, Json::error_handler_t::replace);
        }
    }

    void write_double(double value) {
        if (!std::isfinite(value)) {
            text_ += "null";
            return;
        }
        const double size = std::abs(value);
        constexpr double min_plain = 1e-4;
        constexpr double max_plain = 1e15;
        std::array<char, 32> digits;  // NOLINT(*-member-init): filled as far as it is used
        char* const begin = digits.data();
        char* const last = begin + digits.size();
        char* end = begin;
        if (size < max_plain && value == std::trunc(value)) {
            if (std::signbit(value)) {
                *end++ = '-';
            }
            end = std::to_chars(end, last, static_cast<std::int64_t>(size)).ptr;
            *end++ = '.';
            *end++ = '0';
        } else {
            const bool is_plain = size >= min_plain && size < max_plain;
            end = std::to_chars(begin, last, value,
                                is_plain ? std::chars_format::fixed : std::chars_format::scientific)
                      .ptr;
        }
        text_.append(begin, static_cast<std::size_t>(end - begin));
    }

    static constexpr std::string_view indent = "  ";
    bool has_lines_;
    std::string between_;  ///< two items: a comma and, where it has lines, the next one's indent
    std::string text_;
};

}  // namespace

std::string json_text(const Json& value, JsonLayout layout) {
    JsonWriter writer(layout);
    writer.write(value);
    return writer.take();
}

}  // namespace ravnoves
