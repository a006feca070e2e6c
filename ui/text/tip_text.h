#pragma once

#include <QString>
#include <QStringList>

namespace ravnoves {

/// A tip in lines of readable length: Qt does not wrap plain text.
inline QString tipText(const QString& text) {
    constexpr qsizetype longest = 80;  // letters
    QStringList lines;
    for (QString rest : text.split(QLatin1Char('\n'))) {
        while (rest.size() > longest) {
            const qsizetype blank = rest.lastIndexOf(QLatin1Char(' '), longest);
            if (blank <= 0) {
                break;
            }
            lines << rest.left(blank);
            rest = rest.mid(blank + 1);
        }
        lines << rest;
    }
    return lines.join(QLatin1Char('\n'));
}

}  // namespace ravnoves
