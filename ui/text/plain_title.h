#pragma once

#include <QString>

namespace ravnoves {

/// Somebody's text where it is a title, of a window or a tab: control characters and ends of lines
/// are blanks, and what turns the direction of the letters after it is left out.
inline QString plainTitle(const QString& text) {
    const auto turns = [](char16_t letter) {
        return (letter >= 0x202A && letter <= 0x202E) || (letter >= 0x2066 && letter <= 0x2069);
    };
    QString title;
    title.reserve(text.size());
    for (const QChar letter : text) {
        const QChar::Category category = letter.category();
        if (category == QChar::Other_Control || category == QChar::Separator_Line ||
            category == QChar::Separator_Paragraph) {
            title += QLatin1Char(' ');
        } else if (!turns(letter.unicode())) {
            title += letter;
        }
    }
    return title;
}

}  // namespace ravnoves
