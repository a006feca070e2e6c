#include "text/text_width.h"

#include <QFontMetricsF>
#include <QHash>

namespace ravnoves {

qreal textWidth(const QFont& font, const QString& text) {
    constexpr qsizetype maximum = 8192;  // texts; a long day's are fewer
    static QHash<QFont, QHash<QString, qreal>> measured;
    static qsizetype count = 0;
    QString shape = text;
    for (QChar& sign : shape) {
        sign = sign.isDigit() ? QLatin1Char('0') : sign;
    }
    if (count > maximum) {
        measured.clear();
        count = 0;
    }
    QHash<QString, qreal>& widths = measured[font];
    const auto known = widths.constFind(shape);
    if (known != widths.constEnd()) {
        return *known;
    }
    ++count;
    return *widths.insert(shape, QFontMetricsF(font).horizontalAdvance(shape));
}

}  // namespace ravnoves
