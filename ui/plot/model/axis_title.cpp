#include "plot/model/axis_title.h"

#include <QFontMetricsF>

#include "text/shown_units.h"
#include "text/text_width.h"

namespace ravnoves {

QString fittedAxisTitle(const QString& title, const QFont& font, double room) {
    if (textWidth(font, title) <= room) {
        return title;
    }
    const QString unit = unitOfTitle(title);
    const QString tail = unit.isEmpty() || unit == title ? QString() : QStringLiteral(", ") + unit;
    const QString words = QFontMetricsF(font).elidedText(title.chopped(tail.size()), Qt::ElideRight,
                                                         room - textWidth(font, tail));
    constexpr qsizetype telling = 5;  // letters of a word with its dots that still say what it is
    return tail.isEmpty() || words.size() >= telling ? words + tail : unit;
}

}  // namespace ravnoves
