#pragma once

#include <QString>
#include <exception>
#include <string>

namespace ravnoves {

/// What an InputError of core says, in the language of the program: place, what is allowed there
/// and what was found. Keys and pointers of a case file stay as they stand in the file, and so does
/// what the system says.
QString errorText(const std::exception& error);

/// A text of core in the language of the program, by the phrases listed in error_phrases.h; one
/// that is none of them stays English, part by part ("cannot be written: disk full").
QString coreText(const std::string& text);

}  // namespace ravnoves
