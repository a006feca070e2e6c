#pragma once

#include <string>

namespace ravnoves::cli {

// What the program ends with.
inline constexpr int exit_done = 0;
inline constexpr int exit_our_fault = 1;
inline constexpr int exit_bad_input = 2;

inline constexpr const char* no_memory = "needs more memory than available";

/// The text as a terminal may show it: control characters and ends of lines as their codes.
std::string one_line(const std::string& text);

/// One line on standard error, beginning with the file where there is one.
/// @return exit_bad_input
int complain(const std::string& file, const std::string& text);

/// Prints to standard output.
/// @return the exit status; where it cannot be written, this has been said
int print(const std::string& text);

/// Writes a file as write_text_file() does; prints where its name is empty.
/// @return the exit status; where it cannot be written, this has been said
int write_file(const std::string& path, const std::string& text);

/// Before long work: whether a file can be written at that place, as far as one can tell without
/// writing. Where not, this has been said.
bool can_write_file(const std::string& path);

/// For an option that is written to. @return empty, or what is wrong
std::string names_a_file(const std::string& path);

}  // namespace ravnoves::cli
