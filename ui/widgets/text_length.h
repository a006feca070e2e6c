#pragma once

#include <QString>
#include <optional>

class QLineEdit;
class QWidget;

namespace ravnoves {

/// Lets a field of text hold so many characters, or as many as are in it; where a paste is cut, a
/// tip says so.
void limitLength(QLineEdit* field, int longest);

/// "Cut: at most 80 characters."
QString cutText(int longest);

/// Asks for a name of at most 200 characters. @return nothing where it is given up
std::optional<QString> askName(QWidget* parent, const QString& title, const QString& label,
                               const QString& name);

}  // namespace ravnoves
