#pragma once

#include <QString>

#include "case-file/field.h"
#include "case-file/message.h"

namespace ravnoves {

/// A text of core in the language of the program.
QString shownText(const Text& text);
/// A message of core in the language of the program, its numbers in the user's way.
QString messageText(const Message& message);
/// A field's label without the & of its mnemonic: the name of its undo step.
QString fieldName(const Field& field);

}  // namespace ravnoves
