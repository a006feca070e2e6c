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
    JsonWriter(JsonLayout layout, const TextSink& sink)
        : has_lines_(layout == JsonLayout::lines),
          between_(has_lines_ ? ",\n" : ","),
          sink_(sink) {}

    void write(const Json& value) {
        switch (value.type()) {
            case Json::value_t::object:
                write_items(value.get_ref<const Json::object_t&>(), "{}", [&](const auto& item) {
                    write_string(item.first);
                    put(has_lines_ ? ": " : ":");
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
                put(value.dump());
        }
    }

    void flush() {
        sink_({buffer_.data(), used_});
        used_ = 0;
    }

  private:
    char* room(std::size_t count) {
        if (buffer_.size() - used_ < count) {
            flush();
        }
        return buffer_.data() + used_;
    }

    void put(std::string_view characters) {
        if (characters.size() > buffer_.size()) {
            flush();
            sink_(characters);
            return;
        }
        std::copy(characters.begin(), characters.end(), room(characters.size()));
        used_ += characters.size();
    }

    template <typename Items, typename WriteItem>
    void write_items(const Items& items, std::string_view brackets, const WriteItem& write_item) {
        if (items.empty()) {
            put(brackets);
            return;
        }
        put(brackets.substr(0, 1));
        if (has_lines_) {
            between_ += indent;
        }
        std::size_t skipped = 1;  // the comma before the first
        for (const auto& item : items) {
            put(std::string_view(between_).substr(skipped));
            skipped = 0;
            write_item(item);
        }
        if (has_lines_) {
            between_.resize(between_.size() - indent.size());
        }
        put(std::string_view(between_).substr(1));
        put(brackets.substr(1));
    }

    void write_string(const std::string& string) {
        const bool is_plain = std::all_of(string.begin(), string.end(), [](char c) {
            return c >= ' ' && c <= '~' && c != '"' && c != '\\';
        });
        if (is_plain) {
            put("\"");
            put(string);
            put("\"");
        } else {
            put(Json(string).dump(-1, ' ', false, Json::error_handler_t::replace));
        }
    }

    void write_double(double value) {
        if (!std::isfinite(value)) {
            put("null");
            return;
        }
        const double size = std::abs(value);
        constexpr double min_plain = 1e-4;
        constexpr double max_plain = 1e15;
        constexpr std::size_t longest = 32;
        char* const begin = room(longest);
        char* end = begin;
        if (size < max_plain && value == std::trunc(value)) {
            if (std::signbit(value)) {
                *end++ = '-';
            }
            end = std::to_chars(end, begin + longest, static_cast<std::int64_t>(size)).ptr;
            *end++ = '.';
            *end++ = '0';
        } else {
            const bool is_plain = size >= min_plain && size < max_plain;
            end = std::to_chars(begin, begin + longest, value,
                                is_plain ? std::chars_format::fixed : std::chars_format::scientific)
                      .ptr;
        }
        used_ += static_cast<std::size_t>(end - begin);
    }

    static constexpr std::string_view indent = "  ";
    bool has_lines_;
    std::string between_;  ///< two items: a comma and, where it has lines, the next one's indent
    std::array<char, 16'384> buffer_;  // NOLINT(*-member-init): filled as far as it is used
    std::size_t used_ = 0;
    const TextSink& sink_;
};

}  // namespace

void write_json(const Json& value, JsonLayout layout, const TextSink& sink) {
    JsonWriter writer(layout, sink);
    writer.write(value);
    writer.flush();
}

std::string json_text(const Json& value, JsonLayout layout) {
    std::string text;
    write_json(value, layout, [&](std::string_view part) { text += part; });
    return text;
}

}  // namespace ravnoves
