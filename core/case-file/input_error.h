#pragma once

#include <stdexcept>
#include <string>

#include "case-file/message.h"

namespace ravnoves {

/// A mistake of the user: names the place, the rule and the value found.
///
/// The place is a JSON pointer ("/input/crank_radius_mm") for a case, "line 4, column 2" for a
/// table, or empty for the whole file. what() joins the three in English: "/input/crank_radius_mm:
/// must be greater than 0, got -46".
class InputError : public std::runtime_error {
  public:
    /// What the place names, for those who show it in other words.
    enum class Of {
        value,        ///< a value of the case or of a table
        unknown_key,  ///< a key that nothing has
        named_file    ///< contents of the file whose name is the value
    };

    /// @param where    as above
    /// @param allowed  the rule, a phrase ("must be greater than 0")
    /// @param found    the value; empty without one
    InputError(Message where, Message allowed, Message found = {})
        : std::runtime_error(join(where, allowed, found).english()),
          where_(std::move(where)),
          allowed_(std::move(allowed)),
          found_(std::move(found)) {}

    static InputError unknown_key(Message where, Message rule = Text::tr("is not a known key")) {
        InputError error(std::move(where), std::move(rule));
        error.of_ = Of::unknown_key;
        return error;
    }
    /// Of the contents of a file that the case names; the rule's arguments are the file's name and
    /// the fault.
    /// @param where  of the name
    static InputError in_file(Message where, std::string name, const InputError& fault) {
        InputError error(
            std::move(where),
            {Text{"%1: %2"}, std::move(name), with_place(fault.where_, fault.allowed_)},
            fault.found_);
        error.of_ = Of::named_file;
        return error;
    }

    Of of() const noexcept { return of_; }
    /// The three joined.
    Message message() const { return join(where_, allowed_, found_); }
    /// The same in English.
    std::string where() const { return where_.english(); }
    std::string allowed() const { return allowed_.english(); }
    std::string found() const { return found_.english(); }

    const Message& where_message() const noexcept { return where_; }
    const Message& allowed_message() const noexcept { return allowed_; }
    const Message& found_message() const noexcept { return found_; }

  private:
    static Message with_place(const Message& where, const Message& allowed) {
        return where.empty() ? allowed : Message(Text{"%1: %2"}, where, allowed);
    }
    static Message join(const Message& where, const Message& allowed, const Message& found) {
        const Message text = with_place(where, allowed);
        return found.empty() ? text : Message(Text::tr("%1, got %2"), text, found);
    }

    Message where_;
    Message allowed_;
    Message found_;
    Of of_ = Of::value;
};

}  // namespace ravnoves
