#include "widgets/panel.h"

#include <QPainter>

#include "theme/theme.h"

namespace ravnoves {

void Panel::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    paintPanel(painter, rect());
}

void paintPanel(QPainter& painter, const QRect& panel) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(Theme::instance().border(), 1.0));
    painter.setBrush(Theme::instance().panel());
    painter.drawRoundedRect(QRectF(panel).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
}

QRect paintPanel(QPainter& painter, const QRect& panel, const QString& title) {
    paintPanel(painter, panel);
    painter.setBrush(Qt::NoBrush);
    const QFont font = Theme::font(Theme::baseSize, true);
    painter.setFont(font);
    painter.setPen(Theme::instance().text());
    const QRect line(Theme::margin, Theme::space, panel.width() - 2 * Theme::margin,
                     QFontMetrics(font).height());
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, title);
    return line;
}

}  // namespace ravnoves
