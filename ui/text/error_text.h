#pragma once

#include <QString>
#include <exception>

namespace ravnoves {

/// What an InputError of core says, in the language of the program: place, what is allowed there
/// and what was found. Keys and pointers of a case file stay as they stand in the file, and so does
/// what the system says.
QString errorText(const std::exception& error);

}  // namespace ravnoves
