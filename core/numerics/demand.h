#pragma once

#include <stdexcept>
#include <string>

/// Checks an invariant of our own, in release builds too; a user's mistake is an InputError
/// instead.
/// @throws std::logic_error with the file and the line: "condition (solver.cpp:12)"
#define RAVNOVES_DEMAND(condition, what_must_hold)                         \
    do {                                                                   \
        if (!(condition)) {                                                \
            ::ravnoves::demand_failed(what_must_hold, __FILE__, __LINE__); \
        }                                                                  \
    } while (false)

namespace ravnoves {

[[noreturn]] inline void demand_failed(const std::string& what_must_hold, const std::string& file,
                                       int line) {
    throw std::logic_error(what_must_hold + " (" + file.substr(file.find_last_of("/\\") + 1) + ":" +
                           std::to_string(line) + ")");
}

}  // namespace ravnoves
