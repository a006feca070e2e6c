#pragma once

#include <QString>
#include <functional>
#include <string>

#include "case-file/field.h"
#include "case-file/message.h"

namespace ravnoves {

/// A text of core in the language of the program.
QString shownText(const Text& text);
/// A message of core in the language of the program, its numbers in the user's way.
QString messageText(const Message& message);
/// The same with its words (keys, names of files) as `word` says them.
QString messageText(const Message& message, const std::function<QString(const std::string&)>& word);
/// A field's label without the & of its mnemonic: the name of its undo step.
QString fieldName(const Field& field);

}  // namespace ravnoves
