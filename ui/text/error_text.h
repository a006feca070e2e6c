#pragma once

#include <QString>
#include <exception>

namespace ravnoves {

/// What an InputError of core says, in the language of the program: place, what is allowed there
/// and what was found. Keys and pointers of a case file stay as they stand in the file, and so does
/// what the system says.
QString errorText(const std::exception& error);
/// The same of whatever was thrown in a thread or a slot that nothing may leave.
QString errorText(const std::exception_ptr& thrown);

}  // namespace ravnoves
