#include "widgets/panel.h"

#include <QImage>
#include <QPainter>
#include <cmath>
#include <utility>

#include "plot/model/pixel.h"
#include "theme/theme.h"

namespace ravnoves {

void Panel::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    paintPanel(painter, rect());
}

namespace {

constexpr int corner = 6;  // pixels that the round of a corner takes, and some

void paintWhole(QPainter& painter, const QRect& panel) {
    painter.setPen(QPen(Theme::instance().border(), 1.0));
    painter.setBrush(Theme::instance().panel());
    painter.drawRoundedRect(QRectF(panel).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
}

/// A panel of nothing but corners.
QImage corners(double ratio) {
    const Theme& theme = Theme::instance();
    static QImage kept;
    static std::pair<QRgb, QRgb> colours;
    const std::pair now(theme.border().rgba(), theme.panel().rgba());
    if (kept.isNull() || colours != now || kept.devicePixelRatio() != ratio) {
        colours = now;
        kept = QImage(QSize(2 * corner, 2 * corner) * ratio, QImage::Format_ARGB32_Premultiplied);
        kept.setDevicePixelRatio(ratio);
        kept.fill(Qt::transparent);
        QPainter painter(&kept);
        painter.setRenderHint(QPainter::Antialiasing);
        paintWhole(painter, {0, 0, 2 * corner, 2 * corner});
    }
    return kept;
}

}  // namespace

void paintPanel(QPainter& painter, const QRect& panel) {
    painter.setRenderHint(QPainter::Antialiasing);
    const QTransform& transform = painter.deviceTransform();
    const double ratio = transform.m11();
    const bool isOnPixels = paintsPixels(painter) && ratio == std::floor(ratio) &&
                            transform.dx() == std::floor(transform.dx()) &&
                            transform.dy() == std::floor(transform.dy());
    if (!isOnPixels || panel.width() < 2 * corner || panel.height() < 2 * corner) {
        paintWhole(painter, panel);
        return;
    }
    // Edges and inside are whole pixels, and both colours cover what is below: only the corners are
    // drawn by shape.
    const Theme& theme = Theme::instance();
    const QRect wide = panel.adjusted(corner, 0, -corner, 0);
    const QRect high = panel.adjusted(0, corner, 0, -corner);
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.fillRect(wide, theme.border());
    painter.fillRect(high, theme.border());
    painter.fillRect(wide.adjusted(0, 1, 0, -1), theme.panel());
    painter.fillRect(high.adjusted(1, 0, -1, 0), theme.panel());
    const QImage all = corners(ratio);
    const double part = corner * ratio;
    for (const bool right : {false, true}) {
        for (const bool below : {false, true}) {
            const QPoint to(right ? panel.right() + 1 - corner : panel.left(),
                            below ? panel.bottom() + 1 - corner : panel.top());
            painter.drawImage(QRectF(to, QSizeF(corner, corner)), all,
                              QRectF(right ? part : 0.0, below ? part : 0.0, part, part));
        }
    }
    painter.setRenderHint(QPainter::Antialiasing);
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
