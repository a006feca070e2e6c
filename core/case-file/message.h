#pragma once

#include <cmath>
#include <string>
#include <string_view>
#include <type_traits>
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
    bool trimmed = false;       ///< of the decimals no zeros at the end
};

/// A size as most messages show it.
inline Number in_mm(double length) {
    return {length / units::mm, units::mm, 4};
}

/// A bound of an amount with the digits that tell it from the number found, both in the unit.
inline Number bound(double limit, double found, const Unit& unit) {
    const bool is_near = std::abs(std::abs(limit) - std::abs(found)) < 1e-4 * std::abs(limit);
    return {limit, unit, is_near ? 11 : 6};
}

class Message;

/// A value in a message: a number (written in the reader's way), or another message, such as a word
/// that no language changes (a key, a file's name).
using Argument = std::variant<Number, Message>;

/// What the program says to the user, as data: a pattern and its values. The command line prints
/// english(); the window translates the pattern and writes the numbers in the user's way.
class Message {
  public:
    // Compiled once: inlined wherever one is made, they took 285 kB of the command line.
    Message();
    /// Words that no language changes.
    Message(std::string verbatim);
    Message(std::string_view verbatim);
    Message(const char* verbatim);
    Message(Text pattern);
    /// The number alone.
    Message(Number number);
    template <typename... Values>
    Message(Text pattern, Values&&... values) : Message(pattern) {
        (add(std::forward<Values>(values)), ...);
    }
    Message(const Message& other);
    Message(Message&& other) noexcept;
    Message& operator=(const Message& other);
    Message& operator=(Message&& other) noexcept;
    ~Message();

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
    template <typename Value>
    requires std::is_arithmetic_v<Value>
    void add(Value value) { add(Number{static_cast<double>(value)}); }
    void add(Number value);
    void add(Message value);

    Text pattern_;
    std::string verbatim_;
    std::vector<Argument> arguments_;
};

/// "a, b"
Message joined(Message a, Message b);
/// A place in a table or in the text of a file.
Message line_place(std::size_t line);               ///< "line 4"
Message table_place(std::size_t line, int column);  ///< "line 4, column 2"
/// Words in a row: "a", "b", "c".
Message quoted_list(const std::vector<std::string>& words);

/// Puts values in the places %1, %2 … of a pattern, which may be a label: without the & of its
/// mnemonic.
std::string fill_pattern(std::string_view pattern, const std::vector<std::string>& values);

}  // namespace ravnoves
