#include "case-file/json_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <utility>

#include "case-file/json.h"

namespace ravnoves {

namespace {

class JsonText {
  public:
    JsonText(int indent, bool mends) : indent_(indent), mends_(mends) {}

    void add(const Json& value) {
        switch (value.type()) {
            case Json::value_t::object:
                add_object(value.get_ref<const Json::object_t&>());
                break;
            case Json::value_t::array:
                add_list(value.get_ref<const Json::array_t&>());
                break;
            case Json::value_t::number_float:
                add_number(*value.get_ptr<const double*>());
                break;
            case Json::value_t::number_integer:
                add_whole(*value.get_ptr<const std::int64_t*>());
                break;
            case Json::value_t::number_unsigned:
                add_whole(*value.get_ptr<const std::uint64_t*>());
                break;
            case Json::value_t::string:
                add_text(value.get_ref<const std::string&>());
                break;
            default:
                text += value.dump();
        }
    }

    std::string text;

  private:
    void add_object(const Json::object_t& object) {
        if (object.empty()) {
            text += "{}";
            return;
        }
        text += '{';
        ++level_;
        const char* gap = "";
        for (const auto& [key, value] : object) {
            text += gap;
            gap = ",";
            begin_line();
            add_text(key);
            text += indent_ < 0 ? ":" : ": ";
            add(value);
        }
        --level_;
        begin_line();
        text += '}';
    }

    void add_list(const Json::array_t& list) {
        if (list.empty()) {
            text += "[]";
            return;
        }
        text += '[';
        ++level_;
        const char* gap = "";
        for (const Json& value : list) {
            text += gap;
            gap = ",";
            begin_line();
            add(value);
        }
        --level_;
        begin_line();
        text += ']';
    }

    void add_number(double value) {
        if (!std::isfinite(value)) {
            text += "null";
            return;
        }
        std::array<char, 64> digits{};
        char* const end =
            nlohmann::detail::to_chars(digits.data(), digits.data() + digits.size(), value);
        text.append(digits.data(), end);
    }

    template <typename Whole>
    void add_whole(Whole value) {
        std::array<char, 24> digits{};
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
        text.append(digits.data(), end);
    }

    void add_text(const std::string& value) {
        const bool plain = std::all_of(value.begin(), value.end(), [](char c) {
            return c >= ' ' && c < '\x7f' && c != '"' && c != '\\';
        });
        if (plain) {
            text += '"';
            text += value;
            text += '"';
        } else {
            text += Json(value).dump(
                -1, ' ', false,
                mends_ ? Json::error_handler_t::replace : Json::error_handler_t::strict);
        }
    }

    void begin_line() {
        if (indent_ >= 0) {
            text += '\n';
            text.append(static_cast<std::size_t>(indent_) * level_, ' ');
        }
    }

    int indent_;
    bool mends_;
    std::size_t level_ = 0;
};

}  // namespace

std::string json_text(const Json& value, int indent, bool mends) {
    JsonText text(indent, mends);
    text.add(value);
    return std::move(text.text);
}

}  // namespace ravnoves
