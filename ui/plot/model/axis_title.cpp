#include "plot/model/axis_title.h"

#include <QFontMetricsF>
#include <QStringList>
#include <algorithm>

#include "text/shown_units.h"
#include "text/text_width.h"

namespace ravnoves {

namespace {

/// "Mₛ", "ρ(0)", "−", "×", but neither "mean" nor "of" nor a word in Russian.
bool isSymbol(const QString& word) {
    const auto letters = std::count_if(word.begin(), word.end(), [](QChar sign) {
        return sign.isLetter() && sign.category() != QChar::Letter_Modifier;
    });
    constexpr int most = 2;
    const bool isRussian = std::any_of(word.begin(), word.end(), [](QChar sign) {
        return sign.script() == QChar::Script_Cyrillic;
    });
    const bool isWord = letters == word.size() && letters > 1 &&
                        std::all_of(word.begin(), word.end(), [](QChar sign) {
                            return sign.isLower() && sign.script() == QChar::Script_Latin;
                        });
    return letters <= most && !isRussian && !isWord;
}

}  // namespace

QString fittedAxisTitle(const QString& title, const QFont& font, double room) {
    if (textWidth(font, title) <= room) {
        return title;
    }
    const QString unit = unitOfTitle(title);
    const QString separator = QStringLiteral(", ");
    const bool hasUnit = !unit.isEmpty() && unit.size() < title.size();
    QStringList words =
        (hasUnit ? title.chopped(unit.size() + separator.size()) : title).split(QLatin1Char(' '));
    QStringList symbols;
    while (!words.isEmpty() && isSymbol(words.last())) {
        symbols.prepend(words.takeLast());
    }
    const QString tail = symbols.join(QLatin1Char(' ')) + (!hasUnit            ? QString()
                                                           : symbols.isEmpty() ? unit
                                                                               : separator + unit);
    const QString join =
        symbols.isEmpty() ? (hasUnit ? separator : QString()) : QString(QLatin1Char(' '));
    const double rest = room - textWidth(font, join + tail);
    const QString shortened =
        QFontMetricsF(font).elidedText(words.join(QLatin1Char(' ')), Qt::ElideRight, rest);
    constexpr qsizetype telling = 5;  // letters of a word with its dots that still say what it is
    if (tail.isEmpty() || shortened.size() >= telling) {
        return shortened + join + tail;
    }
    return textWidth(font, tail) <= room || !hasUnit ? tail : unit;
}

}  // namespace ravnoves
