#pragma once

#include <stdexcept>
#include <string>

namespace ravnoves {

/// A mistake in what the user gave: names the place, what is allowed there and what was found.
///
/// The place is a JSON pointer ("/input/crank_radius_mm") for a case, "line 4, column 2" for a
/// table, or empty where the whole file is meant. what() joins the three:
/// "/input/crank_radius_mm: must be greater than 0, got -46".
class InputError : public std::runtime_error {
  public:
    /// @param where    the place, as above
    /// @param allowed  what is allowed there, as a phrase ("must be greater than 0")
    /// @param found    what stood there instead; empty where there is nothing to show
    InputError(std::string where, std::string allowed, std::string found = {})
        : std::runtime_error(join(where, allowed, found)),
          where_(std::move(where)),
          allowed_(std::move(allowed)),
          found_(std::move(found)) {}

    const std::string& where() const noexcept { return where_; }
    const std::string& allowed() const noexcept { return allowed_; }
    const std::string& found() const noexcept { return found_; }

  private:
    static std::string join(const std::string& where, const std::string& allowed,
                            const std::string& found) {
        std::string text = where.empty() ? allowed : where + ": " + allowed;
        if (!found.empty()) {
            text += ", got " + found;
        }
        return text;
    }

    std::string where_;
    std::string allowed_;
    std::string found_;
};

}  // namespace ravnoves
