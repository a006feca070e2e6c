#include "balance-shaft/change_colours.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

#include "theme/theme.h"

namespace ravnoves {

QColor mixedColour(const QColor& from, const QColor& to, double part) {
    const auto channel = [&](int a, int b) {
        return static_cast<int>(std::lround(a + (b - a) * part));
    };
    return {channel(from.red(), to.red()), channel(from.green(), to.green()),
            channel(from.blue(), to.blue())};
}

QColor changeColour(double part) {
    const bool dark = Theme::instance().isDark();
    const QColor neutral = dark ? QColor(0x2b3036) : QColor(0xf7f7f5);
    const std::array help = dark ? std::array{QColor(0x24557f), QColor(0x6cc0ff)}
                                 : std::array{QColor(0x92c5de), QColor(0x15508f)};
    const std::array harm = dark ? std::array{QColor(0x7a4a1c), QColor(0xe09a48)}
                                 : std::array{QColor(0xfccf9c), QColor(0xc2650f)};
    const auto& ends = part < 0.0 ? help : harm;
    const double size = std::min(std::abs(part), 1.0);
    return size <= 0.5 ? mixedColour(neutral, ends[0], 0.25 + 1.5 * size)
                       : mixedColour(ends[0], ends[1], 2.0 * size - 1.0);
}

void paintBarNumbers(QPainter& painter, const QRectF& bar, const std::vector<BarNumber>& numbers) {
    const Theme& theme = Theme::instance();
    painter.setPen(QPen(theme.border(), 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(bar);
    // In smaller type where they would meet.
    const auto boxOf = [&bar](const BarNumber& number, const QFontMetricsF& metrics) {
        const double wide =
            metrics.horizontalAdvance(number.text) + 0.6 * metrics.averageCharWidth() + 2.0;
        return QRectF(bar.left() + number.part * bar.width() - wide / 2.0, bar.bottom() + 1.0, wide,
                      std::ceil(metrics.height()) + 1.0);
    };
    const auto meet = [&](const QFontMetricsF& metrics) {
        return std::any_of(numbers.begin(), numbers.end(), [&](const BarNumber& number) {
            return std::any_of(numbers.begin(), numbers.end(), [&](const BarNumber& other) {
                return number.part < other.part &&
                       boxOf(number, metrics).intersects(boxOf(other, metrics));
            });
        });
    };
    const QFont before = painter.font();
    QFont font = before;
    constexpr int least = 8;  // pixels
    while (font.pixelSize() > least && meet(QFontMetricsF(font))) {
        font.setPixelSize(font.pixelSize() - 1);
    }
    painter.setFont(font);
    std::vector<QRectF> taken;
    for (const BarNumber& number : numbers) {
        const double x = bar.left() + number.part * bar.width();
        painter.setPen(QPen(theme.text(), number.isNoChange ? 2.4 : 1.0));
        painter.drawLine(QPointF(x, number.isNoChange ? bar.top() - 1.0 : bar.bottom() - 3.0),
                         QPointF(x, bar.bottom() + (number.isNoChange ? 2.0 : 1.0)));
        const QRectF box = boxOf(number, QFontMetricsF(font));
        if (std::none_of(taken.begin(), taken.end(),
                         [&](const QRectF& other) { return other.intersects(box); })) {
            taken.push_back(box);
            painter.drawText(box, Qt::AlignCenter, number.text);
        }
    }
    painter.setFont(before);
}

}  // namespace ravnoves
