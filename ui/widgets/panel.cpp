#include "widgets/panel.h"

#include <QPainter>

#include "theme/theme.h"

namespace ravnoves {

void Panel::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(Theme::instance().border(), 1.0));
    painter.setBrush(Theme::instance().panel());
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
}

}  // namespace ravnoves
