#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "numerics/text.h"
#include "numerics/units.h"

namespace ravnoves {

/// A number in a message.
struct Number {
    double value = 0.0;  ///< in the unit
    Unit unit = units::none;
    int digits = 0;  ///< significant; 0: as many as read back to the same number; −2: two decimals
    bool unit_follows = false;  ///< written without its unit: the number after it has the same
};

class Message;

/// A value in a message: a number (written in the reader's way), a word that no language changes
/// (a key, a file's name), or another message.
using Argument = std::variant<std::string, Number, Message>;

/// What the program says to the user, as data: a pattern and its values. The command line prints
/// english(); the window translates the pattern and writes the numbers in the user's way.
class Message {
  public:
    Message() = default;
    /// Words that no language changes.
    Message(std::string verbatim) : verbatim_(std::move(verbatim)) {}
    Message(std::string_view verbatim) : verbatim_(verbatim) {}
    Message(const char* verbatim) : verbatim_(verbatim) {}
    Message(Text pattern) : pattern_(pattern) {}
    /// The number alone.
    Message(Number number);
    template <typename... Values>
    Message(Text pattern, Values&&... values);

    bool empty() const { return pattern_.empty() && verbatim_.empty(); }
    const Text& pattern() const { return pattern_; }
    const std::string& verbatim() const { return verbatim_; }
    const std::vector<Argument>& arguments() const { return arguments_; }
    /// The English sentence.
    std::string english() const;

    /// Messages are the same where they read the same.
    friend bool operator==(const Message& a, const Message& b) {
        return a.english() == b.english();
    }

  private:
    Text pattern_;
    std::string verbatim_;
    std::vector<Argument> arguments_;
};

/// The English sentences, as a result holds its notes.
std::vector<std::string> english(const std::vector<Message>& messages);
/// "a, b"
Message joined(Message a, Message b);
/// A place in a table or in the text of a file.
Message line_place(std::size_t line);               ///< "line 4"
Message table_place(std::size_t line, int column);  ///< "line 4, column 2"
/// Words in a row: "a", "b", "c".
Message quoted_list(const std::vector<std::string>& words);

namespace detail {
inline Argument to_argument(Argument value) {
    return value;
}
inline Argument to_argument(double value) {
    return Number{value};
}
inline Argument to_argument(int value) {
    return Number{static_cast<double>(value)};
}
inline Argument to_argument(std::size_t value) {
    return Number{static_cast<double>(value)};
}
inline Argument to_argument(Number value) {
    return value;
}
inline Argument to_argument(Text value);
inline Argument to_argument(Message value);
inline Argument to_argument(const char* value) {
    return std::string(value);
}
inline Argument to_argument(std::string_view value) {
    return std::string(value);
}
inline Argument to_argument(std::string value) {
    return value;
}
}  // namespace detail

template <typename... Values>
Message::Message(Text pattern, Values&&... values) : pattern_(pattern) {
    arguments_.reserve(sizeof...(values));
    (arguments_.push_back(detail::to_argument(std::forward<Values>(values))), ...);
}

namespace detail {
inline Argument to_argument(Text value) {
    return Message(value);
}
inline Argument to_argument(Message value) {
    return value;
}
}  // namespace detail

/// Puts values in the places %1, %2 … of a pattern.
std::string fill_pattern(std::string_view pattern, const std::vector<std::string>& values);

}  // namespace ravnoves
