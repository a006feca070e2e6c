#pragma once

#include <QString>
#include <optional>

class QLineEdit;
class QWidget;

namespace ravnoves {

/// Limits a field of text to that many characters, or to its present length; where a paste is cut,
/// a tip shows it.
void limitLength(QLineEdit* field, int longest);

/// "Cut: at most 80 characters."
QString cutText(int longest);

/// Prompts for a name of at most 200 characters.
/// @return empty after Cancel
std::optional<QString> askName(QWidget* parent, const QString& title, const QString& label,
                               const QString& name);

}  // namespace ravnoves
