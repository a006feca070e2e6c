#include "case-file/message.h"

#include "case-file/decimal.h"
#include "case-file/object_reader.h"

namespace ravnoves {

namespace {

struct EnglishWriter {
    std::string operator()(const Message& message) const { return message.english(); }
    std::string operator()(const Number& number) const {
        std::string text = number.trimmed
                               ? format_number(rounded_to_decimals(number.value, -number.digits))
                           : number.digits < 0  ? fixed_decimals(number.value, -number.digits)
                           : number.digits == 0 ? format_number(number.value)
                                                : format_number(number.value, number.digits);
        if (!number.unit.name.empty() && !number.unit_follows) {
            text += number.unit == units::degree ? "" : " ";
            text += number.unit.name;
        }
        return text;
    }
};

}  // namespace

std::string fill_pattern(std::string_view pattern, const std::vector<std::string>& values) {
    std::string text;
    for (std::size_t at = 0; at < pattern.size(); ++at) {
        const bool place = pattern[at] == '%' && at + 1 < pattern.size() &&
                           pattern[at + 1] >= '1' &&
                           static_cast<std::size_t>(pattern[at + 1] - '1') < values.size();
        if (place) {
            text += values[static_cast<std::size_t>(pattern[++at] - '1')];
        } else if (pattern[at] != '&') {
            text += pattern[at];
        }
    }
    return text;
}

Message::Message() = default;
Message::Message(std::string verbatim) : verbatim_(std::move(verbatim)) {}
Message::Message(std::string_view verbatim) : verbatim_(verbatim) {}
Message::Message(const char* verbatim) : verbatim_(verbatim) {}
Message::Message(Text pattern) : pattern_(pattern) {}
Message::Message(Number number) : pattern_{"%1"}, arguments_{number} {}
Message::Message(const Message& other) = default;
Message::Message(Message&& other) noexcept = default;
Message& Message::operator=(const Message& other) = default;
Message& Message::operator=(Message&& other) noexcept = default;
Message::~Message() = default;

void Message::add(Number value) {
    arguments_.emplace_back(value);
}
void Message::add(Message value) {
    arguments_.emplace_back(std::move(value));
}

Message joined(Message a, Message b) {
    return {Text{"%1, %2"}, std::move(a), std::move(b)};
}

Message line_place(std::size_t line) {
    return {Text::tr("line %1"), line};
}

Message table_place(std::size_t line, int column) {
    return {Text::tr("line %1, column %2"), line, column};
}

Message quoted_list(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) {
        text += (text.empty() ? "\"" : ", \"") + printable(word) + "\"";
    }
    return text;
}

std::string Message::english() const {
    if (pattern_.empty()) {
        return verbatim_;
    }
    std::vector<std::string> values;
    values.reserve(arguments_.size());
    for (const Argument& argument : arguments_) {
        values.push_back(std::visit(EnglishWriter{}, argument));
    }
    return fill_pattern(pattern_.english, values);
}

}  // namespace ravnoves
