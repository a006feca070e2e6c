#pragma once

#include <QString>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "case-file/field.h"
#include "case-file/message.h"

namespace ravnoves {

/// The context of core's texts in the translations.
inline constexpr const char* core_texts = "Text";
/// A text of core in the language of the program.
QString shownText(const Text& text);
/// A number of a message in the user's way, with its unit.
QString numberText(const Number& number);

/// How the parts of a message are written.
struct MessageWords {
    std::function<QString(const Text&)> text = shownText;
    /// Words of no language: keys, names of files.
    std::function<QString(const std::string&)> word = QString::fromStdString;
    std::function<QString(const Number&)> number = numberText;
};
/// A message of core, by itself in the language of the program.
QString messageText(const Message& message, const MessageWords& words = {});
/// A line for each message.
QString messageLines(const std::vector<Message>& messages);
/// A preset's title, also one that core has as words of no language.
QString presetTitle(const Message& title);
/// A field's label without the & of its mnemonic: the name of its undo step.
QString fieldName(const Field& field);
/// The label of one of a choice's words; empty where it has none.
QString choiceText(const Field& field, std::string_view word);
/// The meaning of a field and of its empty state: its tooltip.
QString fieldHint(const Field& field);

}  // namespace ravnoves
